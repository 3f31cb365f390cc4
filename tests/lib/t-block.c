/* t-block.c: the blocks of the subdivision matrix against an explicit mesh.

   The mesh is made of triangles between vertices with numbers; the rules are written from the textbook in terms of
   the vertices, edges and triangles next to each other.  Nothing of lib/ is used to make it. */
#include "lib/block.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

#define PI 3.14159265358979323846
#define MAX_RINGS 9
#define MAX_VALENCE 20

/* ---- the mesh: vertex 0 is the centre; (sector, a, b), a >= 1, b >= 0, are numbered from 1 ---- */

enum { SECTOR_POINTS = MAX_RINGS * (MAX_RINGS + 1) / 2, MAX_VERTICES = 1 + MAX_VALENCE * SECTOR_POINTS };

typedef struct {
    int k, vertices;
    int edges[MAX_VERTICES];                     /* of each vertex, */
    int to[MAX_VERTICES][MAX_VALENCE];           /* where they lead, */
    int left[MAX_VERTICES][MAX_VALENCE];         /* and the third vertex of the triangle to their left, or -1 */
} mesh;

static mesh grid_mesh;

/* The vertex at (a,b), a, b >= 0, of the sector s. */
static int vertex_at(int k, int s, int a, int b)
{
    if (a == 0 && b == 0)
        return 0;
    if (a == 0)
        s++, a = b, b = 0;
    int row = a + b;
    return 1 + (s % k) * SECTOR_POINTS + row * (row - 1) / 2 + b;
}

static int *find_edge(mesh *z, int from, int to)
{
    int e = 0;
    while (e < z->edges[from] && z->to[from][e] != to)
        e++;
    if (e == z->edges[from]) {
        z->to[from][e] = to;
        z->left[from][e] = -1;
        z->edges[from]++;
    }
    return &z->left[from][e];
}

static void add_triangle(mesh *z, int p, int q, int r)
{
    *find_edge(z, p, q) = r;
    *find_edge(z, q, r) = p;
    *find_edge(z, r, p) = q;
    find_edge(z, q, p), find_edge(z, r, q), find_edge(z, p, r);
}

static void make_mesh(mesh *z, int k)
{
    memset(z, 0, sizeof *z);
    z->k = k;
    z->vertices = 1 + k * SECTOR_POINTS;
    for (int s = 0; s < k; s++)
        for (int row = 0; row < MAX_RINGS; row++)
            for (int b = 0; b <= row; b++) {
                int a = row - b;
                add_triangle(z, vertex_at(k, s, a, b), vertex_at(k, s, a + 1, b), vertex_at(k, s, a, b + 1));
                if (row < MAX_RINGS - 1)
                    add_triangle(z, vertex_at(k, s, a + 1, b + 1), vertex_at(k, s, a, b + 1), vertex_at(k, s, a + 1, b));
            }
}

/* ---- the rules ---- */

typedef struct {
    double centre;       /* c0 at the extraordinary vertex */
    double vertex, ring; /* the vertex rule: itself, each of six neighbours */
    double end, opposite, wing;
} rules;

static rules loop_rules(int k)
{
    double c = 3.0 / 8 + cos(2 * PI / k) / 4;
    return (rules){3.0 / 8 + c * c, 5.0 / 8, 1.0 / 16, 3.0 / 8, 1.0 / 8, 0};
}

static rules odd_rules(int k)
{
    return (rules){2.0 / 3 + sin(PI / k) / 7, 0.7, 0.05, odd_edge[0], odd_edge[1], odd_edge[2]};
}

static void vertex_rule(double *row, mesh *z, int v, const rules *r)
{
    double own = v ? r->vertex : r->centre, each = v ? r->ring : (1 - r->centre) / z->k;
    row[v] += own;
    for (int e = 0; e < z->edges[v]; e++)
        row[z->to[v][e]] += each;
}

