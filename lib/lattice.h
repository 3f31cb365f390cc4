/* lattice.h: points of the triangular lattice (lib/scheme.md, "Lattice"). */
#ifndef LIB_LATTICE_H
#define LIB_LATTICE_H

/* A lattice point or vector a e1 + b e2. */
typedef struct {
    int a, b;
} lattice;

/* The value of the functional f = 0, 1, 2: a, b, a + b. */
static inline long lattice_functional(int f, long a, long b)
{
    return f == 0 ? a : f == 1 ? b : a + b;
}

/* |(a,b)|: the distance from 0 in edges. */
static inline int lattice_distance(int a, int b)
{
    int c = a + b;
    a = a < 0 ? -a : a;
    b = b < 0 ? -b : b;
    c = c < 0 ? -c : c;
    a = a > b ? a : b;
    return a > c ? a : c;
}

#endif
