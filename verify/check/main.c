/* smoothcert-check: verifies certificates of C1 continuity of subdivision
 * schemes.
 *
 * The statement (scheme, valence, claim) comes from the command line, the
 * evidence from the certificate.  check() goes through certificate.md section
 * by section; whatever does not hold ends the program with "rejected" or "cannot
 * check" (answer.h), so that to return from it is to have verified everything.
 *
 * The files, in the order in which to read them:
 *
 *     answer          the three answers
 *     integer         integers of fixed capacity
 *     rational        exact rationals
 *     grid            section 2, grid intervals
 *     trig            section 2, pi, cos, sin
 *     sha256          the hash of the last record
 *     text            files, canonical text, tokens     (lib/scheme.md)
 *     formula         the value of a formula at k       (lib/scheme.md)
 *     mask            masks and their conditions        (lib/scheme.md)
 *     scheme          scheme files                      (lib/scheme.md)
 *     certificate     section 1, the file
 *     regular         section 4, C1 on the regular complex
 *     sector          section 5, sector nets and blocks
 *     spectrum        section 6, the spectrum
 *     window          section 7, elements and windows
 *     characteristic  section 7, the characteristic net
 *     decide          section 8, the decisions
 *     main            sections 3, 9 and 10
 */

#include "answer.h"
#include "certificate.h"
#include "characteristic.h"
#include "decide.h"
#include "regular.h"
#include "scheme.h"
#include "spectrum.h"
#include "text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_SCHEME_BYTES = 65536, MAX_CERTIFICATE_BYTES = 16777216 };

static const char USAGE[] =
    "Usage: smoothcert-check --scheme FILE --valence K --claim c1 CERTIFICATE\n"
    "Checks a certificate that the scheme in FILE is C1 at valence K.\n"
    "\n"
    "      --scheme=FILE      the scheme, in the language of lib/scheme.md\n"
    "      --valence=K        the valence, 3..4096\n"
    "      --claim=CLAIM      the claim: c1 (not-c1 is not in version 0)\n"
    "      --set=NAME=VALUE   a parameter's value (not in version 0)\n"
    "      --help             print this text and exit\n"
    "      --version          print the version and exit\n"
    "\n"
    "Exit status: 0 verified, 1 rejected, 2 cannot check (also wrong usage).\n";

/* The statement and the evidence
 * ------------------------------ */

struct arguments {
    const char *scheme, *valence, *claim, *certificate;
    int k;
};

/* The value of the option `name` in arguments[*i], or of --name=value; NULL if
 * the argument is another one. */
static const char *option_value(const char *name, char **arguments, int count, int *i)
{
    const char *argument = arguments[*i];
    size_t length = strlen(name);

    if (strncmp(argument, name, length) != 0)
        return NULL;
    if (argument[length] == '=')
        return argument + length + 1;
    if (argument[length] != '\0')
        return NULL;
    if (*i + 1 >= count)
        cannot_check("option %s needs a value (see --help)", name);
    (*i)++;
    return arguments[*i];
}

static void set_once(const char **out, const char *value, const char *what)
{
    if (*out != NULL)
        cannot_check("%s is given twice (see --help)", what);
    *out = value;
}

