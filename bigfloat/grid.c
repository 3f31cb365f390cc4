/* grid.c: life, movement between grids, assignment, sums and sets. */
#include "grid.h"

#include <math.h>

#include "grid_internal.h"

void grid_clear(grid *z)
{
    integer_clear(&z->lower);
    integer_clear(&z->upper);
    grid_init(z);
}

void grid_indeterminate(grid *z) { z->state = GRID_INDETERMINATE; }
void grid_no_memory(grid *z) { z->state = GRID_NO_MEMORY; }
bool grid_lacks_memory(const grid *x) { return x->state == GRID_NO_MEMORY; }
bool grid_is_finite(const grid *x) { return x->state == GRID_FINITE; }

void grid_indeterminate_like(grid *z, const grid *x, const grid *y)
{
    z->state = x->state == GRID_NO_MEMORY || y->state == GRID_NO_MEMORY ? GRID_NO_MEMORY : GRID_INDETERMINATE;
}

/* ---- movement ---- */

/* m on grid h becomes floor or ceil(m 2^(g - h)). */
static bool move_integer(integer *z, const integer *m, long h, long g, bool up)
{
    if (g >= h)
        return integer_mul_2exp(z, m, (unsigned long)(g - h));
    return up ? integer_cdiv_2exp(z, m, (unsigned long)(h - g)) : integer_fdiv_2exp(z, m, (unsigned long)(h - g));
}

bool grid_move(grid *z, const grid *x, long g)
{
    if (x->state != GRID_FINITE || !grid_exponent_ok(g)) {
        grid_indeterminate_like(z, x, x);
        return false;
    }
    bool ok = move_integer(&z->lower, &x->lower, x->exponent, g, false)
              && move_integer(&z->upper, &x->upper, x->exponent, g, true);
    grid_finish(z, g, ok);
    return ok;
}

void grid_set_round(grid *z, const grid *x, long g) { (void)grid_move(z, x, g); }

/* ---- assignment ---- */

void grid_set(grid *z, const grid *x)
{
    if (z == x)
        return;
    if (x->state != GRID_FINITE) {
        grid_indeterminate_like(z, x, x);
        return;
    }
    grid_finish(z, x->exponent, integer_set(&z->lower, &x->lower) && integer_set(&z->upper, &x->upper));
}

void grid_zero(grid *z)
{
    integer_zero(&z->lower);
    integer_zero(&z->upper);
    grid_finish(z, 0, true);
}

void grid_one(grid *z)
{
    integer_set_si(&z->lower, 1);
    integer_set_si(&z->upper, 1);
    grid_finish(z, 0, true);
}

void grid_set_endpoints(grid *z, const integer *lower, const integer *upper, long g)
{
    if (integer_cmp(lower, upper) > 0 || !grid_exponent_ok(g))
        grid_indeterminate(z);
    else
        grid_finish(z, g, integer_set(&z->lower, lower) && integer_set(&z->upper, upper));
}

bool grid_get_endpoints(integer *lower, integer *upper, const grid *x, long g)
{
    return x->state == GRID_FINITE && move_integer(lower, &x->lower, x->exponent, g, false)
           && move_integer(upper, &x->upper, x->exponent, g, true);
}

void grid_set_integer_2exp(grid *z, const integer *m, long e, long prec)
{
    if (!grid_exponent_ok(prec) || (e > 64 * (long)INTEGER_MAX_LIMBS && !integer_is_zero(m))) {
        grid_indeterminate(z);
        return;
    }
    if (e < -4 * 64 * (long)INTEGER_MAX_LIMBS)
        e = -4 * 64 * (long)INTEGER_MAX_LIMBS; /* still below every grid and every integer */
    integer t;
    integer_init(&t);
    bool ok = integer_set(&t, m) && move_integer(&z->lower, &t, -e, prec, false)
              && move_integer(&z->upper, &t, -e, prec, true);
    integer_clear(&t);
    grid_finish(z, prec, ok);
}

void grid_set_si(grid *z, long v, long prec)
{
    integer m;
    integer_init(&m);
    integer_set_si(&m, v);
    grid_set_integer_2exp(z, &m, 0, prec);
}

void grid_set_rational(grid *z, const rational *q, long prec)
{
    if (!grid_exponent_ok(prec)) {
        grid_indeterminate(z);
        return;
    }
    rational t;
    rational_init(&t);
    bool ok = rational_mul_2exp(&t, q, prec) && rational_floor(&z->lower, &t) && rational_ceil(&z->upper, &t);
    rational_clear(&t);
    grid_finish(z, prec, ok);
}

