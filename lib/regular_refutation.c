/* regular_refutation.c: recurrences of limits, and where their roots lie (proof: lib/regular_refutation.md). */
#include "regular_refutation.h"

#include <stdlib.h>
#include <string.h>

enum { MAX_REACH = 8, MAX_DEGREE = 40 };
/* In units of about a nanosecond. */
#define MAX_WORK 1e9
/* Moduli are sought up to this one. */
#define MAX_MODULUS ((int64_t)64 * REFUTATION_UNIT)

/* Trouble is sticky: all routines do nothing once it is there. */
typedef struct {
    bool no_memory, too_long;
    double work;
} effort;

static bool goes_on(const effort *e)
{
    return !e->no_memory && !e->too_long;
}

static void need(effort *e, bool memory)
{
    e->no_memory = e->no_memory || !memory;
}

static void spend(effort *e, double work)
{
    e->work += work;
    e->too_long = e->too_long || e->work > MAX_WORK;
}

static double cost_of_product(const integer *x, const integer *y)
{
    return 40 + 2.0 * ((double)integer_bits(x) / 64 + 1) * ((double)integer_bits(y) / 64 + 1);
}

static integer *new_vector(int n, effort *e)
{
    integer *z = calloc((size_t)n + 1, sizeof *z);
    need(e, z != NULL);
    for (int i = 0; z && i < n; i++)
        integer_init(&z[i]);
    return z;
}

static void free_vector(integer *z, int n)
{
    for (int i = 0; z && i < n; i++)
        integer_clear(&z[i]);
    free(z);
}

/* Divides by the greatest common divisor. */
static void remove_content(integer *v, int n, effort *e)
{
    integer content;
    integer_init(&content);
    for (int i = 0; i < n && goes_on(e) && !integer_is_one(&content); i++)
        if (!integer_is_zero(&v[i])) {
            need(e, integer_gcd(&content, &content, &v[i]));
            spend(e, cost_of_product(&content, &v[i]));
        }
    for (int i = 0; i < n && goes_on(e) && !integer_is_zero(&content) && !integer_is_one(&content); i++) {
        need(e, integer_divexact(&v[i], &v[i], &content));
        spend(e, cost_of_product(&content, &v[i]));
    }
    integer_clear(&content);
}

/* ---- linear dependence ---- */

/* Vectors added so far, in echelon form; behind the `length` entries of each stand its coordinates in the vectors as they
   were given. */
typedef struct {
    int length, most;
    int given, count;
    integer **row; /* `most` of them */
    int *pivot;
} echelon;

static void echelon_init(echelon *z, int length, int most, effort *e)
{
    z->length = length;
    z->most = most;
    z->given = z->count = 0;
    z->row = calloc((size_t)most + 1, sizeof *z->row);
    z->pivot = calloc((size_t)most + 1, sizeof *z->pivot);
    need(e, z->row && z->pivot);
}

static void echelon_clear(echelon *z)
{
    for (int i = 0; z->row && i < z->count; i++)
        free_vector(z->row[i], z->length + z->most);
    free(z->row);
    free(z->pivot);
}

/* v = v * row[pivot] - row * v[pivot], after dividing these two by what they have in common. */
static void eliminate(integer *v, const integer *row, int pivot, int n, effort *e)
{
    integer common, x, y;
    integer_init(&common);
    integer_init(&x);
    integer_init(&y);
    need(e, integer_gcd(&common, &v[pivot], &row[pivot]) && integer_divexact(&x, &row[pivot], &common) && integer_divexact(&y, &v[pivot], &common));
    for (int i = 0; i < n && goes_on(e); i++) {
        if (integer_is_zero(&v[i]) && integer_is_zero(&row[i]))
            continue;
        need(e, integer_mul(&v[i], &v[i], &x) && integer_submul(&v[i], &row[i], &y));
        spend(e, cost_of_product(&v[i], &x) + cost_of_product(&row[i], &y));
    }
    integer_clear(&common);
    integer_clear(&x);
    integer_clear(&y);
}

/* Adds v[0..length).  true: it depends on the ones before; then relation[i] v_i adds up to 0, i <= given - 1, with
   relation[given - 1] not 0. */
