/* judge.h: what the checker was asked, what it answered, and the prover's judgement: is what it accepted true? */
#ifndef TESTS_CERTIFICATES_JUDGE_H
#define TESTS_CERTIFICATES_JUDGE_H

#include "tests/certificates/corpus.h"

#include "verify/escalate.h"

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

/* What the prover says by itself of some valences of a claim: of the first one, and of several at a random one of the others.
   It is asked when the first certificate of the claim is accepted. */
typedef struct {
    long valence[2];
    decision at[2];
    int count;
    bool asked;
} opinion;

void opinion_init(opinion *z, valence_range k);
void opinion_clear(opinion *z);

/* The certificate was accepted: test_fail unless the prover, too, comes to its verdict (o: of its claim), with an eigenvalue in
   what the checker printed, and follows the certificate's choices on its grid as well as on a finer one. */
void judge_accepted(const trial *t, opinion *o);

#endif
