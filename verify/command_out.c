/* command_out.c: archives, and complaints about them. */
#include "command_out.h"

#include "command.h"
#include "command_certificates.h"

int command_open_archive(archive *z, const char *path, const scheme *s, const buffer *run)
{
    switch (archive_open(z, path, s, run)) {
    case ARCHIVE_OK:
        return -1;
    case ARCHIVE_OTHER_SCHEME:
        return complain(EXIT_BAD_INPUT, "%s holds evidence for another scheme; name another directory with --out", path);
    case ARCHIVE_NO_SCHEME:
        return complain(EXIT_BAD_INPUT, "%s holds certificates but no " ARCHIVE_SCHEME "; name another directory with --out", path);
    case ARCHIVE_BUSY:
        return complain(EXIT_IO, "%s: another run is at work there; wait for its end, or name another directory with --out", path);
    default:
        return complain_of_file(path);
    }
}

int command_write_index(const archive *z)
{
    valence_range pair[2];
    char first[VALENCE_RANGE_TEXT], second[VALENCE_RANGE_TEXT];
    switch (archive_write_index(z, pair)) {
    case ARCHIVE_OK:
        return 0;
    case ARCHIVE_CONTRADICTION:
        valence_range_print(first, pair[0]);
        valence_range_print(second, pair[1]);
        return complain(EXIT_FAULT, "%s: the certificates for %s and for %s contradict each other: this is a fault of the program", z->path, first, second);
    default:
        return complain_of_file(z->path);
    }
}
