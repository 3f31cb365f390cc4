/* certificate_exact.c: a field, a factor, an eigenvalue, and one line for each exact block. */
#include "certificate_exact.h"

#include "../lib/number_field.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- writing ---- */

/* q = the least common denominator of `count` numbers. */
static bool common_denominator(integer *q, const rational *x, int count)
{
    bool ok = true;
    integer divisor;
    integer_init(&divisor);
    integer_set_si(q, 1);
    for (int i = 0; ok && i < count; i++)
        ok = integer_gcd(&divisor, q, &x[i].denominator) && integer_divexact(q, q, &divisor) && integer_mul(q, q, &x[i].denominator);
    integer_clear(&divisor);
    return ok;
}

static void write_coefficient(buffer *z, const rational *x, int count)
{
    integer q, part;
    bool ok;
    integer_init(&q);
    integer_init(&part);
    ok = common_denominator(&q, x, count);
    buffer_print(z, "coefficient ");
    buffer_hexadecimal(z, &q);
    for (int i = 0; ok && i < count; i++) {
        ok = integer_divexact(&part, &q, &x[i].denominator) && integer_mul(&part, &part, &x[i].numerator);
        buffer_print(z, " ");
        buffer_hexadecimal(z, &part);
    }
    buffer_print(z, "\n");
    if (!ok)
        z->failed = true;
    integer_clear(&q);
    integer_clear(&part);
}

void certificate_write_exact(buffer *z, const choices *c)
{
    const exact_choice *e = &c->exact;
    buffer_print(z, "field %ld\n", e->n);
    if (c->claim != CLAIM_MODULUS_ONE) {
        buffer_print(z, "factor %d\n", e->degree);
        for (int i = 0; i < e->degree; i++)
            write_coefficient(z, &e->coefficient[i * e->field_degree], e->field_degree);
        buffer_print(z, "eigenvalue ");
        buffer_hexadecimal(z, &e->eigenvalue);
        buffer_print(z, "\nradius ");
        buffer_hexadecimal(z, &e->radius);
        buffer_print(z, "\nothers %d\n", e->others);
    }
    for (int i = 0; i < e->count; i++) {
        const exact_line *l = &e->line[i];
        buffer_print(z, "exact %ld %d %d %d %d %d\n", l->frequency, l->sign, l->multiplicity, l->size, l->column, l->power);
    }
}

/* ---- reading ---- */

typedef struct {
    const char *at, *end;
    certificate_status status;
} reader;

static size_t next_word(reader *r, const char **word)
{
    size_t length;
    *word = r->at;
    while (r->at < r->end && *r->at != ' ' && *r->at != '\n')
        r->at++;
    length = (size_t)(r->at - *word);
    if (r->at < r->end)
        r->at++;
    return length;
}

static bool comes(reader *r, const char *name)
{
    const char *start = r->at, *word;
    size_t length = next_word(r, &word);
    if (length == strlen(name) && !memcmp(word, name, length))
        return true;
    r->at = start;
    return false;
}

static void expect(reader *r, const char *name)
{
    if (r->status == CERTIFICATE_READ && !comes(r, name))
        r->status = CERTIFICATE_MALFORMED;
}

static void read_integer(reader *r, integer *z, int base)
{
    const char *word;
    size_t length = next_word(r, &word);
    integer_text_status s;
    if (r->status != CERTIFICATE_READ)
        return;
    s = length && length <= 4098 ? integer_set_str(z, word, length, base) : INTEGER_TEXT_MALFORMED;
    if (s != INTEGER_TEXT_OK)
        r->status = s == INTEGER_TEXT_NO_MEMORY ? CERTIFICATE_NO_MEMORY : CERTIFICATE_MALFORMED;
}

static long read_long(reader *r, long low, long high)
{
    integer z;
    long v = low;
    integer_init(&z);
    read_integer(r, &z, 10);
    if (r->status == CERTIFICATE_READ && integer_cmp_si(&z, low) >= 0 && integer_cmp_si(&z, high) <= 0)
        v = (long)integer_get_si(&z);
    else if (r->status == CERTIFICATE_READ)
        r->status = CERTIFICATE_MALFORMED;
    integer_clear(&z);
    return v;
}

static void read_coefficient(reader *r, rational *x, int count)
{
    integer q, part;
    integer_init(&q);
    integer_init(&part);
    expect(r, "coefficient");
    read_integer(r, &q, 16);
    if (r->status == CERTIFICATE_READ && integer_sign(&q) <= 0)
        r->status = CERTIFICATE_MALFORMED;
    for (int i = 0; r->status == CERTIFICATE_READ && i < count; i++) {
        read_integer(r, &part, 16);
        if (r->status == CERTIFICATE_READ && !rational_set_integers(&x[i], &part, &q))
            r->status = CERTIFICATE_NO_MEMORY;
    }
    integer_clear(&q);
    integer_clear(&part);
}

static void read_factor(reader *r, exact_choice *e)
{
    int degree;
    number_field f;
    expect(r, "factor");
    degree = (int)read_long(r, 1, EXACT_MAX_FACTOR);
    if (r->status != CERTIFICATE_READ)
        return;
    if (!number_field_make(&f, e->n))
        r->status = f.failed ? CERTIFICATE_NO_MEMORY : CERTIFICATE_MALFORMED;
    else if (!exact_choice_make_factor(e, degree, f.degree))
        r->status = CERTIFICATE_NO_MEMORY;
    number_field_free(&f);
    for (int i = 0; r->status == CERTIFICATE_READ && i < degree; i++)
        read_coefficient(r, &e->coefficient[i * e->field_degree], e->field_degree);
    expect(r, "eigenvalue");
    read_integer(r, &e->eigenvalue, 16);
    expect(r, "radius");
    read_integer(r, &e->radius, 16);
    expect(r, "others");
    e->others = (int)read_long(r, 0, EXACT_MAX_POWER);
}

static void read_line(reader *r, exact_line *l, long highest)
{
    l->frequency = read_long(r, 0, highest);
    l->sign = (int)read_long(r, -1, 1);
    l->multiplicity = (int)read_long(r, 1, EXACT_MAX_FACTOR);
    l->size = (int)read_long(r, 1, l->multiplicity);
    l->column = (int)read_long(r, 0, EXACT_MAX_FACTOR);
    l->power = (int)read_long(r, 0, EXACT_MAX_POWER);
    if (l->sign == 0)
        r->status = CERTIFICATE_MALFORMED;
}

certificate_status certificate_read_exact(choices *c, const char **at, const char *end)
{
    reader r = {*at, end, CERTIFICATE_READ};
    exact_choice *e = &c->exact;
    expect(&r, "field");
    e->n = read_long(&r, 2, NUMBER_FIELD_MAX_N);
    if (c->claim != CLAIM_MODULUS_ONE)
        read_factor(&r, e);
    while (r.status == CERTIFICATE_READ && comes(&r, "exact")) {
        if (e->count < EXACT_MAX_LINES)
            read_line(&r, &e->line[e->count++], c->k.first / 2);
        else
            r.status = CERTIFICATE_MALFORMED;
    }
    *at = r.at;
    return r.status;
}
