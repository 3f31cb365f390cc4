/* sector.h: nets on the k-regular complex that rotation multiplies by t = exp(i w), stored on one sector
   (verify/certificate.md, section 5).  Compiled once per number system.

   A value is a pair (x, y).  In the *real form*, for mirror-symmetric schemes, it stands for x + i sin(w/2) y, and
   everything depends on u = cos(w/2) alone; in the *complex form* for x + i y.  Multiplication by t is a 2 x 2
   matrix in both.  A *plain* net has t = 1, and the centre counts: values are reals (y is 0), or, of a complex eigenvalue,
   complex numbers x + i y. */
#ifndef LIB_SECTOR_H
#define LIB_SECTOR_H

#include "../bigfloat/number.h"
#include "exact_range.h"
#include "laurent.h"
#include "mesh.h"

#define pair_matrix_init NUMBER_NAME(pair_matrix_init)
#define pair_matrix_clear NUMBER_NAME(pair_matrix_clear)
#define pair_matrix_apply NUMBER_NAME(pair_matrix_apply)
#define pair_matrix_multiply NUMBER_NAME(pair_matrix_multiply)
#define twist_init NUMBER_NAME(twist_init)
#define twist_clear NUMBER_NAME(twist_clear)
#define twist_set_real NUMBER_NAME(twist_set_real)
#define twist_set_real_range NUMBER_NAME(twist_set_real_range)
#define twist_set_complex NUMBER_NAME(twist_set_complex)
#define twist_set_complex_range NUMBER_NAME(twist_set_complex_range)
#define twist_set_u NUMBER_NAME(twist_set_u)
#define twist_apply NUMBER_NAME(twist_apply)
#define mask_numbers_make NUMBER_NAME(mask_numbers_make)
#define mask_numbers_free NUMBER_NAME(mask_numbers_free)
#define sector_net_make NUMBER_NAME(sector_net_make)
#define sector_net_free NUMBER_NAME(sector_net_free)
#define sector_value NUMBER_NAME(sector_value)
#define sector_masked_value NUMBER_NAME(sector_masked_value)

/* (x, y) -> (xx x + xy y, yx x + yy y) */
typedef struct {
    number xx, xy, yx, yy;
} pair_matrix;

void pair_matrix_init(pair_matrix *z); /* 0 */
void pair_matrix_clear(pair_matrix *z);
void pair_matrix_apply(number *x, number *y, const pair_matrix *t, long prec);
void pair_matrix_multiply(pair_matrix *z, const pair_matrix *s, const pair_matrix *t, long prec);

typedef struct {
    bool complex_form;
    number u;             /* cos(w/2), of the real form */
    pair_matrix forth, back; /* multiplication by t and by 1/t */
} twist;

void twist_init(twist *t);
void twist_clear(twist *t);
/* w = 2 pi m / k for all m of the range, last <= k/2.  For one m the result is that of verify/certificate.md, section 5,
   to the bit.  false: no memory. */
bool twist_set_real_range(twist *t, frequencies m, long k, long prec);
bool twist_set_complex_range(twist *t, frequencies m, long k, long prec);
static inline bool twist_set_real(twist *t, long m, long k, long prec) { return twist_set_real_range(t, one_frequency(m), k, prec); }
static inline bool twist_set_complex(twist *t, long m, long k, long prec) { return twist_set_complex_range(t, one_frequency(m), k, prec); }
/* The real form for all u of an interval within [0, 1].  u = 1 is the limit w -> 0. */
bool twist_set_u(twist *t, const number *u, long prec);
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

/* Values at the points of the sector on the rings 1..rings, and at the centre, (centre, centre_y) (0 unless plain). */
typedef struct {
    mesh_kind mesh;
    bool regular;       /* the k-regular complex is the regular one: nothing is opposite */
    int rings;
    const twist *twist; /* NULL: a plain net; else kept by the caller */
    number centre, centre_y;
    number *x, *y; /* sector_index(net, a, b) */
} sector_net;

static inline int sector_size(int rings) { return rings * (rings + 1); }
static inline int sector_index(const sector_net *z, int a, int b) { return (a - 1) * (z->rings + 1) + b; }

bool sector_net_make(sector_net *z, mesh_kind mesh, bool regular, int rings, const twist *t); /* all values 0; false: no memory */
void sector_net_free(sector_net *z);

typedef enum { SECTOR_OK, SECTOR_OPPOSITE, SECTOR_OUTSIDE } sector_status;

/* (x, y) = the value at any point of the plane.  SECTOR_OPPOSITE: the point lies opposite the sector, where the sheet is
   ambiguous.  SECTOR_OUTSIDE: beyond the rings that are stored. */
sector_status sector_value(number *x, number *y, const sector_net *z, int a, int b, long prec);

/* (x, y) = sum of mask((a,b) - dilation p) times the value at p. */
sector_status sector_masked_value(number *x, number *y, const sector_net *z, const mask_numbers *mask, int dilation, int a, int b, long prec);

#endif
