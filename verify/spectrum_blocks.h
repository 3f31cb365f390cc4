/* spectrum_blocks.h: one block's eigenvalues into a list.  Compiled once per number system. */
#ifndef VERIFY_SPECTRUM_BLOCKS_H
#define VERIFY_SPECTRUM_BLOCKS_H

#include "spectrum_list.h"

#include "../lib/block.h"
#include "../lib/eigenvalues.h"

#define disc_modulus NUMBER_NAME(disc_modulus)
#define block_complaint NUMBER_NAME(block_complaint)
#define spectrum_list_block NUMBER_NAME(spectrum_list_block)

/* modulus contains |t| for all t in the disc. */
void disc_modulus(number *modulus, const eigenvalue_disc *d, long prec);

/* What to tell the user. */
status block_complaint(block_status s, diagnostic *d);

/* Adds the entries of block m. */
status spectrum_list_block(spectrum_list *z, scheme_numbers *numbers, long m, int digits, diagnostic *d);

#endif
