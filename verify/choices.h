/* choices.h: what a certificate contains beside its claim (verify/certificate.md, section 1).

   Whoever has the scheme, the valence and the choices can redo the whole proof: the same tests that search for
   choices also follow them. */
#ifndef VERIFY_CHOICES_H
#define VERIFY_CHOICES_H

#include "../lib/eigenpair_choice.h"
#include "tree.h"

/* Limits of version 0. */
#define CHOICES_MIN_VALENCE 3
#define CHOICES_MAX_VALENCE 4096
#define CHOICES_MIN_GRID 64
#define CHOICES_MAX_GRID 8192
#define CHOICES_NORMAL_BITS 32
#define CHOICES_MAX_POWER 10000
#define CHOICES_MAX_TOTAL_POWER 200000

typedef struct {
    long valence;
    long grid;            /* g: units of 2^-g */
    int contraction[3];   /* N12 N13 N23 */
    eigenpair_choice eigenpair;
    int *power;           /* P_0 .. P_floor(valence/2) */
    long normal[2];       /* of the half-plane that holds one sector's outer curve */
    tree_word regularity;
    tree_word boundary;
} choices;

void choices_init(choices *z);
bool choices_make(choices *z, long valence, long grid); /* false: no memory */
void choices_clear(choices *z);

#endif
