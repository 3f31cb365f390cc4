/* report_read.c: a directory's index, logs and certificates. */
#include "report.h"

#include "analysis.h"
#include "certificate.h"
#include "sha256.h"

#include "../lib/growing.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_FILE_BYTES (64 << 20)
/* Of so many entries of each verdict maps are drawn, unless they are named. */
#define MOST_SHOWN 4
/* Of about so many entries, evenly spread, the Jacobian and the errors are measured. */
#define MOST_MEASURED 60

void report_init(report *z)
{
    memset(z, 0, sizeof *z);
    scheme_init(&z->scheme);
    problem_init(&z->problem);
}

void report_clear(report *z)
{
    for (size_t i = 0; i < z->count; i++)
        picture_clear(&z->entry[i].picture);
    free(z->entry);
    problem_clear(&z->problem);
    scheme_clear(&z->scheme);
}

/* ---- files ---- */

static report_status read_file(report *z, buffer *text, const char *name)
{
    char path[4096];
    if (snprintf(path, sizeof path, "%s/%s", z->path, name) >= (int)sizeof path)
        errno = ENAMETOOLONG;
    else if (buffer_read_file(text, path, MAX_FILE_BYTES))
        return REPORT_OK;
    snprintf(z->complaint, sizeof z->complaint, "%.300s/%.100s: %s", z->path, name, strerror(errno));
    return errno == ENOMEM ? REPORT_NO_MEMORY : REPORT_IO_ERROR;
}

static report_status read_scheme(report *z)
{
    diagnostic d;
    buffer text;
    status read;
    report_status result;
    buffer_init(&text);
    result = read_file(z, &text, "scheme.scheme");
    if (result == REPORT_IO_ERROR && errno == ENOENT)
        snprintf(z->complaint, sizeof z->complaint, "%.300s: there is no scheme.scheme here: expected a directory of 'smoothcert prove'", z->path);
    if (result == REPORT_OK) {
        read = scheme_read(&z->scheme, text.bytes ? text.bytes : "", text.length, NULL, &d);
        result = read == STATUS_OK ? REPORT_OK : read == STATUS_BAD_INPUT ? REPORT_BAD_INPUT : REPORT_NO_MEMORY;
        if (read == STATUS_BAD_INPUT)
            snprintf(z->complaint, sizeof z->complaint, "%.300s/scheme.scheme:%ld:%ld: %.150s", z->path, d.line, d.column, d.text);
    } else if (result == REPORT_IO_ERROR && errno == ENOENT)
        result = REPORT_BAD_INPUT;
    buffer_clear(&text);
    return result;
}

/* ---- the log ---- */

/* What follows "key": in the line; NULL: it does not occur. */
static const char *find_key(const char *line, const char *key)
{
    char quoted[40];
    const char *p;
    snprintf(quoted, sizeof quoted, "\"%s\":", key);
    p = strstr(line, quoted);
    return p ? p + strlen(quoted) : NULL;
}

static double find_number(const char *line, const char *key)
{
    const char *p = find_key(line, key);
    return p && *p != 'n' ? strtod(p, NULL) : NAN;
}

/* The strings of our logs contain no quotes but as \", and are ASCII. */
static void find_string(char *text, size_t size, const char *line, const char *key)
{
    const char *p = find_key(line, key);
    size_t length = 0;
    if (p && *p++ == '"')
        for (; *p && *p != '"' && length + 1 < size; p++) {
            if (*p == '\\' && p[1])
                p++;
            text[length++] = *p;
        }
    text[length] = '\0';
}

static void read_attempt(report_log *l, const char *line)
{
    char system[16], ending[16], test[32];
    long precision = (long)find_number(line, "precision");
    double error = find_number(line, "error"), seconds = find_number(line, "seconds");
    bool known;
    find_string(system, sizeof system, line, "system");
    find_string(ending, sizeof ending, line, "outcome");
    find_string(test, sizeof test, line, "test");
    known = !strcmp(ending, outcome_name(OUTCOME_TRUE));
    l->seconds += isnan(seconds) ? 0 : seconds;
    l->error = isnan(error) ? l->error : error;
    if (!strcmp(system, "grid") || system[0] == '\0')
        return;
    if (strcmp(system, l->system) || precision != l->precision) { /* another rung */
        l->reason[0] = '\0';
        if (strcmp(system, "exact") || !l->system[0]) {
            snprintf(l->system, sizeof l->system, "%s", system);
            l->precision = precision;
        }
    }
    if (known && !strcmp(test, "spectrum"))
        l->others = find_number(line, "bound");
    if (!known && !l->reason[0]) {
        snprintf(l->test, sizeof l->test, "%s", test);
        find_string(l->reason, sizeof l->reason, line, "reason");
    }
}

