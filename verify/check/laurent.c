/* Laurent values: certificate-valences.md, section 4, "Limit", and section 6, "Growing". */

#include "laurent.h"

#include "exact_formula.h"

enum { SIZE = 2 * LAURENT_DEGREE + 1, MAX_LAURENT_EXPONENT = 1024 };

static struct laurent constant(rational q)
{
    struct laurent out;

    for (int i = 0; i < SIZE; i++)
        out.c[i] = rational_from(0, 1);
    out.c[LAURENT_DEGREE] = q;
    return out;
}

rational laurent_at(const struct laurent *a, int i)
{
    return i < -LAURENT_DEGREE || i > LAURENT_DEGREE ? rational_from(0, 1)
                                                     : a->c[i + LAURENT_DEGREE];
}

/* a + q b */
static void add_signed(struct laurent *a, int q, const struct laurent *b)
{
    for (int i = 0; i < SIZE; i++)
        if (b->c[i].num.sign != 0)
            a->c[i] = rational_add(a->c[i], rational_mul(rational_from(q, 1), b->c[i]));
}

/* False beyond the largest degree. */
static bool multiply(struct laurent *a, const struct laurent *b)
{
    struct laurent *out = allocate(1, sizeof *out);

    *out = constant(rational_from(0, 1));
    for (int i = 0; i < SIZE; i++) {
        for (int j = 0; j < SIZE && a->c[i].num.sign != 0; j++) {
            int n = i + j - LAURENT_DEGREE;

            if (b->c[j].num.sign == 0)
                continue;
            if (n < 0 || n >= SIZE)
                return false;
            out->c[n] = rational_add(out->c[n], rational_mul(a->c[i], b->c[j]));
        }
    }
    *a = *out;
    return true;
}

/* 1/a, for one term. */
static bool invert(struct laurent *a)
{
    int terms = 0, at = 0;
    rational q;

    for (int i = 0; i < SIZE; i++) {
        if (a->c[i].num.sign != 0) {
            terms++;
            at = i;
        }
    }
    if (terms != 1)
        return false;
    q = rational_divide(rational_from(1, 1), a->c[at]);
    *a = constant(rational_from(0, 1));
    a->c[SIZE - 1 - at] = q;
    return true;
}

static void set(void *out, rational q)
{
    *(struct laurent *)out = constant(q);
}

static bool apply(void *a, char operation, void *b, const void *field)
{
    (void)field;
    if (operation == '*' || operation == '/')
        return (operation == '*' || invert(b)) && multiply(a, b);
    add_signed(a, operation == '+' ? 1 : -1, b);
    return true;
}

/* Numbers, k, and parameters with a value. */
static bool simple(void *out, const struct node *f, const struct environment *e, const void *field)
{
    const struct definition *d = &e->language->definition[f->name];

    (void)field;
    set(out, rational_from(0, 1));
    if (f->kind == NODE_NUMBER)
        set(out, f->number);
    else if (f->kind == NODE_K)
        ((struct laurent *)out)->c[LAURENT_DEGREE + 1] = rational_from(1, 1);
    else if (f->kind == NODE_NAME && d->formula == NULL && !d->interval)
        set(out, d->low);
    else
        return false;
    return true;
}

bool laurent_weights(struct laurent *out, const struct rule *rule, const struct environment *e)
{
    const struct ring ring = { sizeof *out, -MAX_LAURENT_EXPONENT, MAX_LAURENT_EXPONENT, NULL,
                               simple, set, apply };
    struct laurent *rest = &out[rule->rest];

    *rest = constant(rational_from(1, 1));
    for (int i = 0; i < rule->count; i++) {
        if (i == rule->rest)
            continue;
        if (!ring_value(&out[i], rule->source[i].weight, e, &ring))
            return false;
        add_signed(rest, -1, &out[i]);
    }
    return true;
}

void laurent_rescale(struct laurent *a, int64_t unit)
{
    for (int i = 0; i < SIZE; i++) {
        if (a->c[i].num.sign == 0)
            continue;
        for (int n = LAURENT_DEGREE; n < i; n++)
            a->c[i] = rational_mul(a->c[i], rational_from(unit, 1));
        for (int n = i; n < LAURENT_DEGREE; n++)
            a->c[i] = rational_mul(a->c[i], rational_from(1, unit));
    }
}

/* Horner: z = w_d, then z = z kappa + w_i, i = d - 1 .. 0. */
bool laurent_in_kappa(struct affine *out, const struct laurent *a, struct affine kappa, int g)
{
    int first = LAURENT_DEGREE;

    for (int i = 1; i <= LAURENT_DEGREE; i++)
        if (laurent_at(a, i).num.sign != 0)
            return false;
    while (first > 0 && laurent_at(a, -first).num.sign == 0)
        first--;
    *out = affine_from_whole(0, g);
    for (int i = first; i >= 0; i--)
        *out = affine_add(affine_mul(*out, kappa, g),
                          affine_from(grid_from_rational(laurent_at(a, -i), g)));
    return true;
}
