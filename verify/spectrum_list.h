/* spectrum_list.h: the spectrum of a scheme at one valence, block by block, as proved text and bounds. */
#ifndef VERIFY_SPECTRUM_LIST_H
#define VERIFY_SPECTRUM_LIST_H

#include "../lib/scheme.h"

/* `count` eigenvalues of block m within `radius` of re + i im; or (re NULL) one entry for a block of which nothing is
   proved. */
typedef struct {
    long m;
    int count;
    bool real;
    char *re, *im; /* decimals that enclose real and imaginary part; im is NULL for real ones */
    double modulus_lower, modulus_upper;
} spectrum_entry;

typedef struct {
    spectrum_entry *entry; /* by m, then by falling modulus */
    size_t count, capacity;
} spectrum_list;

void spectrum_list_init(spectrum_list *z);
void spectrum_list_clear(spectrum_list *z);
/* A new last entry, zeroed; NULL: no memory. */
spectrum_entry *spectrum_list_add(spectrum_list *z);

/* Blocks 0..k/2 at valence k.  STATUS_BAD_INPUT: the scheme cannot be evaluated there. */
status spectrum_list_make_interval(spectrum_list *z, const scheme *s, long k, int digits, long prec, diagnostic *d);
status spectrum_list_make_ball(spectrum_list *z, const scheme *s, long k, int digits, long prec, diagnostic *d);
status spectrum_list_make_grid(spectrum_list *z, const scheme *s, long k, int digits, long prec, diagnostic *d);

#endif
