/* judge.h: what the checker was asked, what it answered, and the prover's judgement: is what it accepted true? */
#ifndef TESTS_CERTIFICATES_JUDGE_H
#define TESTS_CERTIFICATES_JUDGE_H

#include "tests/certificates/corpus.h"

/* What the checker is told, and what it says. */
typedef struct {
    const base *from;
    valence_range k;
    bool own_text;       /* the scheme is the mutant's own text, in the file `text` */
    buffer certificate;
    answer answer;
} trial;

/* test_fail unless the checker ended with a status that it has, and said what belongs to it. */
void judge_answer(const trial *t);

/* The certificate was accepted: test_fail unless the prover, too, comes to its verdict at some of the valences, with an
   eigenvalue in what the checker printed, and follows the certificate's choices on its grid as well as on a finer one. */
void judge_accepted(const trial *t);

#endif
