/* Sector nets and the blocks of the subdivision matrix: section 5 of certificate.md. */

#include "sector.h"

#include "answer.h"
#include "grid.h"

#include <string.h>

struct affine pair_norm(struct pair v, int g)
{
    return affine_add(affine_mul(v.x, v.x, g), affine_mul(v.y, v.y, g));
}

struct pair pair_add(struct pair v, struct pair w)
{
    return (struct pair) { affine_add(v.x, w.x), affine_add(v.y, w.y) };
}

struct pair pair_divide(struct pair v, struct pair w, int g)
{
    struct affine d = pair_norm(w, g);
    struct affine x = affine_add(affine_mul(v.x, w.x, g), affine_mul(v.y, w.y, g));
    struct affine y = affine_sub(affine_mul(v.y, w.x, g), affine_mul(v.x, w.y, g));

    return (struct pair) { affine_div(x, d, g), affine_div(y, d, g) };
}

/* Rotation
 * -------- */

void label_from_next(enum mesh mesh, int *a, int *b)
{
    int x = *a;

    *a = mesh == TRIANGLE ? x + *b : *b;
    *b = mesh == DUAL ? 1 - x : -x;
}

void label_from_before(enum mesh mesh, int *a, int *b)
{
    int y = *b;

    *b = mesh == TRIANGLE ? *a + y : *a;
    *a = mesh == DUAL ? 1 - y : -y;
}

enum place label_turn(enum mesh mesh, int *a, int *b)
{
    int first = mesh == DUAL ? 1 : 0;

    if (mesh != DUAL && *a == 0 && *b == 0)
        return CENTRE;
    if (*a >= 1 && *b >= first)
        return IN_SECTOR;
    if (*b >= 1) {
        label_from_next(mesh, a, b);
        return BEHIND;
    }
    if (*a >= first) {
        label_from_before(mesh, a, b);
        return BEFORE;
    }
    return OPPOSITE;
}

static struct pair apply_matrix(const struct affine m[4], struct pair v, int g)
{
    struct pair out = { affine_add(affine_mul(m[0], v.x, g), affine_mul(m[1], v.y, g)),
                        affine_add(affine_mul(m[2], v.x, g), affine_mul(m[3], v.y, g)) };

    return out;
}

static void set_matrix(struct affine m[4], struct affine m0, struct affine m1,
                       struct affine m2, struct affine m3)
{
    m[0] = m0;
    m[1] = m1;
    m[2] = m2;
    m[3] = m3;
}

/* At one valence: the hull of cos(pi m q) over the frequencies m, q = num/k; or of sines. */
static struct affine over_range(interval (*f)(rational, int), int64_t num,
                                const struct block *block)
{
    const struct valence *v = block->v;
    interval out = f(rational_from(num * block->m.first, v->k.first), v->g);

    if (span_is_several(block->m))
        out = interval_hull(out, f(rational_from(num * block->m.last, v->k.first), v->g));
    return affine_from(out);
}

/* c, n and v of the real form. */
static void turn_by_u(struct block *out, struct affine u)
{
    int g = out->v->g;
    struct affine one = affine_from_whole(1, g), v = affine_add(u, u);
    struct affine c = affine_sub(affine_mul(v, u, g), one);
    struct affine n = affine_mul(v, affine_sub(one, affine_mul(u, u, g)), g);

    out->u = u;
    set_matrix(out->turn, c, affine_minus(n), v, c);
    set_matrix(out->back, c, n, affine_minus(v), c);
}

static void turn_by_angle(struct block *out)
{
    int64_t k = out->v->k.first;
    struct affine c = over_range(grid_cos_pi, 2, out), s = over_range(grid_sin_pi, 2, out);

    if (span_is_several(out->m) && 4 * out->m.first <= k && k <= 4 * out->m.last)
        s = affine_hull(s, affine_from_whole(1, out->v->g));
    set_matrix(out->turn, c, affine_minus(s), s, c);
    set_matrix(out->back, c, s, affine_minus(s), c);
}

/* Nets
 * ---- */

static int side(const struct net *net)
{
    return 2 * net->rings + 3;
}

