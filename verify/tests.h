/* tests.h: the tests of one valence, one signature each.  Compiled once per number system.

   They run in this order; each needs what the ones before it have proved and left in the analysis.  A test returns how
   it ends, puts its witness into the choices and its figures into the last attempt of the findings. */
#ifndef VERIFY_TESTS_H
#define VERIFY_TESTS_H

#include "adaptive.h"
#include "analysis.h"
#include "buffer.h"
#include "uniform_net.h"

#define analysis_tests NUMBER_NAME(analysis_tests)
#define test_regular_complex NUMBER_NAME(test_regular_complex)
#define test_window NUMBER_NAME(test_window)
#define test_graded NUMBER_NAME(test_graded)
#define test_eigenpair NUMBER_NAME(test_eigenpair)
#define test_spectrum NUMBER_NAME(test_spectrum)
#define test_regularity NUMBER_NAME(test_regularity)
#define test_injectivity NUMBER_NAME(test_injectivity)
#define test_zero_free NUMBER_NAME(test_zero_free)
#define test_nonzero NUMBER_NAME(test_nonzero)
#define test_fold NUMBER_NAME(test_fold)
#define test_winding NUMBER_NAME(test_winding)
#define test_second NUMBER_NAME(test_second)
#define test_real NUMBER_NAME(test_real)
#define analysis_exchange NUMBER_NAME(analysis_exchange)
#define analysis_signed_jacobian NUMBER_NAME(analysis_signed_jacobian)
#define real_windows NUMBER_NAME(real_windows)
#define test_exact NUMBER_NAME(test_exact)
#define test_exact_witnesses NUMBER_NAME(test_exact_witnesses)
#define exact_free NUMBER_NAME(exact_free)
#define analysis_seek NUMBER_NAME(analysis_seek)
#define analysis_seek_nonzero NUMBER_NAME(analysis_seek_nonzero)
#define analysis_follow_curve NUMBER_NAME(analysis_follow_curve)

#define outcome_from_block NUMBER_NAME(outcome_from_block)
#define analysis_make_block NUMBER_NAME(analysis_make_block)
#define analysis_prove_pair NUMBER_NAME(analysis_prove_pair)
#define analysis_make_net NUMBER_NAME(analysis_make_net)
#define analysis_subdivide NUMBER_NAME(analysis_subdivide)
#define analysis_uniform NUMBER_NAME(analysis_uniform)
#define adaptive_jacobian NUMBER_NAME(adaptive_jacobian)
#define picture_take NUMBER_NAME(picture_take)

/* One eigenpair and its net. */
typedef struct {
    block dominant;
    number *matrix;
    int order;
    number *box;
    sector_net net;
    bool net_made;
} analysis_pair;

typedef struct {
    analysis_plan *plan;
    choices *choices;
    findings *findings;
    bool replay;
    long prec;
    scheme_numbers numbers;
    mask_numbers mask[RING_NETS];
    patch_numbers patch[RING_NETS]; /* if the problem has polynomials */
    block dominant;    /* the block of L: B(w_1), unless the claim says otherwise */
    number *matrix;    /* as a real matrix, order x order */
    int order;
    number *box;       /* its eigenpair, after test_eigenpair: order numbers, then L (complex form: two) */
    number scale;      /* thin, >= 1/|L|, after test_eigenpair */
    sector_net net;    /* of the characteristic map, after analysis_make_net */
    bool net_made;
    analysis_pair other; /* of CLAIM_REAL: the second one, or, between two exchanges, the first */
    const int *mixed;    /* NULL; in test_real, the components of both that make one net */
    struct exact_state *exact; /* of claims that are exact: exact_test.h */
    uniform_net *uniform; /* values and both derivatives at one level, in the tests of the uniform method */
} analysis;

typedef struct {
    test_name name;
    const char *words;
    outcome (*run)(analysis *);
    unsigned claims; /* that need it: 1 << claim_kind */
} analysis_test;

/* In the order in which they run; the last one has no `run`. */
extern const analysis_test analysis_tests[];

/* The scheme is C1 on the regular complex; is that all there is to prove at this valence? */
outcome test_regular_complex(analysis *a);
/* L is a simple eigenvalue of the claim's block, 0 < |L| < 1 (of CLAIM_NOT_C0: 1 < |L|). */
outcome test_eigenpair(analysis *a);
/* 1 is simple, and every eigenvalue of every block other than 1 and L is smaller than L in modulus (but for its
   conjugate in another block). */
outcome test_spectrum(analysis *a);
/* The Jacobian of the characteristic map is positive on the ring. */
outcome test_regularity(analysis *a);
/* The image of one sector's outer curve lies in an open half-plane with 0 on its border: no zero, and winding 1. */
outcome test_injectivity(analysis *a);

