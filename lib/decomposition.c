/* decomposition.c: division of a - b, on sector 0, turned to the other pairs of directions. */
#include "decomposition.h"

/* f = part[0] (z^-direction[0] - 1) + part[1] (z^-direction[1] - 1). */
typedef struct {
    laurent part[2];
    lattice direction[2];
} division;

static void division_init(division *z)
{
    laurent_init(&z->part[0]);
    laurent_init(&z->part[1]);
    z->direction[0] = (lattice){1, 0};
    z->direction[1] = (lattice){0, -1}; /* the thesis's lattice has the edges (1,0), (0,1), (1,1): its b is our -b */
}

static void division_clear(division *z)
{
    laurent_clear(&z->part[0]);
    laurent_clear(&z->part[1]);
}

/* Adds the coefficients of f at low_a..high_a, low_b..high_b to sum. */
static bool add_rectangle(integer *sum, const laurent *f, long low_a, long high_a, long low_b, long high_b)
{
    bool ok = true;
    for (long a = low_a; ok && a <= high_a; a++)
        for (long b = low_b; ok && b <= high_b; b++) {
            const integer *c = laurent_at(f, a, b);
            ok = !c || integer_add(sum, sum, c);
        }
    return ok;
}

/* Polynomial division of f, f(1,1) = 0, by z1^-1 - 1 leaves a remainder in z2 alone times the lowest power of z1, which
   z2 - 1 divides; and the other way round.  This is the mean of both.  A quotient is a sum of coefficients along a line:
   p(a + 1) - p(a) = f(a) if f = p (z1^-1 - 1); towards z2^-1 (powers of the thesis's z2) alike. */
static bool divide(division *z, const laurent *f, const laurent_extent *e)
{
    long low_a = e->low[0], high_a = e->high[0], low_b = e->low[1], high_b = e->high[1];
    bool ok = true;
    for (int i = 0; ok && i < 2; i++) {
        laurent *p = &z->part[i];
        ok = laurent_set_box(p, low_a, low_b, high_a - low_a + 1, high_b - low_b + 1)
             && integer_mul_si(&p->denominator, &f->denominator, 2);
    }
    for (long a = low_a; ok && a <= high_a; a++)
        for (long b = low_b; ok && b <= high_b; b++) {
            long at = (a - low_a) * z->part[0].nb + b - low_b;
            integer *p = &z->part[0].coefficient[at], *q = &z->part[1].coefficient[at];
            ok = (a == low_a || add_rectangle(p, f, a, high_a, b, b)) && integer_neg(p, p)
                 && (b < high_b || add_rectangle(p, f, low_a, a - 1, low_b, high_b))
                 && (b == high_b || add_rectangle(q, f, a, a, low_b, b)) && integer_neg(q, q)
                 && (a > low_a || add_rectangle(q, f, low_a, high_a, b + 1, high_b));
        }
    return ok;
}

/* z = x (z^-d - 1). */
static bool multiply_by_difference(laurent *z, const laurent *x, lattice d)
{
    laurent shifted;
    bool ok;
    laurent_init(&shifted);
    ok = laurent_set(&shifted, x);
    shifted.a0 -= d.a;
    shifted.b0 -= d.b;
    ok = ok && laurent_sub(z, &shifted, x);
    laurent_clear(&shifted);
    return ok;
}

static bool is_zero(const laurent *x)
{
    for (long i = 0; i < x->na * x->nb; i++)
        if (!integer_is_zero(&x->coefficient[i]))
            return false;
    return true;
}

/* Is e = sum of b part[i] (z^-direction[i] - 1)? */
static bool check(bool *identity, const division *z, const laurent *e, const laurent *b)
{
    laurent rest, t;
    bool ok;
    laurent_init(&rest);
    laurent_init(&t);
    ok = laurent_set(&rest, e);
    for (int i = 0; ok && i < 2; i++)
        ok = laurent_mul(&t, &z->part[i], b) && multiply_by_difference(&t, &t, z->direction[i]) && laurent_sub(&rest, &rest, &t);
    *identity = *identity && ok && is_zero(&rest);
    laurent_clear(&rest);
    laurent_clear(&t);
    return ok;
}

/* Turns f by one sector of the regular complex: a sum of terms in z^p becomes the same in z^(turned p). */
static bool rotate(laurent *z)
{
    long low_a = -(z->b0 + z->nb - 1), low_b = z->a0 + z->b0; /* (a,b) -> (-b, a + b) */
    laurent t;
    bool ok = true;
    laurent_init(&t);
    ok = laurent_set_box(&t, low_a, low_b, z->nb, z->na ? z->na + z->nb - 1 : 0) && integer_set(&t.denominator, &z->denominator);
    for (long i = 0; ok && i < z->na * z->nb; i++) {
        lattice p = mesh_rotate_mask(MESH_TRIANGLE, (lattice){(int)(z->a0 + i / z->nb), (int)(z->b0 + i % z->nb)});
        integer_swap(&t.coefficient[(p.a - low_a) * t.nb + p.b - low_b], &z->coefficient[i]);
    }
    laurent_swap(z, &t);
    laurent_clear(&t);
    return ok;
}

