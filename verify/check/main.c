/* smoothcert-check: verifies certificates of C1 continuity of subdivision schemes.
 *
 * The statement (scheme, valences, claim) comes from the command line, the evidence from
 * certificates.  check.c goes through certificate.md section by section; whatever does not hold
 * ends the program with "rejected" or "cannot check" (answer.h), so that to return from it is to
 * have verified everything.  README lists the files, in the order in which to read them.
 */

#include "answer.h"
#include "check.h"
#include "claim.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_SETTINGS = 64 };

static const char USAGE[] =
    "Usage: smoothcert-check --scheme FILE [--set NAME=VALUE]... --valence LIST\n"
    "                        --claim c1|not-c1 CERTIFICATE|DIRECTORY\n"
    "Checks a certificate that the scheme in FILE is C1 (is not C1) at a valence or a\n"
    "range of valences, or certificates in DIRECTORY (*.cert) that together are about\n"
    "all of a list, each valence once.\n"
    "\n"
    "      --scheme=FILE      the scheme, in the language of smoothcert-scheme(5)\n"
    "      --set=NAME=VALUE   a parameter's value, in place of that in FILE\n"
    "      --valence=LIST     numbers and ranges, e.g. 3..7,20..inf; all: 3..inf\n"
    "      --claim=CLAIM      the claim: c1 or not-c1\n"
    "      --help             print this text and exit\n"
    "      --version          print the version and exit\n"
    "\n"
    "Exit status: 0 all verified, 1 rejected, 2 cannot check (also wrong usage).\n";

/* Arguments
 * --------- */

enum { SCHEME, VALENCE, CLAIM, SET, CERTIFICATE, VALUES };

static const char *const NAME[VALUES] = { "--scheme", "--valence", "--claim", "--set",
                                          "certificate" };

struct arguments {
    const char *value[VALUES];
    int settings;
    struct setting setting[MAX_SETTINGS];
};

/* The value of the option `name` in arguments[*i], or of --name=value; NULL if
 * the argument is another one. */
static const char *option_value(const char *name, char **arguments, int count, int *i)
{
    const char *rest = arguments[*i] + strlen(name);

    if (strncmp(arguments[*i], name, strlen(name)) != 0 || (*rest != '=' && *rest != '\0'))
        return NULL;
    if (*rest == '=')
        return rest + 1;
    if (++*i >= count)
        cannot_check("option %s needs a value (see --help)", name);
    return arguments[*i];
}

static void set_once(struct arguments *out, int i, const char *value)
{
    if (out->value[i] != NULL)
        cannot_check("%s is given twice (see --help)", NAME[i]);
    out->value[i] = value;
}

/* NAME=VALUE */
static void add_setting(struct arguments *out, const char *text)
{
    const char *sign = strchr(text, '=');
    char *name;

    if (sign == NULL || sign == text || sign[1] == '\0' || strpbrk(sign, "#\n") != NULL)
        cannot_check("--set: expected NAME=VALUE, and a value on one line");
    if (out->settings == MAX_SETTINGS)
        cannot_check("--set: expected at most %d settings", MAX_SETTINGS);
    name = allocate((size_t)(sign - text) + 1, 1);
    memcpy(name, text, (size_t)(sign - text));
    for (int i = 0; i < out->settings; i++)
        if (strcmp(out->setting[i].name, name) == 0)
            cannot_check("--set: `%s` is set twice", name);
    out->setting[out->settings++] = (struct setting) { name, sign + 1 };
}

/* Output that did not arrive is no answer. */
static void finish_output(void)
{
    if (fflush(stdout) != 0 || ferror(stdout) != 0)
        cannot_check("the standard output cannot be written");
}

static noreturn void print_and_exit(const char *text)
{
    fputs(text, stdout);
    finish_output();
    exit(0);
}

