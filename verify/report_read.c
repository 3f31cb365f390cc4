/* report_read.c: a directory's index, logs and certificates. */
#include "report.h"

#include "analysis.h"
#include "archive.h"
#include "certificate.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of so many entries of each verdict maps are drawn, unless they are named. */
#define MOST_SHOWN 4
/* Of about so many entries, evenly spread, the Jacobian and the errors are measured. */
#define MOST_MEASURED 60

void report_init(report *z)
{
    memset(z, 0, sizeof *z);
    archive_view_init(&z->view);
    scheme_init(&z->scheme);
    problem_init(&z->problem);
    picture_init(&z->limit, false);
}

void report_clear(report *z)
{
    for (size_t i = 0; i < z->count; i++)
        picture_clear(&z->entry[i].picture);
    free(z->entry);
    picture_clear(&z->limit);
    problem_clear(&z->problem);
    scheme_clear(&z->scheme);
    archive_view_clear(&z->view);
}

/* ---- files ---- */

/* The entry's file with the suffix. */
static report_status read_file(report *z, buffer *text, const report_entry *e, const char *suffix)
{
    char name[ARCHIVE_NAME_MAX];
    char *path;
    bool ok;
    archive_name(name, e->k, suffix);
    path = durable_path(z->view.path, name);
    ok = path && buffer_read_file(text, path, ARCHIVE_MAX_BYTES);
    if (!ok)
        snprintf(z->complaint, sizeof z->complaint, "%.300s/%s: %s", z->view.path, name, strerror(errno));
    free(path);
    return ok ? REPORT_OK : errno == ENOMEM ? REPORT_NO_MEMORY : REPORT_IO_ERROR;
}

static report_status read_scheme(report *z)
{
    const buffer *text = &z->view.scheme;
    diagnostic d;
    switch (scheme_read(&z->scheme, text->bytes ? text->bytes : "", text->length, NULL, &d)) {
    case STATUS_OK:
        return problem_make(&z->problem, &z->scheme) ? REPORT_OK : REPORT_NO_MEMORY;
    case STATUS_BAD_INPUT:
        snprintf(z->complaint, sizeof z->complaint, "%.300s/%s:%ld:%ld: %.150s", z->view.path, ARCHIVE_SCHEME, d.line, d.column, d.text);
        return REPORT_BAD_INPUT;
    default:
        return REPORT_NO_MEMORY;
    }
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
    buffer text;
    e->log.others = e->log.error = NAN;
    buffer_init(&text);
    if (read_file(z, &text, e, ARCHIVE_LOG) == REPORT_OK && text.bytes)
        for (char *line = text.bytes, *end; (end = strchr(line, '\n')) != NULL; line = end + 1) {
            *end = '\0';
            read_attempt(&e->log, line);
        }
    buffer_clear(&text);
}

/* ---- the directory ---- */

static report_status add_entry(report *z, const archive_index_entry *from)
{
    report_entry *e = &z->entry[z->count];
    if (from->covered)
        return REPORT_OK;
    memset(e, 0, sizeof *e);
    picture_init(&e->picture, false);
    e->k = from->valences;
    valence_range_print(e->name, e->k);
    e->verdict = from->verdict;
    if (from->verdict != VERDICT_UNDECIDED)
        snprintf(e->digest, sizeof e->digest, "%s", from->digest);
    if (from->damaged) {
        snprintf(z->complaint, sizeof z->complaint, "%.300s: the certificate of valence %s is damaged; run the same 'smoothcert prove' again", z->view.path, e->name);
        return REPORT_BAD_INPUT;
    }
    read_log(z, e);
    z->count++;
    return REPORT_OK;
}

report_status report_read(report *z, const char *path)
{
    report_status result;
    if (!archive_view_read(&z->view, path)) {
        if (errno == ENOENT || errno == ENOTDIR) {
            snprintf(z->complaint, sizeof z->complaint, "%.300s: expected a directory of 'smoothcert prove'", path);
            return REPORT_BAD_INPUT;
        }
        snprintf(z->complaint, sizeof z->complaint, "%.300s: %s", path, strerror(errno));
        return errno == ENOMEM ? REPORT_NO_MEMORY : REPORT_IO_ERROR;
    }
    result = read_scheme(z);
    z->entry = malloc((z->view.index.count + 1) * sizeof *z->entry);
    if (!z->entry)
        result = REPORT_NO_MEMORY;
    for (size_t i = 0; result == REPORT_OK && i < z->view.index.count; i++)
        result = add_entry(z, &z->view.index.entry[i]);
    if (result == REPORT_OK && !z->view.is_indexed) {
        snprintf(z->complaint, sizeof z->complaint, "%.300s: the index does not say what is there; run the same 'smoothcert prove' again, which goes on and writes it, or 'smoothcert archive verify'", path);
        return REPORT_BAD_INPUT;
    }
    return result;
}

/* ---- which ---- */

static void show(report_entry *e, long at)
{
    e->shown = true;
    e->at = at;
    snprintf(e->at_name, sizeof e->at_name, "%ld", at);
}

static void choose_some(report *z, verdict v)
{
    size_t count = 0, at = 0, place = 0;
    for (size_t i = 0; i < z->count; i++)
        count += z->entry[i].verdict == v;
    for (size_t i = 0; i < z->count; i++) {
        report_entry *e = &z->entry[i];
        if (e->verdict != v)
            continue;
        /* MOST_SHOWN places, evenly spread from the first to the last */
        if (count <= MOST_SHOWN || at == place * (count - 1) / (MOST_SHOWN - 1)) {
            show(e, e->k.first);
            place++;
        }
        at++;
    }
}

