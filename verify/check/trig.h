#ifndef CHECK_TRIG_H
#define CHECK_TRIG_H

/* pi, cos(pi q), sin(pi q)
 * ========================
 *
 * Section 2 of certificate.md: for rational q, the least grid interval that
 * contains the number.
 */

#include "grid.h"

/* cos(pi q) or sin(pi q), if it is a rational number; else false.  (By Niven's
 * theorem the rational ones are 0, 1/2, -1/2, 1, -1.) */
bool rational_cos_pi(rational *out, rational q);
bool rational_sin_pi(rational *out, rational q);

interval grid_pi(int g);
interval grid_cos_pi(rational q, int g);
interval grid_sin_pi(rational q, int g);

#endif