/* The index of a label with both coordinates from -rings - 1 to rings + 1. */
static size_t cell(const struct net *net, int a, int b)
{
    int i = a + net->rings + 1, j = b + net->rings + 1;

    if (i < 0 || i >= side(net) || j < 0 || j >= side(net))
        cannot_check("the checker looks for a point outside of its net");
    return (size_t)i * (size_t)side(net) + (size_t)j;
}

struct net net_of(const struct arithmetic *of, enum mesh mesh, int rings)
{
    struct net out = { .of = of, .mesh = mesh, .rings = rings };
    size_t cells = (size_t)side(&out) * (size_t)side(&out);

    out.value = allocate(cells, of->size);
    out.known = allocate(cells, sizeof out.known[0]);
    return out;
}

void *net_add(struct net *net, int a, int b)
{
    size_t i = cell(net, a, b);

    net->known[i] = true;
    return net->value + i * net->of->size;
}

const void *net_find(const struct net *net, const struct block *block, int a, int b)
{
    size_t i = cell(net, a, b);
    void *here = net->value + i * net->of->size;
    enum place place;

    if (net->known[i])
        return here;
    place = label_turn(net->mesh, &a, &b);
    if (place == IN_SECTOR && label_ring(net->mesh, a, b) > net->rings)
        cannot_check("the checker looks for a point outside of its net");
    if (place == IN_SECTOR || place == CENTRE)
        return here;                               /* 0 */
    if (place == OPPOSITE && valence_is_regular(block->v)) {
        label_from_next(net->mesh, &a, &b);
        place = BEHIND;
    }
    if (place == OPPOSITE)
        cannot_check("a rule uses a point opposite to its sector");
    memcpy(here, net_find(net, block, a, b), net->of->size);
    if (!block->plain)
        net->of->turn(here, place == BEHIND, block);
    net->known[i] = true;
    return here;
}

/* Of the net before the step `first`, for j rings of the last one; needed(j) if first = 0. */
static int rings_needed(const struct scheme *scheme, int first, int j)
{
    for (int i = scheme->steps - 1; i >= first; i--)
        j = step_needs(&scheme->step[i], j);
    return j;
}

/* R.  Beyond 200 needed(j) < j: rules name rings up to 16, and the other steps add up to
 * 33 rings before the first one halves. */
static int rings_of_unknowns(const struct scheme *scheme)
{
    int out = 1;

    for (int j = 200; j >= 1; j--)
        if (rings_needed(scheme, 0, j) >= j && j > out)
            out = j;
    while (rings_needed(scheme, 0, out) > out)
        out++;
    return out;
}

/* New values
 * ---------- */

static void find_new_value(void *sum, const struct net *old, const struct block *block, int step,
                           bool centre, int a, int b)
{
    const struct active_step *active = &block->v->step[step];
    const struct active_rule *rule = valence_rule(active, centre, a, b);
    const struct block_rule *r = rule == NULL ? NULL : &block->rule[step][rule - active->rule];
    const struct stencil *s = &active->stencil;
    int class = stencil_class(s, a, b);

    for (int i = 0; r != NULL && i < r->terms; i++)
        old->of->add_term(sum, &r->term[i], net_find(old, block, r->term[i].source->a,
                                                     r->term[i].source->b), block);
    for (int i = s->first[class]; r == NULL && i < s->first[class + 1]; i++) {
        const struct stencil_entry *e = &s->entry[i];

        old->of->add_entry(sum, e, net_find(old, block, (a - e->a) / s->dilation,
                                            (b - e->b) / s->dilation), block);
    }
    if (old->of->finish != NULL)
        old->of->finish(sum, block);
}

static struct net apply_step(const struct net *old, const struct block *block, int step, int rings)
{
    enum mesh mesh = block->v->step[step].step->new;
    struct net out = net_of(old->of, mesh, rings);

    if (block->plain && mesh != DUAL)
        find_new_value(net_add(&out, 0, 0), old, block, step, true, 0, 0);
    for (int a = 1; a <= rings; a++)
        for (int b = mesh == DUAL ? 1 : 0; label_ring(mesh, a, b) <= rings; b++)
            find_new_value(net_add(&out, a, b), old, block, step, false, a, b);
    return out;
}

struct net net_subdivide(const struct net *old, const struct block *block, int rings)
{
    const struct scheme *scheme = block->v->scheme;
    struct net net = *old;

