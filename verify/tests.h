/* tests.h: the tests of one valence, one signature each.  Compiled once per number system.

   They run in this order; each needs what the ones before it have proved and left in the analysis. */
#ifndef VERIFY_TESTS_H
#define VERIFY_TESTS_H

#include "adaptive.h"
#include "analysis.h"

#define test_spectrum NUMBER_NAME(test_spectrum)
#define test_characteristic_net NUMBER_NAME(test_characteristic_net)
#define test_regularity NUMBER_NAME(test_regularity)
#define test_injectivity NUMBER_NAME(test_injectivity)

typedef struct {
    const problem *problem;
    choices *choices;
    findings *findings;
    bool replay;
    int max_level;
    long prec;
    scheme_numbers numbers;
    mask_numbers mask[RING_NETS];
    block dominant;    /* B(w_1) */
    number *box;     /* its eigenpair: n + 1 numbers, after test_spectrum */
    sector_net net;  /* of the characteristic map, after test_characteristic_net */
} analysis;

/* 1 and L are simple, L is real, 0 < L < 1, and every other eigenvalue of every block is smaller than L. */
outcome test_spectrum(analysis *a);
/* Not a test but a construction: the control net of the characteristic map. */
outcome test_characteristic_net(analysis *a);
/* The Jacobian of the characteristic map is positive on the ring. */
outcome test_regularity(analysis *a);
/* The image of one sector's outer curve lies in an open half-plane with 0 on its border: no zero, and winding 1. */
outcome test_injectivity(analysis *a);

#endif
