/* main.c: which command it is. */
#ifdef HAVE_CONFIG_H
#include "config.h"
#endif
#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

#include "command.h"

#include <errno.h>
#include <fenv.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const char help[] =
    "Usage: smoothcert COMMAND [ARGUMENT]...\n"
    "Proves that a subdivision scheme is C1 at extraordinary vertices, with certificates.\n"
    "\n"
    "  smoothcert prove SCHEME --valence LIST [OPTION]...   prove, and keep certificates\n"
    "  smoothcert report DIR [OPTION]...                    a page with figures of what was proved\n"
    "  smoothcert spectrum SCHEME --valence K [OPTION]...   all eigenvalues, enclosed\n"
    "  smoothcert regular SCHEME [OPTION]...                norms and bounds on regular meshes, exactly\n"
    "  smoothcert schemes [NAME]                            list the catalogue, or print a scheme\n"
    "  smoothcert show CERTIFICATE|DIRECTORY...             explain certificates in words\n"
    "  smoothcert rerun CERTIFICATE|DIRECTORY...            prove once more, with more precision\n"
    "  smoothcert archive list|verify|diff|pack DIRECTORY   what directories of certificates hold\n"
    "\n"
    "  smoothcert COMMAND --help    the options of a command\n"
    "  smoothcert --help            this text\n"
    "  smoothcert --version         version of the program and of its certificates\n"
    "\n"
    "Exit status of prove: 0 everything was proved, 1 something was refuted, else 2 something stayed\n"
    "undecided; errors: 64 usage, 65 bad input, 70 a fault of the program, 71 no memory, 74 input or\n"
    "output, 130 interrupted.\n";

int complain(int exit_status, const char *format, ...)
{
    va_list arguments;
    fputs("smoothcert: ", stderr);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return exit_status;
}

int finish_output(int exit_status)
{
    if (fflush(stdout) != 0 || ferror(stdout))
        return complain(EXIT_IO, "standard output: %s", strerror(errno));
    return exit_status;
}

/* "help COMMAND" and "COMMAND -h" become "COMMAND --help", "help" and "-h" become "--help". */
static void understand_help(int argc, char **argv)
{
    static char help_option[] = "--help";
    if (argc == 3 && !strcmp(argv[1], "help"))
        argv[1] = argv[2], argv[2] = help_option;
    else if (argc == 3 && !strcmp(argv[2], "-h"))
        argv[2] = help_option;
    else if (argc == 2 && (!strcmp(argv[1], "help") || !strcmp(argv[1], "-h")))
        argv[1] = help_option;
}

int main(int argc, char **argv)
{
    fesetround(FE_TONEAREST); /* printing relies on it, whatever mode was inherited */
    if (argc < 2)
        return complain(EXIT_USAGE, "no command given; 'smoothcert --help' lists them");
    understand_help(argc, argv);
    if (!strcmp(argv[1], "--help")) {
        fputs(help, stdout);
        return finish_output(0);
    }
    if (!strcmp(argv[1], "--version")) {
        puts("smoothcert " PACKAGE_VERSION "\ncertificate format 1");
        return finish_output(0);
    }
    if (!strcmp(argv[1], "prove"))
        return command_prove(argc - 1, argv + 1);
    if (!strcmp(argv[1], "spectrum"))
        return command_spectrum(argc - 1, argv + 1);
    if (!strcmp(argv[1], "regular"))
        return command_regular(argc - 1, argv + 1);
    if (!strcmp(argv[1], "schemes"))
        return command_schemes(argc - 1, argv + 1);
    if (!strcmp(argv[1], "show"))
        return command_show(argc - 1, argv + 1);
    if (!strcmp(argv[1], "rerun"))
        return command_rerun(argc - 1, argv + 1);
    if (!strcmp(argv[1], "archive"))
        return command_archive(argc - 1, argv + 1);
    if (!strcmp(argv[1], "report"))
        return command_report(argc - 1, argv + 1);
    return complain(EXIT_USAGE, "unknown command '%s'; 'smoothcert --help' lists them", argv[1]);
}
