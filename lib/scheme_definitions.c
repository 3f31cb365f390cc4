/* scheme_definitions.c: parameters, with the values that the command line gives, and abbreviations. */
#include "scheme_reader.h"

#include <stdlib.h>
#include <string.h>

static status read_definition_name(definition *e, scheme_reader *r)
{
    size_t n = 0;
    reader_skip_blank(r);
    size_t start = r->at;
    while (r->at < r->line->length && (is_letter(r->line->text[r->at]) || (n > 0 && (is_digit(r->line->text[r->at]) || r->line->text[r->at] == '_')))) {
        if (n < DEFINITION_MAX_NAME)
            e->name[n] = r->line->text[r->at];
        n++;
        r->at++;
    }
    if (n == 0 || n > DEFINITION_MAX_NAME || formula_is_reserved(r->line->text + start, n)) {
        r->at = start;
        return reader_expected(r, "a new name (lower-case letters, digits and '_'; not a word of the language)");
    }
    e->name[n] = '\0';
    for (int i = 0; i < r->z->definitions.count; i++)
        if (!strcmp(r->z->definitions.entry[i].name, e->name)) {
            r->at = start;
            return reader_expected(r, "a name that is not defined yet");
        }
    return STATUS_OK;
}

/* The text that the command line gives for this parameter, or NULL. */
static const char *setting_of(const scheme_reader *r, const char *name)
{
    size_t length = strlen(name);
    for (int i = 0; r->settings && i < r->settings->count; i++)
        if (!strncmp(r->settings->settings[i], name, length) && r->settings->settings[i][length] == '=')
            return r->settings->settings[i] + length + 1;
    return NULL;
}

/* Reads an exact rational: a formula without variables. */
static status read_rational(rational *value, formula **f, const char *text, size_t length, long line, const long *column, scheme_reader *r)
{
    formula_point nowhere = {0, 0, 0};
    status s = formula_read(f, text, length, line, column, &r->z->definitions, 0, r->complaint);
    if (s == STATUS_OK)
        s = reader_count(r, *f);
    return s == STATUS_OK ? formula_exact_rational(value, *f, &nowhere, r->complaint) : s;
}

/* [LOW, HIGH] between text[0] and text[length - 1]. */
static status read_interval(formula **f, const char *text, size_t length, long line, const long *column, scheme_reader *r)
{
    formula *unused = NULL;
    rational low, high;
    size_t comma = 1;
    int depth = 0;
    status s;
    for (; comma < length && (depth > 0 || text[comma] != ','); comma++)
        depth += (text[comma] == '(') - (text[comma] == ')');
    if (comma >= length || text[length - 1] != ']')
        return diagnostic_set(r->complaint, line, column[0], "expected an interval such as [1/20, 1/10]");
    rational_init(&low);
    rational_init(&high);
    s = read_rational(&low, &unused, text + 1, comma - 1, line, column + 1, r);
    formula_free(unused);
    unused = NULL;
    if (s == STATUS_OK)
        s = read_rational(&high, &unused, text + comma + 1, length - comma - 2, line, column + comma + 1, r);
    formula_free(unused);
    if (s == STATUS_OK && rational_cmp(&low, &high) > 0)
        s = diagnostic_set(r->complaint, line, column[0], "the lower end of this interval is above the upper one");
    if (s == STATUS_OK && !formula_make_interval(f, &low, &high, line, column[0]))
        s = STATUS_NO_MEMORY;
    rational_clear(&low);
    rational_clear(&high);
    return s;
}

/* The value of a parameter: a rational constant, or an interval of them. */
static status read_constant(formula **f, const char *text, size_t length, long line, const long *column, scheme_reader *r)
{
    rational value;
    status s;
    if (length && text[0] == '[')
        return read_interval(f, text, length, line, column, r);
    rational_init(&value);
    s = read_rational(&value, f, text, length, line, column, r);
    rational_clear(&value);
    return s;
}

/* The columns of a text that comes from nowhere in the file: 1, 2, 3 ... */
static status read_setting(formula **f, const char *text, scheme_reader *r)
{
    size_t length = strlen(text);
    long *column = malloc((length + 1) * sizeof *column);
    status s;
    if (!column)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i <= length; i++)
        column[i] = (long)i + 1;
    s = read_constant(f, text, length, 0, column, r);
    free(column);
    return s;
}

static status read_definition(scheme_reader *r, bool is_parameter)
{
    definitions *names = &r->z->definitions;
    definition *e = &names->entry[names->count];
    const char *text;
    status s;
    if (names->count == DEFINITIONS_MAX)
        return reader_complain(r, "more than %s parameters and abbreviations", "64");
    memset(e, 0, sizeof *e);
    e->is_parameter = is_parameter;
    s = read_definition_name(e, r);
    if (s == STATUS_OK && !reader_take(r, '='))
        s = reader_expected(r, "'='");
    if (s != STATUS_OK)
        return s;
    reader_skip_blank(r);
    text = is_parameter ? setting_of(r, e->name) : NULL;
    if (is_parameter) {
        s = read_constant(&e->value, r->line->text + r->at, r->line->length - r->at, r->line->line, r->line->column + r->at, r);
        if (s == STATUS_OK && text) {
            formula_free(e->value);
            e->value = NULL;
            s = read_setting(&e->value, text, r);
        }
    } else {
        s = reader_formula(&e->value, r, FORMULA_ON_VALENCE | FORMULA_ON_FREQUENCY | FORMULA_ON_SECTOR);
    }
    if (s != STATUS_OK) {
        formula_free(e->value);
        return s;
    }
    names->count++;
    return STATUS_OK;
}

/* Leaves the first line that is no definition as the current one. */
status read_definitions(scheme_reader *r)
{
    for (;;) {
        bool parameter;
        status s;
        reader_next_line(r);
        parameter = reader_take_word(r, "parameter");
        if (!parameter && !reader_take_word(r, "let"))
            break;
        s = read_definition(r, parameter);
        if (s != STATUS_OK)
            return s;
    }
    for (int i = 0; r->settings && i < r->settings->count; i++) {
        const char *equals = strchr(r->settings->settings[i], '=');
        bool known = false;
        for (int j = 0; equals && j < i; j++)
            if (!strncmp(r->settings->settings[i], r->settings->settings[j], (size_t)(equals - r->settings->settings[i]) + 1))
                return diagnostic_set(r->complaint, 0, 0, "the parameter in '%.60s' is set twice", r->settings->settings[i]);
        for (int j = 0; j < r->z->definitions.count; j++) {
            const definition *e = &r->z->definitions.entry[j];
            size_t length = strlen(e->name);
            known = known || (e->is_parameter && !strncmp(r->settings->settings[i], e->name, length) && r->settings->settings[i][length] == '=');
        }
        if (!known)
            return diagnostic_set(r->complaint, 0, 0, "the scheme has no parameter for the setting '%.60s' (expected NAME=VALUE)", r->settings->settings[i]);
    }
    return STATUS_OK;
}
