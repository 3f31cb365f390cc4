/* uniform_range.h: the uniform method on one net that stands for the maps of many valences, an interval at each point, as Zorin's
   thesis steps through valences (6.2.1).  Compiled once per number system; affine sources may include it, too. */
#ifndef VERIFY_UNIFORM_RANGE_H
#define VERIFY_UNIFORM_RANGE_H

#include "analysis.h"

#include "../bigfloat/number.h"

#if !defined(NUMBER_AFFINE)
#define base_number number
#define BASE_NAME NUMBER_NAME
#endif

/* x and y: the ranges of the net's values, as lib/sector.h stores them, on so many rings; u: that of cos(pi/k), for the twist.
   Figures go to f, with the largest half-width of the net in uniform_width. */
outcome BASE_NAME(uniform_over_range)(findings *f, choices *c, analysis_plan *p, const base_number *x, const base_number *y, int rings, const base_number *u, long prec);

#if !defined(NUMBER_AFFINE)
#undef base_number
#undef BASE_NAME
#define uniform_over_range NUMBER_NAME(uniform_over_range)
#endif

#endif
