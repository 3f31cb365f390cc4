/* regular.c: difference masks by division, norms by classes. */
#include "regular.h"

#include "power.h"

const lattice regular_direction[3] = {{1, 0}, {0, 1}, {1, -1}};

void regular_init(regular_masks *z)
{
    for (int i = 0; i < 2; i++)
        laurent_init(&z->derivative[i]);
    for (int i = 0; i < 3; i++)
        laurent_init(&z->second[i]);
    z->mesh = MESH_TRIANGLE;
    z->divisible = z->symmetric = false;
}

void regular_clear(regular_masks *z)
{
    for (int i = 0; i < 2; i++)
        laurent_clear(&z->derivative[i]);
    for (int i = 0; i < 3; i++)
        laurent_clear(&z->second[i]);
}

regular_pair regular_get_directions(mesh_kind mesh, int i)
{
    static const regular_pair triangle[3] = {{{0, 1}, {0, 0}}, {{0, 2}, {1, 1}}, {{1, 2}, {2, 2}}};
    static const regular_pair quad[3] = {{{0, 0}, {0, 0}}, {{0, 1}, {1, 1}}, {{1, 1}, {2, 2}}};
    return mesh == MESH_TRIANGLE ? triangle[i] : quad[i];
}

regular_pair regular_get_pair(mesh_kind mesh, int derivative)
{
    static const regular_pair triangle[2] = {{{1, 2}, {0, 1}}, {{0, 2}, {0, 2}}};
    static const regular_pair quad[2] = {{{0, 1}, {0, 1}}, {{0, 1}, {1, 2}}};
    return mesh == MESH_TRIANGLE ? triangle[derivative] : quad[derivative];
}

/* z = a / (1 + z^-d), or leaves *divisible false. */
static bool difference_mask(laurent *z, bool *divisible, const laurent *a, lattice d)
{
    bool exact;
    if (!laurent_divide_binomial(z, &exact, a, d))
        return false;
    *divisible = *divisible && exact;
    return true;
}

static bool is_symmetric(const laurent *mask)
{
    for (long i = 0; i < mask->na * mask->nb; i++) {
        long a = mask->a0 + i / mask->nb, b = mask->b0 + i % mask->nb;
        const integer *mirrored = laurent_at(mask, b, a);
        if (mirrored ? integer_cmp(mirrored, &mask->coefficient[i]) != 0 : !integer_is_zero(&mask->coefficient[i]))
            return false;
    }
    return true;
}

bool regular_derive(regular_masks *z, const laurent *mask, mesh_kind mesh)
{
    bool ok = true;
    z->mesh = mesh;
    z->divisible = true;
    z->symmetric = is_symmetric(mask);
    for (int i = 0; ok && i < 2; i++)
        ok = difference_mask(&z->derivative[i], &z->divisible, mask, regular_direction[i])
             && laurent_mul_si(&z->derivative[i], &z->derivative[i], 2);
    for (int i = 0; ok && i < 3; i++) { /* 2 a_d is there already: dividing it gives 2 a_dd' */
        regular_pair p = regular_get_directions(mesh, i);
        ok = difference_mask(&z->second[i], &z->divisible, &z->derivative[p.direction[0]], regular_direction[p.direction[1]]);
    }
    return ok;
}

/* ---- norms ---- */

void norm_list_init(norm_list *z)
{
    z->count = 0;
    for (int i = 0; i <= REGULAR_MAX_POWER; i++)
        rational_init(&z->norm[i]);
}

void norm_list_clear(norm_list *z)
{
    for (int i = 0; i <= REGULAR_MAX_POWER; i++)
        rational_clear(&z->norm[i]);
    z->count = 0;
}

int norm_list_first_contraction(const norm_list *z)
{
    for (int n = 1; n <= z->count; n++)
        if (rational_cmp_si(&z->norm[n], 1, 1) < 0)
            return n;
    return 0;
}

static bool is_finished(const norm_list *z, int most, bool contracting)
{
    return z->count >= most || (contracting && norm_list_first_contraction(z) > 0);
}

