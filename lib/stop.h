/* stop.h: giving up in the middle of a long computation.

   Each thread has one question that its long loops ask now and then: is there no time left?  What gives up then says that
   it does not know (TRUTH_UNKNOWN, BLOCK_STOPPED, not proved), never more: whether and when somebody stops a proof
   cannot make it prove anything.  Whoever has asked the question asks it again to tell this from other doubts. */
#ifndef LIB_STOP_H
#define LIB_STOP_H

#include <stdbool.h>

/* passed = NULL: there always is time. */
typedef struct {
    bool (*passed)(const void *data);
    const void *data;
} stop_sign;

/* The question of this thread from now on; returns the one before.  data is the caller's as long as it is asked. */
stop_sign stop_watch(stop_sign s);

bool stop_now(void);

#endif