    for (int i = 0; i < scheme->steps; i++)
        net = apply_step(&net, block, i, rings_needed(scheme, i + 1, rings));
    return net;
}

struct net net_extend(const struct net *old, const struct block *block, struct pair l, int rings)
{
    enum mesh mesh = old->mesh;
    struct net out;

    while (rings_needed(block->v->scheme, 0, rings) > old->rings)
        rings--;
    if (rings <= old->rings)
        cannot_check("the checker cannot extend the characteristic net");
    out = net_subdivide(old, block, rings);
    if (block->plain && mesh != DUAL)
        memcpy(net_add(&out, 0, 0), net_find(old, block, 0, 0), old->of->size);
    for (int a = 1; a <= rings; a++) {
        for (int b = mesh == DUAL ? 1 : 0; label_ring(mesh, a, b) <= rings; b++) {
            void *here = net_add(&out, a, b);

            if (label_ring(mesh, a, b) <= old->rings)
                memcpy(here, net_find(old, block, a, b), old->of->size);
            else
                old->of->divide(here, l, block);
        }
    }
    return out;
}

/* Nets of affine numbers
 * ---------------------- */

static void turn_pair(void *v, bool behind, const struct block *block)
{
    struct pair *out = v;

    *out = apply_matrix(behind ? block->turn : block->back, *out, block->v->g);
}

static void add_pair_term(void *sum, const struct term *t, const void *v, const struct block *block)
{
    const struct pair *old = v;
    struct pair *out = sum;
    int g = block->v->g;

    if (block->has_y)
        *out = pair_add(*out, apply_matrix(t->m, *old, g));
    else
        out->x = affine_add(out->x, affine_mul(t->m[0], old->x, g));
}

static void add_pair_entry(void *sum, const struct stencil_entry *e, const void *v,
                           const struct block *block)
{
    const struct pair *old = v;
    struct pair *out = sum;

    affine_add_multiple(&out->x, e->weight, &old->x, block->v->g);
    if (block->has_y)
        affine_add_multiple(&out->y, e->weight, &old->y, block->v->g);
}

static void divide_pair(void *v, struct pair l, const struct block *block)
{
    struct pair *out = v;

    if (!block->real && block->has_y) {
        *out = pair_divide(*out, l, block->v->g);
        return;
    }
    out->x = affine_div(out->x, l.x, block->v->g);
    out->y = affine_div(out->y, l.x, block->v->g);
}

static const struct arithmetic AFFINE = { sizeof(struct pair), turn_pair, add_pair_term,
                                          add_pair_entry, NULL, divide_pair };

struct net net_make(enum mesh mesh, int rings)
{
    return net_of(&AFFINE, mesh, rings);
}

void net_set(struct net *net, int a, int b, struct pair value)
{
    *(struct pair *)net_add(net, a, b) = value;
}

struct pair net_value(const struct net *net, const struct block *block, int a, int b)
{
    return *(const struct pair *)net_find(net, block, a, b);
}

/* Rules at these frequencies
 * -------------------------- */

/* m = W T^s */
static void power_matrix(struct affine m[4], interval w, int sectors, const struct block *block)
{
    int g = block->v->g, turns = sectors < 0 ? -sectors : sectors;
    struct affine one = affine_from_whole(1, g), zero = affine_from_whole(0, g);
    const struct affine *t = sectors < 0 ? block->back : block->turn;

    set_matrix(m, one, zero, zero, one);
    for (int i = 0; !block->plain && i < turns; i++) {
        struct pair left = { m[0], m[2] }, right = { m[1], m[3] };

        left = apply_matrix(t, left, g);
        right = apply_matrix(t, right, g);
        set_matrix(m, left.x, right.x, left.y, right.y);
    }
    for (int i = 0; i < 4; i++)
        m[i] = affine_scale(w, m[i], g);
}

