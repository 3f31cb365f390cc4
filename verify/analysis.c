/* analysis.c: the tests one after the other.  Compiled once per number system. */
#include "tests.h"

#include "../lib/eigenpair.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of L on a line for people; `spectrum` prints as many as one asks for. */
#define MOST_DIGITS 40

#define run_analysis NUMBER_NAME(run_analysis)
outcome run_analysis(findings *f, choices *c, analysis_plan *p, bool replay, long prec);

/* ---- what several tests need ---- */

outcome outcome_from_block(findings *f, block_status s, const diagnostic *d)
{
    switch (s) {
    case BLOCK_OK:
        return OUTCOME_TRUE;
    case BLOCK_OPPOSITE:
        return findings_explain(f, OUTCOME_FALSE, "a rule reaches behind the extraordinary vertex, where its sheet is ambiguous");
    case BLOCK_NO_CENTRE_RULE:
        return findings_explain(f, OUTCOME_FALSE, "the scheme has no rule for the extraordinary vertex, and the mask is none");
    case BLOCK_STOPPED:
        return findings_explain(f, OUTCOME_STOPPED, "no time left");
    case BLOCK_BAD_INPUT:
        return findings_explain(f, OUTCOME_BAD_INPUT, "%ld:%ld: %s", d->line, d->column, d->text);
    default:
        return OUTCOME_NO_MEMORY;
    }
}

#if !defined(NUMBER_AFFINE)
outcome analysis_make_block(block *b, analysis *a, long first, long last)
{
    diagnostic d;
    frequencies m = {first, last};
    return analysis_from_block(a, block_make_range(b, &a->numbers, m, !a->choices->eigenpair.complex_form, &d), &d);
}
#endif

/* How many numbers an eigenvector of block 0 has, with the eigenvalue: n + 1, or of a pair twice as many. */
static size_t plain_size(const analysis *a)
{
    return (size_t)(a->choices->pair + 1) * (size_t)(a->dominant.n + 1);
}

/* From the differences y of block 0, in a->box, its eigenvector x_i = y_i + x_p and its eigenvalue: row p of B x = L x is
   (B y)_p + x_p = L x_p, for it sums to 1. */
static number *plain_eigenvector(const analysis *a)
{
    int n = a->dominant.n, parts = a->choices->pair + 1;
    const number *eigenvalue = &a->box[a->order];
    number *z = number_array_new(plain_size(a)), rest;
    if (!z)
        return NULL;
    number_init(&rest);
    for (int part = 0; part < parts; part++)
        for (int j = 1; j < n; j++)
            number_addmul(&z[part * n], &a->dominant.entry[j], &a->box[part * (n - 1) + j - 1], a->prec);
    number_one(&rest);
    number_sub(&rest, eigenvalue, &rest, a->prec);
    if (parts == 2)
        charnet_divide(&z[0], &z[n], &rest, eigenvalue + 1, a->prec);
    else
        number_div(&z[0], &z[0], &rest, a->prec);
    for (int part = 0; part < parts; part++) {
        for (int j = 1; j < n; j++)
            number_add(&z[part * n + j], &a->box[part * (n - 1) + j - 1], &z[part * n], a->prec);
        number_set(&z[parts * n + part], &eigenvalue[part]);
    }
    number_clear(&rest);
    return z;
}

/* The frequency was last set to that of the last block: it has to be that of L again. */
outcome analysis_make_net(analysis *a)
{
    long m = a->choices->frequency;
    diagnostic d = {0, 0, ""};
    number *plain = NULL;
    block_status made = BLOCK_NO_MEMORY;
    if (a->net_made)
        return OUTCOME_TRUE;
    if (scheme_numbers_set_frequency(&a->numbers, m, m ? &a->dominant.twist : NULL, &d) != STATUS_OK)
        return OUTCOME_NO_MEMORY;
    if (m == 0)
        plain = plain_eigenvector(a);
    if (m > 0 || plain)
        made = charnet_make(&a->net, &a->dominant, m ? a->box : plain, a->dominant.imaginary || a->choices->pair, &a->numbers, a->plan->problem->geometry.rings);
    if (plain)
        number_array_free(plain, plain_size(a));
    a->net_made = made == BLOCK_OK;
    return analysis_from_block(a, made, &d);
}

/* The task with everything that is the same for all tests; windows[0..*made) are the caller's to free. */
static outcome prepare(analysis *a, adaptive_task *task, charnet_windows *windows, int *made, const element *elements, int count)
{
    const problem *p = a->plan->problem;
    outcome o = analysis_make_net(a);
    task->geometry = &p->geometry;
    task->elements = elements;
    task->count = count;
    task->replay = a->replay;
    task->max_level = a->plan->max_level;
    task->max_elements = a->replay ? 0 : a->plan->max_elements;
    task->deadline = a->plan->deadline;
    for (*made = 0; o == OUTCOME_TRUE && *made < task->nets; ++*made) {
        int i = *made, which = task->which[i];
        o = analysis_from_block(a, a->mixed ? real_windows(&windows[i], a, which, elements, count)
                                            : charnet_windows_make(&windows[i], &a->net, &p->geometry, which, elements, count, a->prec), NULL);
        task->windows[i] = &windows[i];
        task->mask[i] = &a->mask[which];
        task->patch[i] = p->polynomial ? &a->patch[which] : NULL;
        task->stability[i] = a->choices->stability[which].bound;
    }
    return o;
}

