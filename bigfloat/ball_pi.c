/* ball_pi.c: pi. */
#include "ball.h"
#include "fraction.h"

void ball_pi(ball *z, long prec)
{
    size_t n = (size_t)ball_room_bits(prec) / 64 + 1;
    ball_scratch space;
    limb_t *p = ball_scratch_new(&space, n + 1);
    if (p && fraction_pi(p, n)) {
        /* ROUNDING (hidden but for one in 2^63): floor, or one less, below pi by less than 2 units.  The last limb is
           cut off anyway: unless it is among the highest, its last bit says "and more", so that what was lost counts
           once. */
        bool carries = p[0] >= ~(limb_t)1;
        p[0] |= 1;
        ball_store(z, p, n + 1, false, carries ? 2 : 0, 0, -(int64_t)(64 * n), prec);
    } else
        ball_no_memory(z);
    ball_scratch_free(&space);
}