static void edge_rule(double *row, mesh *z, int p, int q, const rules *r)
{
    for (int side = 0; side < 2; side++) {
        int from = side ? q : p, to = side ? p : q;
        int third = *find_edge(z, from, to);
        row[from] += r->end;
        row[third] += r->opposite;
        if (r->wing != 0) {
            row[*find_edge(z, from, third)] += r->wing; /* the triangle behind the edge from-third */
            row[*find_edge(z, third, to)] += r->wing;
        }
    }
}

/* row[v] = what the old vertex v contributes to the new vertex (s,a,b). */
static void new_vertex(double *row, mesh *z, int s, int a, int b, const rules *r)
{
    int k = z->k;
    for (int v = 0; v < z->vertices; v++)
        row[v] = 0;
    if (a % 2 == 0 && b % 2 == 0)
        vertex_rule(row, z, vertex_at(k, s, a / 2, b / 2), r);
    else if (a % 2 && b % 2)
        edge_rule(row, z, vertex_at(k, s, (a - 1) / 2, (b + 1) / 2), vertex_at(k, s, (a + 1) / 2, (b - 1) / 2), r);
    else
        edge_rule(row, z, vertex_at(k, s, a / 2, b / 2), vertex_at(k, s, (a + 1) / 2, (b + 1) / 2), r);
}

/* ---- traces ---- */

enum { POWERS = 6 };

/* trace[p - 1] = the trace of m^p, p = 1..6. */
static void traces(double *trace, const double *m, int n)
{
    size_t size = (size_t)n * (size_t)n;
    double *power = malloc(2 * size * sizeof *power), *next = power + size;
    memcpy(power, m, size * sizeof *m);
    for (int p = 0; p < POWERS; p++) {
        trace[p] = 0;
        for (int i = 0; i < n; i++)
            trace[p] += power[i * n + i];
        memset(next, 0, size * sizeof *next);
        for (int i = 0; i < n; i++)
            for (int l = 0; l < n; l++)
                if (power[i * n + l] != 0)
                    for (int j = 0; j < n; j++)
                        next[i * n + j] += power[i * n + l] * m[l * n + j];
        memcpy(power, next, size * sizeof *next);
    }
    free(power);
}

/* The traces of the full matrix on the rings 0..rings. */
static void full_traces(double *trace, int k, int rings, const rules *r)
{
    int inside = rings * (rings + 1) / 2, n = 1 + k * inside;
    double *m = calloc((size_t)n * (size_t)n, sizeof *m), *row = malloc(MAX_VERTICES * sizeof *row);
    int *number_of = malloc(MAX_VERTICES * sizeof *number_of);
    make_mesh(&grid_mesh, k);
    for (int v = 0; v < grid_mesh.vertices; v++)
        number_of[v] = v == 0 ? 0 : (v - 1) % SECTOR_POINTS < inside ? 1 + (v - 1) / SECTOR_POINTS * inside + (v - 1) % SECTOR_POINTS : -1;
    for (int s = -1; s < k; s++)
        for (int j = s < 0 ? 0 : 1; j <= (s < 0 ? 0 : rings); j++)
            for (int b = 0; b < (j ? j : 1); b++) {
                int at = number_of[vertex_at(k, s < 0 ? 0 : s, j - b, b)];
                new_vertex(row, &grid_mesh, s < 0 ? 0 : s, j - b, b, r);
                for (int v = 0; v < grid_mesh.vertices; v++) {
                    CHECK(row[v] == 0 || number_of[v] >= 0, "ring %d uses points beyond ring %d", j, rings);
                    if (number_of[v] >= 0)
                        m[at * n + number_of[v]] = row[v];
                }
            }
    traces(trace, m, n);
    free(m);
    free(row);
    free(number_of);
}