/* No log is no error: certificates say what is proved. */
static void read_log(report *z, report_entry *e)
{
    char name[80];
    buffer text;
    e->log.others = e->log.error = NAN;
    snprintf(name, sizeof name, "valence-%s.log", e->name);
    buffer_init(&text);
    if (read_file(z, &text, name) == REPORT_OK && text.bytes)
        for (char *line = text.bytes, *end; (end = strchr(line, '\n')) != NULL; line = end + 1) {
            *end = '\0';
            read_attempt(&e->log, line);
        }
    buffer_clear(&text);
}

/* ---- the index ---- */

/* "7", "8..20", "21..inf" */
static bool read_valences(report_entry *e)
{
    char *end;
    e->first = e->last = strtol(e->name, &end, 10);
    if (!strcmp(end, "..inf")) {
        e->last = CHOICES_MAX_VALENCE;
        return true;
    }
    if (!strncmp(end, "..", 2))
        e->last = strtol(end + 2, &end, 10);
    return *end == '\0' && e->first >= CHOICES_MIN_VALENCE && e->last >= e->first;
}

static bool read_index_line(report_entry *e, const char *line)
{
    char word[16] = "";
    int fields = sscanf(line, "%47s %15s %64s %79s", e->name, word, e->digest, e->file);
    if (!strcmp(word, verdict_name(VERDICT_UNDECIDED)))
        e->verdict = VERDICT_UNDECIDED;
    else if (!strcmp(word, verdict_name(VERDICT_PROVED)))
        e->verdict = VERDICT_PROVED;
    else if (!strcmp(word, verdict_name(VERDICT_REFUTED)))
        e->verdict = VERDICT_REFUTED;
    else
        return false;
    return fields == (e->verdict == VERDICT_UNDECIDED ? 2 : 4) && !strchr(e->file, '/') && read_valences(e);
}

static report_status read_index(report *z)
{
    buffer text;
    long number = 0;
    report_status result;
    buffer_init(&text);
    result = read_file(z, &text, "index");
    if (result == REPORT_IO_ERROR && errno == ENOENT) {
        snprintf(z->complaint, sizeof z->complaint, "%.300s: there is no index; run the same 'smoothcert prove' again, which goes on and writes it", z->path);
        result = REPORT_BAD_INPUT;
    }
    for (char *line = text.bytes, *end; result == REPORT_OK && line && (end = strchr(line, '\n')) != NULL; line = end + 1) {
        report_entry *p = growing_room(z->entry, z->count, &z->capacity, sizeof *p);
        if (!p) {
            result = REPORT_NO_MEMORY;
            break;
        }
        *end = '\0';
        number++;
        z->entry = p;
        p = &z->entry[z->count];
        memset(p, 0, sizeof *p);
        picture_init(&p->picture, false);
        if (!read_index_line(p, line)) {
            snprintf(z->complaint, sizeof z->complaint, "%.300s/index:%ld: expected 'VALENCE proved SHA256 FILE' or 'VALENCE undecided'", z->path, number);
            result = REPORT_BAD_INPUT;
        } else {
            read_log(z, p);
            z->count++;
        }
    }
    buffer_clear(&text);
    return result;
}

report_status report_read(report *z, const char *path)
{
    report_status result;
    z->path = path;
    result = read_scheme(z);
    if (result == REPORT_OK)
        result = read_index(z);
    if (result == REPORT_OK && !problem_make(&z->problem, &z->scheme))
        result = REPORT_NO_MEMORY;
    return result;
}

/* ---- which ---- */

static void choose_some(report *z, verdict v)
{
    size_t count = 0, at = 0, place = 0;
    for (size_t i = 0; i < z->count; i++)
        count += z->entry[i].verdict == v && z->entry[i].first == z->entry[i].last;
    for (size_t i = 0; i < z->count; i++) {
        report_entry *e = &z->entry[i];
        if (e->verdict != v || e->first != e->last)
            continue;
        /* MOST_SHOWN places, evenly spread from the first to the last */
        e->shown = count <= MOST_SHOWN || at == place * (count - 1) / (MOST_SHOWN - 1);
        place += e->shown;
        at++;
    }
}

static bool is_listed(const valence_list *list, long valence)
{
    for (int i = 0; i < list->ranges; i++)
        if (valence >= list->range[i].first && valence <= list->range[i].last)
            return true;
    return false;
}

void report_choose(report *z, const valence_list *list)
{
    if (list)
        for (size_t i = 0; i < z->count; i++)
            z->entry[i].shown = z->entry[i].first == z->entry[i].last && is_listed(list, z->entry[i].first);
    else
        for (int v = VERDICT_PROVED; v <= VERDICT_UNDECIDED; v++)
            choose_some(z, (verdict)v);
}

/* ---- certificates ---- */

const char *report_reason(const report_entry *e)
{
    static const char *const reasons[] = {
        [CLAIM_C1] = "C1", [CLAIM_FREQUENCY] = "another frequency dominates", [CLAIM_NOT_C0] = "an eigenvalue beyond 1: not even continuous",
        [CLAIM_FOLD] = "the characteristic map folds", [CLAIM_TIE] = "too many blocks share the largest modulus",
        [CLAIM_JORDAN] = "a larger Jordan block dominates", [CLAIM_MODULUS_ONE] = "an eigenvalue of modulus 1: not even continuous"};
    return (size_t)e->claim < sizeof reasons / sizeof *reasons && reasons[e->claim] ? reasons[e->claim] : "not C1";
}

