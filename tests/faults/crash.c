/* crash.c: what a loss of power may leave behind, from a record of preload.c; and whether that is good enough.

   usage: crash RECORD OUTPUT DIRECTORY [EVERY COMMAND]

   OUTPUT is what the program wrote to stdout, DIRECTORY the archive as the record names it.  At every point of the
   record the power may go.  Then each file keeps what was synced, and of the writes since then nothing, half, zeros of the same length,
   or all; each directory keeps the entries that were synced, and of the changes since then none, all, only the last, all
   but the last, or some.  In each of these states must hold:

     - a file with a final name is complete: one of those that were ever renamed to it;
     - what the journal calls finished is there;
     - what stdout has told is there, log included, and in the journal;
     - beside a certificate there are the scheme, the script and the runs;
     - after the end everything is as the program left it.

   Every EVERYth good state is put into the working directory, under DIRECTORY, and COMMAND (a shell's) must succeed on it.
   The last line is "N states" or "fault: ...", with status 0 or 1. */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_FILES = 512, MOST_ENTRIES = 1024, NAME = 256, MOST_OPERATIONS = 20000 };

static void die(const char *what)
{
    fprintf(stderr, "crash: %s\n", what);
    exit(2);
}

/* ---- what is on the disk, and what is only in memory ---- */

typedef struct {
    char *bytes;
    size_t length;
} content;

typedef struct {
    long number; /* of the record; reused by later files */
    content now, synced;
    bool is_synced;
} file;

/* A change of a directory: `name` becomes the file (index), or nothing (-1); mkdir: -2. */
typedef struct {
    char name[NAME], directory[NAME];
    int target;
} change;

static file files[MOST_FILES];
static int file_count;
static change synced[MOST_ENTRIES], pending[MOST_ENTRIES];
static int synced_count, pending_count;
static struct {
    char name[NAME];
    content bytes;
} versions[MOST_ENTRIES]; /* complete files that were renamed to their names */
static int version_count;
static const char *archive;
static char *output;
static long told; /* bytes of it */

static content copy(content c)
{
    content z = {malloc(c.length + 1), c.length};
    if (!z.bytes)
        die("no memory");
    memcpy(z.bytes, c.bytes ? c.bytes : "", c.length);
    z.bytes[c.length] = '\0';
    return z;
}

static bool equal(content a, content b)
{
    return a.length == b.length && (a.length == 0 || !memcmp(a.bytes, b.bytes, a.length));
}

static int find_file(long number)
{
    for (int i = file_count - 1; i >= 0; i--)
        if (files[i].number == number)
            return i;
    return -1;
}

static void directory_of(char *z, const char *path)
{
    const char *slash = strrchr(path, '/');
    snprintf(z, NAME, "%.*s", slash ? (int)(slash - path) : 1, slash ? path : ".");
}

/* ---- the namespace ---- */

static void apply(change *entries, int *count, const change *c)
{
    int i = 0;
    while (i < *count && strcmp(entries[i].name, c->name))
        i++;
    if (i == MOST_ENTRIES)
        die("too many entries");
    if (c->target == -1) {
        if (i < *count)
            entries[i] = entries[--*count];
        return;
    }
    entries[i] = *c;
    *count += i == *count;
}

static void change_name(const char *name, int target)
{
    change *c = &pending[pending_count];
    if (pending_count++ == MOST_ENTRIES)
        die("too many changes");
    snprintf(c->name, NAME, "%s", name);
    directory_of(c->directory, name);
    c->target = target;
}

static int lookup(const change *entries, int count, const char *name)
{
    for (int i = 0; i < count; i++)
        if (!strcmp(entries[i].name, name))
            return entries[i].target;
    return -1;
}

static int lookup_now(const char *name)
{
    int target = lookup(synced, synced_count, name);
    for (int i = 0; i < pending_count; i++)
        if (!strcmp(pending[i].name, name))
            target = pending[i].target;
    return target;
}

static void sync_names(const char *directory)
{
    int kept = 0;
    for (int i = 0; i < pending_count; i++) {
        if (!strcmp(pending[i].directory, directory))
            apply(synced, &synced_count, &pending[i]);
        else
            pending[kept++] = pending[i];
    }
    pending_count = kept;
}

/* ---- one operation ---- */

static void do_write(int f, long offset, const char *hex)
{
    size_t length = strlen(hex) / 2;
    file *z = &files[f];
    z->now.bytes = realloc(z->now.bytes, (size_t)offset + length + 1);
    if (!z->now.bytes || (size_t)offset != z->now.length)
        die("a write that does not append");
    for (size_t i = 0; i < length; i++) {
        unsigned byte;
        sscanf(hex + 2 * i, "%2x", &byte);
        z->now.bytes[(size_t)offset + i] = (char)byte;
    }
    z->now.length = (size_t)offset + length;
    z->now.bytes[z->now.length] = '\0';
}

