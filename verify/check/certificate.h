#ifndef CHECK_CERTIFICATE_H
#define CHECK_CERTIFICATE_H

/* Certificates
 * ============
 *
 * Section 1 of certificate.md and of certificate-valences.md: the file.  Reading checks its form,
 * its limits, its records and its hash; what the choices prove is checked elsewhere.  A file that
 * has not exactly the form: rejected.  Beyond a limit: cannot check.
 */

#include "field.h"
#include "span.h"

/* P for the frequencies m */
struct block_record {
    struct span m;
    int power;
    int line;
};

/* What proves an eigenpair. */
struct choices {
    int pivot;                                     /* from 1 on */
    integer eigenvalue[2];                         /* real form: [0] */
    integer *eigenvector;                          /* n - 1, or twice as many */
    integer radius, range;                         /* range: of several valences */
    integer *inverse;                              /* N x N, row by row */
    integer modulus;                               /* complex form */
    struct {
        int pivot, eigenvalue, radius, range, modulus;
    } line_of;
};

/* A word of trees. */
struct trees {
    const char *word;
    size_t size;
    int line;
};

/* Of several valences: `rise Q P` (`wave Q P`) with its eigenpair (and `boundary`), and
 * `cover D D Q P`. */
struct rise {
    int64_t q;                                     /* in units of 2^-48 */
    struct block_record record;                    /* m: 1..ENDLESS; wave: from 2 on */
    struct choices pair;
    struct trees boundary;
};

struct cover {
    int64_t q;
    struct block_record record;
};

/* An element of level 0, and the way to a descendant: digits, or `-`. */
struct witness {
    int64_t element;
    const char *path;
    size_t path_size;
    int line;
};

/* `exact m s a q j P` of exact.md. */
struct exact_record {
    int64_t m;
    int sign, a, q, j;
    struct block_record record;
};

/* What proves that eigenvalues are equal: exact.md. */
struct exact_choices {
    int field;                                     /* n */
    int degree;                                    /* e of g */
    integer *coefficient;                          /* of each Q, then d numerators */
    integer eigenvalue, radius;
    struct block_record others;
    int count;
    struct exact_record *line;
    int line_of_eigenvalue;
};

struct certificate {
    const char *file;

    int version;
    const char *scheme_text;                       /* canonical, it says */
    size_t scheme_size;
    enum claim { CLAIM_C1, CLAIM_NOT_C1, CLAIM_OTHER } claim;
    struct span valence;                           /* k */
    int grid;                                      /* g */

    int contraction[3];
    int stability_power[3];                        /* n_i, T_i */
    int64_t stability[3];
    enum reason {
        REASON_NONE, REASON_FREQUENCY, REASON_NOT_C0, REASON_FOLD, REASON_WINDING,
        REASON_REAL, REASON_TIE, REASON_JORDAN, REASON_MODULUS_ONE
    } reason;
    int64_t frequency;                             /* m of the eigenpair; c1: 1; -1: of a */
    int64_t window;                                /* window from there on, 2^-48; */
    integer bound;                                 /* with this R */
    bool real;                                     /* the form; also `plain`, `graded` */
    bool graded;
    int64_t unit;                                  /* q */
    int degree;                                    /* d; the e_i */
    int *grade;
    int n;                                         /* number of unknowns of a block */
    int size;                                      /* N: n or, complex form, 2 n */
    struct choices pair;
    int64_t second_frequency;                      /* reason real: m' */
    struct choices second;
    struct exact_choices exact;                    /* tie, jordan, modulus-one */
    int blocks, rises, covers;
    struct block_record *block;
    struct rise *rise;
    struct cover *cover;
    bool has_limit;                                /* in place of block 0 */
    struct rise limit;                             /* without Q */
    integer normal[2];
    bool has_splines;                              /* 2 is a letter */
    struct trees regularity, boundary;             /* words over {0,1,2} */
    size_t letters;                                /* of all words of trees */
    int powers;                                    /* the sum of all */
    struct witness witness[2];

    struct {                                       /* for messages */
        int scheme, claim, valence, contraction, stability, form, window;
    } line_of;

    const char *text, *end, *next;                 /* still to be read: next */
    int line;                                      /* number of the next line */
};

/* The records up to `grid`: what the certificate is about. */
void certificate_read_subject(struct certificate *out, const char *file,
                              const char *text, size_t size);

/* `contraction` and, if not plainly regular, what follows up to `form`; of the reasons of exact.md
 * all up to `records`. */
void certificate_read_form(struct certificate *out, bool plainly_regular);

/* Is the reason one of exact.md? */
bool certificate_is_exact(const struct certificate *c);

/* What follows up to `boundary` or `witness`, for eigenpairs of n[0] unknowns at frequency 0 (plain
 * form: one less than block 0 has), else of n[1]. */
void certificate_read_choices(struct certificate *out, const int n[2]);

void certificate_read_end(struct certificate *out);

#endif
