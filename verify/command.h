/* command.h: the commands of the program.  Each gets the arguments behind its name and returns the exit status. */
#ifndef VERIFY_COMMAND_H
#define VERIFY_COMMAND_H

/* Exit status, the same for all commands. */
enum {
    EXIT_PROVED = 0,
    EXIT_REFUTED = 1,
    EXIT_UNDECIDED = 2,
    EXIT_USAGE = 64,
    EXIT_BAD_INPUT = 65,
    EXIT_FAULT = 70,
    EXIT_NO_MEMORY = 71,
    EXIT_IO = 74,
    EXIT_INTERRUPTED = 130
};

int command_prove(int argc, char **argv);
int command_spectrum(int argc, char **argv);
int command_regular(int argc, char **argv);
int command_schemes(int argc, char **argv);
int command_show(int argc, char **argv);
int command_rerun(int argc, char **argv);
int command_archive(int argc, char **argv);
int command_report(int argc, char **argv);

/* Complains on stderr, as "smoothcert: ...", and returns the status given. */
int complain(int exit_status, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/* Flushes stdout; EXIT_IO with a complaint if anything written to it was lost, else the status given. */
int finish_output(int exit_status);

#endif