static outcome note_report(analysis *a, outcome o, const adaptive_report *report)
{
    attempt *log = findings_last(a->findings);
    log->max_level = a->plan->max_level;
    log->level = report->level;
    log->elements = report->examined;
    log->bound = report->margin;
    return o == OUTCOME_STOPPED ? findings_explain(a->findings, o, "no time left") : o;
}

/* By trees in `word`, or, if there is none, one witness. */
static outcome run_adaptive(analysis *a, adaptive_task *task, tree_word *word, witness_choice *witness, const element *elements, int count)
{
    charnet_windows windows[ADAPTIVE_MAX_NETS];
    adaptive_report report = {0, 0, NAN};
    int made;
    outcome o = prepare(a, task, windows, &made, elements, count);
    if (o == OUTCOME_TRUE)
        o = word ? adaptive_run(&report, word, task, a->prec) : adaptive_seek(&report, witness, task, a->prec);
    for (int i = 0; i < made; i++)
        charnet_windows_free(&windows[i]);
    return note_report(a, o, &report);
}

outcome analysis_subdivide(analysis *a, adaptive_task *task, tree_word *word, const element *elements, int count)
{
    return run_adaptive(a, task, word, NULL, elements, count);
}

outcome analysis_seek(analysis *a, adaptive_task *task, witness_choice *witness, const element *elements, int count)
{
    return run_adaptive(a, task, NULL, witness, elements, count);
}

/* ---- one after the other ---- */

/* What the scheme's formulas and masks are worth at this valence. */
static outcome evaluate_scheme(analysis *a)
{
    const problem *p = a->plan->problem;
    diagnostic d;
    for (int i = 0; i < RING_NETS; i++)
        if (!mask_numbers_make(&a->mask[i], p->geometry.mask[i], a->prec) || (p->polynomial && !patch_numbers_make(&a->patch[i], &p->bernstein[i], i == RING_VALUES, a->prec)))
            return OUTCOME_NO_MEMORY;
    switch (scheme_numbers_make_range(&a->numbers, p->scheme, a->choices->k, a->prec, &d)) {
    case STATUS_OK:
        return OUTCOME_TRUE;
    case STATUS_BAD_INPUT:
        return findings_explain(a->findings, OUTCOME_BAD_INPUT, "%ld:%ld: %s", d.line, d.column, d.text);
    default:
        return OUTCOME_NO_MEMORY;
    }
}

/* What was found earlier for a wider or narrower L?  The bound 1/scale of the others must still be one of L. */
static bool is_still_true(const analysis *a, test_name name)
{
    return a->plan->found[name] && (name != TEST_SPECTRUM || number_upper_bound(&a->scale) <= a->plan->scale_upper);
}

static outcome run_test(analysis *a, const analysis_test *t)
{
    double start = deadline_now();
    attempt *log = findings_begin(a->findings, t->words, t->name == TEST_REGULAR_COMPLEX && !a->replay ? "exact" : a->plan->system,
                                  t->name == TEST_REGULAR_COMPLEX && !a->replay ? 0 : a->prec);
    outcome o = t->run(a);
    if ((o == OUTCOME_FALSE || o == OUTCOME_UNDEFINED || o == OUTCOME_FAIL) && stop_now())
        o = findings_explain(a->findings, OUTCOME_STOPPED, "no time left");
    log->outcome = o;
    log->seconds = deadline_now() - start;
    if (o == OUTCOME_UNDEFINED && a->plan->uniform && !a->replay && a->plan->found[TEST_UNIFORM])
        findings_explain(a->findings, o, "adaptive subdivision needs more than the %d levels that are enough for the uniform method", a->plan->max_level);
    if (o == OUTCOME_TRUE && !a->replay) {
        a->plan->found[t->name] = true;
        a->findings->elements += log->elements;
        a->findings->level = log->level > a->findings->level ? log->level : a->findings->level;
    }
    return o;
}

/* It writes its own attempts, and limits the search for trees that follows. */
static outcome run_uniform(analysis *a)
{
    outcome o = OUTCOME_TRUE;
    if (!a->plan->uniform || a->replay)
        return o;
    if (!a->plan->found[TEST_UNIFORM]) {
        o = analysis_uniform(a);
        findings_last(a->findings)->outcome = o;
    }
    if (o == OUTCOME_TRUE) {
        a->plan->found[TEST_UNIFORM] = true;
        a->plan->max_level = a->findings->uniform_level;
    }
    return o;
}