/* The eigenfunction has no zero on the ring's outer curve. */
outcome test_zero_free(analysis *a);

/* z += J = x1 y2 - y1 x2 of the derivatives (x1, y1), (x2, y2). */
void adaptive_jacobian(number *z, const number *const x[], const number *const y[], const void *data, long prec);

/* The eigenfunction is not 0 somewhere on the outer curve. */
outcome test_nonzero(analysis *a);
/* The Jacobian is positive somewhere on the ring, and negative somewhere else. */
outcome test_fold(analysis *a);
/* The outer curve, on which the characteristic map has no zero, winds several times, or the wrong way round. */
outcome test_winding(analysis *a);

/* CLAIM_REAL: the second eigenvalue is simple in its block, and smaller than the first; the scale is its own. */
outcome test_second(analysis *a);
/* CLAIM_REAL: the Jacobian of both eigenfunctions is not 0 somewhere on the ring. */
outcome test_real(analysis *a);
/* Exchanges both eigenpairs, with their choices. */
void analysis_exchange(analysis *a);
/* z += sign J, data: the sign, a long; x[0], y[0] and x[1], y[1] are the derivatives in both directions. */
void analysis_signed_jacobian(number *z, const number *const x[], const number *const y[], const void *data, long prec);
/* The windows of a net that has one component of each pair's net. */
block_status real_windows(charnet_windows *z, const analysis *a, int which, const element *elements, int count);

/* The blocks of the choices have the eigenvalue that they are said to have, exactly, in Jordan blocks that are no larger;
   all their other eigenvalues are smaller (but of CLAIM_MODULUS_ONE).  Leaves the first eigenvector that counts. */
outcome test_exact(analysis *a);
/* The eigenfunctions that count are not 0. */
outcome test_exact_witnesses(analysis *a);
void exact_free(analysis *a);

/* The matrix of the eigenpair: that of the block, unless something else is made of it. */
static inline const number *analysis_matrix(const analysis *a) { return a->matrix ? a->matrix : a->dominant.entry; }

/* a->box: the eigenpair of analysis_matrix(a), of order a->order, by choices that are found or followed (only for affine numbers). */
outcome analysis_prove_pair(analysis *a, eigenpair_choice *e, const char *of_what);

/* The eigenvalue of block 0 that grows without bound with the valence, scaled, and its net (only for affine numbers). */
outcome test_graded(analysis *a);

/* At every valence the blocks of some frequencies in a window dominate, simply, and their eigenfunctions have no zero on the outer
   curve (only for affine numbers). */
outcome test_window(analysis *a);

/* What a block's status means for a test, explained in the last attempt; d: the complaint that belongs to BLOCK_BAD_INPUT
   (NULL where that cannot be). */
outcome outcome_from_block(findings *f, block_status s, const diagnostic *d);
static inline outcome analysis_from_block(analysis *a, block_status s, const diagnostic *d) { return outcome_from_block(a->findings, s, d); }
/* The enclosure of the blocks first..last; OUTCOME_TRUE, or why it could not be made.  On any outcome block_free. */
outcome analysis_make_block(block *b, analysis *a, long first, long last);
/* The control net of the characteristic map, if it is not made yet. */
outcome analysis_make_net(analysis *a);
/* Subdivides elements as the task says, with the nets of which[]; fills in the parts of the task that are the same for
   all tests, and the figures of the attempt. */
outcome analysis_subdivide(analysis *a, adaptive_task *task, tree_word *word, const element *elements, int count);

/* Looks for an element, or some descendant of one, where the task's quantity is certainly positive, or follows the
   witness that there is. */
outcome analysis_seek(analysis *a, adaptive_task *task, witness_choice *witness, const element *elements, int count);

/* The eigenfunction has no zero on the outer curve, by the trees of the choices.  directions: NULL, or the direction of each leaf, in
   the order of the trees, a digit d: its box is where x > 0, y > 0, x < 0 or y < 0, d = 0, 1, 2 or 3, the first that is true. */
outcome analysis_follow_curve(analysis *a, buffer *directions);

/* Looks for a place where the eigenfunction of the net is not 0, on the outer curve, or follows the witness that there is. */
outcome analysis_seek_nonzero(analysis *a, witness_choice *witness);

/* Regularity, isolation and winding number by the uniform method (uniform.h), as far down as the plan allows.
   OUTCOME_UNDEFINED: more levels may help; OUTCOME_FAIL: more precision. */
outcome analysis_uniform(analysis *a);

/* A picture of the map of the eigenpair in a->box, and of the choices' trees in a replay; OUTCOME_FALSE if no eigenpair is
   proved.  Nothing can be seen of block 0. */
outcome picture_take(picture *p, analysis *a);

#endif