static bool make_block(block *b, const scheme *s, long m, long k, long prec)
{
    scheme_numbers numbers;
    diagnostic d = {0, 0, ""};
    memset(b, 0, sizeof *b);
    twist_init(&b->twist);
    status made = scheme_numbers_make(&numbers, s, k, prec, &d);
    CHECK(made == STATUS_OK, "numbers at k = %ld: %s", k, d.text);
    block_status answer = made == STATUS_OK ? block_make(b, &numbers, m, true, &d) : BLOCK_BAD_INPUT;
    CHECK(answer == BLOCK_OK, "block %ld of %ld: status %d: %s", m, k, (int)answer, d.text);
    scheme_numbers_free(&numbers);
    return answer == BLOCK_OK;
}

static double *doubles(const block *b, double tolerance)
{
    double *m = malloc((size_t)(b->n * b->n) * sizeof *m);
    for (int i = 0; i < b->n * b->n; i++) {
        m[i] = number_mid_approx(&b->entry[i]);
        CHECK(is_near(&b->entry[i], m[i], tolerance), "an entry is wide");
    }
    return m;
}

static void block_traces(double *trace, const scheme *s, long m, long k)
{
    block b;
    memset(trace, 0, POWERS * sizeof *trace);
    if (make_block(&b, s, m, k, 64)) {
        double *entries = doubles(&b, 1e-12);
        traces(trace, entries, b.n);
        free(entries);
    }
    block_free(&b);
}

static void compare_traces(const char *text, rules (*make_rules)(int), int k)
{
    double full[POWERS], sum[POWERS] = {0}, trace[POWERS];
    scheme s;
    rules r = make_rules(k);
    read_scheme(&s, text);
    full_traces(full, k, scheme_closed_rings(&s), &r);
    for (int m = 0; m <= k / 2; m++) {
        block_traces(trace, &s, m, k);
        for (int p = 0; p < POWERS; p++)
            sum[p] += (m == 0 || 2 * m == k ? 1 : 2) * trace[p];
    }
    for (int p = 0; p < POWERS; p++)
        CHECK(fabs(sum[p] - full[p]) < 1e-9, "k = %d: the trace of power %d is %.12g, the blocks say %.12g", k, p + 1, full[p], sum[p]);
    scheme_clear(&s);
}

static void test_traces(void)
{
    static const int valences[] = {3, 4, 5, 6, 7, 8, 9, 10, 20};
    test_begin("block-traces-of-full-matrix-loop");
    for (int i = 0; i < 9; i++)
        compare_traces(catalogue_text("loop"), loop_rules, valences[i]);
    test_end();
    test_begin("block-traces-of-full-matrix-reach-3");
    for (int i = 0; i < 9; i++)
        compare_traces(ODD_TEXT, odd_rules, valences[i]);
    test_end();
}

/* ---- one step on nets that rotation multiplies by t ---- */

typedef struct {
    double re, im;
} complex_value;

static complex_value times(complex_value p, complex_value q)
{
    return (complex_value){p.re * q.re - p.im * q.im, p.re * q.im + p.im * q.re};
}

/* Random values on one sector, carried round the whole mesh. */
static void random_net(complex_value *full, sector_net *net, int k, int m)
{
    double w = 2 * PI * m / k;
    for (int j = 1; j <= net->rings; j++)
        for (int b = 0; b < j; b++) {
            int at = sector_index(net, j - b, b);
            double x = random_unit(), y = m ? random_unit() : 0;
            number_set_double(&net->x[at], x, 64);
            number_set_double(&net->y[at], y, 64);
            for (int s = 0; s < k; s++)
                full[vertex_at(k, s, j - b, b)] = times((complex_value){x, sin(w / 2) * y}, (complex_value){cos(w * s), sin(w * s)});
        }
    full[0] = (complex_value){m ? 0 : random_unit(), 0};
    number_set_double(&net->centre, full[0].re, 64);
}

