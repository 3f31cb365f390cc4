/* command_archive.c: what to do with which directories; and the list of what they hold. */
#define _GNU_SOURCE /* getopt_long */
#include "command_archive.h"

#include "archive.h"
#include "command.h"
#include "command_certificates.h"
#include "json.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <string.h>

static const char help[] =
    "Usage: smoothcert archive list|verify DIRECTORY... [--json]\n"
    "       smoothcert archive diff DIRECTORY DIRECTORY [--json]\n"
    "       smoothcert archive pack DIRECTORY [--without-logs] [--out FILE]\n"
    "Looks at directories in which `smoothcert prove` has left certificates; changes nothing in them.\n"
    "\n"
    "  list     the scheme, the valences with their verdicts, versions, precisions, the last run\n"
    "  verify   compares all files with index and journal, and follows every certificate once more\n"
    "  diff     which valences have other verdicts or other certificates in the second directory\n"
    "  pack     one file in tar's format, the same bytes for the same archive\n"
    "\n"
    "  --json          one JSON object per line (list, verify, diff)\n"
    "  --without-logs  only scheme, index, certificates and verify.sh: the same bytes on every machine\n"
    "  --out FILE      where to pack (default: standard output)\n"
    "  --help          this text\n"
    "\n"
    "Exit status: 0, diff: 1 if there are differences; 65 something is damaged or missing, or no archive;\n"
    "70 two certificates contradict each other: a fault of the program; 64, 71, 74 as always.\n";

int archive_view_open(archive_view *z, const char *path)
{
    if (archive_view_read(z, path))
        return -1;
    if (errno == ENOENT)
        return complain(EXIT_BAD_INPUT, "%s: there is no archive here (no " ARCHIVE_SCHEME ")", path);
    return complain_of_file(path);
}

/* ---- list ---- */

typedef struct {
    int oldest, newest; /* versions */
    long coarsest, finest;
    size_t bytes;
} summary;

static summary summarise(const archive_index *index)
{
    summary z = {0, 0, 0, 0, 0};
    bool first = true;
    for (size_t i = 0; i < index->count; i++) {
        const archive_index_entry *e = &index->entry[i];
        z.bytes += e->bytes;
        if (e->verdict == VERDICT_UNDECIDED)
            continue;
        z.oldest = first || e->version < z.oldest ? e->version : z.oldest;
        z.newest = first || e->version > z.newest ? e->version : z.newest;
        z.coarsest = first || e->grid < z.coarsest ? e->grid : z.coarsest;
        z.finest = first || e->grid > z.finest ? e->grid : z.finest;
        first = false;
    }
    return z;
}

/* The last line of the runs: a JSON object. */
static const char *last_run(const archive_view *v, int *length)
{
    const char *end = v->runs.bytes + v->runs.length, *p;
    if (v->runs.length < 3 || end[-1] != '\n')
        return NULL;
    for (p = end - 1; p > v->runs.bytes && p[-1] != '\n';)
        p--;
    *length = (int)(end - 1 - p);
    return p;
}

static int list_for_people(const archive_view *v)
{
    static const char *const verdicts[] = {[VERDICT_PROVED] = "proved", [VERDICT_REFUTED] = "refuted", [VERDICT_UNDECIDED] = "undecided"};
    summary s = summarise(&v->index);
    char name[65];
    const char *run;
    int length = 0;
    archive_view_name(name, v);
    printf("%s: %s\n", v->path, name);
    for (int i = VERDICT_PROVED; i <= VERDICT_UNDECIDED; i++) {
        buffer line;
        buffer_init(&line);
        buffer_print(&line, "  %-10s ", verdicts[i]);
        if (archive_view_list(&line, v, (verdict)i) && print_line(&line))
            return EXIT_NO_MEMORY;
        buffer_clear(&line);
    }
    printf("  format     %d", s.newest);
    if (s.oldest < s.newest)
        printf(" and older, from %d", s.oldest);
    printf("\n  grid       2^-%ld", s.coarsest);
    if (s.finest > s.coarsest)
        printf(" to 2^-%ld", s.finest);
    printf("\n  bytes      %zu of certificates\n", s.bytes);
    run = last_run(v, &length);
    if (run)
        printf("  last run   %.*s\n", length, run);
    if (!v->is_indexed)
        printf("  index      not up to date: a run was interrupted, or files were changed\n");
    return 0;
}

