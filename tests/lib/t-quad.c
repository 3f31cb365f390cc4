/* t-quad.c: nets on quad meshes and on their duals against explicit meshes.

   The mesh is a list of squares between vertices with numbers, k sectors of them round vertex 0.  What is next to what
   comes from the list alone; the rules are the textbooks'.  A dual net has its values on the squares.  Values that the
   border of the mesh would be asked for are NAN.  Nothing of lib/ is used to make any of this. */
#include "lib/block.h"

#include <math.h>
#include <stdlib.h>

#include "common.h"
#include "region.h"

#define PI 3.14159265358979323846

enum {
    RINGS = 9,
    MOST_SECTORS = 8,
    SECTOR_VERTICES = RINGS * (RINGS + 1),
    SECTOR_SQUARES = RINGS * RINGS,
    MOST_VERTICES = 1 + MOST_SECTORS * SECTOR_VERTICES,
    MOST_SQUARES = MOST_SECTORS * SECTOR_SQUARES
};

/* ---- the mesh ---- */

typedef struct {
    int k, vertices, squares;
    int corner[MOST_SQUARES][4];              /* counter-clockwise */
    int edges[MOST_VERTICES];                 /* of each vertex, in no order, */
    int to[MOST_VERTICES][MOST_SECTORS + 1];  /* where they lead */
    int left[MOST_VERTICES][MOST_SECTORS + 1]; /* and the square to their left, or -1 */
} mesh;

static mesh grid_mesh;

/* The vertex at (a,b), a, b >= 0, of the sector s. */
static int vertex_at(int s, int a, int b)
{
    if (a == 0 && b == 0)
        return 0;
    if (a == 0)
        s++, a = b, b = 0;
    return 1 + (s % grid_mesh.k) * SECTOR_VERTICES + (a - 1) * (RINGS + 1) + b;
}

/* The square that has (a,b) as its corner farthest from the centre, a, b >= 1. */
static int square_at(int s, int a, int b)
{
    return (s % grid_mesh.k) * SECTOR_SQUARES + (a - 1) * RINGS + b - 1;
}

static int edge_to(int from, int to)
{
    mesh *z = &grid_mesh;
    int e = 0;
    while (e < z->edges[from] && z->to[from][e] != to)
        e++;
    if (e == z->edges[from]) {
        z->to[from][e] = to;
        z->left[from][e] = -1;
        z->edges[from]++;
    }
    return e;
}

/* The square to the left of an edge, -1 beyond the border. */
static int left_of(int from, int to)
{
    return grid_mesh.left[from][edge_to(from, to)];
}

static void make_mesh(int k)
{
    mesh *z = &grid_mesh;
    memset(z, 0, sizeof *z);
    z->k = k;
    z->vertices = 1 + k * SECTOR_VERTICES;
    z->squares = k * SECTOR_SQUARES;
    for (int s = 0; s < k; s++)
        for (int a = 1; a <= RINGS; a++)
            for (int b = 1; b <= RINGS; b++) {
                int f = square_at(s, a, b), *c = z->corner[f];
                c[0] = vertex_at(s, a - 1, b - 1), c[1] = vertex_at(s, a, b - 1), c[2] = vertex_at(s, a, b), c[3] = vertex_at(s, a - 1, b);
                for (int i = 0; i < 4; i++) {
                    z->left[c[i]][edge_to(c[i], c[(i + 1) % 4])] = f;
                    edge_to(c[(i + 1) % 4], c[i]);
                }
            }
}

static int corner_of(int square, int vertex)
{
    int i = 0;
    while (i < 3 && grid_mesh.corner[square][i] != vertex)
        i++;
    return i;
}

/* The squares round a vertex, counter-clockwise from `first`; how many there are, 0 at the border. */
static int squares_round(int *list, int vertex, int first)
{
    int n = 0, f = first;
    do {
        if (f < 0 || n > MOST_SECTORS)
            return 0;
        list[n++] = f;
        f = left_of(vertex, grid_mesh.corner[f][(corner_of(f, vertex) + 3) % 4]);
    } while (f != first);
    return n;
}

static int some_square(int vertex)
{
    return grid_mesh.left[vertex][0];
}

/* ---- rules: new values on the same labels from old ones ---- */

static double vertex_values[3][MOST_VERTICES], square_values[3][MOST_SQUARES]; /* scratch */

static double mean_of_corners(const double *vertices, int square)
{
    const int *c = grid_mesh.corner[square];
    return (vertices[c[0]] + vertices[c[1]] + vertices[c[2]] + vertices[c[3]]) / 4;
}

