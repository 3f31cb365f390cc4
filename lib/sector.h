/* sector.h: nets on the k-regular complex that rotation multiplies by t = exp(i w), stored on one sector
   (verify/certificate.md, section 5).  Compiled once per number system.

   In the real form a value is a pair (x, y) that stands for x + i sin(w/2) y; then everything depends on
   u = cos(w/2) alone.  A plain net has t = 1: values are reals (y unused), and the centre counts. */
#ifndef LIB_SECTOR_H
#define LIB_SECTOR_H

#include "../bigfloat/number.h"
#include "laurent.h"

#define twist_init NUMBER_NAME(twist_init)
#define twist_clear NUMBER_NAME(twist_clear)
#define twist_set NUMBER_NAME(twist_set)
#define twist_apply NUMBER_NAME(twist_apply)
#define mask_numbers_make NUMBER_NAME(mask_numbers_make)
#define mask_numbers_free NUMBER_NAME(mask_numbers_free)
#define sector_net_make NUMBER_NAME(sector_net_make)
#define sector_net_free NUMBER_NAME(sector_net_free)
#define sector_value NUMBER_NAME(sector_value)
#define sector_refined_value NUMBER_NAME(sector_refined_value)

/* Multiplication by t: (x, y) -> (c x - n y, v x + c y), of determinant 1; v = 2u, c = cos w, n = 2 sin^2(w/2) u. */
typedef struct {
    number u, v, c, n;
} twist;

void twist_init(twist *t);
void twist_clear(twist *t);
/* The twist with u = cos(pi m / k). */
bool twist_set(twist *t, long m, long k, long prec); /* false: no memory */
/* (x, y) = t^turns (x, y). */
void twist_apply(number *x, number *y, const twist *t, int turns, long prec);

/* The weights of a mask as numbers. */
typedef struct {
    const laurent *mask; /* kept by the caller, alive as long as this */
    number *weight;      /* in the order of the mask's coefficients */
} mask_numbers;

bool mask_numbers_make(mask_numbers *z, const laurent *mask, long prec); /* false: no memory */
void mask_numbers_free(mask_numbers *z);
static inline const number *mask_numbers_at(const mask_numbers *z, long a, long b)
{
    return &z->weight[(a - z->mask->a0) * z->mask->nb + (b - z->mask->b0)];
}

/* Values at the points (a,b), a >= 1, b >= 0, a + b <= rings, and at the centre (0 unless plain). */
typedef struct {
    int rings;
    const twist *twist; /* NULL: a plain net; else kept by the caller */
    number centre;
    number *x, *y; /* sector_index(a,b) */
} sector_net;

static inline int sector_size(int rings) { return rings * (rings + 1) / 2; }
static inline int sector_index(int a, int b) { return (a + b) * (a + b - 1) / 2 + b; }

bool sector_net_make(sector_net *z, int rings, const twist *t); /* all values 0; false: no memory */
void sector_net_free(sector_net *z);

typedef enum { SECTOR_OK, SECTOR_OPPOSITE, SECTOR_OUTSIDE } sector_status;

/* (x, y) = the value at any point of the plane.  SECTOR_OPPOSITE: a < 0 and b <= 0, where the sheet is
   ambiguous.  SECTOR_OUTSIDE: beyond the rings that are stored. */
sector_status sector_value(number *x, number *y, const sector_net *z, int a, int b, long prec);

/* (x, y) = the value at (a,b) after one subdivision by the mask. */
sector_status sector_refined_value(number *x, number *y, const sector_net *z, const mask_numbers *mask, int a, int b, long prec);

#endif