static bool division_rotate(division *z)
{
    for (int i = 0; i < 2; i++)
        z->direction[i] = mesh_rotate_mask(MESH_TRIANGLE, z->direction[i]);
    return rotate(&z->part[0]) && rotate(&z->part[1]);
}

/* printed = sum of |S_(b part)|, proved = sum of |S_(b_d part)|, b_d = b / (1 + z^-d). */
static bool constants(rational *printed, rational *proved, const division *z, const laurent *b)
{
    laurent product, divided;
    rational norm;
    bool ok = rational_set_si(printed, 0, 1) && rational_set_si(proved, 0, 1), exact = true;
    laurent_init(&product);
    laurent_init(&divided);
    rational_init(&norm);
    for (int i = 0; ok && i < 2; i++)
        ok = laurent_mul(&product, &z->part[i], b) && laurent_class_norm(&norm, &product, 2) && rational_add(printed, printed, &norm)
             && laurent_divide_binomial(&divided, &exact, b, z->direction[i]) && laurent_mul(&product, &z->part[i], &divided)
             && laurent_class_norm(&norm, &product, 2) && rational_add(proved, proved, &norm);
    laurent_clear(&product);
    laurent_clear(&divided);
    rational_clear(&norm);
    return ok;
}

/* z = x divided by 1 + z^-d for all three directions. */
static bool divide_thrice(laurent *z, bool *identity, const laurent *x)
{
    bool ok = laurent_set(z, x), exact;
    for (int i = 0; ok && i < 3; i++) {
        ok = laurent_divide_binomial(z, &exact, z, regular_direction[i]);
        *identity = *identity && exact;
    }
    return ok;
}

/* f = (a - b) / b: both are divisible by the three binomials, and what is left of b is z^p / 2. */
static bool quotient(laurent *f, bool *identity, const laurent *e, const laurent *b)
{
    laurent unit;
    laurent_extent at;
    bool ok;
    laurent_init(&unit);
    ok = divide_thrice(&unit, identity, b) && divide_thrice(f, identity, e) && laurent_mul_si(f, f, 2);
    if (ok) {
        at = laurent_get_extent(&unit);
        f->a0 -= at.low[0];
        f->b0 -= at.low[1];
    }
    laurent_clear(&unit);
    return ok;
}

void decomposition_init(decomposition *z)
{
    comparison_init(&z->printed);
    comparison_init(&z->proved);
    z->identity = false;
}

void decomposition_clear(decomposition *z)
{
    comparison_clear(&z->printed);
    comparison_clear(&z->proved);
}

/* e = S_a - S_b for values or a derivative, b the latter's mask. */
static bool check_and_measure(rational *printed, rational *proved, bool *identity, const division *d, const laurent *a, const laurent *b)
{
    laurent e;
    bool ok;
    laurent_init(&e);
    ok = laurent_sub(&e, a, b) && check(identity, d, &e, b) && constants(printed, proved, d, b);
    laurent_clear(&e);
    return ok;
}

static bool divide_difference(division *d, bool *identity, const laurent *a, const laurent *b)
{
    laurent e, f;
    bool ok;
    laurent_init(&e);
    laurent_init(&f);
    ok = laurent_sub(&e, a, b) && quotient(&f, identity, &e, b);
    if (ok && !is_zero(&f)) {
        laurent_extent extent = laurent_get_extent(&f);
        ok = divide(d, &f, &extent);
    }
    laurent_clear(&e);
    laurent_clear(&f);
    return ok;
}

/* Turned once, the directions (1,0) and (0,-1) are (0,1) and (1,-1), those of the first derivative; turned twice, up to
   sign those of the second, (1,-1) and (1,0). */
bool decomposition_make(decomposition *z, const laurent *mask, const regular_masks *masks)
{
    division d;
    laurent b;
    bool ok;
    division_init(&d);
    laurent_init(&b);
    z->identity = true;
    ok = comparison_values(&b, MESH_TRIANGLE) && divide_difference(&d, &z->identity, mask, &b)
         && check_and_measure(&z->printed.values, &z->proved.values, &z->identity, &d, mask, &b);
    for (int i = 0; ok && i < 2; i++)
        ok = division_rotate(&d) && comparison_derivative(&b, MESH_TRIANGLE, i)
             && check_and_measure(&z->printed.derivative[i], &z->proved.derivative[i], &z->identity, &d, &masks->derivative[i], &b);
    laurent_clear(&b);
    division_clear(&d);
    return ok;
}
