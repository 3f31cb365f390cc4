/* Formulas and conditions, lib/formula.h: read, and evaluated exactly if they are short.  The first byte says which. */
#include "fuzz.h"

#include "lib/formula.h"

#include <stdlib.h>
#include <string.h>

enum { MAX_LINE = 1000, MAX_NODES = 40 };

static void evaluate(const formula *f, bool is_condition)
{
    formula_point at = {7, 2, 3};
    bool known, holds;
    diagnostic d;
    exact_value v;
    if (f->size > MAX_NODES)
        return;
    if (is_condition) {
        (void)!formula_exact_condition(&holds, &known, f, &at, &d);
        return;
    }
    exact_init(&v);
    (void)!formula_exact(&v, &known, f, &at, &d);
    exact_clear(&v);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static long column[MAX_LINE + 1];
    static definitions none;
    unsigned all = FORMULA_ON_VALENCE | FORMULA_ON_FREQUENCY | FORMULA_ON_SECTOR;
    bool is_condition = size > 0 && bytes[0] == '?';
    diagnostic d = {0, 0, ""};
    formula *f = NULL;
    status got;
    char *text;
    if (size < 1 || size > MAX_LINE || memchr(bytes, '\0', size) || !(text = malloc(size)))
        return 0;
    memcpy(text, bytes + 1, size - 1);
    for (size_t i = 0; i < size; i++)
        column[i] = (long)i + 1;
    got = (is_condition ? formula_read_condition : formula_read)(&f, text, size - 1, 1, column, &none, all, &d);
    if (got == STATUS_BAD_INPUT && (d.text[0] == '\0' || d.column > (long)size))
        abort(); /* a complaint without words, or about no place */
    if (got == STATUS_OK)
        evaluate(f, is_condition);
    formula_free(f);
    free(text);
    return fuzz_result(got == STATUS_OK);
}