static double mean_of_squares(const double *squares, int vertex)
{
    int list[MOST_SECTORS + 1], n = squares_round(list, vertex, some_square(vertex));
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += squares[list[i]];
    return n ? sum / n : NAN;
}

static double square_or_nan(const double *squares, int f)
{
    return f < 0 ? NAN : squares[f];
}

static double catmull_clark_at(const double *old, int s, int a, int b)
{
    if (a % 2 && b % 2)
        return mean_of_corners(old, square_at(s, (a + 1) / 2, (b + 1) / 2));
    if (a % 2 || b % 2) {
        int p = vertex_at(s, a / 2, b / 2), q = vertex_at(s, (a + 1) / 2, (b + 1) / 2), f = left_of(p, q), g = left_of(q, p);
        return f < 0 || g < 0 ? NAN : (old[p] + old[q] + mean_of_corners(old, f) + mean_of_corners(old, g)) / 4;
    }
    int v = vertex_at(s, a / 2, b / 2), list[MOST_SECTORS + 1], n = squares_round(list, v, some_square(v));
    double q = 0, r = 0;
    for (int i = 0; i < n; i++) {
        q += mean_of_corners(old, list[i]) / n;
        r += (old[v] + old[grid_mesh.to[v][i]]) / 2 / n;
    }
    return n ? (q + 2 * r + (n - 3) * old[v]) / n : NAN;
}

static void catmull_clark(double *new_values, const double *old)
{
    new_values[0] = catmull_clark_at(old, 0, 0, 0);
    for (int s = 0; s < grid_mesh.k; s++)
        for (int a = 1; a <= RINGS; a++)
            for (int b = 0; b <= RINGS; b++)
                new_values[vertex_at(s, a, b)] = catmull_clark_at(old, s, a, b);
}

/* A new point for each corner of each face of the net, that is, for each square at each vertex. */
static void doo_sabin(double *new_values, const double *old)
{
    for (int s = 0; s < grid_mesh.k; s++)
        for (int a = 1; a <= RINGS; a++)
            for (int b = 1; b <= RINGS; b++) {
                int p = (a + 1) / 2, q = (b + 1) / 2, list[MOST_SECTORS + 1], n = squares_round(list, vertex_at(s, a - p, b - q), square_at(s, p, q));
                double sum = n ? 0 : NAN;
                for (int j = 0; j < n; j++)
                    sum += (j ? (3 + 2 * cos(2 * PI * j / n)) / (4 * n) : (5.0 + n) / (4 * n)) * old[list[j]];
                new_values[square_at(s, a, b)] = sum;
            }
}

/* Old vertices (or squares, of a dual net), midpoints of edges, centres of squares (or of the faces round vertices). */
static void refine(double *new_values, const double *old, bool dual)
{
    for (int s = 0; s < grid_mesh.k; s++)
        for (int a = 0; a <= RINGS; a++)
            for (int b = 0; b <= RINGS; b++) {
                int p = vertex_at(s, a / 2, b / 2), q = vertex_at(s, (a + 1) / 2, (b + 1) / 2);
                double *z = &new_values[vertex_at(s, a, b)];
                if (a % 2 && b % 2) {
                    int f = square_at(s, (a + 1) / 2, (b + 1) / 2);
                    *z = dual ? old[f] : mean_of_corners(old, f);
                } else if (a % 2 || b % 2) {
                    *z = dual ? (square_or_nan(old, left_of(p, q)) + square_or_nan(old, left_of(q, p))) / 2 : (old[p] + old[q]) / 2;
                } else {
                    *z = dual ? mean_of_squares(old, p) : old[p];
                }
            }
}

/* Midpoint subdivision: refine, then degree - 1 times to the means of the faces. */
static void midpoint(double *new_values, const double *old, int degree)
{
    bool dual = degree % 2 == 0;
    refine(vertex_values[0], old, dual);
    for (int i = 1; i < degree; i++)
        if (i % 2)
            for (int f = 0; f < grid_mesh.squares; f++)
                square_values[0][f] = mean_of_corners(vertex_values[0], f);
        else
            for (int v = 0; v < grid_mesh.vertices; v++)
                vertex_values[0][v] = mean_of_squares(square_values[0], v);
    if (dual)
        memcpy(new_values, square_values[0], (size_t)grid_mesh.squares * sizeof *new_values);
    else
        memcpy(new_values, vertex_values[0], (size_t)grid_mesh.vertices * sizeof *new_values);
}

