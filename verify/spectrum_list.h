/* spectrum_list.h: the spectrum of a scheme at one valence, block by block, as proved text and bounds. */
#ifndef VERIFY_SPECTRUM_LIST_H
#define VERIFY_SPECTRUM_LIST_H

#include "../lib/exact_range.h"
#include "../lib/scheme.h"

/* `count` eigenvalues of block m within `radius` of re + i im; or (re NULL) one entry for a block of which nothing is
   proved. */
typedef struct {
    long m;
    int count;
    bool real;       /* all of them are; if there are several, re is exact */
    bool one;        /* a single one of block 0, real, that may be 1 */
    bool real_block; /* of a real matrix, whose eigenvalues come with their conjugates */
    char *re, *im;   /* decimals that enclose real and imaginary part; im is NULL for real ones */
    double modulus_lower, modulus_upper;
    double lower[2], upper[2]; /* bounds of real and imaginary part */
} spectrum_entry;

/* All eigenvalues of the blocks of a range are at most this large; INFINITY: nothing is proved. */
typedef struct {
    frequencies m;
    double upper;
} spectrum_range;

typedef struct {
    spectrum_entry *entry; /* by m, then by falling modulus */
    size_t count, capacity;
    spectrum_range *range; /* of blocks that have no entries, by m */
    size_t ranges, range_capacity;
    /* Where there are ranges: */
    long top;          /* the block of the largest eigenvalue besides 1, as far as it is known */
    bool ordered;      /* is it larger than all eigenvalues of all other blocks but block 0? */
    double rest_upper; /* and these are all at most this large; INFINITY: not proved */
    bool exhausted;    /* if not, would more work help rather than more precision? */
    frequencies open;  /* if not ordered: all blocks that may have one as large lie between, apart from those with entries */
} spectrum_list;

void spectrum_list_init(spectrum_list *z);
void spectrum_list_clear(spectrum_list *z);
/* A new last entry, zeroed; NULL: no memory. */
spectrum_entry *spectrum_list_add(spectrum_list *z);

/* The index of the eigenvalue 1 of block 0, which has one; -1: it cannot be told from others. */
long spectrum_find_one(const spectrum_list *z);
/* Are the entries i and j certainly two conjugate eigenvalues of one block? */
bool spectrum_is_conjugate_pair(const spectrum_list *z, size_t i, size_t j);
/* A new last range, or a longer one if the last one continues with the same bound.  false: no memory. */
BIGFLOAT_MUST_USE bool spectrum_list_add_range(spectrum_list *z, frequencies m, double upper);

/* Blocks 0..k/2 at valence k.  STATUS_BAD_INPUT: the scheme cannot be evaluated there. */
status spectrum_list_make_interval(spectrum_list *z, const scheme *s, long k, int digits, long prec, diagnostic *d);
status spectrum_list_make_ball(spectrum_list *z, const scheme *s, long k, int digits, long prec, diagnostic *d);
status spectrum_list_make_grid(spectrum_list *z, const scheme *s, long k, int digits, long prec, diagnostic *d);

/* The same for large k: entries for a few blocks, ranges for the others.  Mirror-symmetric or not; `bounds`: with a bound of
   its own for each range, which takes longer. */
status spectrum_survey_interval(spectrum_list *z, const scheme *s, long k, int digits, long prec, bool bounds, diagnostic *d);
status spectrum_survey_ball(spectrum_list *z, const scheme *s, long k, int digits, long prec, bool bounds, diagnostic *d);
status spectrum_survey_grid(spectrum_list *z, const scheme *s, long k, int digits, long prec, bool bounds, diagnostic *d);

#endif
