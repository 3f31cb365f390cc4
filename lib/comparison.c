/* comparison.c: the simple schemes, and transport of weights at the least cost. */
#include "comparison.h"

#include <stdlib.h>
#include <string.h>

/* The least cost is sought for this many points of a class, and in this many moves: no mask of the language for single
   steps has more points, nor has one been seen that takes more than some dozens of moves. */
#define MAX_POINTS 100
#define MAX_MOVES 1000

/* ---- the simple schemes ---- */

/* z = the product of a factor in z1 and one in z2, each a hat (1, 2, 1)/2 at -1, 0, 1 or a box (1, 1) at -1, 0. */
static bool tensor(laurent *z, bool hat_a, bool hat_b)
{
    static const int hat[3] = {1, 2, 1}, box[3] = {2, 2, 0}; /* over 2 */
    lattice point[9];
    rational weight[9];
    size_t count = 0;
    bool ok = true;
    for (int i = 0; i < 9; i++)
        rational_init(&weight[i]);
    for (int i = 0; ok && i < (hat_a ? 3 : 2); i++)
        for (int j = 0; ok && j < (hat_b ? 3 : 2); j++) {
            point[count] = (lattice){i - 1, j - 1};
            ok = rational_set_si(&weight[count++], (hat_a ? hat : box)[i] * (hat_b ? hat : box)[j], 4);
        }
    ok = ok && laurent_set_terms(z, point, weight, count);
    for (int i = 0; i < 9; i++)
        rational_clear(&weight[i]);
    return ok;
}