/* m = sum of W_j T_j */
static void each_matrix(struct affine m[4], const interval *each, const struct block *block)
{
    const struct valence *v = block->v;
    interval h = grid_sin_pi(rational_from(block->m.first, v->k.first), v->g);

    if (span_is_several(block->m))
        rejected(v->reference.file, v->reference.line,
                 "a weight for each sector is for single frequencies only");
    for (int i = 0; i < 4; i++)
        m[i] = affine_from_whole(0, v->g);
    for (int64_t j = 0; j < v->k.first; j++) {
        struct mark mark = scratch_mark();
        int64_t n = block->m.first * j % v->k.first;
        interval c = v->cosine[n], s = v->sine[n];
        interval t[4] = { c, interval_minus(s), s, c };

        if (block->real) {
            t[1] = interval_minus(grid_mul(h, s, v->g));
            t[2] = grid_div(s, h, v->g);
        }
        for (int i = 0; i < 4; i++)
            m[i].c = interval_add(m[i].c, grid_mul(each[j], t[i], v->g));
        affine_keep(mark, m, 4);
    }
}

static interval formula_at(const struct node *formula, const struct environment *e,
                           const struct valence *v)
{
    struct value value = evaluate(formula, e);

    value_require(value, e->language, v->reference.file, v->reference.line);
    return value_enclose(value, v->g);
}

/* m = (R, -I; I, R).  I counts as 0 at m = k/2. */
static void spectrum_matrix(struct affine m[4], const struct source *s, const struct block *block)
{
    const struct valence *v = block->v;
    struct environment e = environment_make(&v->scheme->language, v->k, block->m, NOTHING, v->g);
    struct affine r = affine_from(formula_at(s->weight, &e, v));
    struct affine i = affine_from_whole(0, v->g);

    if (s->imaginary != NULL && 2 * block->m.first != v->k.first) {
        i.c = formula_at(s->imaginary, &e, v);
        if (2 * block->m.last >= v->k.first)
            i.c = interval_hull(i.c, grid_from(0, v->g));
    }
    set_matrix(m, r, affine_minus(i), i, r);
}

/* False if the source contributes nothing. */
static bool make_term(struct term *out, const struct weighted *w, const struct block *block)
{
    struct affine zero = affine_from_whole(0, block->v->g);

    out->source = w->source;
    set_matrix(out->m, w->weight, zero, zero, w->weight);
    if (block->plain)                              /* all weights are totals */
        return true;
    switch (w->source->kind) {
    case SOURCE_CENTRE:
    case SOURCE_ALL:
        return false;
    case SOURCE_ONE:
        power_matrix(out->m, w->weight.c, w->source->sectors, block);
        return true;
    case SOURCE_EACH:
        each_matrix(out->m, w->each, block);
        return true;
    default:
        spectrum_matrix(out->m, w->source, block);
        return true;
    }
}

static void prepare_rules(struct block *out)
{
    for (int i = 0; i < out->v->scheme->steps; i++) {
        const struct active_step *step = &out->v->step[i];

        out->rule[i] = allocate((size_t)step->rules, sizeof out->rule[i][0]);
        for (int n = 0; n < step->rules; n++) {
            struct block_rule *rule = &out->rule[i][n];
            int count = step->rule[n].rule->count;

            if (!out->plain && step->rule[n].rule->centre)
                continue;                          /* it stays 0 */
            if (step->rule[n].missing != NULL)
                value_require(*step->rule[n].missing, &out->v->scheme->language,
                              out->v->reference.file, out->v->reference.line);
            rule->term = allocate((size_t)count, sizeof rule->term[0]);
            for (int s = 0; s < count; s++)
                if (make_term(&rule->term[rule->terms], &step->rule[n].weighted[s], out))
                    rule->terms++;
        }
    }
}

/* Unknowns
 * -------- */

static void add_unknown(struct block *out, int a, int b, enum unknown_kind kind)
{
    out->unknown[out->n++] = (struct unknown) { a, b, kind };
}

static void add_unknowns_at(struct block *out, int a, int b)
{
    if (out->plain) {
        add_unknown(out, a, b, UNKNOWN_PLAIN);
    } else if (!out->real) {
        add_unknown(out, a, b, UNKNOWN_COMPLEX);
    } else if (b == 0) {
        add_unknown(out, a, b, UNKNOWN_SPOKE);
    } else if (a == b) {
        add_unknown(out, a, b, UNKNOWN_BISECTOR);
    } else if (a > b) {
        add_unknown(out, a, b, UNKNOWN_X);
        add_unknown(out, a, b, UNKNOWN_Y);
    }
}

