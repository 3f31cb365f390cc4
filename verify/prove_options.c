/* prove_options.c: what the command line of `prove` says. */
#define _GNU_SOURCE /* getopt_long */
#include "prove_options.h"

#include "command.h"

#include <ctype.h>
#include <getopt.h>
#include <stdio.h>
#include <string.h>

static const char help[] =
    "Usage: smoothcert prove SCHEME --valence LIST [OPTION]...\n"
    "Proves that the scheme (a name of the catalogue, or a file) is C1 at vertices of each valence, or\n"
    "that it is not.\n"
    "\n"
    "  --valence LIST        valences, such as 7 or 3..20,50 or 8..inf or all; up to 1,000 of them are\n"
    "                        examined one by one, more in ranges, as wide as can be decided at once\n"
    "  --each                one by one, however many they are (100,000 at most)\n"
    "  --set NAME=VALUE      another value for a parameter of the scheme (may be repeated)\n"
    "  --method METHOD       adaptive (default), or uniform: the reference for triangle meshes, which\n"
    "                        subdivides everywhere alike and bounds the error of the whole net; the\n"
    "                        certificate's trees are then sought no deeper\n"
    "  --precision BITS      only balls of this precision (64 to 8192); default: hardware\n"
    "                        intervals, then balls of 64, 128, 256 ... bits\n"
    "  --max-precision BITS  the highest precision to try (default 4096; 0: intervals only)\n"
    "  --max-level N         the deepest subdivision to try (default: grows with the precision)\n"
    "  --time-limit SECONDS  leave undecided what is not decided by then\n"
    "  --jobs N              work on N valences at a time (default 1)\n"
    "  --out DIR|none        where certificates and logs go (default smoothcert-NAME, with the\n"
    "                        settings, method and precision behind it); what is proved there\n"
    "                        already is only checked again\n"
    "  --json                one JSON object per line, for each valence or range\n"
    "  --help                this text\n"
    "\n"
    "Behind ranges a line sums up, such as \"butterfly, in 7 boxes: C1: 4..7; not C1: 3 (jordan) ...\".\n"
    "Exit status: 0 everything was proved, 1 something was refuted, else 2 something stayed undecided.\n";

/* -1: go on; else the exit status. */
static int read_option(prove_options *o, int option, const char *value)
{
    long level = 0;
    switch (option) {
    case 'v':
        o->list = value;
        return -1;
    case 's':
        return scheme_options_set(&o->scheme, value) ? -1 : complain(EXIT_USAGE, "--set: at most %d settings", SCHEME_OPTIONS_MAX);
    case 'M':
        o->uniform = !strcmp(value, "uniform");
        return o->uniform || !strcmp(value, "adaptive") ? -1 : complain(EXIT_USAGE, "--method: expected 'adaptive' or 'uniform', found '%s'", value);
    case 'p':
        if (read_long_option(&o->limits.precision, value, LIMITS_MIN_PRECISION, LIMITS_MAX_PRECISION))
            return -1;
        return complain(EXIT_USAGE, "--precision: expected a number of bits from %d to %d, found '%s'", LIMITS_MIN_PRECISION, LIMITS_MAX_PRECISION, value);
    case 'm':
        if (read_long_option(&o->limits.max_precision, value, 0, LIMITS_MAX_PRECISION))
            return -1;
        return complain(EXIT_USAGE, "--max-precision: expected a number of bits from 0 to %d, found '%s'", LIMITS_MAX_PRECISION, value);
    case 'l':
        if (!read_long_option(&level, value, 1, TREE_MAX_DEPTH))
            return complain(EXIT_USAGE, "--max-level: expected a number from 1 to %d, found '%s'", TREE_MAX_DEPTH, value);
        o->limits.max_level = (int)level;
        return -1;
    case 't':
        return read_seconds_option(&o->limits.deadline, value) ? -1 : complain(EXIT_USAGE, "--time-limit: expected a number of seconds, found '%s'", value);
    case 'j':
        return read_long_option(&o->jobs, value, 1, 256) ? -1 : complain(EXIT_USAGE, "--jobs: expected a number from 1 to 256, found '%s'", value);
    case 'o':
        o->out = value;
        return -1;
    case 'e':
        o->each = true;
        return -1;
    case 'J':
        o->json = true;
        return -1;
    default:
        fputs(help, stdout);
        return finish_output(0);
    }
}

int prove_options_read(prove_options *o, int argc, char **argv)
{
    static const struct option known[] = {
        {"valence", required_argument, NULL, 'v'},   {"set", required_argument, NULL, 's'},       {"precision", required_argument, NULL, 'p'},
        {"max-precision", required_argument, NULL, 'm'}, {"max-level", required_argument, NULL, 'l'}, {"time-limit", required_argument, NULL, 't'},
        {"jobs", required_argument, NULL, 'j'},      {"out", required_argument, NULL, 'o'},       {"json", no_argument, NULL, 'J'},
        {"method", required_argument, NULL, 'M'},    {"each", no_argument, NULL, 'e'},               {"help", no_argument, NULL, 'h'},
        {NULL, 0, NULL, 0},
    };
    int option, result;
    memset(o, 0, sizeof *o);
    o->limits.max_precision = 4096;
    o->jobs = 1;
    opterr = 0;
    while ((option = getopt_long(argc, argv, "", known, NULL)) != -1) {
        if (option == '?')
            return complain(EXIT_USAGE, "prove: unknown option or missing value at '%s'; see 'smoothcert prove --help'", argv[optind - 1]);
        result = read_option(o, option, optarg);
        if (result >= 0)
            return result;
    }
    result = scheme_options_name(&o->scheme, "prove", argc, argv, optind);
    if (result >= 0)
        return result;
    if (!o->list)
        return complain(EXIT_USAGE, "prove: no valences given, such as --valence 3..20");
    return -1;
}

static size_t append(char *name, size_t length, const char *text)
{
    for (; *text && length + 1 < PROVE_ARCHIVE_NAME; text++)
        if (*text != ' ')
            name[length++] = strchr(",+-.=_", *text) || isalnum((unsigned char)*text) ? *text : '_';
    name[length] = '\0';
    return length;
}

/* smoothcert-NAME, and the settings.  Characters that might not do in the name of a file become `_`; if two schemes come to have
   one name so, archive_open tells them apart. */
void prove_options_archive(char name[PROVE_ARCHIVE_NAME], const prove_options *o, const char *scheme_name)
{
    char precision[40];
    size_t length = append(name, append(name, 0, "smoothcert-"), scheme_name);
    for (int i = 0; i < o->scheme.count; i++)
        length = append(name, append(name, length, ","), o->scheme.settings[i]);
    if (o->uniform)
        length = append(name, length, ",uniform");
    if (o->limits.precision) {
        snprintf(precision, sizeof precision, ",precision=%ld", o->limits.precision);
        append(name, length, precision);
    }
}
