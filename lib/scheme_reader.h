/* scheme_reader.h: what the readers of a scheme file's parts share: the place where they are, and its words.

   Private to scheme_*.c.  Every function that can fail complains into r->complaint with the place in the file. */
#ifndef LIB_SCHEME_READER_H
#define LIB_SCHEME_READER_H

#include "scheme.h"

typedef struct {
    scheme *z;
    size_t next;            /* index of the next line */
    const text_line *line;  /* the current one; NULL at the end */
    size_t at;              /* in the current line */
    long operations;        /* of all formulas so far, definitions written out */
    const scheme_settings *settings;
    diagnostic *complaint;
} scheme_reader;

static inline bool is_letter(char c) { return c >= 'a' && c <= 'z'; }
static inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

static inline bool is_word_character(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

/* ---- words (scheme_lines.c) ---- */

void reader_next_line(scheme_reader *r);
void reader_skip_blank(scheme_reader *r);
bool reader_at_end(scheme_reader *r);              /* of the line */
status reader_expect_end(scheme_reader *r);        /* of the line */
bool reader_take_word(scheme_reader *r, const char *word); /* is the next word this one? then steps over it */
bool reader_take(scheme_reader *r, char c);
/* "expected WHAT, found ..." at the current place. */
status reader_expected(scheme_reader *r, const char *what);
/* A complaint about the whole current line; the format has one %s for `what`. */
status reader_complain(const scheme_reader *r, const char *format, const char *what);

/* Twice the coordinates of a point; the label of a point of the sector. */
status reader_point(lattice *twice, mesh_kind mesh, scheme_reader *r);
status reader_sector_point(lattice *p, mesh_kind mesh, scheme_reader *r);
/* Counts a formula's operations; refuses what would take too long to evaluate. */
status reader_count(scheme_reader *r, const formula *f);
/* The formula up to `end`, or that fills the rest of the line. */
status reader_formula_until(formula **f, scheme_reader *r, size_t end, unsigned allowed);
status reader_formula(formula **f, scheme_reader *r, unsigned allowed);

/* ---- parts of a file ---- */

/* scheme_definitions.c: parameters and abbreviations.  Leaves the first line that is none as the current one. */
status read_definitions(scheme_reader *r);
/* scheme_mask.c; the current line begins with `mask`. */
status read_mask(scheme_reader *r);
/* scheme_rule.c; the current line begins with `rule`. */
status read_rule(scheme_reader *r);
/* scheme_symmetry.c: are the rules evidently invariant under reflection? */
status find_symmetry(bool *symmetric, const scheme_step *step, mesh_kind mesh);
/* scheme_compose.c; the current line begins with `compose`. */
status read_compose(scheme_reader *r);
/* z->text, when everything has been read. */
status scheme_set_text(scheme_reader *r);

/* The whole mask of a scheme whose mesh is r->z->mesh: affine, and the same seen from every sector (scheme_mask.c). */
status check_mask(scheme_reader *r, const laurent *mask);
/* Removes the last step (scheme.c). */
void scheme_drop_step(scheme *z);
/* A new last step, NULL: there are too many (scheme_mask.c). */
scheme_step *add_step(scheme *z, mesh_kind from, mesh_kind to, int dilation, int reach);

#endif
