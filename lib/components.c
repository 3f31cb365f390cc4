/* components.c: the transitive closure, row by row in sets of bits (S. Warshall, 1962). */
#include "components.h"

#include <stdint.h>
#include <stdlib.h>

enum { WORD = 64 };

static bool has(const uint64_t *set, int j)
{
    return set[j / WORD] >> (j % WORD) & 1;
}

static void close_transitively(uint64_t *reach, int n, int words)
{
    for (int middle = 0; middle < n; middle++)
        for (int i = 0; i < n; i++)
            for (int w = 0; has(&reach[i * words], middle) && w < words; w++)
                reach[i * words + w] |= reach[middle * words + w];
}

bool components_find(int *component, const bool *arrow, int n)
{
    int words = n / WORD + 1;
    uint64_t *reach = calloc((size_t)n * (size_t)words + 1, sizeof *reach);
    if (!reach)
        return false;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            if (arrow[i * n + j])
                reach[i * words + j / WORD] |= (uint64_t)1 << (j % WORD);
    close_transitively(reach, n, words);
    for (int i = 0; i < n; i++) {
        int leader = 0;
        while (leader < i && !(has(&reach[i * words], leader) && has(&reach[leader * words], i)))
            leader++;
        component[i] = leader;
    }
    free(reach);
    return true;
}
