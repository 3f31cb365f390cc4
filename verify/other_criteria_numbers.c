/* other_criteria_numbers.c: an eigenvector's first component, and the weights of waves.  Compiled once per number system. */
#include "other_criteria_numbers.h"

#include "block_matrix.h"

#include "../lib/eigenpair.h"
#include "../lib/formula_value.h"

#define wave_weights NUMBER_NAME(has_wave_weights)
#define first_ring NUMBER_NAME(is_first_ring_not_zero)
#define formula_value NUMBER_NAME(formula_value)
bool wave_weights(const scheme *s, long k, long prec);
bool first_ring(const scheme *s, long k, long m, long prec);

/* ---- the first ring ---- */

static bool is_not_zero(const number *x)
{
    return number_is_positive(x) == TRUTH_TRUE || number_is_negative(x) == TRUTH_TRUE;
}

/* The first unknown of every block but that of frequency 0 is the value at (1,0). */
static bool has_first_component(const number *matrix, int n, bool complex_form, long prec)
{
    eigenpair_choice choice;
    number *box = number_array_new(eigenpair_box_size(n, complex_form));
    bool answer = false;
    eigenpair_choice_init(&choice);
    if (box && eigenpair_choose(&choice, matrix, n, complex_form, prec, prec) == TRUTH_TRUE && eigenpair_prove(box, &choice, matrix, prec) == TRUTH_TRUE)
        answer = is_not_zero(&box[0]) || (complex_form && is_not_zero(&box[n / 2]));
    if (box)
        number_array_free(box, eigenpair_box_size(n, complex_form));
    eigenpair_choice_clear(&choice);
    return answer;
}

bool first_ring(const scheme *s, long k, long m, long prec)
{
    scheme_numbers numbers;
    diagnostic unused;
    int n;
    bool complex_form, answer = false;
    status result = scheme_numbers_make(&numbers, s, k, prec, &unused);
    number *matrix = result == STATUS_OK ? block_matrix_make(&n, &complex_form, &result, &numbers, m, &unused) : NULL;
    if (matrix) {
        answer = has_first_component(matrix, n, complex_form, prec);
        number_array_free(matrix, (size_t)n * (size_t)n);
    }
    scheme_numbers_free(&numbers);
    return answer;
}

/* ---- waves ---- */

/* 0 <= alpha < 1, 0 <= beta < 1, 0 < alpha + beta < 1.  The sum is positive if one of them is and the other is not negative. */
static bool are_weights_good(const number *alpha, const number *beta, long prec)
{
    bool good;
    number one, sum;
    number_init(&one);
    number_init(&sum);
    number_one(&one);
    number_add(&sum, alpha, beta, prec);
    good = (number_is_positive(alpha) == TRUTH_TRUE || number_is_zero(alpha) == TRUTH_TRUE) && (number_is_positive(beta) == TRUTH_TRUE || number_is_zero(beta) == TRUTH_TRUE)
           && number_is_positive(&sum) == TRUTH_TRUE && number_less(&sum, &one) == TRUTH_TRUE;
    number_clear(&one);
    number_clear(&sum);
    return good;
}

/* The regular weights: the mask has alpha in its middle and beta/4 beside it. */
static bool is_regular_good(const scheme_step *step, long prec)
{
    rational q;
    number alpha, beta;
    bool good;
    rational_init(&q);
    number_init(&alpha);
    number_init(&beta);
    good = laurent_get(&q, &step->mask, 0, 0);
    number_set_rational(&alpha, &q, prec);
    good = good && laurent_get(&q, &step->mask, 1, 0) && rational_mul_2exp(&q, &q, 2);
    number_set_rational(&beta, &q, prec);
    good = good && are_weights_good(&alpha, &beta, prec);
    rational_clear(&q);
    number_clear(&alpha);
    number_clear(&beta);
    return good;
}

/* Those at the centre: of the vertex itself and in total of its neighbours (lib/scheme_compose.c). */
static bool is_centre_good(const rule *r, long k, long prec)
{
    formula_point at = {k, 0, 0};
    diagnostic unused;
    number alpha, beta;
    bool good;
    number_init(&alpha);
    number_init(&beta);
    good = formula_value(&alpha, r->sources[0].weight, &at, prec, &unused) == STATUS_OK && formula_value(&beta, r->sources[1].weight, &at, prec, &unused) == STATUS_OK
           && are_weights_good(&alpha, &beta, prec);
    number_clear(&alpha);
    number_clear(&beta);
    return good;
}

/* Only compositions have several steps. */
bool wave_weights(const scheme *s, long k, long prec)
{
    bool good = s->step_count > 1;
    for (int i = 1; good && i < s->step_count; i++) {
        const scheme_step *step = &s->steps[i];
        if (step->to == MESH_QUAD)
            good = step->rule_count == 1 && step->rules[0].count == 3 && is_regular_good(step, prec) && is_centre_good(&step->rules[0], k, prec);
    }
    return good;
}

/* The rounding mode is set round calls that contain no arithmetic of their own (bigfloat/number.h). */
bool NUMBER_NAME(is_wave)(const scheme *s, long k, long prec)
{
    number_mode mode = number_enter();
    bool answer = wave_weights(s, k, prec);
    number_leave(mode);
    return answer;
}

bool NUMBER_NAME(first_ring_is_not_zero)(const scheme *s, long k, long m, long prec)
{
    number_mode mode = number_enter();
    bool answer = first_ring(s, k, m, prec);
    number_leave(mode);
    return answer;
}