static bool echelon_add(echelon *z, const integer *v, integer *relation, effort *e)
{
    int n = z->length + z->most, pivot = 0;
    integer *w = new_vector(n, e);
    bool depends = false;
    if (!w)
        return false;
    for (int i = 0; i < z->length && goes_on(e); i++)
        need(e, integer_set(&w[i], &v[i]));
    integer_set_si(&w[z->length + z->given++], 1);
    for (int i = 0; i < z->count && goes_on(e); i++)
        if (!integer_is_zero(&w[z->pivot[i]]))
            eliminate(w, z->row[i], z->pivot[i], n, e);
    remove_content(w, n, e);
    while (pivot < z->length && integer_is_zero(&w[pivot]))
        pivot++;
    if (!goes_on(e) || pivot == z->length) {
        depends = goes_on(e);
        for (int i = 0; depends && i < z->given; i++)
            integer_swap(&relation[i], &w[z->length + i]);
        free_vector(w, n);
        return depends;
    }
    z->pivot[z->count] = pivot;
    z->row[z->count++] = w;
    return false;
}

/* ---- values of the limit at whole places ---- */

/* phi at (a,b), |a|, |b| <= MAX_REACH, up to one factor: zero outside. */
typedef struct {
    mesh_kind mesh;
    int reach;
    integer value[2 * MAX_REACH + 1][2 * MAX_REACH + 1];
} whole_values;

static const integer *phi_at(const whole_values *z, lattice p)
{
    static const integer zero;
    return abs(p.a) > MAX_REACH || abs(p.b) > MAX_REACH ? &zero : &z->value[p.a + MAX_REACH][p.b + MAX_REACH];
}

/* Which points have their images under rotation in common: one number for each orbit of those with a reach below z->reach. */
static int number_orbits(int orbit[2 * MAX_REACH + 1][2 * MAX_REACH + 1], lattice *first, mesh_kind mesh, int reach)
{
    int count = 0;
    memset(orbit, -1, (2 * MAX_REACH + 1) * sizeof *orbit);
    for (int a = -MAX_REACH; a <= MAX_REACH; a++)
        for (int b = -MAX_REACH; b <= MAX_REACH; b++) {
            lattice p = {a, b};
            if (mesh_mask_reach(mesh, p) >= reach || orbit[a + MAX_REACH][b + MAX_REACH] >= 0)
                continue;
            first[count] = p;
            for (int i = 0; i < mesh_regular_valence(mesh); i++) {
                orbit[p.a + MAX_REACH][p.b + MAX_REACH] = count;
                p = mesh_rotate_mask(mesh, p);
            }
            count++;
        }
    return count;
}

/* phi(n) = sum of a(2n - j) phi(j) determines phi at whole n up to a factor, if the solutions are a line.  The dimension of the
   solutions; 0 also if they add up to 0. */
static int find_whole_values(whole_values *z, const laurent *mask, effort *e)
{
    int orbit[2 * MAX_REACH + 1][2 * MAX_REACH + 1], lines = 0;
    lattice first[(2 * MAX_REACH + 1) * (2 * MAX_REACH + 1)];
    int count = number_orbits(orbit, first, z->mesh, z->reach);
    integer *column = new_vector(count, e), *relation = new_vector(count, e), *solution = new_vector(count, e), sum;
    echelon system;
    echelon_init(&system, count, count, e);
    integer_init(&sum);
    for (int j = 0; j < count && goes_on(e); j++) { /* what phi = 1 on orbit j contributes to each orbit, times the denominator */
        for (int n = 0; n < count && goes_on(e); n++) {
            integer_zero(&column[n]);
            if (n == j)
                need(e, integer_neg(&column[n], &mask->denominator));
            for (long i = 0; i < mask->na * mask->nb && goes_on(e); i++) {
                lattice p = {(int)(2 * first[n].a - mask->a0 - i / mask->nb), (int)(2 * first[n].b - mask->b0 - i % mask->nb)};
                if (mesh_mask_reach(z->mesh, p) < z->reach && orbit[p.a + MAX_REACH][p.b + MAX_REACH] == j)
                    need(e, integer_add(&column[n], &column[n], &mask->coefficient[i]));
            }
            spend(e, 10.0 * (double)mask->na * (double)mask->nb);
        }
        if (goes_on(e) && echelon_add(&system, column, relation, e)) {
            lines++;
            for (int i = 0; i <= j; i++)
                integer_swap(&solution[i], &relation[i]);
        }
    }
    for (int a = -MAX_REACH; a <= MAX_REACH && goes_on(e); a++)
        for (int b = -MAX_REACH; b <= MAX_REACH && goes_on(e); b++) {
            int o = orbit[a + MAX_REACH][b + MAX_REACH];
            if (o >= 0)
                need(e, integer_set(&z->value[a + MAX_REACH][b + MAX_REACH], &solution[o]) && integer_add(&sum, &sum, &solution[o]));
        }
    lines = goes_on(e) && integer_is_zero(&sum) ? 0 : lines;
    echelon_clear(&system);
    free_vector(column, count);
    free_vector(relation, count);
    free_vector(solution, count);
    integer_clear(&sum);
    return goes_on(e) ? lines : 0;
}

