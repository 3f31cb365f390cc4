/* trig_pi.c: exact reduction of the angle pi r, and balls around its cosine and sine. */
#include "trig_pi.h"

#include "ball.h"
#include "ball_internal.h"

/* t = r mod 2, in [0, 2) */
static bool modulo_two(rational *t, const rational *r)
{
    integer twice, rest;
    integer_init(&twice);
    integer_init(&rest);
    bool ok = integer_mul_2exp(&twice, &r->denominator, 1) && integer_fdiv_qr(NULL, &rest, &r->numerator, &twice)
              && rational_set_integers(t, &rest, &r->denominator);
    integer_clear(&twice);
    integer_clear(&rest);
    return ok;
}

/* t = p / q - t */
static bool reflect(rational *t, int64_t p, int64_t q)
{
    rational c;
    rational_init(&c);
    return rational_set_si(&c, p, q) && rational_sub(t, &c, t);
}

bool trig_pi_reduce(trig_pi *u, const rational *r, bool of_sine)
{
    u->exact = u->sine = u->negative = false;
    u->half = 0;
    rational_init(&u->t);
    if (!rational_set(&u->t, r) || (of_sine && !reflect(&u->t, 1, 2)) /* sin a = cos(pi/2 - a) */
        || !modulo_two(&u->t, &u->t))
        return false;
    if (rational_cmp_si(&u->t, 1, 1) > 0 && !reflect(&u->t, 2, 1)) /* cos(2 pi - a) = cos a */
        return false;
    if (rational_cmp_si(&u->t, 1, 2) > 0) { /* cos(pi - a) = -cos a */
        u->negative = true;
        if (!reflect(&u->t, 1, 1))
            return false;
    }
    int sign = u->negative ? -1 : 1;
    u->exact = true;
    if (rational_is_zero(&u->t))
        u->half = 2 * sign;
    else if (rational_cmp_si(&u->t, 1, 3) == 0)
        u->half = sign;
    else if (rational_cmp_si(&u->t, 1, 2) != 0)
        u->exact = false;
    if (!u->exact && rational_cmp_si(&u->t, 1, 4) > 0) {
        u->sine = true;
        return reflect(&u->t, 1, 2);
    }
    return true;
}

static void ball_trig_pi(ball *z, const rational *r, bool of_sine, long prec)
{
    trig_pi u;
    ball s, c, angle;
    ball_init(&s);
    ball_init(&c);
    ball_init(&angle);
    if (!trig_pi_reduce(&u, r, of_sine))
        ball_no_memory(z);
    else if (u.exact) {
        ball_set_si(z, u.half, prec);
        ball_mul_2exp(z, z, -1, prec);
    } else {
        ball_set_rational(&c, &u.t, prec + 20);
        ball_pi(&angle, prec + 20);
        ball_mul(&angle, &angle, &c, prec + 20);
        ball_sin_cos(&s, &c, &angle, prec + 8);
        ball_set_round(z, u.sine ? &s : &c, prec);
        if (u.negative)
            ball_neg(z, z);
    }
    rational_clear(&u.t);
    ball_clear(&s);
    ball_clear(&c);
    ball_clear(&angle);
}

void ball_cos_pi(ball *z, const rational *r, long prec) { ball_trig_pi(z, r, false, prec); }
void ball_sin_pi(ball *z, const rational *r, long prec) { ball_trig_pi(z, r, true, prec); }