static void compare_step(const sector_net *net, const mask_numbers *mask, const complex_value *full, const rules *r, int m, int reach)
{
    int k = grid_mesh.k;
    double *row = malloc(MAX_VERTICES * sizeof *row), half = sin(PI * m / k);
    number x, y;
    number_init(&x), number_init(&y);
    for (int j = 1; (j + reach) / 2 <= net->rings - 1; j++)
        for (int b = 0; b < j; b++) {
            double re = 0, im = 0;
            sector_status answer = sector_masked_value(&x, &y, net, mask, 2, j - b, b, 64);
            CHECK(answer == SECTOR_OK, "(%d,%d): status %d", j - b, b, (int)answer);
            new_vertex(row, &grid_mesh, 0, j - b, b, r);
            for (int v = 0; v < grid_mesh.vertices; v++)
                if (row[v] != 0) {
                    re += row[v] * full[v].re;
                    im += row[v] * full[v].im;
                }
            CHECK(is_near(&x, re, 1e-11), "k = %d, m = %d, (%d,%d): x is %.15g, not %.15g", k, m, j - b, b, number_mid_approx(&x), re);
            if (m)
                CHECK(fabs(half * number_mid_approx(&y) - im) < 1e-11, "k = %d, m = %d, (%d,%d): y", k, m, j - b, b);
            else
                CHECK(number_is_zero(&y) == TRUTH_TRUE, "y of a plain net");
        }
    number_clear(&x), number_clear(&y);
    free(row);
}

static void check_step(const char *text, rules (*make_rules)(int))
{
    static complex_value full[MAX_VERTICES];
    int k = (int)random_range(3, 9), m = (int)random_range(0, k - 1);
    scheme s;
    mask_numbers mask;
    sector_net net;
    twist t;
    rules r = make_rules(k);
    read_scheme(&s, text);
    MUST(mask_numbers_make(&mask, &s.mask, 64));
    twist_init(&t);
    MUST(twist_set_real(&t, m, k, 64));
    MUST(sector_net_make(&net, s.mesh, k == 6, MAX_RINGS, m ? &t : NULL));
    make_mesh(&grid_mesh, k);
    random_net(full, &net, k, m);
    compare_step(&net, &mask, full, &r, m, s.steps[0].reach);
    sector_net_free(&net);
    twist_clear(&t);
    mask_numbers_free(&mask);
    scheme_clear(&s);
}

static void test_step(void)
{
    test_begin("sector-step-on-the-mesh-loop");
    for (test_cases(12); test_next();)
        check_step(LOOP_TEXT, loop_rules);
    test_end();
    test_begin("sector-step-on-the-mesh-reach-3");
    for (test_cases(12); test_next();)
        check_step(ODD_TEXT, odd_rules);
    test_end();
}

/* ---- points outside the sector ---- */

