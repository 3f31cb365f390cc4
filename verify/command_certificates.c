/* command_certificates.c: a file, or all certificates of a directory. */
#define _POSIX_C_SOURCE 200809L
#include "command_certificates.h"

#include "archive.h"
#include "archive_index.h"
#include "command.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

int complain_of_file(const char *path)
{
    return complain(errno == ENOMEM ? EXIT_NO_MEMORY : EXIT_IO, "%s: %s", path, strerror(errno));
}

int complain_of_memory(void)
{
    return complain(EXIT_NO_MEMORY, "no memory");
}

int print_line(buffer *text)
{
    int result = text->failed ? complain_of_memory() : 0;
    if (result == 0)
        puts(text->bytes ? text->bytes : "");
    buffer_clear(text);
    return result;
}

static int for_each_of_index(const archive_index *index, const char *path, int (*act)(const char *, void *), void *data)
{
    int result = 0;
    for (size_t i = 0; result == 0 && i < index->count; i++) {
        char name[ARCHIVE_NAME_MAX];
        char *file;
        if (!index->entry[i].bytes)
            continue;
        archive_name(name, index->entry[i].valences, ARCHIVE_CERTIFICATE);
        file = durable_path(path, name);
        result = file ? act(file, data) : complain_of_memory();
        free(file);
    }
    return result;
}

static int for_each_of_directory(const char *path, int (*act)(const char *, void *), void *data)
{
    archive_index index;
    journal finished;
    int result;
    archive_index_init(&index);
    journal_init(&finished);
    if (!archive_read_journal(&finished, path) || !archive_index_make(&index, path, &finished))
        result = complain_of_file(path);
    else
        result = for_each_of_index(&index, path, act, data);
    journal_clear(&finished);
    archive_index_clear(&index);
    return result;
}

int for_each_certificate(const char *path, int (*act)(const char *, void *), void *data)
{
    struct stat s;
    return stat(path, &s) == 0 && S_ISDIR(s.st_mode) ? for_each_of_directory(path, act, data) : act(path, data);
}
