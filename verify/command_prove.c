/* command_prove.c: the main command: a scheme, valences, one line and one certificate for each. */
#define _POSIX_C_SOURCE 200809L /* sigaction */
#include "prove_run.h"

#include "archive_run.h"
#include "command.h"
#include "command_out.h"

#include "../bigfloat/interval.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

/* More valences than that are examined in ranges, unless --each is given, which goes farther. */
enum { MAX_EACH = 1000, MAX_EACH_FORCED = 100000 };

/* ---- what is needed ---- */

/* One by one, or in ranges?  These need the real form. */
static int prepare_ranges(prove_run *r)
{
    bool each = r->options.each || r->list.count <= MAX_EACH || (!r->scheme.mirror_symmetric && r->list.count <= MAX_EACH_FORCED);
    r->in_ranges = !each;
    if (each && r->list.count > MAX_EACH_FORCED)
        return complain(EXIT_USAGE, "--each examines at most %d valences in a run", MAX_EACH_FORCED);
    if (!each && !r->scheme.mirror_symmetric)
        return complain(EXIT_USAGE, "ranges of valences need a scheme that is evidently mirror-symmetric, which %s is not; name at most %d valences", r->scheme.name,
                        MAX_EACH_FORCED);
    return -1;
}

/* What the uniform method needs, where it is wanted. */
static int prepare_method(prove_run *r)
{
    if (!r->options.uniform)
        return -1;
    if (r->scheme.mesh != MESH_TRIANGLE)
        return complain(EXIT_USAGE, "--method uniform is for triangle meshes only, and %s is a scheme on a %s mesh", r->scheme.name, mesh_name(r->scheme.mesh));
    if (!uniform_bounds_make(&r->uniform, &r->problem))
        return complain(EXIT_NO_MEMORY, "no memory");
    if (r->uniform.obstacle && !r->problem.obstacle)
        return complain(EXIT_USAGE, "--method uniform cannot be used for %s: %s", r->scheme.name, r->uniform.obstacle);
    r->options.limits.uniform = &r->uniform;
    return -1;
}

static int open_archive(prove_run *r)
{
    char name[PROVE_ARCHIVE_NAME];
    const char *path = r->options.out;
    int result;
    if (path && !strcmp(path, "none"))
        return -1;
    prove_options_archive(name, &r->options, r->scheme.name);
    result = command_open_archive(&r->archive, path ? path : name, &r->scheme, &r->command);
    if (result >= 0)
        return result;
    return archive_index_make(&r->earlier, r->archive.path, &r->archive.finished)
               ? -1
               : complain(errno == ENOMEM ? EXIT_NO_MEMORY : EXIT_IO, "%s: %s", r->archive.path, strerror(errno));
}

/* ---- the work ---- */

/* false: no memory. */
static bool summarise(const prove_run *r)
{
    buffer text;
    bool ok;
    buffer_init(&text);
    if (r->options.json) {
        buffer_print(&text, "{\"scheme\":\"%s\",\"boxes\":%ld,", r->scheme.name, r->classification.boxes);
        classification_print_json(&text, &r->classification);
        buffer_print(&text, "}");
    } else {
        buffer_print(&text, "%s, in %ld %s: ", r->scheme.name, r->classification.boxes, r->classification.boxes == 1 ? "box" : "boxes");
        classification_print(&text, &r->classification);
        if (r->options.uniform)
            buffer_print(&text, "; uniform method: nets up to +/- %.2g wide, level %d at most", r->classification.uniform_width, r->classification.uniform_level);
    }
    ok = !text.failed;
    if (ok)
        puts(text.bytes);
    buffer_clear(&text);
    return ok;
}

static int decide_all(prove_run *r)
{
    bool ran, told;
    progress_begin(&r->progress, r->list.count);
    keeper_start(&r->keeper);
    ran = (r->in_ranges ? prove_decide_ranges : prove_decide_each)(r);
    keeper_finish(&r->keeper);
    progress_clear(&r->progress);
    if (!ran)
        return complain(EXIT_NO_MEMORY, "no memory");
    told = !r->classification.count || summarise(r);
    if (r->result <= EXIT_UNDECIDED || r->result == EXIT_INTERRUPTED || r->result == EXIT_BAD_INPUT) {
        int written = command_write_index(&r->archive);
        if (written)
            return written;
    }
    if (r->result == EXIT_INTERRUPTED)
        complain(0, r->archive.path ? "interrupted; what is finished is kept in %s, and the same command goes on" : "interrupted", r->archive.path);
    if (!told)
        return complain(EXIT_NO_MEMORY, "no memory for the last line, which sums up the others");
    return r->result;
}

static int prove(prove_run *r)
{
    const char *complaint;
    int result = scheme_options_load(&r->scheme, &r->options.scheme);
    if (result >= 0)
        return result;
    complaint = valence_list_read(&r->list, r->options.list);
    if (complaint)
        return complain(EXIT_USAGE, "--valence %s: %s", r->options.list, complaint);
    if (!interval_self_test()) {
        r->options.limits.no_intervals = true;
        complain(0, "this machine or compiler does not round doubles as told: only balls are used");
    }
    if (!problem_make(&r->problem, &r->scheme))
        return complain(EXIT_NO_MEMORY, "no memory");
    result = prepare_method(r);
    if (result >= 0)
        return result;
    result = prepare_ranges(r);
    if (result >= 0)
        return result;
    result = open_archive(r);
    return result >= 0 ? result : decide_all(r);
}

static void interrupt(int signal)
{
    (void)signal;
    deadline_interrupt();
}

static void heed_interrupts(void)
{
    struct sigaction action = {.sa_handler = interrupt};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

int command_prove(int argc, char **argv)
{
    prove_run r;
    int result;
    buffer_init(&r.command);
    archive_describe_run(&r.command, argc, argv);
    result = prove_options_read(&r.options, argc, argv);
    if (result >= 0) {
        buffer_clear(&r.command);
        return result;
    }
    r.result = EXIT_PROVED;
    scheme_init(&r.scheme);
    problem_init(&r.problem);
    uniform_bounds_init(&r.uniform);
    r.list.count = 0;
    r.in_ranges = false;
    classification_init(&r.classification);
    archive_index_init(&r.earlier);
    r.reported = 0;
    r.told = one_valence(0);
    r.keeper = (keeper){.keep = prove_keep, .discard = prove_discard, .data = &r};
    archive_init(&r.archive);
    heed_interrupts();
    result = prove(&r);
    archive_clear(&r.archive);
    archive_index_clear(&r.earlier);
    classification_clear(&r.classification);
    buffer_clear(&r.command);
    uniform_bounds_clear(&r.uniform);
    problem_clear(&r.problem);
    scheme_clear(&r.scheme);
    return finish_output(result);
}
