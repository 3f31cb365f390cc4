/* other_criteria_numbers.h: what other_criteria.h needs to know about numbers, in each number system. */
#ifndef VERIFY_OTHER_CRITERIA_NUMBERS_H
#define VERIFY_OTHER_CRITERIA_NUMBERS_H

#include "../lib/scheme.h"

/* Is the eigenvector of block m's dominant eigenvalue certainly not 0 at (1,0)?  m >= 1. */
bool first_ring_is_not_zero_interval(const scheme *s, long k, long m, long prec);
bool first_ring_is_not_zero_ball(const scheme *s, long k, long m, long prec);
bool first_ring_is_not_zero_grid(const scheme *s, long k, long m, long prec);

/* Is it a composition of degree 2 or more, whose weights at the regular and at this valence are certainly such that
   0 <= alpha, beta < 1 and 0 < alpha + beta < 1? */
bool is_wave_interval(const scheme *s, long k, long prec);
bool is_wave_ball(const scheme *s, long k, long prec);
bool is_wave_grid(const scheme *s, long k, long prec);

#endif
