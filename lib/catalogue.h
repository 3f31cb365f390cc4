#ifndef LIB_CATALOGUE_H
#define LIB_CATALOGUE_H

/* The scheme files of lib/catalogue/, embedded in the program by lib/embed-catalogue. */

struct catalogue_entry {
	const char *name; /* the file's name without .scheme */
	const char *text; /* the whole file */
};

/* In the order of lib/local.mk; the last entry's name is NULL. */
extern const struct catalogue_entry catalogue[];

#endif