static void read_option(struct arguments *out, char **arguments, int count, int *i)
{
    const char *value;

    if (strcmp(arguments[*i], "--help") == 0)
        print_and_exit(USAGE);
    if (strcmp(arguments[*i], "--version") == 0)
        print_and_exit("smoothcert-check, certificates of versions 0 and 1\n");
    for (int n = 0; n < CERTIFICATE; n++) {
        value = option_value(NAME[n], arguments, count, i);
        if (value == NULL)
            continue;
        if (n == SET)
            add_setting(out, value);
        else
            set_once(out, n, value);
        return;
    }
    cannot_check("unknown option %s (see --help)", arguments[*i]);
}

static void read_arguments(struct arguments *out, int count, char **arguments)
{
    bool options_end = false;

    for (int i = 1; i < count; i++) {
        if (options_end || arguments[i][0] != '-' || arguments[i][1] == '\0')
            set_once(out, CERTIFICATE, arguments[i]);
        else if (strcmp(arguments[i], "--") == 0)
            options_end = true;
        else
            read_option(out, arguments, count, &i);
    }
    for (int i = 0; i < VALUES; i++)
        if (i != SET && out->value[i] == NULL)
            cannot_check("no %s is given (see --help)", NAME[i] + (i == CERTIFICATE ? 0 : 2));
    if (strcmp(out->value[CLAIM], "c1") != 0 && strcmp(out->value[CLAIM], "not-c1") != 0)
        cannot_check("--claim: expected c1 or not-c1");
}

/* The answer
 * ---------- */

enum { DIGITS = 9, TEN_TO_DIGITS = 1000000000 };

/* floor (or ceiling) of a 2^-g 10^DIGITS, for 0 <= a. */
static void print_decimal(integer a, bool ceiling, int g)
{
    integer scaled = integer_mul(integer_from(TEN_TO_DIGITS), a);
    int64_t value;

    scaled = ceiling ? integer_shift_ceil(scaled, g) : integer_shift_floor(scaled, g);
    if (!integer_get_small(&value, scaled, INT64_MAX))
        cannot_check("the checker cannot print L");
    printf("%lld.%0*d", (long long)(value / TEN_TO_DIGITS), DIGITS, (int)(value % TEN_TO_DIGITS));
}

/* L lies strictly inside of its interval (section 6), at one valence. */
static void print_verified(const char *scheme, bool not_c1, struct span k, const struct verified *v)
{
    const char *name = v->real ? "L" : "|L|", *less = span_is_several(k) ? "<=" : "<";

    printf("verified: %s is %sC1 at %s %s (", scheme, not_c1 ? "not " : "",
           span_is_several(k) ? "valences" : "valence", span_text(k));
    if (v->plainly_regular) {
        printf("plainly regular)\n");
        return;
    }
    if (not_c1 && v->frequency < 0)
        printf("a window of frequencies: ");
    else if (not_c1)
        printf("frequency %lld: ", (long long)v->frequency);
    if (v->exact) {
        printf("|L| = 1)\n");
        return;
    }
    print_decimal(v->eigenvalue.lo, false, v->g);
    printf(" %s %s", less, name);
    if (v->degree > 0)
        printf(" (%lld/k)^%d", (long long)v->unit, v->degree);
    printf(" %s ", less);
    print_decimal(v->eigenvalue.hi, true, v->g);
    printf(")\n");
}

int main(int count, char **arguments)
{
    struct arguments *a = allocate(1, sizeof *a);
    struct claim *claim = allocate(1, sizeof *claim);
    struct statement *statement;
    struct folder folder;
    bool not_c1;

    read_arguments(a, count, arguments);
    claim_read(claim, a->value[VALENCE]);
    not_c1 = strcmp(a->value[CLAIM], "not-c1") == 0;
    statement = statement_new(a->value[SCHEME], a->setting, a->settings, not_c1);
    folder_partition(&folder, a->value[CERTIFICATE], claim);
    for (int i = 0; i < folder.count; i++) {
        struct span k = folder.file[i].k;
        struct verified v = check_certificate(statement, k, folder.file[i].name);

        print_verified(statement_scheme_name(statement), not_c1, k, &v);
    }
    finish_output();
    return ANSWER_VERIFIED;
}
