#ifndef CHECK_FIELD_H
#define CHECK_FIELD_H

/* Fields of cosines
 * =================
 *
 * Section 2 of exact.md.  K = Q(theta), theta = 2 cos(pi/n), of degree d.  A number is
 * (part_0 + part_1 theta + ... + part_(d-1) theta^(d-1)) / den.  Always den > 0, and all these
 * integers have no common divisor, so equal numbers have equal parts.  Numbers are values, as
 * integers are; what is to survive a release goes through number_keep().
 */

#include "grid.h"

enum { MAX_DEGREE = 64, MIN_FIELD = 2, MAX_FIELD = 4096 };

struct field {
    int n, degree;                                 /* n, d */
    integer minimal[MAX_DEGREE + 1];               /* Psi, monic */
};

struct number {
    integer den, part[MAX_DEGREE];                 /* those from d on are 0 */
};

/* d, for n in MIN_FIELD..MAX_FIELD. */
int field_degree(int n);

/* The field of n; its degree must be at most MAX_DEGREE. */
void field_make(struct field *out, int n);

void number_keep(struct mark mark, struct number *numbers, size_t count);

struct number number_from(rational q);
struct number number_from_whole(int64_t a);

/* (part_0 + ... + part_(d-1) theta^(d-1)) / den, den > 0. */
struct number number_of(const integer *part, integer den, const struct field *k);

/* cos(pi q); false unless n q is whole. */
bool number_cos_pi(struct number *out, rational q, const struct field *k);

struct number number_add(const struct number *a, const struct number *b);
struct number number_sub(const struct number *a, const struct number *b);
struct number number_minus(const struct number *a);
struct number number_mul(const struct number *a, const struct number *b, const struct field *k);

/* sum + a b; numbers that are 0 may be zeroed memory. */
void number_add_product(struct number *sum, const struct number *a, const struct number *b,
                        const struct field *k);
struct number number_scale(rational q, const struct number *a, const struct field *k);

bool number_is_zero(const struct number *a);

/* The number as a rational one; false if it is none. */
bool number_get_rational(rational *out, const struct number *a);

/* The enclosure of section 2. */
interval number_enclose(const struct number *a, const struct field *k, int g);

#endif