static outcome run_tests(analysis *a)
{
    const analysis_test *tests = analysis_tests;
    outcome o = OUTCOME_TRUE;
    if (!(tests[0].claims & 1U << a->choices->claim)) { /* the first test belongs to every claim that there is here */
        findings_begin(a->findings, "claim", a->plan->system, a->prec);
        return findings_last(a->findings)->outcome = findings_explain(a->findings, OUTCOME_FALSE, "claims of this kind are not proved of %s", is_one_valence(a->choices->k) ? "one valence" : "several valences at once");
    }
    for (size_t i = 0; o == OUTCOME_TRUE && tests[i].run; i++) {
        if (!(tests[i].claims & 1U << a->choices->claim))
            continue;
        if (tests[i].name == TEST_EIGENPAIR || tests[i].name == TEST_EXACT) {
            if (a->choices->plainly_regular)
                break;
            o = evaluate_scheme(a);
        }
        if (tests[i].name == TEST_REGULARITY)
            o = run_uniform(a);
        if (o == OUTCOME_TRUE && (a->replay || tests[i].name == TEST_EIGENPAIR || !is_still_true(a, tests[i].name)))
            o = run_test(a, &tests[i]);
    }
    return o;
}

/* What is there as text belongs to the scaled block: with its factor. */
static bool describe_growth(analysis *a)
{
    char growth[CHOICES_GROWTH_TEXT], *scaled = a->findings->eigenvalue, *text = malloc(strlen(scaled) + sizeof growth + 4);
    choices_print_growth(growth, a->choices);
    if (text && *growth)
        sprintf(text, "(%s) %s", scaled, growth);
    else if (text)
        strcpy(text, scaled);
    free(scaled);
    a->findings->eigenvalue = text;
    return text != NULL;
}

/* L as text. */
static bool describe(analysis *a)
{
    findings *f = a->findings;
    int digits = a->prec < 128 ? 16 : MOST_DIGITS;
    char *re, *im;
    if (a->choices->plainly_regular || a->replay || !a->box)
        return true;
    free(f->eigenvalue);
    re = number_get_decimal(&a->box[a->order], digits);
    f->eigenvalue = re;
    if (re && a->choices->claim == CLAIM_GRADED)
        return describe_growth(a);
    if (!a->choices->eigenpair.complex_form || !re)
        return re != NULL;
    im = number_get_decimal(&a->box[a->order + 1], digits);
    f->eigenvalue = im ? malloc(strlen(re) + strlen(im) + 16) : NULL;
    if (f->eigenvalue)
        sprintf(f->eigenvalue, "(%s) + i (%s)", re, im);
    free(re);
    free(im);
    return f->eigenvalue != NULL;
}

static void free_pair(analysis *a, const eigenpair_choice *e)
{
    if (a->box)
        number_array_free(a->box, eigenpair_box_size(a->order, e->complex_form));
    if (a->matrix)
        number_array_free(a->matrix, (size_t)a->order * (size_t)a->order);
    sector_net_free(&a->net);
    block_free(&a->dominant);
}

outcome run_analysis(findings *f, choices *c, analysis_plan *p, bool replay, long prec)
{
    analysis a;
    outcome o;
    memset(&a, 0, sizeof a);
    a.plan = p;
    a.choices = c;
    a.findings = f;
    a.replay = replay;
    a.prec = prec;
    number_init(&a.scale);
    o = run_tests(&a);
#if !defined(NUMBER_AFFINE)
    if (p->picture && a.box)
        picture_take(p->picture, &a);
#endif
    if (o == OUTCOME_TRUE && !describe(&a))
        o = OUTCOME_NO_MEMORY;
    for (int i = 0; i < RING_NETS; i++) {
        if (a.mask[i].mask)
            mask_numbers_free(&a.mask[i]);
        if (a.patch[i].exact)
            patch_numbers_free(&a.patch[i]);
    }
    analysis_exchange(&a);
    free_pair(&a, &c->eigenpair);
    analysis_exchange(&a);
    free_pair(&a, &c->eigenpair);
    exact_free(&a);
    number_clear(&a.scale);
    scheme_numbers_free(&a.numbers);
    return o;
}

/* The rounding mode is set round calls that contain no arithmetic of their own (bigfloat/number.h). */
static outcome in_region(findings *f, choices *c, analysis_plan *p, bool replay, long prec)
{
    number_mode mode = number_enter();
    outcome o = run_analysis(f, c, p, replay, prec);
    number_leave(mode);
    return o;
}

outcome NUMBER_NAME(analysis_search)(findings *f, choices *c, analysis_plan *p, long prec)
{
    return in_region(f, c, p, false, prec);
}

outcome NUMBER_NAME(analysis_replay)(findings *f, choices *c, analysis_plan *p, long prec)
{
    return in_region(f, c, p, true, prec);
}
