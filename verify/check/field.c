/* Fields of cosines: section 2 of exact.md. */

#include "field.h"

#include "answer.h"

#include <string.h>

/* The field
 * --------- */

/* The sign of Moebius' function. */
static int moebius(int a)
{
    int out = 1;

    for (int p = 2; p <= a; p++) {
        if (a % p != 0)
            continue;
        a /= p;
        if (a % p == 0)
            return 0;
        out = -out;
    }
    return out;
}

/* The degree of Phi_2n is the sum of moebius(2n/e) e over the divisors e. */
int field_degree(int n)
{
    int sum = 0;

    for (int e = 1; e <= 2 * n; e++)
        if (2 * n % e == 0)
            sum += moebius(2 * n / e) * e;
    return sum / 2;
}

/* Phi_2n up to z^d, as the product of (1 - z^e)^moebius(2n/e) over the divisors e of 2n; the
 * rest of it mirrors that.  (No minus signs get lost: there are as many factors above as below.) */
static void find_cyclotomic(int64_t out[MAX_DEGREE + 1], const struct field *k)
{
    memset(out, 0, (MAX_DEGREE + 1) * sizeof out[0]);
    out[0] = 1;
    for (int e = 1; e <= 2 * k->n; e++) {
        int sign = 2 * k->n % e == 0 ? moebius(2 * k->n / e) : 0;

        for (int i = k->degree; sign > 0 && i >= e; i--)
            out[i] -= out[i - e];
        for (int i = e; sign < 0 && i <= k->degree; i++)
            out[i] += out[i - e];
    }
}

/* Psi = c_0 + sum of c_i V_i, c_i the coefficient of z^(d-i) in Phi_2n.  The coefficients of all
 * V_i here are below 2^45, and those of Phi_2n tiny. */
void field_make(struct field *out, int n)
{
    int64_t phi[MAX_DEGREE + 1], sum[MAX_DEGREE + 1] = { 0 };
    int64_t v[MAX_DEGREE + 1] = { 2 }, next[MAX_DEGREE + 2] = { 0, 1 };

    memset(out, 0, sizeof *out);
    out->n = n;
    out->degree = field_degree(n);
    find_cyclotomic(phi, out);
    sum[0] = phi[out->degree];
    for (int i = 1; i <= out->degree; i++) {
        for (int j = 0; j <= i; j++)
            sum[j] += phi[out->degree - i] * next[j];
        for (int j = i + 1; j >= 0; j--) {         /* V_(i+1) = x V_i - V_(i-1) */
            int64_t new = (j > 0 ? next[j - 1] : 0) - (j < i ? v[j] : 0);

            if (j <= i)
                v[j] = next[j];
            if (j <= MAX_DEGREE)
                next[j] = new;
        }
    }
    for (int i = 0; i <= out->degree; i++)
        out->minimal[i] = integer_from(sum[i]);
}

/* Numbers
 * ------- */

void number_keep(struct mark mark, struct number *numbers, size_t count)
{
    enum { PARTS = MAX_DEGREE + 1 };

    _Static_assert(sizeof *numbers == PARTS * sizeof(integer), "a number is integers only");
    integer_keep(mark, (integer *)numbers, PARTS * count);
}

/* In lowest terms. */
static void cancel(struct number *a)
{
    integer gcd = a->den;

    for (int i = 0; i < MAX_DEGREE && integer_bits(gcd) > 1; i++)
        if (a->part[i].sign != 0)
            gcd = integer_gcd(gcd, a->part[i]);
    if (integer_bits(gcd) > 1) {
        a->den = integer_divide_floor(a->den, gcd);          /* exact */
        for (int i = 0; i < MAX_DEGREE; i++)
            if (a->part[i].sign != 0)
                a->part[i] = integer_divide_floor(a->part[i], gcd);
    }
    for (int i = -1; i < MAX_DEGREE; i++)
        if (integer_bits(i < 0 ? a->den : a->part[i]) > RATIONAL_BITS)
            cannot_check("an exact number of more than %d bits occurs", RATIONAL_BITS);
}

struct number number_from(rational q)
{
    struct number out;

    memset(&out, 0, sizeof out);                   /* zeroed memory is 0 */
    out.part[0] = q.num;
    out.den = q.den;
    return out;
}

struct number number_from_whole(int64_t a)
{
    return number_from((rational) { integer_from(a), integer_from(1) });
}

struct number number_of(const integer *part, integer den, const struct field *k)
{
    struct number out = number_from((rational) { integer_from(0), den });

    for (int i = 0; i < k->degree; i++)
        out.part[i] = part[i];
    cancel(&out);
    return out;
}

struct number number_add(const struct number *a, const struct number *b)
{
    struct mark mark = scratch_mark();
    bool same = integer_compare(a->den, b->den) == 0;
    struct number out = *a;

