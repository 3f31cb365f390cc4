#ifndef CHECK_SLOPES_H
#define CHECK_SLOPES_H

/* Eigenpairs of several valences: section 3 of certificate-valences.md. */

#include "spectrum.h"

/* The affine eigenpair of the matrix over u that the choices prove; else rejects.  Its s
 * is left 0. */
struct eigenpair slopes_prove_eigenpair(const struct affine *matrix, int g,
                                        const struct choices *choices,
                                        const struct certificate *certificate);

#endif
