/* archive_run.c: a line about a run, and the script that needs none of it. */
#ifdef HAVE_CONFIG_H
#include "config.h"
#endif
#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

#define _POSIX_C_SOURCE 200809L
#include "archive_run.h"

#include "json.h"
#include "statement.h"

#include <stdio.h>
#include <sys/utsname.h>
#include <time.h>

#if defined(__clang_version__)
#define COMPILER "clang " __clang_version__
#elif defined(__VERSION__)
#define COMPILER "gcc " __VERSION__
#else
#define COMPILER "unknown"
#endif

static void add_machine(buffer *line)
{
    struct utsname machine;
    char text[256];
    if (uname(&machine) < 0)
        return;
    snprintf(text, sizeof text, "%.80s %.80s", machine.sysname, machine.machine);
    json_add_string(line, "system", text);
    json_add_string(line, "host", machine.nodename);
}

void archive_describe_run(buffer *line, int argc, char *const *argv)
{
    time_t now = time(NULL);
    struct tm utc;
    char started[32] = "";
    if (gmtime_r(&now, &utc))
        strftime(started, sizeof started, "%Y-%m-%dT%H:%M:%SZ", &utc);
    buffer_print(line, "{\"started\":\"%s\"", started);
    json_add_string(line, "version", PACKAGE_VERSION);
    buffer_print(line, ",\"certificate_format\":%d", STATEMENT_NEWEST_VERSION);
    json_add_string(line, "compiler", COMPILER);
    add_machine(line);
    buffer_print(line, ",\"command\":[\"smoothcert\"");
    for (int i = 0; i < argc; i++) {
        buffer_print(line, ",");
        json_string(line, argv[i]);
    }
    buffer_print(line, "]}\n");
}

/* The claims are those of the index: whoever reads it knows what is claimed, and need not believe it.  A certificate that the
   index does not mention is no evidence for anything. */
const char archive_verify_script[] =
    "#!/bin/sh\n"
    "# Checks every certificate of this directory with smoothcert-check alone: what the index claims, for the scheme in\n"
    "# scheme.scheme.  SMOOTHCERT_CHECK names the program if it is not on PATH.\n"
    "# Exit status: 0 all verified, 1 a certificate was rejected, 2 one cannot be checked, or there is none.\n"
    "here=$(CDPATH='' cd -- \"$(dirname -- \"$0\")\" && pwd) || exit 2\n"
    "check=${SMOOTHCERT_CHECK:-smoothcert-check}\n"
    "verified=0 rejected=0 unchecked=0 undecided=0\n"
    "[ -r \"$here/index\" ] || { echo \"$here/index is missing: 'smoothcert archive verify' says more\" >&2; exit 2; }\n"
    "while read -r valences verdict digest file; do\n"
    "  case $verdict in\n"
    "    proved) claim=c1 ;;\n"
    "    refuted) claim=not-c1 ;;\n"
    "    *) echo \"undecided: valence $valences\"; undecided=$((undecided + 1)); continue ;;\n"
    "  esac\n"
    "  \"$check\" --scheme \"$here/scheme.scheme\" --valence \"$valences\" --claim \"$claim\" \"$here/$file\" </dev/null\n"
    "  case $? in\n"
    "    0) verified=$((verified + 1)) ;;\n"
    "    1) rejected=$((rejected + 1)) ;;\n"
    "    *) unchecked=$((unchecked + 1)) ;;\n"
    "  esac\n"
    "done <\"$here/index\"\n"
    "echo \"$verified verified, $rejected rejected, $unchecked could not be checked, $undecided undecided\"\n"
    "[ \"$rejected\" -eq 0 ] || exit 1\n"
    "[ \"$unchecked\" -eq 0 ] && [ \"$verified\" -gt 0 ] || exit 2\n";