static int read_valence(const char *list)
{
    int k = 0;
    size_t length = strlen(list);

    if (length == 0)
        cannot_check("--valence needs a number");
    for (size_t i = 0; i < length; i++)
        if (list[i] < '0' || list[i] > '9' || (i == 0 && list[i] == '0'))
            cannot_check("--valence: expected one number; lists and ranges are "
                         "not in version 0");
    for (size_t i = 0; i < length && k <= 4096; i++)
        k = 10 * k + (list[i] - '0');
    if (k < 3 || k > 4096)
        cannot_check("--valence: expected a number in 3..4096");
    return k;
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

static void read_arguments(struct arguments *out, int count, char **arguments)
{
    bool options_end = false;
    const char *value;

    memset(out, 0, sizeof *out);
    for (int i = 1; i < count; i++) {
        const char *argument = arguments[i];

        if (options_end || argument[0] != '-' || argument[1] == '\0')
            set_once(&out->certificate, argument, "the certificate");
        else if (strcmp(argument, "--") == 0)
            options_end = true;
        else if (strcmp(argument, "--help") == 0)
            print_and_exit(USAGE);
        else if (strcmp(argument, "--version") == 0)
            print_and_exit("smoothcert-check, certificates of version 0\n");
        else if ((value = option_value("--scheme", arguments, count, &i)) != NULL)
            set_once(&out->scheme, value, "--scheme");
        else if ((value = option_value("--valence", arguments, count, &i)) != NULL)
            set_once(&out->valence, value, "--valence");
        else if ((value = option_value("--claim", arguments, count, &i)) != NULL)
            set_once(&out->claim, value, "--claim");
        else if (option_value("--set", arguments, count, &i) != NULL)
            cannot_check("--set: parameters are not in version 0");
        else
            cannot_check("unknown option %s (see --help)", argument);
    }
    if (out->scheme == NULL)
        cannot_check("no scheme is given (see --help)");
    if (out->valence == NULL)
        cannot_check("no valence is given (see --help)");
    if (out->claim == NULL)
        cannot_check("no claim is given (see --help)");
    if (out->certificate == NULL)
        cannot_check("no certificate is given (see --help)");
    if (strcmp(out->claim, "not-c1") == 0)
        cannot_check("--claim: not-c1 is not in version 0");
    if (strcmp(out->claim, "c1") != 0)
        cannot_check("--claim: expected c1");
    out->k = read_valence(out->valence);
}

/* Section 3: the certificate is about the reader's statement. */
static void compare_subject(const struct certificate *c, const char *canonical,
                            size_t size, int k)
{
    size_t same = 0;
    int line = c->line_of.scheme + 1;

    while (same < size && same < c->scheme_size &&
           canonical[same] == c->scheme_text[same]) {
        if (canonical[same] == '\n')
            line++;
        same++;
    }
    if (same < size || same < c->scheme_size)
        rejected(c->file, line, "scheme: expected the text of the given scheme");
    if (!c->claims_c1)
        rejected(c->file, c->line_of.claim, "claim: expected c1");
    if (c->valence != k)
        rejected(c->file, c->line_of.valence, "valence: expected %d", k);
}

/* Sections 4 to 8
 * --------------- */

/* Section 4; first: a_1 and a_2. */
static void check_regular(struct derived_masks *masks, const struct scheme *scheme,
                          const struct certificate *c)
{
    static const char *const name[3] = { "a_12", "a_13", "a_23" };
    int line = c->line_of.contraction;

    if (!regular_derive(masks, &scheme->mask))
        rejected(c->file, line, "contraction: the mask's symbol is not divisible "
                 "by the factors that differences need");
    for (int i = 0; i < 3; i++)
        if (!regular_contracts(&masks->second[i], c->contraction[i]))
            rejected(c->file, line, "contraction: power %d of 2 %s has a norm of at "
                     "least 1", c->contraction[i], name[i]);
}

/* Sections 5 and 6.  block: that of m = 1. */
static void check_spectrum(struct eigenpair *pair, const struct block *block,
                           const struct certificate *c)
{
    interval *matrix = block_matrix(block);

    spectrum_prove_eigenpair(pair, block, matrix, c);
    spectrum_prove_rest(block, matrix, pair, c);
    free(matrix);
    for (int m = 0; m <= c->valence / 2; m++) {
        struct block other;

        if (m == 1)
            continue;
        block_prepare(&other, block->scheme, block->mask, c->valence, m, c->grid);
        matrix = block_matrix(&other);
        spectrum_prove_rest(&other, matrix, pair, c);
        free(matrix);
        block_clear(&other);
    }
}

/* Sections 7 and 8 */
static void check_map(const struct block *block, const struct eigenpair *pair,
                      const struct derived_masks *masks, const struct certificate *c)
{
    struct characteristic *characteristic = allocate(1, sizeof *characteristic);
    struct mask *q = allocate(2, sizeof *q);

    mask_double(&q[0], &masks->first[0]);
    mask_double(&q[1], &masks->first[1]);
    if (!mask_is_nonnegative(&block->scheme->mask) ||
        !mask_is_nonnegative(&q[0]) || !mask_is_nonnegative(&q[1]))
        rejected(c->file, c->line_of.regularity, "regularity: version 0 needs "
                 "non-negative masks for values and derivatives");
    characteristic_prepare(characteristic, block, pair, &q[0], &q[1]);
    decide_regularity(characteristic, c);
    decide_boundary(characteristic, c);
    characteristic_clear(characteristic);
    free(characteristic);
    free(q);
}

/* Verifies the certificate: returns only if everything is proved. */
static void check(struct scheme *scheme, interval *eigenvalue,
                  struct certificate *certificate, const struct arguments *statement)
{
    size_t text_size, canonical_size, certificate_size;
    char *text = text_read_file(statement->scheme, MAX_SCHEME_BYTES, &text_size);
    char *canonical = text_canonical(statement->scheme, text, text_size,
                                     &canonical_size);
    char *bytes = text_read_file(statement->certificate, MAX_CERTIFICATE_BYTES,
                                 &certificate_size);
    struct derived_masks *masks = allocate(1, sizeof *masks);
    struct stencil *mask = allocate(1, sizeof *mask);
    struct eigenpair *pair = allocate(1, sizeof *pair);
    struct block block;

    certificate_read_subject(certificate, statement->certificate, bytes,
                             certificate_size);
    compare_subject(certificate, canonical, canonical_size, statement->k);
    scheme_read(scheme, statement->scheme, text, text_size, certificate->valence,
                certificate->grid);
    stencil_from_mask(mask, &scheme->mask, certificate->grid);
    certificate_read_choices(certificate, block_size(stencil_radius(mask)));

    block_prepare(&block, scheme, mask, certificate->valence, 1, certificate->grid);
    check_regular(masks, scheme, certificate);
    check_spectrum(pair, &block, certificate);
    check_map(&block, pair, masks, certificate);
    interval_set(eigenvalue, &pair->eigenvalue);

    free(pair->unknowns);
    free(pair);
    block_clear(&block);
    free(mask);
    free(masks);
    certificate_clear(certificate);
    free(bytes);
    free(canonical);
    free(text);
}

/* The answer
 * ---------- */

enum { DIGITS = 9, TEN_TO_DIGITS = 1000000000 };

/* floor (or ceiling) of a 2^-g 10^DIGITS, for 0 <= a <= 2^g. */
static long decimals(const integer *a, bool ceiling, int g)
{
    integer scaled;
    int64_t value;

    integer_set_small(&scaled, TEN_TO_DIGITS);
    integer_mul(&scaled, &scaled, a);
    if (ceiling)
        integer_shift_ceil(&scaled, &scaled, g);
    else
        integer_shift_floor(&scaled, &scaled, g);
    if (!integer_get_small(&value, &scaled, TEN_TO_DIGITS))
        cannot_check("the checker cannot print L");
    return (long)value;
}

static void print_decimal(long value)
{
    printf("%ld.%0*ld", value / TEN_TO_DIGITS, DIGITS, value % TEN_TO_DIGITS);
}

/* L lies strictly inside of its interval (section 6). */
static void print_verified(const struct scheme *scheme, const interval *eigenvalue,
                           int k, int g)
{
    printf("verified: %s is C1 at valence %d (", scheme->name, k);
    print_decimal(decimals(&eigenvalue->lo, false, g));
    printf(" < L < ");
    print_decimal(decimals(&eigenvalue->hi, true, g));
    printf(")\n");
    finish_output();
}

int main(int count, char **arguments)
{
    struct arguments statement;
    struct scheme *scheme = allocate(1, sizeof *scheme);
    struct certificate *certificate = allocate(1, sizeof *certificate);
    interval eigenvalue;

    read_arguments(&statement, count, arguments);
    check(scheme, &eigenvalue, certificate, &statement);
    print_verified(scheme, &eigenvalue, statement.k, certificate->grid);
    free(scheme);
    free(certificate);
    return ANSWER_VERIFIED;
}