static void midpoint_2(double *z, const double *old) { midpoint(z, old, 2); }
static void midpoint_3(double *z, const double *old) { midpoint(z, old, 3); }
static void midpoint_4(double *z, const double *old) { midpoint(z, old, 4); }
static void midpoint_5(double *z, const double *old) { midpoint(z, old, 5); }

/* The weight of the sector j with this discrete Fourier transform, m = 0 .. k/2. */
static double weight_of_spectrum(const double *re, const double *im, int k, int j)
{
    double sum = 0;
    for (int m = 0; m <= k / 2; m++) {
        double angle = 2 * PI * m * j / k; /* the term of k - m is the conjugate */
        sum += (m == 0 || 2 * m == k ? 1 : 2) * (re[m] * cos(angle) + im[m] * sin(angle));
    }
    return sum / k;
}

/* Catmull-Clark, with rules that nobody would use near the centre: every kind of source is there. */
static void odd_vertices(double *z, const double *old)
{
    int k = grid_mesh.k;
    catmull_clark(z, old);
    for (int s = 0; s < k; s++) {
        double re[MOST_SECTORS], im[MOST_SECTORS], sum = 0, total = 0, weight;
        for (int j = 0; j < k; j++) {
            weight = (1 + j * j) / (7.0 * k);
            sum += weight * old[vertex_at(s + j, 1, 1)];
            total += weight;
        }
        sum += old[0] / 3 + old[vertex_at(s + 1, 1, 0)] / 8 - old[vertex_at(s + 2 * k - 2, 2, 1)] / 16;
        total += 1.0 / 3 + 1.0 / 8 - 1.0 / 16;
        z[vertex_at(s, 1, 0)] = sum + (1 - total) * old[vertex_at(s, 1, 0)];
        sum = total = 0;
        for (int m = 0; m <= k / 2; m++)
            re[m] = 1.0 / (m + 2), im[m] = sin(2 * PI * m / k) / 5;
        for (int j = 0; j < k; j++) {
            weight = weight_of_spectrum(re, im, k, j);
            sum += weight * old[vertex_at(s + j, 1, 0)];
            total += weight;
            sum += old[vertex_at(s + j, 1, 2)] / 10 / k;
        }
        sum += old[vertex_at(s + k - 1, 1, 2)] / 9;
        total += 0.1 + 1.0 / 9;
        z[vertex_at(s, 1, 1)] = sum + (1 - total) * old[vertex_at(s + 1, 2, 2)];
    }
}

#define HEAD_QUAD "scheme x\nmesh quad\ndilation 2\nvertices interior\n"
#define HEAD_DUAL "scheme x\nmesh quad-dual\ndilation 2\nvertices interior\n"
#define CATMULL_CLARK_MASK "mask symmetric\n(0,0) 9/16\n(1,0) 3/8\n(1,1) 1/4\n(2,0) 3/32\n(2,1) 1/16\n(2,2) 1/64\nend\n"
#define CATMULL_CLARK_RULE "rule centre\ncentre rest\nall (1,0) 3/(2*k)\nall (1,1) 1/(4*k)\nend\n"
#define DOO_SABIN_MASK "mask symmetric\n(1/2,1/2) 9/16\n(1/2,3/2) 3/16\n(3/2,3/2) 1/16\nend\n"
#define MIDPOINT_TEXT(degree) HEAD_QUAD "parameter degree = " #degree "\ncompose\nrefine\nrepeat (degree - 1 - mod(degree - 1, 2))/2: smooth 1/4, 1/2\naverage when mod(degree, 2) = 0\nend\n"

typedef struct {
    const char *name, *text;
    void (*subdivide)(double *, const double *);
    bool dual, symmetric;
} subject;