/* The cost of the last product: the terms of s times the box of s^(N-1), which is about 2^(N-1) times as wide. */
static bool is_affordable(const laurent *s, int exponent)
{
    double size = (double)s->na * (double)s->nb;
    return exponent <= REGULAR_MAX_LONG_POWER && size * size * (double)(1L << 2 * (exponent - 1)) <= REGULAR_MAX_WORK;
}

/* Goes on where words were too short: s^N(z) = s(z) s(z^2) ... s(z^(2^(N-1))) with integers of any length. */
static bool add_long_norms(norm_list *z, const laurent *s, int most, bool contracting)
{
    laurent product, factor;
    bool ok;
    laurent_init(&product);
    laurent_init(&factor);
    ok = laurent_set(&product, s);
    for (int n = 1; ok && !is_finished(z, most, contracting) && is_affordable(s, n); n++) {
        if (n > 1)
            ok = laurent_stretch(&factor, s, 1L << (n - 1)) && laurent_mul(&product, &factor, &product);
        if (ok && n == z->count + 1)
            ok = laurent_class_norm(&z->norm[++z->count], &product, 1L << n);
    }
    laurent_clear(&product);
    laurent_clear(&factor);
    return ok;
}

bool norm_list_make(norm_list *z, const laurent *s, int most, bool contracting)
{
    mask_power p;
    power_status status;
    bool ok = rational_set_si(&z->norm[0], 1, 1);
    z->count = 0;
    most = most < REGULAR_MAX_POWER ? most : REGULAR_MAX_POWER;
    power_init(&p);
    status = power_start(&p, s, false);
    while (ok && status == POWER_OK && !is_finished(z, most, contracting) && (status = power_raise(&p)) == POWER_OK)
        ok = power_norm(&z->norm[++z->count], &p);
    power_clear(&p);
    if (ok && status == POWER_TOO_LARGE)
        ok = add_long_norms(z, s, most, contracting);
    return ok && status != POWER_NO_MEMORY;
}

bool regular_norm(rational *norm, const laurent *s, int power)
{
    norm_list norms;
    bool ok;
    norm_list_init(&norms);
    ok = norm_list_make(&norms, s, power, false) && norms.count == power && rational_set(norm, &norms.norm[power]);
    norm_list_clear(&norms);
    return ok;
}

/* z = the larger norms of both, as far as both go. */
static bool join(norm_list *z, const norm_list *x)
{
    bool ok = true;
    z->count = x->count < z->count ? x->count : z->count;
    for (int n = 0; ok && n <= z->count; n++)
        if (rational_cmp(&z->norm[n], &x->norm[n]) < 0)
            ok = rational_set(&z->norm[n], &x->norm[n]);
    return ok;
}

bool regular_contraction_list(norm_list *z, const regular_masks *masks, int derivative)
{
    regular_pair p = regular_get_pair(masks->mesh, derivative > 0);
    const laurent *x = derivative < 0 ? &masks->derivative[0] : &masks->second[p.second[0]];
    const laurent *y = derivative < 0 ? &masks->derivative[1] : &masks->second[p.second[1]];
    norm_list other;
    bool ok;
    norm_list_init(&other);
    ok = norm_list_make(z, x, REGULAR_MAX_POWER, false) && norm_list_make(&other, y, REGULAR_MAX_POWER, false) && join(z, &other);
    for (int n = 1; ok && derivative < 0 && n <= z->count; n++) /* a_d is half of 2 a_d */
        ok = rational_mul_2exp(&z->norm[n], &z->norm[n], -n);
    norm_list_clear(&other);
    return ok;
}

bool regular_contraction(int power[3], rational norm[3], const regular_masks *masks)
{
    bool ok = true;
    norm_list norms;
    norm_list_init(&norms);
    for (int i = 0; ok && i < 3; i++) {
        power[i] = 0;
        ok = !masks->divisible || norm_list_make(&norms, &masks->second[i], REGULAR_MAX_POWER, true);
        if (ok && masks->divisible)
            power[i] = norm_list_first_contraction(&norms);
        if (ok && power[i])
            ok = rational_set(&norm[i], &norms.norm[power[i]]);
    }
    norm_list_clear(&norms);
    return ok;
}