static int list_as_json(const archive_view *v)
{
    summary s = summarise(&v->index);
    char name[65];
    const char *run;
    int length = 0;
    buffer b;
    buffer_init(&b);
    archive_view_name(name, v);
    buffer_print(&b, "{\"scheme\":\"%s\"", name);
    json_add_string(&b, "directory", v->path);
    for (int i = VERDICT_PROVED; i <= VERDICT_UNDECIDED; i++) {
        buffer_print(&b, ",\"%s\":\"", verdict_name((verdict)i));
        archive_view_list(&b, v, (verdict)i);
        buffer_print(&b, "\"");
    }
    buffer_print(&b, ",\"formats\":[%d,%d],\"grids\":[%ld,%ld],\"bytes\":%zu", s.oldest, s.newest, s.coarsest, s.finest, s.bytes);
    buffer_print(&b, ",\"indexed\":%s", v->is_indexed ? "true" : "false");
    run = last_run(v, &length);
    if (run)
        buffer_print(&b, ",\"last_run\":%.*s", length, run);
    buffer_print(&b, "}");
    return print_line(&b);
}

int archive_list(const archive_options *o)
{
    int result = 0;
    for (int i = 0; result == 0 && i < o->count; i++) {
        archive_view v;
        archive_view_init(&v);
        result = archive_view_open(&v, o->directory[i]);
        if (result < 0)
            result = (o->json ? list_as_json : list_for_people)(&v);
        archive_view_clear(&v);
    }
    return result;
}

/* ---- which part ---- */

typedef struct {
    const char *name;
    int (*run)(const archive_options *);
    int least, most; /* directories */
} part;

static const part parts[] = {{"list", archive_list, 1, 1 << 20}, {"verify", archive_verify, 1, 1 << 20}, {"diff", archive_diff, 2, 2}, {"pack", archive_pack, 1, 1}};

static const part *find_part(const char *name)
{
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        if (!strcmp(parts[i].name, name))
            return &parts[i];
    return NULL;
}

/* -1: go on; else the exit status. */
static int read_options(archive_options *o, int argc, char **argv)
{
    static const struct option known[] = {
        {"out", required_argument, NULL, 'o'}, {"without-logs", no_argument, NULL, 'w'}, {"json", no_argument, NULL, 'J'}, {"help", no_argument, NULL, 'h'}, {NULL, 0, NULL, 0}};
    opterr = 0;
    for (int option; (option = getopt_long(argc, argv, "", known, NULL)) != -1;) {
        switch (option) {
        case 'o':
            o->out = optarg;
            break;
        case 'w':
            o->without_logs = true;
            break;
        case 'J':
            o->json = true;
            break;
        case 'h':
            fputs(help, stdout);
            return finish_output(0);
        default:
            return complain(EXIT_USAGE, "archive: unknown option or missing value at '%s'; see 'smoothcert archive --help'", argv[optind - 1]);
        }
    }
    return -1;
}

int command_archive(int argc, char **argv)
{
    archive_options o = {.json = false};
    const part *p;
    int result = read_options(&o, argc, argv);
    if (result >= 0)
        return result;
    if (optind == argc)
        return complain(EXIT_USAGE, "archive: expected list, verify, diff or pack; see 'smoothcert archive --help'");
    p = find_part(argv[optind]);
    if (!p)
        return complain(EXIT_USAGE, "archive: expected list, verify, diff or pack, found '%s'", argv[optind]);
    o.directory = argv + optind + 1;
    o.count = argc - optind - 1;
    if (o.count < p->least || o.count > p->most)
        return complain(EXIT_USAGE, "archive %s: expected %s", p->name, p->least == 2 ? "two directories" : p->most == 1 ? "one directory" : "a directory");
    if ((o.out || o.without_logs) && p->run != archive_pack)
        return complain(EXIT_USAGE, "archive %s: --out and --without-logs are for pack", p->name);
    if (o.json && p->run == archive_pack)
        return complain(EXIT_USAGE, "archive pack: --json is for list, verify and diff");
    return finish_output(p->run(&o));
}