static void test_sector_value(void)
{
    test_begin("sector-value-turns");
    for (test_cases(30); test_next();) {
        bool regular = random_below(4) == 0;
        int k = regular ? 6 : (int)random_range(3, 30), m = (int)random_range(1, k - 1), rings = 6;
        double w = 2 * PI * m / k;
        sector_net net;
        twist t;
        number x, y;
        number_init(&x), number_init(&y);
        twist_init(&t);
        MUST(twist_set_real(&t, m, k, 64));
        MUST(sector_net_make(&net, MESH_TRIANGLE, k == 6 && regular, rings, &t));
        for (int i = 0; i < sector_size(rings); i++) {
            number_set_double(&net.x[i], random_unit(), 64);
            number_set_double(&net.y[i], random_unit(), 64);
        }
        for (int a = -rings - 2; a <= rings + 2; a++)
            for (int b = -rings - 2; b <= rings + 2; b++) {
                sector_status answer = sector_value(&x, &y, &net, a, b, 64);
                int p = a, q = b, turns = 0;
                if (a == 0 && b == 0) {
                    CHECK(answer == SECTOR_OK && number_is_zero(&x) == TRUTH_TRUE && number_is_zero(&y) == TRUTH_TRUE, "centre");
                    continue;
                }
                if (a < 0 && b <= 0 && !regular) {
                    CHECK(answer == SECTOR_OPPOSITE, "(%d,%d) is opposite", a, b);
                    continue;
                }
                /* turn by -60 degrees until the point is in the sector 0 <= angle < 60 degrees; angles below 0 are
                   those of the half plane right of the sector's edge */
                bool clockwise = b < 0 && a >= 0; /* any way round if the complex is the plane */
                while (p < 1 || q < 0) {
                    int old = p;
                    if (clockwise)
                        p = -q, q = old + q, turns--;
                    else
                        p = old + q, q = -old, turns++;
                }
                if (p + q > rings) {
                    CHECK(answer == SECTOR_OUTSIDE, "(%d,%d) is outside", a, b);
                    continue;
                }
                CHECK(answer == SECTOR_OK, "(%d,%d): status %d", a, b, (int)answer);
                complex_value v = {number_mid_approx(&net.x[sector_index(&net, p, q)]), sin(w / 2) * number_mid_approx(&net.y[sector_index(&net, p, q)])};
                v = times(v, (complex_value){cos(w * turns), sin(w * turns)});
                CHECK(is_near(&x, v.re, 1e-12) && fabs(sin(w / 2) * number_mid_approx(&y) - v.im) < 1e-12, "(%d,%d), k = %d, m = %d", a, b, k, m);
            }
        sector_net_free(&net);
        twist_clear(&t);
        number_clear(&x), number_clear(&y);
    }
    test_end();
}

/* ---- the real form has the spectrum of the complex one ---- */

/* The value of the old net at (a,b) is t^turns times that of the point with this index. */
static int turn(int a, int b, int *turns)
{
    *turns = 0;
    for (; a < 1 || b < 0;) {
        int old = a;
        if (b >= 1)
            a = old + b, b = -old, ++*turns;
        else
            a = -b, b = old + b, --*turns;
    }
    return (a + b) * (a + b - 1) / 2 + b;
}

/* Traces of the powers of the complex n x n matrix on the points of the sector; their imaginary parts must be 0. */
static void complex_traces(double *trace, const scheme *s, int m, int k)
{
    enum { MOST = 6 };
    int rings = scheme_closed_rings(s), n = rings * (rings + 1) / 2;
    complex_value b[MOST][MOST] = {{{0, 0}}}, power[MOST][MOST], next[MOST][MOST];
    double w = 2 * PI * m / k;
    for (int j = 1; j <= rings; j++)
        for (int e = 0; e < j; e++)
            for (int p = -3; p <= 3; p++)
                for (int q = -3; q <= 3; q++) {
                    rational weight;
                    int turns, a = j - e, column;
                    rational_init(&weight);
                    MUST(laurent_get(&weight, &s->mask, a - 2 * p, e - 2 * q));
                    if (!rational_is_zero(&weight) && (p || q)) {
                        double c = rational_get_double_approx(&weight);
                        column = turn(p, q, &turns);
                        complex_value *entry = &b[j * (j - 1) / 2 + e][column];
                        entry->re += c * cos(w * turns);
                        entry->im += c * sin(w * turns);
                    }
                    rational_clear(&weight);
                }
    memcpy(power, b, sizeof b);
    for (int p = 0; p < POWERS; p++) {
        double im = 0;
        trace[p] = 0;
        for (int i = 0; i < n; i++)
            trace[p] += power[i][i].re, im += power[i][i].im;
        CHECK(fabs(im) < 1e-12, "a complex trace");
        memset(next, 0, sizeof next);
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                for (int l = 0; l < n; l++) {
                    complex_value c = times(power[i][l], b[l][j]);
                    next[i][j].re += c.re;
                    next[i][j].im += c.im;
                }
        memcpy(power, next, sizeof next);
    }
}