static void do_rename(const char *from, const char *to)
{
    int target = lookup_now(from);
    if (target < 0 || version_count == MOST_ENTRIES)
        die("rename of what is not there");
    snprintf(versions[version_count].name, NAME, "%s", to);
    versions[version_count++].bytes = copy(files[target].now);
    change_name(from, -1);
    change_name(to, target);
}

static void do_create(long number, const char *name)
{
    if (file_count == MOST_FILES)
        die("too many files");
    files[file_count].number = number;
    change_name(name, file_count++);
}

static void operate(char *line)
{
    char *word = strtok(line, " "), *a = strtok(NULL, " "), *b = strtok(NULL, " "), *c = strtok(NULL, " ");
    if (!word || !a)
        die("a line that is too short");
    if (!strcmp(word, "mkdir"))
        change_name(a, -2);
    else if (!strcmp(word, "create"))
        do_create(atol(a), b);
    else if (!strcmp(word, "write"))
        do_write(find_file(atol(a)), atol(b), c ? c : "");
    else if (!strcmp(word, "truncate"))
        die("nothing is truncated here");
    else if (!strcmp(word, "fsync")) {
        file *f = &files[find_file(atol(a))];
        free(f->synced.bytes);
        f->synced = copy(f->now);
    } else if (!strcmp(word, "fsyncdir"))
        sync_names(a);
    else if (!strcmp(word, "rename"))
        do_rename(a, b);
    else if (!strcmp(word, "unlink"))
        change_name(a, -1);
    else if (!strcmp(word, "out"))
        told = atol(a);
    else
        die(word);
}

/* ---- states after a crash ---- */

typedef enum { DATA_LOST, DATA_HALF, DATA_ZEROS, DATA_KEPT, DATA_MODES } data_mode;
typedef enum { NAMES_LOST, NAMES_KEPT, NAMES_LAST, NAMES_BUT_LAST, NAMES_SOME, NAMES_OTHERS, NAMES_MODES } names_mode;

static change state[MOST_ENTRIES];
static int state_count;
static content left[MOST_FILES];
static uint64_t random_state = 1;

static bool toss(void)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return random_state >> 63;
}

static void leave_data(data_mode mode)
{
    for (int i = 0; i < file_count; i++) {
        content now = files[i].now, old = files[i].synced;
        size_t more = now.length - old.length;
        free(left[i].bytes);
        left[i] = copy(mode == DATA_LOST ? old : now);
        if (mode == DATA_HALF)
            left[i].length = old.length + more / 2;
        if (mode == DATA_ZEROS)
            memset(left[i].bytes + old.length, 0, more);
    }
}

static bool survives(names_mode mode, int i)
{
    switch (mode) {
    case NAMES_LOST:
        return false;
    case NAMES_KEPT:
        return true;
    case NAMES_LAST:
        return i == pending_count - 1;
    case NAMES_BUT_LAST:
        return i < pending_count - 1;
    default:
        return toss();
    }
}

static void leave_names(names_mode mode)
{
    memcpy(state, synced, sizeof synced);
    state_count = synced_count;
    for (int i = 0; i < pending_count; i++)
        if (survives(mode, i))
            apply(state, &state_count, &pending[i]);
}

/* A path is there if all directories above are. */
static int reach(const char *path)
{
    char above[NAME];
    directory_of(above, path);
    if (strcmp(above, ".") && reach(above) != -2)
        return -1;
    return lookup(state, state_count, path);
}

static content *find(const char *name)
{
    char path[2 * NAME];
    int target;
    snprintf(path, sizeof path, "%s/%s", archive, name);
    target = reach(path);
    return target >= 0 ? &left[target] : NULL;
}

/* ---- what must hold ---- */

static char fault[1024];

static bool blame(const char *what, const char *name)
{
    snprintf(fault, sizeof fault, "%.200s: %s", name, what);
    return false;
}

static bool is_final(const char *path)
{
    const char *name = path + strlen(archive) + 1;
    return !strncmp(path, archive, strlen(archive)) && strncmp(name, "unfinished-", 11) && strcmp(name, "lock") && strcmp(name, "journal");
}

static bool files_are_complete(void)
{
    for (int i = 0; i < state_count; i++) {
        bool complete = false;
        if (state[i].target < 0 || reach(state[i].name) < 0 || !is_final(state[i].name))
            continue;
        for (int v = 0; !complete && v < version_count; v++)
            complete = !strcmp(versions[v].name, state[i].name) && equal(versions[v].bytes, left[state[i].target]);
        if (!complete)
            return blame("half-written under its final name", state[i].name);
    }
    return true;
}

static bool journal_has(const char *name)
{
    content *j = find("journal");
    char line[NAME];
    snprintf(line, sizeof line, "  %s\n", name);
    return j && memchr(j->bytes, '\n', j->length) && strstr(j->bytes, line);
}