static void list_unknowns(struct block *out)
{
    enum mesh mesh = out->v->scheme->mesh;

    out->unknown = allocate((size_t)(out->rings + 1) * (size_t)(out->rings + 1) * 2,
                            sizeof out->unknown[0]);
    if (out->plain && mesh != DUAL)
        add_unknown(out, 0, 0, UNKNOWN_PLAIN);
    for (int ring = 1; ring <= out->rings; ring++)
        for (int b = mesh == DUAL ? 1 : 0; b <= ring; b++)
            for (int a = ring; a >= 1; a--)
                if (label_ring(mesh, a, b) == ring)
                    add_unknowns_at(out, a, b);
}

void net_set_unknowns(struct net *out, const struct block *block, const struct affine *unknowns)
{
    struct affine zero = affine_from_whole(0, block->v->g);
    int g = block->v->g;

    for (int i = 0; i < block->n; i++) {
        const struct unknown *at = &block->unknown[i];
        struct pair value = { unknowns[i], zero };

        if (block->has_y && !block->real)
            value.y = unknowns[i + block->n];
        if (at->kind == UNKNOWN_BISECTOR)
            value = (struct pair) { affine_mul(block->u, unknowns[i], g), unknowns[i] };
        if (at->kind == UNKNOWN_X)                 /* UNKNOWN_Y is unknown i + 1 */
            value.y = unknowns[i + 1];
        if (at->kind != UNKNOWN_Y)
            net_set(out, at->a, at->b, value);
        value.y = affine_minus(value.y);
        if (at->kind == UNKNOWN_X)                 /* V(b,a) = T (x, -y) */
            net_set(out, at->b, at->a, apply_matrix(block->turn, value, g));
    }
}

/* Blocks
 * ------ */

static void begin_block(struct block *out, const struct valence *v, bool real, struct span m)
{
    memset(out, 0, sizeof *out);
    out->v = v;
    out->m = m;
    out->plain = m.first == 0;
    out->has_y = !out->plain;
    out->real = real && !out->plain;
    out->rings = rings_of_unknowns(v->scheme);
}

/* The rest, once T is known. */
static void finish_block(struct block *out)
{
    prepare_rules(out);
    list_unknowns(out);
    out->size = out->plain || out->real ? out->n : 2 * out->n;
}

void block_prepare(struct block *out, const struct valence *v, bool real, struct span m)
{
    begin_block(out, v, real, m);
    if (out->real)
        turn_by_u(out, over_range(grid_cos_pi, 1, out));
    else if (!out->plain)
        turn_by_angle(out);
    finish_block(out);
}

void block_prepare_over(struct block *out, const struct valence *v, struct span m, struct affine u)
{
    begin_block(out, v, true, m);
    turn_by_u(out, u);
    finish_block(out);
}

/* The value of a net at an unknown; `second`: the imaginary part. */
static struct affine read_off(const struct net *net, const struct block *block, int i, bool second)
{
    const struct unknown *unknown = &block->unknown[i];
    struct pair v = net_value(net, block, unknown->a, unknown->b);

    if (unknown->kind == UNKNOWN_BISECTOR || unknown->kind == UNKNOWN_Y || second)
        return v.y;
    return v.x;
}

struct affine *block_matrix(const struct block *block)
{
    size_t size = (size_t)block->size, n = (size_t)block->n;
    struct affine *matrix = allocate(size * size, sizeof matrix[0]);
    struct affine *unit = allocate(2 * n, sizeof unit[0]);
    struct affine *column = allocate(size, sizeof column[0]);

    for (size_t j = 0; j < n; j++) {
        struct mark mark = scratch_mark();
        struct net net = net_make(block->v->scheme->mesh, block->rings);

        unit[j] = affine_from_whole(1, block->v->g);
        net_set_unknowns(&net, block, unit);
        net = net_subdivide(&net, block, block->rings);
        for (size_t i = 0; i < size; i++)
            column[i] = read_off(&net, block, (int)(i % n), i >= n);
        affine_keep(mark, column, size);
        unit[j] = affine_from_whole(0, block->v->g);
        for (size_t i = 0; i < size; i++)
            matrix[i * size + j] = column[i];
        for (size_t i = 0; size > n && i < n; i++) {
            matrix[i * size + n + j] = affine_minus(column[i + n]);
            matrix[(i + n) * size + n + j] = column[i];
        }
    }
    return matrix;
}