/* The first valence of the list that the entry is about. */
static void choose_listed(report_entry *e, const valence_list *list)
{
    for (int i = list->ranges - 1; i >= 0; i--)
        if (valence_range_overlap(list->range[i], e->k))
            show(e, list->range[i].first > e->k.first ? list->range[i].first : e->k.first);
}

void report_choose(report *z, const valence_list *list)
{
    if (list)
        for (size_t i = 0; i < z->count; i++)
            choose_listed(&z->entry[i], list);
    else
        for (int v = VERDICT_PROVED; v <= VERDICT_UNDECIDED; v++)
            choose_some(z, (verdict)v);
}

/* ---- certificates ---- */

const char *report_reason(const report_entry *e)
{
    static const char *const reasons[] = {
        [CLAIM_C1] = "C1", [CLAIM_FREQUENCY] = "another frequency dominates", [CLAIM_NOT_C0] = "an eigenvalue beyond 1: not even continuous",
        [CLAIM_FOLD] = "the characteristic map folds", [CLAIM_WINDING] = "the characteristic map does not wind once", [CLAIM_GRADED] = "an eigenvalue beyond 1 that grows with the valence: not even continuous",
        [CLAIM_REAL] = "a single real function dominates", [CLAIM_TIE] = "too many blocks share the largest modulus",
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
    if (claim_is_exact(c->claim) || !is_one_valence(c->k))
        e->log.others = NAN; /* equal ones are no bound, and that of a range is not one for each valence's L */
    e->radius = c->plainly_regular || claim_is_exact(c->claim) ? NAN : ldexp(integer_get_double_approx(&c->eigenpair.radius), -(int)c->grid);
    for (int i = 0; i < 2 && c->claim == CLAIM_FOLD && e->picture.taken && e->picture.with_net; i++)
        e->witness[i] = find_witness(&e->picture, &c->witness[i]);
}

static void note_findings(report_entry *e, const findings *f)
{
    e->eigenvalue_lower = f->eigenvalue_lower;
    e->eigenvalue_upper = f->eigenvalue_upper;
    e->windings = e->claim == CLAIM_WINDING ? f->windings : e->frequency;
    e->jacobian = e->claim == CLAIM_C1 && !e->plainly_regular ? f->jacobian : NAN;
    for (int i = 0; i < f->attempt_count; i++) {
        e->elements += f->attempts[i].elements;
        e->level = f->attempts[i].level > e->level ? f->attempts[i].level : e->level;
    }
}

/* Does the text prove the verdict?  The figures are taken over. */
static report_status replay(report *z, report_entry *e, const buffer *text)
{
    deadline never = {0};
    analysis_plan plan = {.problem = &z->problem, .deadline = &never, .system = "grid"};
    findings f;
    choices c;
    long line = 0;
    report_status result = REPORT_OK;
    findings_init(&f);
    choices_init(&c);
    if (is_one_valence(e->k) && (e->shown || (size_t)(e - z->entry) % (z->count / MOST_MEASURED + 1) == 0))
        plan.picture = &e->picture;
    if (!certificate_read(&c, &line, &z->scheme, text->bytes ? text->bytes : "", text->length)) {
        result = REPORT_NO_MEMORY;
    } else if (line == 0 && valence_range_equal(c.k, e->k) && (c.claim == CLAIM_C1) == (e->verdict == VERDICT_PROVED)) {
        outcome o = analysis_replay(&f, &c, &plan);
        e->followed = o == OUTCOME_TRUE;
        result = o == OUTCOME_NO_MEMORY ? REPORT_NO_MEMORY : REPORT_OK;
        note_choices(e, &c);
        note_findings(e, &f);
    }
    choices_clear(&c);
    findings_clear(&f);
    return result;
}

/* How far a search in double intervals comes at one valence, for a picture of what is undecided, or of one of many. */
static report_status look(report *z, picture *p, long valence)
{
    deadline never = {0};
    analysis_plan plan = {.problem = &z->problem, .deadline = &never, .system = "interval", .max_level = 6, .picture = p};
    findings f;
    choices c;
    outcome o;
    findings_init(&f);
    choices_init(&c);
    c.k = one_valence(valence);
    o = analysis_search(&f, &c, &plan, 0);
    choices_clear(&c);
    findings_clear(&f);
    return o == OUTCOME_NO_MEMORY ? REPORT_NO_MEMORY : REPORT_OK;
}

report_status report_follow(report *z, report_entry *e)
{
    buffer text;
    report_status result;
    e->picture.with_net = e->shown;
    e->jacobian = e->radius = NAN;
    if (e->verdict == VERDICT_UNDECIDED)
        return e->shown ? look(z, &e->picture, e->at) : REPORT_OK;
    buffer_init(&text);
    result = read_file(z, &text, e, ARCHIVE_CERTIFICATE);
    if (result == REPORT_OK)
        result = replay(z, e, &text);
    if (result == REPORT_OK && !e->followed) {
        snprintf(z->complaint, sizeof z->complaint, "%.300s: the certificate of valence %.48s does not prove what it claims", z->view.path, e->name);
        result = REPORT_BAD_INPUT;
    }
    buffer_clear(&text);
    if (result == REPORT_OK && e->shown && !is_one_valence(e->k) && e->verdict == VERDICT_PROVED)
        result = look(z, &e->picture, e->at);
    return result;
}

report_status report_compare_with_limit(report *z)
{
    report_status result = REPORT_OK;
    bool any = false;
    for (size_t i = 0; i < z->count; i++)
        any = any || (z->entry[i].picture.control && is_one_valence(z->entry[i].k));
    if (any)
        result = look(z, &z->limit, CHOICES_MAX_VALENCE);
    for (size_t i = 0; i < z->count; i++)
        z->entry[i].distance = is_one_valence(z->entry[i].k) ? picture_distance(&z->entry[i].picture, &z->limit) : NAN;
    return result;
}