/* Lines are "64 digits, two blanks, name"; a torn one is none. */
static bool journal_is_true(void)
{
    content *j = find("journal");
    char name[NAME];
    for (size_t i = 0; j && i < j->length;) {
        char *stop = memchr(j->bytes + i, '\n', j->length - i);
        size_t length = stop ? (size_t)(stop - j->bytes) - i : 0;
        if (!stop)
            break;
        if (length > 66 && length < NAME && isxdigit((unsigned char)j->bytes[i])) {
            snprintf(name, sizeof name, "%.*s", (int)(length - 66), j->bytes + i + 66);
            if (!find(name))
                return blame("in the journal, but not there", name);
        }
        i += length + 1;
    }
    return true;
}

static bool told_is_kept(void)
{
    for (char *line = output; line < output + told;) {
        char *end = strchr(line, '\n'), *name, certificate[NAME], log[NAME];
        if (!end || end >= output + told)
            break;
        for (name = end; name > line && name[-1] != '/';)
            name--;
        snprintf(certificate, sizeof certificate, "%.*s", (int)(end - name), name);
        snprintf(log, sizeof log, "%.*s.log", (int)(end - name - 5), name);
        if (name > line && (!find(certificate) || !find(log)))
            return blame("reported, and lost", certificate);
        if (name > line && (!journal_has(certificate) || !journal_has(log)))
            return blame("reported, but not in the journal", certificate);
        line = end + 1;
    }
    return true;
}

static bool certificates_are_described(void)
{
    for (int i = 0; i < state_count; i++)
        if (strstr(state[i].name, ".cert") && is_final(state[i].name) && reach(state[i].name) >= 0)
            if (!find("scheme.scheme") || !find("verify.sh") || !find("runs"))
                return blame("there is no scheme, script or list of runs beside it", state[i].name);
    return true;
}

static bool all_is_kept(void)
{
    for (int i = 0; i < version_count; i++) {
        content *c = find(versions[i].name + strlen(archive) + 1);
        if (!c)
            return blame("lost after the end", versions[i].name);
    }
    return true;
}

static bool is_good(bool ended)
{
    return files_are_complete() && journal_is_true() && told_is_kept() && certificates_are_described() && (!ended || all_is_kept());
}

/* ---- going on from there ---- */

static void make_above(const char *path)
{
    char above[NAME];
    directory_of(above, path);
    if (strcmp(above, ".")) {
        make_above(above);
        mkdir(above, 0777);
    }
}

static void put_files(void)
{
    for (int i = 0; i < state_count; i++) {
        FILE *f;
        if (state[i].target < 0 || reach(state[i].name) < 0)
            continue;
        make_above(state[i].name);
        f = fopen(state[i].name, "wb");
        if (!f || fwrite(left[state[i].target].bytes, 1, left[state[i].target].length, f) != left[state[i].target].length || fclose(f) != 0)
            die("cannot write a state");
    }
}

static bool goes_on(const char *command)
{
    char clear[2 * NAME];
    snprintf(clear, sizeof clear, "rm -rf '%s'", archive);
    if (system(clear) != 0)
        die("rm");
    put_files();
    return system(command) == 0 || blame("the program did not go on from this state", archive);
}

static bool try_states(bool ended, long every, const char *command, long *states)
{
    for (int d = 0; d < DATA_MODES; d++)
        for (int n = 0; n < NAMES_MODES; n++) {
            leave_data((data_mode)d);
            leave_names((names_mode)n);
            if (!is_good(ended))
                return false;
            if (++*states % every == 0 && command && !goes_on(command))
                return false;
        }
    return true;
}

static char *read_whole(const char *path)
{
    FILE *f = fopen(path, "rb");
    size_t length = 0, capacity = 1 << 26;
    char *z = malloc(capacity);
    if (!f || !z)
        die(path);
    length = fread(z, 1, capacity - 1, f);
    z[length] = '\0';
    fclose(f);
    return z;
}

int main(int argc, char **argv)
{
    char *record, *line;
    long states = 0, operation = 0;
    if (argc != 4 && argc != 6)
        die("usage: crash RECORD OUTPUT DIRECTORY [EVERY COMMAND]");
    record = read_whole(argv[1]);
    output = read_whole(argv[2]);
    archive = argv[3];
    for (line = record; *line; operation++) {
        char *stop = strchr(line, '\n');
        if (!stop)
            die("the record is cut off");
        *stop = '\0';
        operate(line);
        line = stop + 1;
        if (!try_states(*line == '\0', argc == 6 ? atol(argv[4]) : 1, argc == 6 ? argv[5] : NULL, &states)) {
            printf("fault: after operation %ld: %s\n", operation + 1, fault);
            return 1;
        }
    }
    printf("%ld states\n", states);
    return 0;
}