void grid_set_double(grid *z, double v, long prec)
{
    ball t;
    ball_init(&t);
    ball_set_double(&t, v, 64);
    grid_set_ball(z, &t, prec);
    ball_clear(&t);
}

/* Endpoints of a ball out of memory's reach are not distinguished from missing memory. */
void grid_set_ball(grid *z, const ball *x, long g)
{
    if (!ball_is_finite(x) || !grid_exponent_ok(g)) {
        z->state = ball_lacks_memory(x) ? GRID_NO_MEMORY : GRID_INDETERMINATE;
        return;
    }
    grid_finish(z, g, ball_lower_grid(&z->lower, x, g) && ball_upper_grid(&z->upper, x, g));
}

void ball_set_grid(ball *z, const grid *x, long prec)
{
    if (x->state != GRID_FINITE) {
        ball none;
        ball_init(&none);
        if (x->state == GRID_NO_MEMORY) {
            none.exponent = BALL_INDETERMINATE;
            none.error = 1;
        } else
            ball_indeterminate(&none);
        ball_set(z, &none);
        return;
    }
    ball lower, upper;
    ball_init(&lower);
    ball_init(&upper);
    ball_set_integer_2exp(&lower, &x->lower, -(long)x->exponent, BALL_MAX_PRECISION);
    ball_set_integer_2exp(&upper, &x->upper, -(long)x->exponent, BALL_MAX_PRECISION);
    ball_hull(z, &lower, &upper, prec);
    ball_clear(&lower);
    ball_clear(&upper);
}

/* ---- sign, sums ---- */

void grid_neg(grid *z, const grid *x)
{
    grid_set(z, x);
    integer_swap(&z->lower, &z->upper);
    z->lower.size = -z->lower.size;
    z->upper.size = -z->upper.size;
}

void grid_abs(grid *z, const grid *x)
{
    if (x->state == GRID_FINITE && integer_sign(&x->lower) < 0 && integer_sign(&x->upper) > 0) {
        bool ok = integer_cmp_abs(&x->lower, &x->upper) > 0 ? integer_neg(&z->upper, &x->lower)
                                                             : integer_set(&z->upper, &x->upper);
        integer_zero(&z->lower);
        grid_finish(z, x->exponent, ok);
    } else if (x->state == GRID_FINITE && integer_sign(&x->lower) < 0)
        grid_neg(z, x);
    else
        grid_set(z, x);
}

/* Both operands are moved even if one fails, so that missing memory of either is seen. */
void grid_on_grid(grid *z, const grid *x, const grid *y, long g,
                  void (*op)(grid *, const grid *, const grid *, long))
{
    grid s, t;
    grid_init(&s);
    grid_init(&t);
    bool sok = grid_move(&s, x, g), tok = grid_move(&t, y, g);
    if (sok && tok)
        op(z, &s, &t, g);
    else
        grid_indeterminate_like(z, &s, &t);
    grid_clear(&s);
    grid_clear(&t);
}

#if LIMB_INT128
/* All four endpoints below 2^126: sums fit a signed 128-bit word. */
static inline bool are_short(const grid *x, const grid *y)
{
    return integer_is_short(&x->lower) && integer_is_short(&x->upper) && integer_is_short(&y->lower)
           && integer_is_short(&y->upper);
}
#endif

void grid_add(grid *z, const grid *x, const grid *y, long prec)
{
    if (!grid_ready(x, prec) || !grid_ready(y, prec)) {
        grid_on_grid(z, x, y, prec, grid_add);
        return;
    }
#if LIMB_INT128
    if (are_short(x, y)) {
        limb_signed_pair_t lower = integer_get_pair(&x->lower) + integer_get_pair(&y->lower);
        integer_set_pair(&z->upper, integer_get_pair(&x->upper) + integer_get_pair(&y->upper));
        integer_set_pair(&z->lower, lower);
        grid_finish(z, prec, true);
        return;
    }
#endif
    grid_finish(z, prec, integer_add(&z->lower, &x->lower, &y->lower) && integer_add(&z->upper, &x->upper, &y->upper));
}