static void test_real_form(void)
{
    static const char *const text[] = {LOOP_TEXT, ODD_TEXT, BUTTERFLY_TEXT};
    test_begin("block-real-form-against-complex");
    for (test_cases(60); test_next();) {
        double real[POWERS], complex_form[POWERS];
        scheme s;
            int k = (int)random_range(3, 1000), m = (int)random_range(1, k / 2);
        read_scheme(&s, text[random_below(3)]);
        block_traces(real, &s, m, k);
        complex_traces(complex_form, &s, m, k);
        for (int p = 0; p < POWERS; p++)
            CHECK(fabs(real[p] - complex_form[p]) < 1e-11, "k = %d, m = %d, power %d: %.12g and %.12g", k, m, p + 1, real[p], complex_form[p]);
        scheme_clear(&s);
    }
    test_end();
}

/* ---- golden values ---- */

static void check_power_sums(const double *trace, const double *eigenvalue, int n, const char *what, long k, long m)
{
    for (int p = 0; p < POWERS; p++) {
        double sum = 0;
        for (int i = 0; i < n; i++)
            sum += pow(eigenvalue[i], p + 1);
        CHECK(fabs(sum - trace[p]) < 1e-11, "%s, k = %ld, m = %ld: trace of power %d is %.12g, not %.12g", what, k, m, p + 1, trace[p], sum);
    }
}

/* det(b - x) of a small matrix. */
static double determinant(const double *b, int n, double x)
{
    double a[12][12], det = 1;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            a[i][j] = b[i * n + j] - (i == j ? x : 0);
    for (int c = 0; c < n; c++) {
        int p = c;
        for (int i = c + 1; i < n; i++)
            if (fabs(a[i][c]) > fabs(a[p][c]))
                p = i;
        for (int j = 0; j < n; j++) {
            double swap = a[c][j];
            a[c][j] = a[p][j];
            a[p][j] = swap;
        }
        det *= p == c ? a[c][c] : -a[c][c];
        for (int i = c + 1; i < n && a[c][c] != 0; i++) {
            double f = a[i][c] / a[c][c];
            for (int j = c; j < n; j++)
                a[i][j] -= f * a[c][j];
        }
    }
    return det;
}

static void test_golden(void)
{
    scheme loop, butterfly;
    double trace[POWERS];
    test_begin("block-golden-eigenvalues");
    read_scheme(&loop, catalogue_text("loop"));
    read_scheme(&butterfly, BUTTERFLY_TEXT);
    CHECK(scheme_closed_rings(&loop) == 2 && scheme_closed_rings(&butterfly) == 3, "rings");
    for (long k = 3; k <= 60; k++) {
        double c0 = loop_rules((int)k).centre;
        block_traces(trace, &loop, 0, k);
        check_power_sums(trace, (double[]){1, c0 - 0.375, 0.125, 0.0625}, 4, "Loop", k, 0);
        for (long m = 1; m <= k / 2; m++) {
            block_traces(trace, &loop, m, k);
            check_power_sums(trace, (double[]){0.375 + cos(2 * PI * (double)m / (double)k) / 4, 0.125, 0.0625}, 3, "Loop", k, m);
        }
        for (long m = 1; m <= k / 2; m++) {
            /* three eigenvalues are the roots of a cubic: e1, e2, e3 are their symmetric functions */
            double z = cos(PI * (double)m / (double)k), q = z * z;
            double e1 = 0.25 + 1.5 * q - q * q, e2 = 1.0 / 64 + 23.0 / 64 * q - 3.0 / 16 * q * q, e3 = q / 64;
            double sum[POWERS] = {e1, e1 * e1 - 2 * e2, e1 * e1 * e1 - 3 * e1 * e2 + 3 * e3};
            for (int p = 3; p < POWERS; p++)
                sum[p] = e1 * sum[p - 1] - e2 * sum[p - 2] + e3 * sum[p - 3];
            block_traces(trace, &butterfly, m, k);
            for (int p = 0; p < POWERS; p++)
                CHECK(fabs(trace[p] - sum[p] - 2 * pow(-1.0 / 16, p + 1)) < 1e-11, "Butterfly, k = %ld, m = %ld, power %d", k, m, p + 1);
        }
    }
    static const struct {
        long k, m;
        double modulus;
    } moduli[] = {{7, 1, 0.48191070}, {7, 2, 0.40611654}, {8, 1, 0.46241777}, {8, 2, 0.46904152}, {9, 1, 0.44442936}, {9, 2, 0.49729407}};
    for (int i = 0; i < 6; i++) {
        block b;
        if (make_block(&b, &butterfly, moduli[i].m, moduli[i].k, 64)) {
            double *m = doubles(&b, 1e-12);
            CHECK(determinant(m, b.n, moduli[i].modulus - 2e-8) * determinant(m, b.n, moduli[i].modulus + 2e-8) < 0, "Butterfly has no eigenvalue near %.8f at k = %ld",
                  moduli[i].modulus, moduli[i].k);
            free(m);
        }
        block_free(&b);
    }
    scheme_clear(&loop), scheme_clear(&butterfly);
    test_end();
}

