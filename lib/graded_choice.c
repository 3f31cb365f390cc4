/* graded_choice.c: life of a graded_choice, and the choice itself: shortest paths to the centre. */
#include "graded_choice.h"

#include <stdlib.h>

void graded_choice_init(graded_choice *z)
{
    *z = (graded_choice){1, 0, 0, NULL};
}

void graded_choice_clear(graded_choice *z)
{
    free(z->grade);
    graded_choice_init(z);
}

bool graded_choice_make(graded_choice *z, int n)
{
    graded_choice_clear(z);
    z->n = n;
    z->grade = calloc((size_t)n, sizeof *z->grade);
    return z->grade != NULL;
}

static bool is_degree(int d)
{
    return d >= 0 && d <= GRADED_MAX_DEGREE;
}

bool graded_choice_is_within_limits(const graded_choice *z)
{
    bool ok = is_degree(z->degree) && z->unit >= 1 && z->unit <= GRADED_MAX_UNIT;
    for (int i = 0; i < z->n; i++)
        ok = ok && is_degree(z->grade[i]);
    return ok;
}

/* ---- degree and grades ---- */

/* Unknowns that never depend on the centre begin that far away. */
enum { FAR = 1 << 24 };

/* grade_i <= degree + order_ij + grade_j for all j, unless that is so already. */
static bool lower(int *grade, const int *order, int n, int degree)
{
    bool changed = false;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            int o = order[i * n + j], most = o == GRADED_ABSENT ? grade[i] : degree + o + grade[j];
            if (most < grade[i]) {
                grade[i] = most;
                changed = true;
            }
        }
    return changed;
}

/* The lengths of the shortest paths from each unknown to the centre, by steps of the length degree + order.  false: there is a cycle of
   negative length. */
static bool find_paths(int *grade, const int *order, int n, int degree)
{
    for (int i = 0; i < n; i++)
        grade[i] = i ? FAR : 0;
    for (int round = 0; round <= n && grade[0] == 0; round++)
        if (!lower(grade, order, n, degree))
            return true;
    return false;
}

/* What does not depend on the centre comes as near as the others allow. */
static void bring_near(int *grade, const int *order, int n, int degree)
{
    int farthest = 0, nearest = INT_MAX;
    for (int i = 0; i < n; i++)
        if (grade[i] < FAR / 2)
            farthest = grade[i] > farthest ? grade[i] : farthest;
        else
            nearest = grade[i] < nearest ? grade[i] : nearest;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            int o = order[i * n + j];
            if (grade[i] < FAR / 2 && grade[j] >= FAR / 2 && o != GRADED_ABSENT && grade[i] - degree - o > farthest)
                farthest = grade[i] - degree - o;
        }
    for (int i = 0; i < n; i++)
        if (grade[i] >= FAR / 2)
            grade[i] += farthest - nearest;
}

static void subtract_least(int *grade, int n)
{
    int least = 0;
    for (int i = 0; i < n; i++)
        least = grade[i] < least ? grade[i] : least;
    for (int i = 0; i < n; i++)
        grade[i] -= least;
}

bool graded_choice_from_orders(graded_choice *z, const int *order, int n)
{
    if (!graded_choice_make(z, n))
        return false;
    while (z->degree <= GRADED_MAX_DEGREE && !find_paths(z->grade, order, n, z->degree))
        z->degree++;
    if (z->degree <= GRADED_MAX_DEGREE)
        bring_near(z->grade, order, n, z->degree);
    subtract_least(z->grade, n);
    return true;
}