/* The middle of the element that a witness names. */
static point find_witness(const picture *p, const witness_choice *w)
{
    const element *at = &p->ring->elements[w->element];
    picture_leaf leaf = {at->type, at->a, at->b, 0, 0, 0, 0};
    point sum = {0, 0};
    int corners = element_vertices(leaf.type);
    for (; leaf.level < w->depth; leaf.level++) {
        element_child c = element_get_child(leaf.type, w->path[leaf.level] - '0');
        leaf.type = c.type;
        leaf.a = 2 * leaf.a + c.shift.a;
        leaf.b = 2 * leaf.b + c.shift.b;
    }
    for (int i = 0; i < corners; i++) {
        point v = picture_vertex(p, &leaf, i, 0);
        sum.x += v.x / corners;
        sum.y += v.y / corners;
    }
    return sum;
}

static void note_choices(report_entry *e, const choices *c)
{
    e->claim = c->claim;
    e->frequency = c->frequency;
    e->grid = c->grid;
    e->plainly_regular = c->plainly_regular;
    e->radius = c->plainly_regular ? NAN : ldexp(integer_get_double_approx(&c->eigenpair.radius), -(int)c->grid);
    for (int i = 0; i < 2 && c->claim == CLAIM_FOLD && e->picture.taken && e->picture.with_net; i++)
        e->witness[i] = find_witness(&e->picture, &c->witness[i]);
}

static void note_findings(report_entry *e, const findings *f)
{
    e->eigenvalue_lower = f->eigenvalue_lower;
    e->eigenvalue_upper = f->eigenvalue_upper;
    e->jacobian = e->claim == CLAIM_C1 && !e->plainly_regular ? f->jacobian : NAN;
    for (int i = 0; i < f->attempt_count; i++) {
        e->elements += f->attempts[i].elements;
        e->level = f->attempts[i].level > e->level ? f->attempts[i].level : e->level;
    }
}

/* Does the text have the digest of the index, and prove its verdict?  The figures are taken over. */
static report_status replay(report *z, report_entry *e, const buffer *text)
{
    deadline never = {0};
    analysis_plan plan = {.problem = &z->problem, .deadline = &never, .system = "grid"};
    findings f;
    choices c;
    char digest[65];
    long line = 0;
    report_status result = REPORT_OK;
    findings_init(&f);
    choices_init(&c);
    sha256_hex(digest, text->bytes ? text->bytes : "", text->length);
    if (e->first == e->last && (e->shown || (size_t)(e - z->entry) % (z->count / MOST_MEASURED + 1) == 0))
        plan.picture = &e->picture;
    if (!certificate_read(&c, &line, &z->scheme, text->bytes ? text->bytes : "", text->length)) {
        result = REPORT_NO_MEMORY;
    } else if (line == 0 && c.k.first == e->first && !strcmp(digest, e->digest) && (c.claim == CLAIM_C1) == (e->verdict == VERDICT_PROVED)) {
        outcome o = analysis_replay_grid(&f, &c, &plan, c.grid);
        e->followed = o == OUTCOME_TRUE;
        result = o == OUTCOME_NO_MEMORY ? REPORT_NO_MEMORY : REPORT_OK;
        note_choices(e, &c);
        note_findings(e, &f);
    }
    choices_clear(&c);
    findings_clear(&f);
    return result;
}

/* How far a search in double intervals comes, for a picture of what is undecided. */
static report_status look_at_undecided(report *z, report_entry *e)
{
    deadline never = {0};
    analysis_plan plan = {.problem = &z->problem, .deadline = &never, .system = "interval", .max_level = 6, .picture = &e->picture};
    findings f;
    choices c;
    outcome o;
    findings_init(&f);
    choices_init(&c);
    c.k = one_valence(e->first);
    o = analysis_search(&f, &c, &plan, 0);
    e->jacobian = e->radius = NAN;
    choices_clear(&c);
    findings_clear(&f);
    return o == OUTCOME_NO_MEMORY ? REPORT_NO_MEMORY : REPORT_OK;
}

report_status report_follow(report *z, report_entry *e)
{
    buffer text;
    report_status result;
    e->picture.with_net = e->shown;
    if (e->verdict == VERDICT_UNDECIDED)
        return e->shown ? look_at_undecided(z, e) : REPORT_OK;
    buffer_init(&text);
    result = read_file(z, &text, e->file);
    if (result == REPORT_OK)
        result = replay(z, e, &text);
    if (result == REPORT_OK && !e->followed) {
        snprintf(z->complaint, sizeof z->complaint, "%.300s/%.80s: the certificate does not prove what the index says of valence %.48s", z->path, e->file, e->name);
        result = REPORT_BAD_INPUT;
    }
    buffer_clear(&text);
    return result;
}