/* ---- exactness, shape and refusals ---- */

/* At k = 3 and m = 1, u = 1/2: all entries of Loop's block are rational, computed by hand from V(0,1) = T (x, 0) and
   V(1,-1) = T^-1 (x, 0), so V(0,1) + V(1,-1) = (2 c x, 0) = (-x, 0).
     new (1,0) = 3/8 (1,0) + 1/8 (-1) (1,0);
     new (2,0) = 5/8 (1,0) + 1/16 ((0,1) + (1,-1) + (2,0) + (1,1) + (2,-1)), of which (1,1) = r (1/2, 1) and
       (2,-1) = T^-1 (1,1), together r (1/2 + c/2 + n, ..) = r with c = -1/2, n = 3/4;
     new (1,1) = 3/8 ((1,0) + (0,1)) + 1/8 (1,1), y = 3/8 v x + r/8 with v = 1. */
static void test_exact(void)
{
    static const int expected[9] = {4, 0, 0, 9, 1, 1, 6, 0, 2}; /* sixteenths */
    scheme s;
    block b;
    rational q;
    test_begin("block-exact-entries");
    rational_init(&q);
    read_scheme(&s, LOOP_TEXT);
    if (make_block(&b, &s, 1, 3, 64)) {
        CHECK(b.n == 3 && b.rings == 2 && b.m == 1 && b.k.first == 3, "shape");
        for (int i = 0; i < 9 && b.n == 3; i++) {
            MUST(rational_set_si(&q, expected[i], 16));
            CHECK(number_contains_rational(&b.entry[i], &q) && number_is_thin(&b.entry[i]), "entry %d is %.17g, not %d/16", i, number_mid_approx(&b.entry[i]), expected[i]);
        }
    }
    block_free(&b);
    /* every entry contains its exact value: compare enclosures of different precision and kind */
    for (long k = 5; k <= 100; k += 19)
        for (long m = 0; m <= k / 2; m += 3) {
            block fine;
            bool made = make_block(&b, &s, m, k, 64);
            if (make_block(&fine, &s, m, k, 256) && made)
                for (int i = 0; i < b.n * b.n; i++)
                    CHECK(number_upper_bound(&b.entry[i]) >= number_lower_bound(&fine.entry[i])
                              && number_lower_bound(&b.entry[i]) <= number_upper_bound(&fine.entry[i]), "k = %ld, m = %ld: entry %d of two precisions is disjoint", k, m, i);
            block_free(&b), block_free(&fine);
        }
    scheme_clear(&s);
    rational_clear(&q);
    test_end();
}

