#ifndef CHECK_SYMMETRY_H
#define CHECK_SYMMETRY_H

/* Evident mirror symmetry: lib/scheme.md, "Mirror symmetry". */

#include "scheme.h"

bool scheme_is_mirrored(const struct scheme *scheme);

#endif
