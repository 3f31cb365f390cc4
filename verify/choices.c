/* choices.c: life of the choices. */
#include "choices.h"

#include <string.h>

void choices_init(choices *z)
{
    memset(z, 0, sizeof *z);
    z->claim = CLAIM_C1;
    z->frequency = 1;
    eigenpair_choice_init(&z->eigenpair);
    eigenpair_choice_init(&z->second);
    exact_choice_init(&z->exact);
    integer_init(&z->modulus);
    cover_list_init(&z->blocks);
    tree_init(&z->regularity);
    tree_init(&z->boundary);
}

void choices_clear(choices *z)
{
    eigenpair_choice_clear(&z->eigenpair);
    eigenpair_choice_clear(&z->second);
    exact_choice_clear(&z->exact);
    integer_clear(&z->modulus);
    cover_list_clear(&z->blocks);
    tree_clear(&z->regularity);
    tree_clear(&z->boundary);
    choices_init(z);
}