static void test_unknowns(void)
{
    static const struct {
        unknown_kind kind;
        int a, b;
    } listed[] = {{UNKNOWN_SPOKE, 1, 0}, {UNKNOWN_SPOKE, 2, 0}, {UNKNOWN_BISECTOR, 1, 1}, {UNKNOWN_SPOKE, 3, 0}, {UNKNOWN_X, 2, 1}, {UNKNOWN_Y, 2, 1}};
    static const int plain[7][2] = {{0, 0}, {1, 0}, {2, 0}, {1, 1}, {3, 0}, {2, 1}, {1, 2}};
    scheme s;
    block b;
    test_begin("block-unknowns");
    read_scheme(&s, ODD_TEXT);
    if (make_block(&b, &s, 2, 7, 64)) {
        sector_net net;
        number *value = number_array_new(6);
        number x, y;
        number_init(&x), number_init(&y);
        CHECK(b.n == 6, "%d unknowns", b.n);
        for (int i = 0; i < 6 && b.n == 6; i++) {
            CHECK(b.unknowns[i].kind == listed[i].kind && b.unknowns[i].a == listed[i].a && b.unknowns[i].b == listed[i].b, "unknown %d", i);
            number_set_double(&value[i], random_unit(), 64);
        }
        /* the net is its own mirror image: V(b,a) = t conj V(a,b) */
        MUST(sector_net_make(&net, s.mesh, false, 3, &b.twist));
        block_net(&net, &b, value, NULL, 64);
        for (int j = 1; j <= 3; j++)
            for (int e = 0; e < j; e++) {
                sector_value(&x, &y, &net, e, j - e, 64);
                int at = sector_index(&net, j - e, e);
                double w = 4 * PI / 7, re = number_mid_approx(&net.x[at]), im = -sin(w / 2) * number_mid_approx(&net.y[at]);
                CHECK(is_near(&x, cos(w) * re - sin(w) * im, 1e-12) && fabs(sin(w / 2) * number_mid_approx(&y) - sin(w) * re - cos(w) * im) < 1e-12, "(%d,%d) has no mirror image", j - e, e);
            }
        number_clear(&x), number_clear(&y);
        number_array_free(value, 6);
        sector_net_free(&net);
    }
    block_free(&b);
    if (make_block(&b, &s, 0, 7, 64)) {
        CHECK(b.n == 7, "%d unknowns of block 0", b.n);
        for (int i = 0; i < 7 && b.n == 7; i++) {
            double sum = 0;
            CHECK(b.unknowns[i].a == plain[i][0] && b.unknowns[i].b == plain[i][1] && b.unknowns[i].kind == (i ? UNKNOWN_PLAIN : UNKNOWN_CENTRE), "plain unknown %d", i);
            for (int j = 0; j < 7; j++)
                sum += number_mid_approx(&b.entry[i * 7 + j]);
            CHECK(fabs(sum - 1) < 1e-12, "row %d of block 0 sums to %.15g", i, sum);
        }
    }
    block_free(&b);
    scheme_clear(&s);
    test_end();
}

/* The mask's point (3,0) makes the midpoint of the spoke ask for (-1,0), behind the centre. */
static void test_opposite(void)
{
    static const char text[] = SCHEME_TEXT("(0,0) 1\n(1,0) 7/16\n(3,0) 1/16\n", "1/2");
    scheme s;
    test_begin("block-opposite");
    read_scheme(&s, text);
    for (long m = 0; m <= 2; m++) {
        scheme_numbers numbers;
        block b;
        diagnostic d;
        CHECK(scheme_numbers_make(&numbers, &s, 5, 64, &d) == STATUS_OK, "numbers");
        CHECK(block_make(&b, &numbers, m, true, &d) == BLOCK_OPPOSITE, "not refused, m = %ld", m);
        block_free(&b);
        scheme_numbers_free(&numbers);
    }
    scheme_clear(&s);
    test_end();
}

static void tests(void)
{
    test_traces();
    test_step();
    test_sector_value();
    test_real_form();
    test_golden();
    test_exact();
    test_unknowns();
    test_opposite();
}
MAIN(tests);
