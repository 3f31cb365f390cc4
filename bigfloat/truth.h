/* truth.h: the three answers of a comparison between enclosures. */
#ifndef BIGFLOAT_TRUTH_H
#define BIGFLOAT_TRUTH_H

/* TRUTH_TRUE and TRUTH_FALSE hold for every choice of numbers in the enclosures compared;
   TRUTH_UNKNOWN promises nothing.  "Not TRUTH_TRUE" is not "TRUTH_FALSE". */
typedef enum { TRUTH_FALSE, TRUTH_TRUE, TRUTH_UNKNOWN } truth;

static inline truth truth_not(truth t)
{
    return t == TRUTH_UNKNOWN ? TRUTH_UNKNOWN : t == TRUTH_TRUE ? TRUTH_FALSE : TRUTH_TRUE;
}

static inline truth truth_and(truth s, truth t)
{
    if (s == TRUTH_FALSE || t == TRUTH_FALSE)
        return TRUTH_FALSE;
    return s == TRUTH_TRUE && t == TRUTH_TRUE ? TRUTH_TRUE : TRUTH_UNKNOWN;
}

static inline truth truth_or(truth s, truth t)
{
    return truth_not(truth_and(truth_not(s), truth_not(t)));
}

#endif