void grid_sub(grid *z, const grid *x, const grid *y, long prec)
{
    if (!grid_ready(x, prec) || !grid_ready(y, prec)) {
        grid_on_grid(z, x, y, prec, grid_sub);
        return;
    }
#if LIMB_INT128
    if (are_short(x, y)) {
        limb_signed_pair_t lower = integer_get_pair(&x->lower) - integer_get_pair(&y->upper);
        integer_set_pair(&z->upper, integer_get_pair(&x->upper) - integer_get_pair(&y->lower));
        integer_set_pair(&z->lower, lower);
        grid_finish(z, prec, true);
        return;
    }
#endif
    integer t;
    integer_init(&t);
    bool ok = integer_sub(&t, &x->lower, &y->upper) && integer_sub(&z->upper, &x->upper, &y->lower);
    integer_swap(&z->lower, &t);
    integer_clear(&t);
    grid_finish(z, prec, ok);
}

/* ---- sets ---- */

static bool set_extreme(integer *z, const integer *x, const integer *y, bool greater)
{
    return integer_set(z, (integer_cmp(x, y) > 0) == greater ? x : y);
}

static void combine(grid *z, const grid *x, const grid *y, bool lower_greater, bool upper_greater, long prec)
{
    grid s, t;
    grid_init(&s);
    grid_init(&t);
    bool sok = grid_move(&s, x, prec), tok = grid_move(&t, y, prec);
    if (sok && tok) {
        bool ok = set_extreme(&s.lower, &s.lower, &t.lower, lower_greater)
                  && set_extreme(&s.upper, &s.upper, &t.upper, upper_greater);
        grid_finish(&s, prec, ok);
        if (ok && integer_cmp(&s.lower, &s.upper) > 0)
            grid_indeterminate(&s);
        grid_swap(z, &s);
    } else
        grid_indeterminate_like(z, &s, &t);
    grid_clear(&s);
    grid_clear(&t);
}

void grid_hull(grid *z, const grid *x, const grid *y, long prec) { combine(z, x, y, false, true, prec); }
void grid_min(grid *z, const grid *x, const grid *y, long prec) { combine(z, x, y, false, false, prec); }
void grid_max(grid *z, const grid *x, const grid *y, long prec) { combine(z, x, y, true, true, prec); }

void grid_intersection(grid *z, const grid *x, const grid *y, long prec)
{
    if (x->state == GRID_FINITE && y->state == GRID_FINITE)
        combine(z, x, y, true, false, prec);
    else
        (void)grid_move(z, x->state == GRID_FINITE ? x : y, prec);
}

void grid_lower(grid *z, const grid *x, long prec)
{
    if (grid_move(z, x, prec))
        grid_finish(z, prec, integer_set(&z->upper, &z->lower));
}

void grid_upper(grid *z, const grid *x, long prec)
{
    if (grid_move(z, x, prec))
        grid_finish(z, prec, integer_set(&z->lower, &z->upper));
}

void grid_midpoint(grid *z, const grid *x, long prec)
{
    if (grid_move(z, x, prec))
        grid_finish(z, prec, integer_add(&z->lower, &z->lower, &z->upper) && integer_fdiv_2exp(&z->lower, &z->lower, 1)
                                 && integer_set(&z->upper, &z->lower));
}

/* upper - midpoint >= midpoint - lower, since the midpoint was rounded down. */
void grid_radius_upper(grid *z, const grid *x, long prec)
{
    if (!grid_move(z, x, prec))
        return;
    bool ok = integer_add(&z->lower, &z->lower, &z->upper) && integer_fdiv_2exp(&z->lower, &z->lower, 1)
              && integer_sub(&z->upper, &z->upper, &z->lower) && integer_set(&z->lower, &z->upper);
    grid_finish(z, prec, ok);
}

void grid_magnitude_upper(grid *z, const grid *x, long prec)
{
    if (!grid_move(z, x, prec))
        return;
    if (integer_cmp_abs(&z->lower, &z->upper) > 0)
        integer_swap(&z->lower, &z->upper);
    grid_finish(z, prec, integer_abs(&z->upper, &z->upper) && integer_set(&z->lower, &z->upper));
}

static void widen(grid *z, const grid *x, const grid *r, long prec)
{
    integer m;
    integer_init(&m);
    bool ok = integer_abs(&m, integer_cmp_abs(&r->lower, &r->upper) > 0 ? &r->lower : &r->upper)
              && integer_sub(&z->lower, &x->lower, &m) && integer_add(&z->upper, &x->upper, &m);
    integer_clear(&m);
    grid_finish(z, prec, ok);
}

void grid_add_error(grid *z, const grid *x, const grid *r, long prec) { grid_on_grid(z, x, r, prec, widen); }