/* ---- functionals on nets ---- */

/* A functional on nets is a weight for each label (a,b), |a|, |b| <= span. */
static int index_of(int span, lattice p)
{
    return (p.a + span) * (2 * span + 1) + p.b + span;
}

static bool is_inside(int span, lattice p)
{
    return abs(p.a) <= span && abs(p.b) <= span;
}

/* Places turn round (0,0) also on dual meshes. */
static lattice rotate_place(mesh_kind mesh, lattice x)
{
    return mesh_rotate_mask(mesh == MESH_DUAL ? MESH_QUAD : mesh, x);
}

/* The character of a frequency: twice its cosines, or cosines where those are whole. */
static const int *character(mesh_kind mesh, int frequency)
{
    static const int six[4][6] = {{1, 1, 1, 1, 1, 1}, {2, 1, -1, -2, -1, 1}, {2, -1, -1, 2, -1, -1}, {1, -1, 1, -1, 1, -1}};
    static const int four[3][4] = {{1, 1, 1, 1}, {1, 0, -1, 0}, {1, -1, 1, -1}};
    return mesh == MESH_TRIANGLE ? six[frequency] : four[frequency];
}

/* v(p) = sum over s of character(s) f(turned x): f(x) = sum of phi(x - i) p(i). */
static void set_value_at(integer *v, int span, const whole_values *phi, lattice x, int frequency, effort *e)
{
    const int *weight = character(phi->mesh, frequency);
    integer t;
    integer_init(&t);
    for (int i = 0; i < (2 * span + 1) * (2 * span + 1); i++)
        integer_zero(&v[i]);
    for (int s = 0; s < mesh_regular_valence(phi->mesh); s++, x = rotate_place(phi->mesh, x))
        for (int a = -phi->reach; a <= phi->reach && goes_on(e); a++)
            for (int b = -phi->reach; b <= phi->reach && goes_on(e); b++) {
                lattice p = {x.a - a, x.b - b};
                const integer *value = phi_at(phi, (lattice){a, b});
                if (!integer_is_zero(value))
                    need(e, integer_mul_si(&t, value, weight[s]) && integer_add(&v[index_of(span, p)], &v[index_of(span, p)], &t));
            }
    integer_clear(&t);
}

/* z = v behind one subdivision, times the mask's denominator: z(y) = sum of v(x) a(x - 2y). */
static void pull_back(integer *z, const integer *v, int span, const laurent *mask, effort *e)
{
    for (int i = 0; i < (2 * span + 1) * (2 * span + 1); i++)
        integer_zero(&z[i]);
    for (int a = -span; a <= span; a++)
        for (int b = -span; b <= span; b++) {
            const integer *weight = &v[index_of(span, (lattice){a, b})];
            if (integer_is_zero(weight))
                continue;
            for (long i = 0; i < mask->na * mask->nb && goes_on(e); i++) {
                int twice_a = a - (int)(mask->a0 + i / mask->nb), twice_b = b - (int)(mask->b0 + i % mask->nb);
                lattice y = {twice_a / 2, twice_b / 2};
                if (twice_a % 2 || twice_b % 2 || integer_is_zero(&mask->coefficient[i]))
                    continue;
                if (!is_inside(span, y)) /* cannot be: the span is chosen so */
                    e->too_long = true;
                else
                    need(e, integer_addmul(&z[index_of(span, y)], weight, &mask->coefficient[i]));
                spend(e, cost_of_product(weight, &mask->coefficient[i]));
            }
        }
}

