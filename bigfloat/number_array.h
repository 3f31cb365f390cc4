/* number_array.h: arrays of initialised numbers.

   X_array_new(n) gives n numbers, all 0, or NULL when there is no memory (never for n = 0);
   X_array_free(a, n) clears and releases them; a may be NULL. */
#ifndef BIGFLOAT_NUMBER_ARRAY_H
#define BIGFLOAT_NUMBER_ARRAY_H

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#define NUMBER_ARRAY_FUNCTIONS(X)                                          \
    static inline X *X##_array_new(size_t n)                               \
    {                                                                      \
        if (n > SIZE_MAX / sizeof(X))                                      \
            return NULL;                                                   \
        X *a = malloc(n ? n * sizeof(X) : sizeof(X));                      \
        for (size_t i = 0; a && i < n; i++)                                \
            X##_init(&a[i]);                                               \
        return a;                                                          \
    }                                                                      \
    static inline void X##_array_free(X *a, size_t n)                      \
    {                                                                      \
        for (size_t i = 0; a && i < n; i++)                                \
            X##_clear(&a[i]);                                              \
        free(a);                                                           \
    }                                                                      \
    struct X##_array_ends_here

#endif
