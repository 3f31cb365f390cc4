/* corpus.c: see corpus.h. */
#include "corpus.h"

#include "tests/harness.h"
#include "verify/sha256.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- files ---- */

static const char *source_folder(void)
{
    const char *folder = getenv("SRCDIR");
    return folder ? folder : ".";
}

char *read_text(const char *path)
{
    buffer b;
    buffer_init(&b);
    if (!buffer_read_file(&b, path, 1 << 20)) {
        buffer_clear(&b);
        return NULL;
    }
    buffer_append(&b, "", 1);
    return b.bytes;
}

void write_file(const char *path, const char *bytes, size_t length)
{
    FILE *file = fopen(path, "wb");
    CHECK(file && fwrite(bytes, 1, length, file) == length, "%s cannot be written", path);
    if (file)
        fclose(file);
}

void seal(buffer *z)
{
    char digest[65];
    long count = 0;
    for (size_t i = 0; i < z->length; i++)
        count += z->bytes[i] == '\n';
    buffer_print(z, "records %ld\n", count);
    sha256_hex(digest, z->bytes, z->length);
    buffer_print(z, "sha256 %s\n", digest);
}

/* ---- good certificates ---- */

static void find_scheme_file(char *out, size_t size, const char *name)
{
    snprintf(out, size, "%s/lib/catalogue/%s.scheme", source_folder(), name);
    if (access(out, R_OK) != 0)
        snprintf(out, size, "%s/tests/certificates/schemes/%s.scheme", source_folder(), name);
}

/* The text of the scheme that stands in the certificate, behind its two first lines. */
static void write_own_scheme(base *z)
{
    const char *begin = strstr(z->whole, "\nscheme "), *end = strstr(z->whole, "\nclaim ");
    begin = begin ? strchr(begin + 1, '\n') : NULL;
    CHECK(begin && end && begin < end, "%s: where is its scheme?", z->name);
    if (!begin || !end || begin >= end)
        return;
    strcat(strcpy(z->scheme_file, z->name), ".scheme");
    write_file(z->scheme_file, begin + 1, (size_t)(end - begin));
}

/* A row of a table: NAME SCHEME VALENCES [OPTION VALUE]..., SCHEME being - where it is what the certificate says. */
static void read_row(corpus *c, char *row, const char *folder, bool not_c1)
{
    base *z = &c->base[c->count];
    char path[600];
    const char *scheme, *word = strtok(row, " ");
    if (!word || *word == '#' || c->count == MAX_BASES)
        return;
    snprintf(z->name, sizeof z->name, "%s", word);
    snprintf(path, sizeof path, "%s/tests/certificates/%s/%s.cert", source_folder(), folder, word);
    scheme = strtok(NULL, " ");
    word = valence_range_read(&z->k, strtok(NULL, " "));
    CHECK(word && !*word, "%s: of which valences?", z->name);
    z->not_c1 = not_c1;
    while ((word = strtok(NULL, " ")) != NULL) {
        char *value = strtok(NULL, " ");
        if (strcmp(word, "--set") == 0)
            z->setting[z->settings++] = strdup(value);
    }
    z->whole = read_text(path);
    CHECK(z->whole, "%s cannot be read", path);
    if (!z->whole)
        return;
    if (strcmp(scheme, "-") == 0)
        write_own_scheme(z);
    else
        find_scheme_file(z->scheme_file, sizeof z->scheme_file, scheme);
    lines_read(&z->body, z->whole, "records ");
    c->count++;
}

void corpus_read(corpus *z, const char *folder, const char *table, bool not_c1)
{
    char path[600], *text;
    lines rows;
    snprintf(path, sizeof path, "%s/tests/certificates/%s/%s", source_folder(), folder, table);
    text = read_text(path);
    CHECK(text, "%s cannot be read", path);
    if (!text)
        return;
    lines_read(&rows, text, NULL);
    for (int i = 0; i < rows.count; i++)
        read_row(z, rows.line[i], folder, not_c1);
    lines_clear(&rows);
    free(text);
}

void corpus_read_all(corpus *z)
{
    corpus_read(z, "accept", "table", false);
    corpus_read(z, "accept-1", "table", false);
    corpus_read(z, "accept-1", "refuted", true);
    corpus_read(z, "../check/ranges", "table", false);
    corpus_read(z, "../check/ranges", "refuted", true);
}

static bool is_wanted(const char *name, const char *const *part)
{
    bool any = *part == NULL;
    for (; *part; part++)
        any = any || strstr(name, *part);
    return any;
}

void corpus_choose(choice_of_bases *z, const corpus *from, const char *const *parts)
{
    z->count = 0;
    for (int i = 0; i < from->count; i++)
        if (is_wanted(from->base[i].name, parts))
            z->base[z->count++] = &from->base[i];
    CHECK(z->count > 0, "no such certificates");
}

const base *corpus_find(const corpus *z, const char *name)
{
    for (int i = 0; i < z->count; i++)
        if (strcmp(z->base[i].name, name) == 0)
            return &z->base[i];
    return NULL;
}

/* ---- the checker ---- */

static const char *checker_program(void)
{
    const char *program = getenv("SMOOTHCERT_CHECK");
    return program ? program : "./smoothcert-check";
}

static void become_checker(const base *b, const char *scheme, valence_range k, const char *certificate)
{
    struct rlimit limit = {SECONDS_PER_CHECK, SECONDS_PER_CHECK};
    char valences[VALENCE_RANGE_TEXT];
    const char *argument[16 + 2 * MAX_SETTINGS];
    int count = 0;
    valence_range_print(valences, k);
    argument[count++] = checker_program();
    argument[count++] = "--scheme";
    argument[count++] = scheme ? scheme : b->scheme_file;
    for (int i = 0; !scheme && i < b->settings; i++) {
        argument[count++] = "--set";
        argument[count++] = b->setting[i];
    }
    argument[count++] = "--valence";
    argument[count++] = valences;
    argument[count++] = "--claim";
    argument[count++] = b->not_c1 ? "not-c1" : "c1";
    argument[count++] = certificate;
    argument[count] = NULL;
    setrlimit(RLIMIT_CPU, &limit);
    if (freopen("stdout", "w", stdout) && freopen("stderr", "w", stderr))
        execv(argument[0], (char **)(uintptr_t)argument);
    _exit(126);
}

static void read_said(char *out, size_t size, const char *name)
{
    FILE *file = fopen(name, "r");
    size_t length = file ? fread(out, 1, size - 1, file) : 0;
    out[length] = '\0';
    if (file)
        fclose(file);
}

void ask_checker(answer *z, const base *b, const char *scheme, valence_range k, const char *certificate)
{
    int how = 0;
    pid_t child;
    fflush(stdout);
    child = fork();
    if (child == 0)
        become_checker(b, scheme, k, certificate);
    z->status = -1;
    if (child > 0 && waitpid(child, &how, 0) == child && WIFEXITED(how))
        z->status = WEXITSTATUS(how);
    read_said(z->out, sizeof z->out, "stdout");
    read_said(z->err, sizeof z->err, "stderr");
}
