/* ball_sets.c: endpoints, midpoints, radii, hulls. */
#include "ball.h"
#include "ball_internal.h"

/* z = the endpoint of x, moved outward to prec where it is longer; thin. */
static void thin_endpoint(ball *z, const ball *x, bool upper, long prec)
{
    if (ball_is_special(x)) {
        ball_indeterminate_like(z, x, x);
        return;
    }
    ball_scratch space;
    limb_t *w = ball_scratch_new(&space, ball_length(x) + 1);
    if (w) {
        dyadic d;
        ball_endpoint(&d, w, x, upper);
        ball_store(z, w, d.n, d.negative, 0, 0, d.e, prec);
    } else
        ball_no_memory(z);
    ball_scratch_free(&space);
    /* ball_store cuts towards 0 and then sets the error 1; where that is the wrong way, take the unit beyond */
    if (!ball_is_special(z) && z->error) {
        bool outward_is_away = (z->size < 0) != upper;
        limb_t *p = z->capacity ? z->at.heap : z->at.inline_limbs;
        size_t n = ball_length(z);
        bool underflow = n == 0;
        if (underflow) {
            p = ball_fresh(z, 1);
            p[0] = z->error;
            z->size = upper ? 1 : -1;
        } else if (outward_is_away && limb_add_1(p, p, n, 1)) {
            p[n - 1] = (limb_t)1 << 63; /* all ones became 2^(64 n) */
            z->exponent++;
        }
        z->error = 0;
    }
}

void ball_lower(ball *z, const ball *x, long prec) { thin_endpoint(z, x, false, prec); }
void ball_upper(ball *z, const ball *x, long prec) { thin_endpoint(z, x, true, prec); }

void ball_midpoint(ball *z, const ball *x, long prec)
{
    ball_set_round(z, x, prec);
    if (!ball_is_special(z)) {
        z->error = 0;
        if (z->size == 0)
            z->exponent = 0;
    }
}

/* The midpoint as returned has lost less than one unit of its last place, 2^s units of x, s = the cut. */
void ball_radius_upper(ball *z, const ball *x, long prec)
{
    if (ball_is_special(x)) {
        ball_indeterminate_like(z, x, x);
        return;
    }
    int64_t s = (int64_t)ball_mantissa_bits(x) - ball_room_bits(prec), e = x->exponent;
    limb_t r = x->error;
    if (s > 0) {
        r = (s < 64 ? r >> s : 0) + 2; /* ROUNDING: ceiling of err 2^-s, and the unit lost */
        e += s;
    }
    ball_store(z, &r, 1, false, 0, 0, e, 64);
}

void ball_magnitude_upper(ball *z, const ball *x, long prec)
{
    ball t;
    ball_init(&t);
    if (x->size < 0)
        ball_neg(&t, x);
    else
        ball_set(&t, x);
    ball_upper(z, &t, prec);
    ball_clear(&t);
}

void ball_set_thin_bounds(ball *z, const ball *lower, const ball *upper, long prec)
{
    ball middle, radius;
    ball_init(&middle);
    ball_init(&radius);
    ball_add(&middle, lower, upper, prec);
    ball_sub(&radius, upper, lower, 64);
    ball_mul_2exp(&radius, &radius, -1, 64);
    ball_mul_2exp(&middle, &middle, -1, prec);
    ball_add_error(z, &middle, &radius, prec);
    ball_clear(&middle);
    ball_clear(&radius);
}

/* For hull, min, max and intersection: which of the two lower and of the two upper endpoints bounds the result.
   +1: the greater, -1: the less. */
static void combine(ball *z, const ball *x, const ball *y, int lower_choice, int upper_choice, long prec)
{
    if (ball_is_special(x) || ball_is_special(y)) {
        ball_indeterminate_like(z, x, y);
        return;
    }
    const long working = 2 * prec + 64;
    ball a, b, c, d;
    ball_init(&a);
    ball_init(&b);
    ball_init(&c);
    ball_init(&d);
    ball_lower(&a, x, working);
    ball_lower(&b, y, working);
    ball_upper(&c, x, working);
    ball_upper(&d, y, working);
    truth lower = ball_less(&a, &b), upper = ball_less(&c, &d);
    const ball *low = (lower == TRUTH_TRUE) == (lower_choice < 0) ? &a : &b;
    const ball *high = (upper == TRUTH_TRUE) == (upper_choice < 0) ? &c : &d;
    if (lower == TRUTH_UNKNOWN || upper == TRUTH_UNKNOWN)
        ball_no_memory(z); /* thin numbers are comparable, unless memory is missing here or before */
    else if (ball_less(high, low) == TRUTH_TRUE)
        ball_indeterminate(z);
    else
        ball_set_thin_bounds(z, low, high, prec);
    ball_clear(&a);
    ball_clear(&b);
    ball_clear(&c);
    ball_clear(&d);
}

void ball_hull(ball *z, const ball *x, const ball *y, long prec) { combine(z, x, y, -1, 1, prec); }
void ball_min(ball *z, const ball *x, const ball *y, long prec) { combine(z, x, y, -1, -1, prec); }
void ball_max(ball *z, const ball *x, const ball *y, long prec) { combine(z, x, y, 1, 1, prec); }

/* The result is some enclosure of the common part; where the parts are disjoint, indeterminate. */
void ball_intersection(ball *z, const ball *x, const ball *y, long prec)
{
    if (ball_is_special(x) || ball_is_special(y))
        ball_set_round(z, ball_is_special(x) ? y : x, prec);
    else
        combine(z, x, y, 1, -1, prec);
}

long ball_accuracy_bits_approx(const ball *x)
{
    if (ball_is_special(x))
        return LONG_MIN;
    if (x->error == 0)
        return LONG_MAX;
    return (long)ball_mantissa_bits(x) - limb_bits(x->error);
}
