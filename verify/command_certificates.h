/* command_certificates.h: what commands on certificates and directories of them share. */
#ifndef VERIFY_COMMAND_CERTIFICATES_H
#define VERIFY_COMMAND_CERTIFICATES_H

#include "buffer.h"

/* Calls act for the file, or, if it is a directory, for each of its certificates in order, until one returns something else
   than 0, which is the result.  Complains of what cannot be read. */
int for_each_certificate(const char *path, int (*act)(const char *file, void *data), void *data);

/* Prints the text as a line of stdout and clears it.  0, or no memory: it has complained, and this is the exit status. */
int print_line(buffer *text);

/* Complains of errno; returns the exit status. */
int complain_of_file(const char *path);
int complain_of_memory(void);

#endif
