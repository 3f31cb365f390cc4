/* Laurent values: certificate-valences.md, section 4, "Limit". */

#include "laurent.h"

#include "exact_formula.h"

enum { SIZE = 2 * LAURENT_DEGREE + 1 };

struct laurent laurent_constant(rational q)
{
    struct laurent out;

    for (int i = 0; i < SIZE; i++)
        out.c[i] = rational_from(0, 1);
    out.c[LAURENT_DEGREE] = q;
    return out;
}

rational laurent_at(const struct laurent *a, int i)
{
    return a->c[i + LAURENT_DEGREE];
}

static void add(struct laurent *a, const struct laurent *b)
{
    for (int i = 0; i < SIZE; i++)
        if (b->c[i].num.sign != 0)
            a->c[i] = rational_add(a->c[i], b->c[i]);
}

static void negate(struct laurent *a)
{
    for (int i = 0; i < SIZE; i++)
        a->c[i] = rational_negate(a->c[i]);
}

void laurent_subtract(struct laurent *a, const struct laurent *b)
{
    negate(a);
    add(a, b);
    negate(a);
}

/* False beyond the largest degree. */
static bool multiply(struct laurent *a, const struct laurent *b)
{
    struct laurent *out = allocate(1, sizeof *out);

    *out = laurent_constant(rational_from(0, 1));
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
    *a = laurent_constant(rational_from(0, 1));
    a->c[SIZE - 1 - at] = q;
    return true;
}

static void set(void *out, rational q)
{
    *(struct laurent *)out = laurent_constant(q);
}

static bool apply(void *a, char operation, void *b, const void *field)
{
    (void)field;
    if (operation == '+')
        add(a, b);
    else if (operation == '-')
        laurent_subtract(a, b);
    else
        return (operation == '*' || invert(b)) && multiply(a, b);
    return true;
}

/* Numbers, k, and parameters with a value. */
static bool simple(void *out, const struct node *f, const struct environment *e,
                   const void *field)
{
    const struct definition *d = &e->language->definition[f->name];

    (void)field;
    set(out, rational_from(0, 1));
    if (f->kind == NODE_NUMBER)
        set(out, f->number);
    else if (f->kind == NODE_K)
        ((struct laurent *)out)->c[LAURENT_DEGREE + 1] = rational_from(1, 1);
    else if (f->kind == NODE_NAME && d->formula == NULL &&
             rational_compare(d->low, d->high) == 0)
        set(out, d->low);
    else
        return false;
    return true;
}

bool laurent_evaluate(struct laurent *out, const struct node *f, const struct environment *e)
{
    const struct ring ring = { sizeof *out, LAURENT_DEGREE, NULL, simple, set, apply };

    return ring_value(out, f, e, &ring);
}