/* ---- polynomials ---- */

/* Divides c of degree n by y - root if it is a zero: the degree afterwards. */
static int divide_by_root(integer *c, int n, int root, effort *e)
{
    integer *quotient;
    bool divides;
    if (n < 1 || !(quotient = new_vector(n + 1, e)))
        return n;
    for (int i = n; i >= 0 && goes_on(e); i--) { /* quotient[i - 1] = c[i] + root quotient[i]; at i = 0 the value at the root */
        integer *q = i ? &quotient[i - 1] : &quotient[n];
        if (i == 0)
            integer_zero(q);
        need(e, (i == n || integer_mul_si(q, &quotient[i], root)) && integer_add(q, q, &c[i]));
    }
    divides = goes_on(e) && integer_is_zero(&quotient[n]);
    for (int i = 0; divides && i < n; i++)
        integer_swap(&c[i], &quotient[i]);
    free_vector(quotient, n + 1);
    return divides ? n - 1 : n;
}

/* Are all zeros of c, of degree n, inside the circle of the radius p / q?  (Schur and Cohn; lib/regular_refutation.md, 4.)  In
   trouble: yes, for that proves nothing. */
static bool zeros_are_inside(const integer *c, int n, int64_t p, int64_t q, effort *e)
{
    integer *x = new_vector(n + 1, e), *y = new_vector(n + 1, e);
    bool inside = true;
    for (int i = 0; i <= n && goes_on(e); i++) { /* the circle becomes the unit circle */
        need(e, integer_set(&x[i], &c[i]));
        for (int j = 0; j < n && goes_on(e); j++)
            need(e, integer_mul_si(&x[i], &x[i], j < i ? p : q));
    }
    for (int degree = n; degree > 0 && inside && goes_on(e); degree--) {
        integer *other = y;
        remove_content(x, degree + 1, e);
        inside = !goes_on(e) || integer_cmp_abs(&x[0], &x[degree]) < 0;
        for (int i = 0; i < degree && inside && goes_on(e); i++) {
            need(e, integer_mul(&y[i], &x[degree], &x[i + 1]) && integer_submul(&y[i], &x[0], &x[degree - 1 - i]));
            spend(e, 2 * cost_of_product(&x[degree], &x[i + 1]));
        }
        y = x;
        x = other;
    }
    free_vector(x, n + 1);
    free_vector(y, n + 1);
    return inside;
}

/* The largest p such that not all zeros are inside the circle of the radius p / q, given one. */
static int64_t largest_radius(int64_t p, const integer *c, int n, int64_t q, effort *e)
{
    int64_t high = 2 * p;
    while (high < MAX_MODULUS && !zeros_are_inside(c, n, high, q, e)) {
        p = high;
        high *= 2;
    }
    while (high - p > 1) {
        int64_t middle = p + (high - p) / 2;
        if (zeros_are_inside(c, n, middle, q, e))
            high = middle;
        else
            p = middle;
    }
    return p;
}

/* ---- recurrences ---- */

/* The recurrence of the functional v under pull_back, as a polynomial c in y = 2z of the degree n; -1: none was found. */
static int find_recurrence(integer *c, integer *v, int span, const laurent *mask, effort *e)
{
    int length = (2 * span + 1) * (2 * span + 1), degree = -1;
    integer *next = new_vector(length, e), factor;
    echelon functionals;
    echelon_init(&functionals, length, MAX_DEGREE + 1, e);
    integer_init(&factor);
    while (degree < 0 && functionals.given <= MAX_DEGREE && goes_on(e)) {
        if (echelon_add(&functionals, v, c, e)) {
            degree = functionals.given - 1;
            break;
        }
        pull_back(next, v, span, mask, e);
        for (int i = 0; i < length; i++)
            integer_swap(&v[i], &next[i]);
    }
    integer_set_si(&factor, 1);
    for (int i = 0; i <= degree && goes_on(e); i++) { /* v has been multiplied by the denominator at each step, and z = y/2 */
        need(e, integer_mul(&c[i], &c[i], &factor) && integer_mul_2exp(&c[i], &c[i], (unsigned long)(degree - i))
                    && integer_mul(&factor, &factor, &mask->denominator));
    }
    echelon_clear(&functionals);
    free_vector(next, length);
    integer_clear(&factor);
    return goes_on(e) ? degree : -1;
}

