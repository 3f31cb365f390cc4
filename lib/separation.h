/* separation.h: the blocks m >= 2 of many valences have only eigenvalues smaller than that of frequency 1
   (verify/certificate-valences.md, section 4).  Compiled once per number system.

   Where m/k is far from 1/k the gap is wide enough for spans (lib/span.h).  Near it there is a gap only because the eigenvalue
   rises with u (lib/rise.h): the chain goes from 1/k.last beyond 1/k.first, as far as spans need it. */
#ifndef LIB_SEPARATION_H
#define LIB_SEPARATION_H

#include "rise.h"
#include "span.h"

#define separation_search NUMBER_NAME(separation_search)
#define separation_verify NUMBER_NAME(separation_verify)

typedef struct {
    block_status status; /* BLOCK_OK, or what was wrong with the scheme, or BLOCK_NO_MEMORY: then no more is said */
    bool proved;
    bool stopped;        /* lib/stop.h */
    rise_answer rise;    /* the last ones, which say where it has failed; */
    span_answer span;    /* open_from = rise.end: the chain was too short */
} separation_answer;

/* Finds lists, which are empty before, with which separation_verify proves that all eigenvalues of the blocks 2 <= m <= k/2 are
   smaller in modulus, at each valence, than the largest one of block 1, which is simple and real, and 1/scale at least; scale is thin and
   positive, and that is proved elsewhere.  Mirror-symmetric schemes only.  If nothing is found the lists are empty. */
separation_answer separation_search(rise_list *rises, span_list *spans, const scheme *s, valence_range k, const number *scale, const cover_limits *limits, long g, long prec, diagnostic *d);

separation_answer separation_verify(const rise_list *rises, const span_list *spans, const scheme *s, valence_range k, const number *scale, long prec, diagnostic *d);

#endif
