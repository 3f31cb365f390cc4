/* grid_trig.c: the least grid intervals around pi, cos(pi r) and sin(pi r).

   The value is enclosed in balls of growing precision until its floor and ceiling on the grid are decided
   (Ziv).  An irrational value is never on the grid, so this ends; the rational values are known exactly. */
#include "ball.h"
#include "grid.h"
#include "grid_internal.h"

typedef void (*enclosure)(ball *z, const rational *r, long prec);

static void pi_of(ball *z, const rational *r, long prec)
{
    (void)r;
    ball_pi(z, prec);
}

/* Is the ball inside one cell of the grid?  Then z is that cell. */
static bool decided(grid *z, const ball *x, long g)
{
    grid_set_ball(z, x, g);
    if (!grid_is_finite(z))
        return true;
    integer width;
    integer_init(&width);
    bool ok = integer_sub(&width, &z->upper, &z->lower);
    bool narrow = ok && integer_cmp_si(&width, 1) <= 0;
    integer_clear(&width);
    if (!ok)
        grid_no_memory(z);
    return !ok || narrow;
}

/* The value is irrational and below 4 in absolute value. */
static void ziv(grid *z, const rational *r, long g, enclosure f)
{
    if (!grid_exponent_ok(g)) {
        grid_indeterminate(z);
        return;
    }
    ball x;
    ball_init(&x);
    for (long prec = (g > 0 ? g : 0) + 32;; prec += prec / 2) {
        f(&x, r, prec);
        if (decided(z, &x, g))
            break;
        if (prec > BALL_MAX_PRECISION) { /* the precision does not grow further: give up */
            grid_indeterminate(z);
            break;
        }
    }
    ball_clear(&x);
}

void grid_pi(grid *z, long prec) { ziv(z, NULL, prec, pi_of); }

/* Where the value is 0, +-1/2, +-1 the ball is exact, whatever its precision. */
static void exact_or_ziv(grid *z, const rational *r, long prec, enclosure f)
{
    ball x;
    ball_init(&x);
    f(&x, r, 64);
    if (ball_is_thin(&x))
        grid_set_ball(z, &x, prec);
    else
        ziv(z, r, prec, f);
    ball_clear(&x);
}

void grid_cos_pi(grid *z, const rational *r, long prec) { exact_or_ziv(z, r, prec, ball_cos_pi); }
void grid_sin_pi(grid *z, const rational *r, long prec) { exact_or_ziv(z, r, prec, ball_sin_pi); }