/* Looks at the values at 2^-N x of one frequency. */
static void look_at(regular_refutation *z, const whole_values *phi, lattice x, int frequency, const laurent *mask, effort *e)
{
    int span = 2 * phi->reach + 1, degree; /* points and phi reach as far as the mask, and each step back halves the excess */
    int length = (2 * span + 1) * (2 * span + 1);
    integer *v = new_vector(length, e), *c = new_vector(MAX_DEGREE + 2, e);
    if (goes_on(e)) {
        set_value_at(v, span, phi, x, frequency, e);
        degree = find_recurrence(c, v, span, mask, e);
        if (frequency == 0)
            degree = divide_by_root(c, degree, 2, e); /* constants: z = 1 */
        if (frequency == 1)
            degree = divide_by_root(c, degree, 1, e); /* linear functions: z = 1/2 */
        if (degree > 0 && !zeros_are_inside(c, degree, z->modulus, REFUTATION_UNIT / 2, e)) {
            z->refuted = true;
            z->frequency = frequency;
            z->point = x;
            z->modulus = largest_radius(z->modulus, c, degree, REFUTATION_UNIT / 2, e);
        }
    }
    free_vector(v, length);
    free_vector(c, MAX_DEGREE + 2);
}

static int mask_reach(const laurent *mask, mesh_kind mesh)
{
    int reach = 0;
    for (long i = 0; i < mask->na * mask->nb; i++) {
        int here = mesh_mask_reach(mesh, (lattice){(int)(mask->a0 + i / mask->nb), (int)(mask->b0 + i % mask->nb)});
        reach = !integer_is_zero(&mask->coefficient[i]) && here > reach ? here : reach;
    }
    return reach;
}

bool regular_refute(regular_refutation *z, const laurent *mask, mesh_kind mesh)
{
    effort e = {false, false, 0};
    int lines = 0;
    mesh_kind places = mesh == MESH_DUAL ? MESH_QUAD : mesh; /* whole places are vertices */
    whole_values *phi = calloc(1, sizeof *phi);
    *z = (regular_refutation){false, 0, {0, 0}, REFUTATION_UNIT / 2};
    need(&e, phi != NULL);
    for (int i = 0; phi && i < (2 * MAX_REACH + 1) * (2 * MAX_REACH + 1); i++)
        integer_init(&phi->value[i / (2 * MAX_REACH + 1)][i % (2 * MAX_REACH + 1)]);
    if (phi) {
        phi->mesh = mesh;
        phi->reach = mask_reach(mask, mesh);
    }
    if (phi && phi->reach <= MAX_REACH)
        lines = find_whole_values(phi, mask, &e);
    if (lines > 1)
        *z = (regular_refutation){true, 0, {0, 0}, REFUTATION_UNIT};
    if (lines == 1)
        for (int frequency = 0; frequency <= mesh_regular_valence(mesh) / 2; frequency++)
            for (int a = 1; a <= phi->reach; a++)
                for (int b = 0; b <= phi->reach; b++)
                    if (mesh_ring(places, a, b) <= phi->reach && goes_on(&e))
                        look_at(z, phi, (lattice){a, b}, frequency, mask, &e);
    for (int i = 0; phi && i < (2 * MAX_REACH + 1) * (2 * MAX_REACH + 1); i++)
        integer_clear(&phi->value[i / (2 * MAX_REACH + 1)][i % (2 * MAX_REACH + 1)]);
    free(phi);
    return !e.no_memory;
}
