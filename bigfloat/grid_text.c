/* grid_text.c: grids as decimal text. */
#include "grid.h"

char *grid_get_decimal(const grid *x, int digits)
{
    ball t;
    ball_init(&t);
    ball_set_grid(&t, x, 64 + 4 * (long)(digits > 0 ? digits : 1));
    char *text = ball_get_decimal(&t, digits);
    ball_clear(&t);
    return text;
}