/* New vertices are old ones or midpoints of edges. */
static bool midpoints_of_triangles(laurent *z)
{
    static const lattice point[7] = {{0, 0}, {1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};
    rational weight[7];
    bool ok = true;
    for (int i = 0; i < 7; i++)
        rational_init(&weight[i]);
    for (int i = 0; ok && i < 7; i++)
        ok = rational_set_si(&weight[i], 1, i == 0 ? 1 : 2);
    ok = ok && laurent_set_terms(z, point, weight, 7);
    for (int i = 0; i < 7; i++)
        rational_clear(&weight[i]);
    return ok;
}

bool comparison_values(laurent *z, mesh_kind mesh)
{
    if (mesh == MESH_TRIANGLE)
        return midpoints_of_triangles(z);
    return mesh == MESH_QUAD ? tensor(z, true, true) : tensor(z, false, false);
}

/* On dual quads the label x is the place x - (1/2, 1/2) (lib/mesh.h), so differences in direction 1 lie at whole places
   along axis 1: the hat is centred at them.  Along axis 2, as for values, x has the children 2x - 1 and 2x. */
bool comparison_derivative(laurent *z, mesh_kind mesh, int direction)
{
    bool exact;
    if (mesh == MESH_DUAL)
        return tensor(z, direction == 0, direction == 1);
    return comparison_values(z, mesh) && laurent_divide_binomial(z, &exact, z, regular_direction[direction]) && laurent_mul_si(z, z, 2);
}

/* ---- transport ---- */

/* Amounts that lie too much at some points and are missing at others, in one class. */
typedef struct {
    int sources, sinks;
    lattice *from, *to;     /* in coordinates along u and v */
    integer *excess, *need; /* > 0 until moved */
    integer *flow;          /* sources * sinks */
    int *distance, *came;   /* sources + sinks of each: by the cheapest way from a source with excess */
} transport;

static void transport_clear(transport *z)
{
    for (int i = 0; z->excess && i < z->sources; i++)
        integer_clear(&z->excess[i]);
    for (int j = 0; z->need && j < z->sinks; j++)
        integer_clear(&z->need[j]);
    for (int i = 0; z->flow && i < z->sources * z->sinks; i++)
        integer_clear(&z->flow[i]);
    free(z->from);
    free(z->to);
    free(z->excess);
    free(z->need);
    free(z->flow);
    free(z->distance);
    free(z->came);
}

static integer *new_integers(size_t n)
{
    integer *z = malloc((n + 1) * sizeof *z);
    for (size_t i = 0; z && i < n; i++)
        integer_init(&z[i]);
    return z;
}

static int cost(const transport *z, int i, int j)
{
    return abs(z->from[i].a - z->to[j].a) + abs(z->from[i].b - z->to[j].b);
}

/* The cheapest ways from the sources with excess: along any edge from a source to a sink, back along edges with flow
   (Bellman and Ford).  The answer is the nearest sink in need; -1: nothing is left to move. */
static int find_way(transport *z)
{
    int nodes = z->sources + z->sinks, best = -1;
    bool changed = true;
    for (int i = 0; i < nodes; i++) {
        z->distance[i] = i < z->sources && !integer_is_zero(&z->excess[i]) ? 0 : INT32_MAX;
        z->came[i] = -1;
    }
    while (changed) {
        changed = false;
        for (int i = 0; i < z->sources; i++)
            for (int j = 0; j < z->sinks; j++) {
                int *di = &z->distance[i], *dj = &z->distance[z->sources + j], c = cost(z, i, j);
                if (*di < INT32_MAX && *di + c < *dj) {
                    *dj = *di + c;
                    z->came[z->sources + j] = i;
                    changed = true;
                }
                if (*dj < INT32_MAX && *dj - c < *di && !integer_is_zero(&z->flow[i * z->sinks + j])) {
                    *di = *dj - c;
                    z->came[i] = z->sources + j;
                    changed = true;
                }
            }
    }
    for (int j = 0; j < z->sinks; j++)
        if (!integer_is_zero(&z->need[j]) && (best < 0 || z->distance[z->sources + j] < z->distance[z->sources + best]))
            best = j;
    return best;
}

/* Moves as much as the way to the sink j admits, and says where it began. */
static bool move_along(transport *z, int j)
{
    int node = z->sources + j;
    integer amount;
    bool ok;
    integer_init(&amount);
    ok = integer_set(&amount, &z->need[j]);
    while (ok && z->came[node] >= 0) {
        int before = z->came[node];
        if (node < z->sources) { /* back along the flow from `node` to the sink before it */
            const integer *flow = &z->flow[node * z->sinks + before - z->sources];
            if (integer_cmp(flow, &amount) < 0)
                ok = integer_set(&amount, flow);
        }
        node = before;
    }
    if (ok && integer_cmp(&z->excess[node], &amount) < 0)
        ok = integer_set(&amount, &z->excess[node]);
    ok = ok && integer_sub(&z->excess[node], &z->excess[node], &amount) && integer_sub(&z->need[j], &z->need[j], &amount);
    for (node = z->sources + j; ok && z->came[node] >= 0; node = z->came[node]) {
        int before = z->came[node];
        integer *flow = node < z->sources ? &z->flow[node * z->sinks + before - z->sources] : &z->flow[before * z->sinks + node - z->sources];
        ok = node < z->sources ? integer_sub(flow, flow, &amount) : integer_add(flow, flow, &amount);
    }
    integer_clear(&amount);
    return ok;
}

/* Any way will do, in the order of points. */
static int find_any_way(transport *z)
{
    int i = 0, j = 0;
    while (j < z->sinks && integer_is_zero(&z->need[j]))
        j++;
    while (i < z->sources && integer_is_zero(&z->excess[i]))
        i++;
    if (i == z->sources || j == z->sinks)
        return -1;
    z->came[i] = -1;
    z->came[z->sources + j] = i;
    return j;
}

/* total = what it costs to bring all excess where it is needed: the least, unless that takes too long.  Whatever the
   ways, a plan proves its cost. */
static bool transport_solve(integer *total, transport *z)
{
    integer c;
    bool ok = true;
    int j, moves = z->sources + z->sinks <= MAX_POINTS ? MAX_MOVES : 0;
    while (ok && (j = moves > 0 ? find_way(z) : find_any_way(z)) >= 0) {
        ok = move_along(z, j);
        moves--;
    }
    integer_init(&c);
    integer_zero(total);
    for (int i = 0; ok && i < z->sources * z->sinks; i++)
        ok = integer_mul_si(&c, &z->flow[i], cost(z, i / z->sinks, i % z->sinks)) && integer_add(total, total, &c);
    integer_clear(&c);
    return ok;
}

/* The coordinates of p along the basis u, v. */
static lattice along(lattice p, lattice u, lattice v)
{
    int determinant = u.a * v.b - u.b * v.a; /* 1 or -1 */
    return (lattice){(p.a * v.b - p.b * v.a) * determinant, (u.a * p.b - u.b * p.a) * determinant};
}

/* The row of x is sum of e(x - 2y) p(y): amounts e at places -y, that is at (x' - x) / 2 for x' = x - 2y. */
static bool transport_set(transport *z, const laurent *e, int class, lattice u, lattice v)
{
    size_t points = (size_t)(e->na * e->nb) + 1;
    bool ok = true;
    memset(z, 0, sizeof *z);
    z->from = malloc(points * sizeof *z->from);
    z->to = malloc(points * sizeof *z->to);
    z->excess = new_integers(points);
    z->need = new_integers(points);
    ok = z->from && z->to && z->excess && z->need;
    for (long i = 0; ok && i < e->na * e->nb; i++) {
        int a = (int)(e->a0 + i / e->nb), b = (int)(e->b0 + i % e->nb);
        int sign = integer_sign(&e->coefficient[i]);
        if ((a & 1) * 2 + (b & 1) != class || sign == 0)
            continue;
        lattice place = along((lattice){(a - (a & 1)) / 2, (b - (b & 1)) / 2}, u, v);
        if (sign > 0) {
            z->from[z->sources] = place;
            ok = integer_set(&z->excess[z->sources++], &e->coefficient[i]);
        } else {
            z->to[z->sinks] = place;
            ok = integer_neg(&z->need[z->sinks++], &e->coefficient[i]);
        }
    }
    z->flow = new_integers((size_t)z->sources * (size_t)z->sinks);
    z->distance = malloc((size_t)(z->sources + z->sinks + 1) * sizeof *z->distance);
    z->came = malloc((size_t)(z->sources + z->sinks + 1) * sizeof *z->came);
    return ok && z->flow && z->distance && z->came;
}

bool comparison_constant(rational *c, const laurent *s, const laurent *b, lattice u, lattice v)
{
    laurent e;
    integer total, largest;
    bool ok;
    laurent_init(&e);
    integer_init(&total);
    integer_init(&largest);
    ok = laurent_sub(&e, s, b);
    for (int class = 0; ok && class < 4; class++) {
        transport t;
        ok = transport_set(&t, &e, class, u, v) && transport_solve(&total, &t);
        transport_clear(&t);
        if (ok && integer_cmp(&total, &largest) > 0)
            integer_swap(&total, &largest);
    }
    ok = ok && rational_set_integers(c, &largest, &e.denominator);
    laurent_clear(&e);
    integer_clear(&total);
    integer_clear(&largest);
    return ok;
}

/* ---- all three ---- */

void comparison_init(comparison *z)
{
    rational_init(&z->values);
    rational_init(&z->derivative[0]);
    rational_init(&z->derivative[1]);
}

void comparison_clear(comparison *z)
{
    rational_clear(&z->values);
    rational_clear(&z->derivative[0]);
    rational_clear(&z->derivative[1]);
}

bool comparison_make(comparison *z, const laurent *mask, const regular_masks *masks)
{
    laurent b;
    bool ok;
    laurent_init(&b);
    ok = comparison_values(&b, masks->mesh) && comparison_constant(&z->values, mask, &b, regular_direction[0], regular_direction[1]);
    for (int i = 0; ok && i < 2; i++) {
        regular_pair p = regular_get_pair(masks->mesh, i);
        ok = comparison_derivative(&b, masks->mesh, i)
             && comparison_constant(&z->derivative[i], &masks->derivative[i], &b, regular_direction[p.direction[0]], regular_direction[p.direction[1]]);
    }
    laurent_clear(&b);
    return ok;
}
