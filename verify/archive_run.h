/* archive_run.h: what an archive says of its making, and how to check it. */
#ifndef VERIFY_ARCHIVE_RUN_H
#define VERIFY_ARCHIVE_RUN_H

#include "buffer.h"

/* Appends a JSON object, on one line: the command (argv[0] is its name, without "smoothcert"), the versions of the program and of
   its certificates, the time, the machine. */
void archive_describe_run(buffer *line, int argc, char *const *argv);

/* A shell script that checks all certificates of the directory in which it lies, with smoothcert-check alone. */
extern const char archive_verify_script[];

#endif