    if (!same)
        out.den = integer_mul(a->den, b->den);
    for (int i = 0; i < MAX_DEGREE; i++) {
        if (a->part[i].sign == 0 && b->part[i].sign == 0)
            continue;
        out.part[i] = same ? integer_add(a->part[i], b->part[i])
                           : integer_add(integer_mul(a->part[i], b->den),
                                         integer_mul(b->part[i], a->den));
    }
    cancel(&out);
    number_keep(mark, &out, 1);
    return out;
}

struct number number_minus(const struct number *a)
{
    struct number out = *a;

    for (int i = 0; i < MAX_DEGREE; i++)
        out.part[i] = integer_negate(a->part[i]);
    return out;
}

struct number number_sub(const struct number *a, const struct number *b)
{
    struct number minus = number_minus(b);

    return number_add(a, &minus);
}

struct number number_mul(const struct number *a, const struct number *b, const struct field *k)
{
    struct mark mark = scratch_mark();
    struct number out = number_from_whole(0);
    integer product[2 * MAX_DEGREE];
    int d = k->degree;

    memset(product, 0, sizeof product);
    for (int i = 0; i < d; i++)
        for (int j = 0; j < d && a->part[i].sign != 0; j++)
            if (b->part[j].sign != 0)
                product[i + j] = integer_add(product[i + j], integer_mul(a->part[i], b->part[j]));
    for (int i = 2 * d - 2; i >= d; i--)           /* theta^d = - Psi_0 - Psi_1 theta ... */
        for (int j = 0; j < d && product[i].sign != 0; j++)
            if (k->minimal[j].sign != 0)
                product[i - d + j] = integer_sub(product[i - d + j],
                                                 integer_mul(product[i], k->minimal[j]));
    memcpy(out.part, product, (size_t)d * sizeof product[0]);
    out.den = integer_mul(a->den, b->den);
    cancel(&out);
    number_keep(mark, &out, 1);
    return out;
}

void number_add_product(struct number *sum, const struct number *a, const struct number *b,
                        const struct field *k)
{
    struct number product;

    if (number_is_zero(a) || number_is_zero(b))
        return;
    product = number_mul(a, b, k);
    *sum = number_is_zero(sum) ? product : number_add(sum, &product);
}

struct number number_scale(rational q, const struct number *a, const struct field *k)
{
    struct number factor = number_from(q);

    return number_mul(&factor, a, k);
}

bool number_is_zero(const struct number *a)
{
    for (int i = 0; i < MAX_DEGREE; i++)
        if (a->part[i].sign != 0)
            return false;
    return true;
}

bool number_get_rational(rational *out, const struct number *a)
{
    for (int i = 1; i < MAX_DEGREE; i++)
        if (a->part[i].sign != 0)
            return false;
    *out = (rational) { a->part[0], a->den };
    return true;
}

/* V_i(theta), from V_0 = 2 and V_(-1) = V_1 = theta on */
static struct number chebyshev(int i, const struct field *k)
{
    struct number last, theta = number_from_whole(0), here = number_from_whole(2);

    if (k->degree > 1)
        theta.part[1] = integer_from(1);
    else                                           /* Psi = x - theta */
        theta.part[0] = integer_negate(k->minimal[0]);
    last = theta;
    for (; i > 0; i--) {
        struct number next = number_mul(&theta, &here, k);

        next = number_sub(&next, &last);
        last = here;
        here = next;
    }
    return here;
}

/* V has the period 2n, and is even. */
bool number_cos_pi(struct number *out, rational q, const struct field *k)
{
    rational n = rational_from(k->n, 1), period = rational_from(2 * k->n, 1), place, turns;
    int64_t i;

    place = rational_mul(n, q);
    if (!rational_is_whole(place))
        return false;
    turns = rational_floor(rational_divide(place, period));
    place = rational_sub(place, rational_mul(turns, period));
    if (!integer_get_small(&i, place.num, 2 * MAX_FIELD))
        return false;
    *out = chebyshev((int)(i > k->n ? 2 * k->n - i : i), k);
    *out = number_scale(rational_from(1, 2), out, k);
    return true;
}

interval number_enclose(const struct number *a, const struct field *k, int g)
{
    struct mark mark = scratch_mark();
    interval c = grid_cos_pi(rational_from(1, k->n), g), t = interval_add(c, c), z;

    z = grid_from_fraction(a->part[k->degree - 1], a->den, g);
    for (int i = k->degree - 2; i >= 0; i--)
        z = interval_add(grid_mul(z, t, g), grid_from_fraction(a->part[i], a->den, g));
    interval_keep(mark, &z, 1);
    return z;
}