static const subject subjects[] = {
    {"catmull-clark-by-rule", HEAD_QUAD CATMULL_CLARK_MASK CATMULL_CLARK_RULE, catmull_clark, false, true},
    {"catmull-clark-composed", HEAD_QUAD "compose\nrefine\nsmooth 1/4, 1/2 centre 1 - 3/k, 2/k\nend\n", catmull_clark, false, true},
    {"doo-sabin-by-sectors", HEAD_DUAL DOO_SABIN_MASK "rule (1/2,1/2)\n(1/2,1/2) rest\n(1/2,1/2) @ j cases(j = 0: 0; else: (3 + 2*cos(2*pi*j/k))/(4*k))\nend\n", doo_sabin, true, true},
    {"doo-sabin-by-spectrum", HEAD_DUAL DOO_SABIN_MASK "rule (1/2,1/2)\n(1/2,1/2) spectrum cases(m = 0: 7; m = 1: 1/2; else: 1/4)\nend\n", doo_sabin, true, true},
    {"doo-sabin-but-at-4", HEAD_DUAL DOO_SABIN_MASK "rule (1/2,1/2) when k != 4\n(1/2,1/2) spectrum cases(m = 0: 1; m = 1: 1/2; else: 1/4)\nend\n", doo_sabin, true, true},
    {"odd", HEAD_QUAD CATMULL_CLARK_MASK CATMULL_CLARK_RULE
     "rule (1,0)\ncentre 1/3\n(1,0) rest\n(1,0) @ 1 1/8\n(2,1) @ -2 -1/16\n(1,1) @ j (1 + j^2)/(7*k)\nend\n"
     "rule (1,1)\n(1,0) spectrum 1/(m+2), sin(2*pi*m/k)/5\nall (1,2) 1/10\n(1,2) @ -1 1/9\n(2,2) @ 1 rest\nend\n", odd_vertices, false, false},
    {"midpoint-2", MIDPOINT_TEXT(2), midpoint_2, true, true},
    {"midpoint-3", MIDPOINT_TEXT(3), midpoint_3, false, true},
    {"midpoint-4", MIDPOINT_TEXT(4), midpoint_4, true, true},
    {"midpoint-5", MIDPOINT_TEXT(5), midpoint_5, false, true},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

/* ---- one step on nets that rotation multiplies by t ---- */

typedef struct {
    double re[MOST_VERTICES], im[MOST_VERTICES];
} full_net;

static int point_at(bool dual, int s, int a, int b)
{
    return dual ? square_at(s, a, b) : vertex_at(s, a, b);
}

/* The twist of frequency m; NULL for m = 0. */
static const twist *make_twist(twist *t, int m, int k, bool real)
{
    twist_init(t);
    if (m)
        MUST(real ? twist_set_real(t, m, k, 64) : twist_set_complex(t, m, k, 64));
    return m ? t : NULL;
}

/* Random values on one sector, carried round the whole mesh. */
static void random_net(full_net *full, sector_net *net, bool dual, int m, bool real)
{
    int k = grid_mesh.k;
    double w = 2 * PI * m / k;
    for (int a = 1; a <= RINGS; a++)
        for (int b = dual; b <= RINGS; b++) {
            int at = sector_index(net, a, b);
            double x = random_unit(), y = m ? random_unit() : 0, im = real ? sin(w / 2) * y : y;
            number_set_double(&net->x[at], x, 64);
            number_set_double(&net->y[at], y, 64);
            for (int s = 0; s < k; s++) {
                full->re[point_at(dual, s, a, b)] = cos(w * s) * x - sin(w * s) * im;
                full->im[point_at(dual, s, a, b)] = sin(w * s) * x + cos(w * s) * im;
            }
        }
    if (!dual) {
        full->re[0] = m ? 0 : random_unit();
        full->im[0] = 0;
        number_set_double(&net->centre, full->re[0], 64);
    }
}

static void check_step(const subject *z, const scheme *s, int m, bool real)
{
    static full_net old, image;
    enum { FAR = RINGS - 3 };
    int k = grid_mesh.k;
    double half = real ? sin(PI * m / k) : 1;
    scheme_numbers numbers;
    sector_net net, next;
    twist twist_of_m;
    diagnostic d = {0, 0, ""};
    const twist *t = make_twist(&twist_of_m, m, k, real);
    CHECK(scheme_numbers_make(&numbers, s, k, 64, &d) == STATUS_OK && scheme_numbers_set_frequency(&numbers, m, t, &d) == STATUS_OK, "numbers: %s", d.text);
    MUST(sector_net_make(&net, s->mesh, k == 4, RINGS, t));
    random_net(&old, &net, z->dual, m, real);
    z->subdivide(image.re, old.re);
    z->subdivide(image.im, old.im);
    CHECK(scheme_rings_needed(s, FAR) <= RINGS, "%d rings are needed", scheme_rings_needed(s, FAR));
    CHECK(scheme_subdivide(&next, &net, &numbers, FAR) == SUBDIVIDE_OK, "k = %d, m = %d", k, m);
    for (int a = 1; a <= FAR; a++)
        for (int b = z->dual; b <= FAR && !test_failed(); b++) {
            int here = point_at(z->dual, 0, a, b), at = sector_index(&next, a, b);
            CHECK(is_near(&next.x[at], image.re[here], 1e-11), "k = %d, m = %d, %s form, (%d,%d): x is %.15g, not %.15g", k, m, real ? "real" : "complex", a, b,
                  number_mid_approx(&next.x[at]), image.re[here]);
            CHECK(fabs(half * number_mid_approx(&next.y[at]) - image.im[here]) < 1e-11, "k = %d, m = %d, %s form, (%d,%d): y is %.15g, not %.15g", k, m, real ? "real" : "complex", a, b,
                  half * number_mid_approx(&next.y[at]), image.im[here]);
        }
    if (!z->dual && !m)
        CHECK(is_near(&next.centre, image.re[0], 1e-11), "k = %d: the centre is %.15g, not %.15g", k, number_mid_approx(&next.centre), image.re[0]);
    sector_net_free(&next);
    sector_net_free(&net);
    scheme_numbers_free(&numbers);
    twist_clear(&twist_of_m);
}

/* Real nets of mirror-symmetric schemes need not be symmetric themselves, so the real form is tried on any net. */
static void test_steps(void)
{
    for (int i = 0; i < SUBJECTS; i++) {
        char name[80];
        scheme s;
        snprintf(name, sizeof name, "quad-step-on-the-mesh-%s", subjects[i].name);
        test_begin(name);
        read_scheme(&s, subjects[i].text);
        CHECK(s.mesh == (subjects[i].dual ? MESH_DUAL : MESH_QUAD) && s.mirror_symmetric == subjects[i].symmetric, "mesh and symmetry");
        for (int k = 3; k <= MOST_SECTORS && !test_failed(); k++) {
            make_mesh(k);
            for (int m = 0; m <= k / 2 && !test_failed(); m++) {
                if (s.mirror_symmetric)
                    check_step(&subjects[i], &s, m, true);
                check_step(&subjects[i], &s, m, false);
            }
        }
        scheme_clear(&s);
        test_end();
    }
}

/* ---- traces of powers ---- */

enum { POWERS = 6 };

/* re, im += the traces of the powers of the n x n matrix p + i q (q may be NULL). */
static void traces(double *re, double *im, const double *p, const double *q, int n)
{
    size_t size = (size_t)n * (size_t)n;
    double *now = calloc(4 * size, sizeof *now), *next = now + 2 * size;
    for (int i = 0; i < n; i++)
        now[i * n + i] = 1;
    for (int power = 0; power < POWERS; power++) {
        memset(next, 0, 2 * size * sizeof *next);
        for (int i = 0; i < n; i++)
            for (int l = 0; l < n; l++) {
                double x = now[i * n + l], y = now[(int)size + i * n + l];
                if (x != 0 || y != 0)
                    for (int j = 0; j < n; j++) {
                        double u = p[l * n + j], v = q ? q[l * n + j] : 0;
                        next[i * n + j] += x * u - y * v;
                        next[(int)size + i * n + j] += x * v + y * u;
                    }
            }
        memcpy(now, next, 2 * size * sizeof *now);
        for (int i = 0; i < n; i++) {
            re[power] += now[i * n + i];
            im[power] += now[(int)size + i * n + i];
        }
    }
    free(now);
}

/* The points of the rings up to `rings`, the centre included, in any order. */
static int list_points(int *list, bool dual, int rings)
{
    int n = 0;
    if (!dual)
        list[n++] = 0;
    for (int s = 0; s < grid_mesh.k; s++)
        for (int a = 1; a <= rings; a++)
            for (int b = dual; b <= rings; b++)
                list[n++] = point_at(dual, s, a, b);
    return n;
}

static void full_traces(double *trace, const subject *z, int rings)
{
    static int list[MOST_VERTICES];
    static full_net unit;
    double none[POWERS] = {0};
    int n = list_points(list, z->dual, rings);
    double *m = malloc((size_t)n * (size_t)n * sizeof *m);
    for (int j = 0; j < n; j++) {
        memset(&unit, 0, sizeof unit);
        unit.re[list[j]] = 1;
        z->subdivide(unit.im, unit.re);
        for (int i = 0; i < n; i++) {
            m[i * n + j] = unit.im[list[i]];
            CHECK(!isnan(m[i * n + j]), "the test itself: the mesh is too small");
        }
    }
    memset(trace, 0, POWERS * sizeof *trace);
    traces(trace, none, m, NULL, n);
    free(m);
}

/* Adds the traces of the block, `times` times; imaginary parts must cancel with those of the conjugate block. */
static void add_block_traces(double *sum, const scheme *s, int k, int m, bool real, int times)
{
    scheme_numbers numbers;
    block b;
    diagnostic d = {0, 0, ""};
    double re[POWERS] = {0}, im[POWERS] = {0};
    block_status answer = BLOCK_BAD_INPUT;
    CHECK(scheme_numbers_make(&numbers, s, k, 64, &d) == STATUS_OK, "numbers: %s", d.text);
    answer = block_make(&b, &numbers, m, real, &d);
    CHECK(answer == BLOCK_OK, "block %d of %d: status %d %s", m, k, (int)answer, d.text);
    if (answer == BLOCK_OK) {
        double *p = malloc(2 * (size_t)(b.n * b.n) * sizeof *p), *q = p + b.n * b.n;
        CHECK((b.imaginary != NULL) == (m && !real) && b.rings == scheme_closed_rings(s) && b.mesh == s->mesh, "form");
        for (int i = 0; i < b.n * b.n; i++) {
            p[i] = number_mid_approx(&b.entry[i]);
            q[i] = b.imaginary ? number_mid_approx(&b.imaginary[i]) : 0;
            CHECK(is_near(&b.entry[i], p[i], 1e-12) && (!b.imaginary || is_near(&b.imaginary[i], q[i], 1e-12)), "an entry is wide");
        }
        traces(re, im, p, q, b.n);
        for (int i = 0; i < POWERS; i++) {
            CHECK((2 * m != k && m) || fabs(im[i]) < 1e-11, "block %d of %d has a complex trace", m, k);
            sum[i] += times * re[i];
        }
        free(p);
    }
    block_free(&b);
    scheme_numbers_free(&numbers);
}

static void test_traces(void)
{
    for (int i = 0; i < SUBJECTS; i++) {
        char name[80];
        scheme s;
        snprintf(name, sizeof name, "quad-traces-of-full-matrix-%s", subjects[i].name);
        test_begin(name);
        read_scheme(&s, subjects[i].text);
        for (int k = 3; k <= MOST_SECTORS && !test_failed(); k++) {
            double full[POWERS];
            make_mesh(k);
            full_traces(full, &subjects[i], scheme_closed_rings(&s));
            for (int real = 0; real <= s.mirror_symmetric; real++) {
                double sum[POWERS] = {0};
                for (int m = 0; m <= k / 2; m++)
                    add_block_traces(sum, &s, k, m, real, m == 0 || 2 * m == k ? 1 : 2);
                for (int p = 0; p < POWERS; p++)
                    CHECK(fabs(sum[p] - full[p]) < 1e-9, "k = %d, %s form: the trace of power %d is %.12g, the blocks say %.12g", k, real ? "real" : "complex", p + 1, full[p], sum[p]);
            }
        }
        scheme_clear(&s);
        test_end();
    }
}

/* ---- points outside the sector: straight on across the spokes ---- */

/* The square on the other side of the edge i of a square (from corner i to the next). */
static int across(int square, int i)
{
    const int *c = grid_mesh.corner[square];
    return left_of(c[(i + 1) % 4], c[i]);
}

/* Coming to `vertex` from `from`, straight on at a vertex with four edges. */
static int straight_on(int from, int vertex)
{
    int list[MOST_SECTORS + 1], f = left_of(from, vertex);
    int n = f < 0 ? 0 : squares_round(list, vertex, f);
    if (n != 4)
        return -1;
    /* from -> vertex has f on its left; the square before f, clockwise, lies on the right; two edges further on */
    const int *c = grid_mesh.corner[list[2]];
    return c[(corner_of(list[2], vertex) + 1) % 4] == from ? -1 : c[(corner_of(list[2], vertex) + 3) % 4];
}

static void check_value_at(const sector_net *net, const full_net *full, int point, int a, int b, bool real, int m)
{
    double half = real ? sin(PI * m / grid_mesh.k) : 1;
    number x, y;
    number_init(&x), number_init(&y);
    CHECK(sector_value(&x, &y, net, a, b, 64) == SECTOR_OK, "(%d,%d) has no value", a, b);
    CHECK(is_near(&x, full->re[point], 1e-12) && fabs(half * number_mid_approx(&y) - full->im[point]) < 1e-12, "k = %d, m = %d, %s form: the value at (%d,%d)", grid_mesh.k, m, real ? "real" : "complex", a, b);
    number_clear(&x), number_clear(&y);
}

/* From every point of the sector west across the second spoke, and south across the first. */
static void check_walks(bool dual, int k, int m, bool real)
{
    static full_net full;
    enum { STEPS = 5 };
    sector_net net;
    twist twist_of_m;
    const twist *t = make_twist(&twist_of_m, m, k, real);
    make_mesh(k);
    MUST(sector_net_make(&net, dual ? MESH_DUAL : MESH_QUAD, k == 4, RINGS, t));
    random_net(&full, &net, dual, m, real);
    for (int south = 0; south < 2; south++)
        for (int row = 1; row <= RINGS - 1; row++) { /* the coordinate that stays */
            int at[STEPS];
            if (dual) {
                at[0] = south ? square_at(0, row, 1) : square_at(0, 1, row);
                int edge = south ? 0 : 3; /* the first step leaves over the side next to a spoke; then always the opposite one */
                for (int i = 1; i < STEPS; i++) {
                    int next = across(at[i - 1], edge), c = grid_mesh.corner[at[i - 1]][edge];
                    edge = (corner_of(next, c) + 1) % 4; /* there it runs backwards, and its end comes first: c is its end */
                    at[i] = next;
                }
            } else {
                at[0] = south ? vertex_at(0, row, 1) : vertex_at(0, 1, row);
                at[1] = south ? vertex_at(0, row, 0) : vertex_at(0, 0, row);
                for (int i = 2; i < STEPS; i++)
                    at[i] = straight_on(at[i - 2], at[i - 1]);
            }
            for (int i = 1; i < STEPS && !test_failed(); i++) {
                int place = 1 - i; /* 1 is the first row or column of the sector */
                CHECK(at[i] >= 0, "the test itself");
                if (!test_failed())
                    check_value_at(&net, &full, at[i], south ? row : place, south ? place : row, real, m);
            }
        }
    number x, y;
    number_init(&x), number_init(&y);
    for (int a = -3; a <= 0; a++)
        for (int b = -3; b <= 0; b++) {
            sector_status answer = sector_value(&x, &y, &net, a, b, 64);
            if (!dual && a == 0) /* the centre, and the spoke to the right of the sector */
                check_value_at(&net, &full, vertex_at(k - 1, -b, 0), a, b, real, m);
            else if (k == 4) /* the plane */
                check_value_at(&net, &full, dual ? square_at(2, 1 - a, 1 - b) : vertex_at(2, -a, -b), a, b, real, m);
            else
                CHECK(answer == SECTOR_OPPOSITE, "(%d,%d) is opposite: %d", a, b, (int)answer);
        }
    CHECK(sector_value(&x, &y, &net, RINGS + 1, 1, 64) == SECTOR_OUTSIDE && sector_value(&x, &y, &net, 1, RINGS + 1, 64) == SECTOR_OUTSIDE, "outside");
    CHECK(sector_value(&x, &y, &net, -RINGS - 1, 2, 64) == SECTOR_OUTSIDE && sector_value(&x, &y, &net, 2, -RINGS - 1, 64) == SECTOR_OUTSIDE, "outside, across a spoke");
    number_clear(&x), number_clear(&y);
    sector_net_free(&net);
    twist_clear(&twist_of_m);
}

static void test_walks(void)
{
    test_begin("quad-sector-value-walks");
    for (int dual = 0; dual < 2; dual++)
        for (int k = 3; k <= MOST_SECTORS; k++)
            for (int m = 0; m <= k / 2 && !test_failed(); m++)
                for (int real = 0; real < 2; real++)
                    check_walks(dual, k, m, real);
    test_end();
}

/* ---- golden values ---- */

/* det(B - x) of these is 0: elimination meets a pivot that is about 0. */
static double least_pivot(const block *b, double x)
{
    enum { MOST = 40 };
    double a[MOST][MOST], least = 1;
    int n = b->n;
    CHECK(n <= MOST, "%d unknowns", n);
    for (int i = 0; i < n && n <= MOST; i++)
        for (int j = 0; j < n; j++)
            a[i][j] = number_mid_approx(&b->entry[i * n + j]) - (i == j ? x : 0);
    for (int c = 0; c < n && n <= MOST; c++) {
        int pivot = c;
        for (int i = c + 1; i < n; i++)
            pivot = fabs(a[i][c]) > fabs(a[pivot][c]) ? i : pivot;
        for (int j = 0; j < n; j++) {
            double swap = a[c][j];
            a[c][j] = a[pivot][j], a[pivot][j] = swap;
        }
        least = fmin(least, fabs(a[c][c]));
        for (int i = c + 1; i < n && a[c][c] != 0; i++) {
            double f = a[i][c] / a[c][c];
            for (int j = c; j < n; j++)
                a[i][j] -= f * a[c][j];
        }
    }
    return least;
}

static void test_golden(void)
{
    test_begin("quad-golden-eigenvalues");
    scheme s;
    read_scheme(&s, subjects[0].text);
    for (int k = 3; k <= 40; k++)
        for (int m = 1; m <= k / 2; m++) {
            /* On ring 1 the unknowns are the edge point and the face point: new edge 3/8 e + 1/16 (t + 1/t) e + 1/16 (1 + 1/t) f,
               new face 1/4 (1 + t) e + 1/4 f, so x^2 - (5/8 + c/8) x + 1/4 (3/8 + c/8) - 1/32 (1 + c) = 0 with c = cos w. */
            double c = cos(2 * PI * m / k), p = 5.0 / 8 + c / 8, q = (3.0 / 8 + c / 8) / 4 - (1 + c) / 32, root = sqrt(p * p - 4 * q);
            scheme_numbers numbers;
            block b;
            diagnostic d;
            CHECK(scheme_numbers_make(&numbers, &s, k, 64, &d) == STATUS_OK && block_make(&b, &numbers, m, true, &d) == BLOCK_OK, "block");
            for (int sign = -1; sign <= 1 && !test_failed(); sign += 2)
                CHECK(least_pivot(&b, (p + sign * root) / 2) < 1e-12, "k = %d, m = %d: %.12g is no eigenvalue", k, m, (p + sign * root) / 2);
            CHECK(least_pivot(&b, (p + root) / 2 + 1e-6) > 1e-9, "k = %d, m = %d: everything is an eigenvalue", k, m);
            block_free(&b);
            scheme_numbers_free(&numbers);
        }
    scheme_clear(&s);
    test_end();
}

/* ---- refusals ---- */

static void check_refusal(const char *text, int k, int m, block_status expected, const char *complaint)
{
    scheme s;
    scheme_numbers numbers;
    block b;
    diagnostic d = {0, 0, ""};
    read_scheme(&s, text);
    CHECK(scheme_numbers_make(&numbers, &s, k, 64, &d) == STATUS_OK, "%s", d.text);
    block_status answer = block_make(&b, &numbers, m, s.mirror_symmetric, &d);
    CHECK(answer == expected, "k = %d, m = %d: %d, not %d", k, m, (int)answer, (int)expected);
    CHECK(!strcmp(d.text, complaint), "\"%s\", not \"%s\"", d.text, complaint);
    block_free(&b);
    scheme_numbers_free(&numbers);
    scheme_clear(&s);
}

static void test_refusals(void)
{
    test_begin("quad-refusals");
    check_refusal(HEAD_DUAL DOO_SABIN_MASK, 5, 0, BLOCK_OPPOSITE, "");
    check_refusal(HEAD_DUAL DOO_SABIN_MASK, 5, 2, BLOCK_OPPOSITE, "");
    check_refusal(HEAD_DUAL DOO_SABIN_MASK, 4, 0, BLOCK_OK, ""); /* nothing is opposite there */
    check_refusal(HEAD_DUAL DOO_SABIN_MASK, 4, 1, BLOCK_OK, "");
    check_refusal(HEAD_DUAL DOO_SABIN_MASK, 4, 2, BLOCK_OK, "");
    check_refusal(HEAD_QUAD CATMULL_CLARK_MASK, 5, 0, BLOCK_NO_CENTRE_RULE, "");
    check_refusal(HEAD_QUAD CATMULL_CLARK_MASK, 5, 1, BLOCK_OK, ""); /* the centre is 0 */
    check_refusal(HEAD_QUAD CATMULL_CLARK_MASK "rule centre when k != 5\ncentre rest\nend\n", 5, 0, BLOCK_NO_CENTRE_RULE, "");
    check_refusal(HEAD_QUAD CATMULL_CLARK_MASK "rule centre when k != 5\ncentre rest\nend\n", 6, 0, BLOCK_OK, "");
    check_refusal(HEAD_QUAD CATMULL_CLARK_MASK CATMULL_CLARK_RULE "rule (1,0)\n(1,0) spectrum 1/(m - 2)\ncentre rest\nend\n", 5, 1, BLOCK_OK, "");
    check_refusal(HEAD_QUAD CATMULL_CLARK_MASK CATMULL_CLARK_RULE "rule (1,0)\n(1,0) spectrum 1/(m - 2)\ncentre rest\nend\n", 5, 2, BLOCK_BAD_INPUT, "division by zero (at m = 2)");
    check_refusal(HEAD_QUAD CATMULL_CLARK_MASK CATMULL_CLARK_RULE "rule (1,0)\n(1,0) @ j 1/(j + k - 8)\ncentre rest\nend\n", 5, 1, BLOCK_BAD_INPUT, "division by zero (at k = 5, j = 3)");
    test_end();
}

static void tests(void)
{
    test_steps();
    test_traces();
    test_walks();
    test_golden();
    test_refusals();
}
MAIN(tests);
