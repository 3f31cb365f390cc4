/* spectrum_doubles.h: what double intervals tell a survey of the spectrum at any precision: where to look, and bounds of
   blocks wherever they suffice, for they are as much of a proof and cost a fraction. */
#ifndef VERIFY_SPECTRUM_DOUBLES_H
#define VERIFY_SPECTRUM_DOUBLES_H

#include "../lib/diagnostic.h"
#include "../lib/exact_range.h"
#include "../lib/scheme.h"

typedef struct spectrum_doubles spectrum_doubles;

/* Must not be called where the rounding mode is set already (interval_self_test).  On any status spectrum_doubles_free. */
status spectrum_doubles_make(spectrum_doubles **z, const scheme *s, long k, diagnostic *d);
void spectrum_doubles_free(spectrum_doubles *z);

/* About the largest modulus of block m; what cannot be evaluated counts as 0, the proofs will complain. */
double spectrum_doubles_radius(spectrum_doubles *z, long m);

/* Order of the real matrix of the last block that spectrum_doubles_radius has seen. */
int spectrum_doubles_size(const spectrum_doubles *z);

/* The first frequency of m for which it could not be proved within so many boxes that all eigenvalues of its block and of
   those before it are smaller than bound, m.last + 1 if there is none. */
long spectrum_doubles_below(spectrum_doubles *z, frequencies m, double bound, long tries);

#endif
