/* choices.c: life of the choices. */
#include "choices.h"

#include <stdio.h>
#include <string.h>

const char *claim_name(claim_kind c)
{
    static const char *const names[] = {[CLAIM_C1] = "c1", [CLAIM_FREQUENCY] = "frequency", [CLAIM_NOT_C0] = "not-c0", [CLAIM_FOLD] = "fold", [CLAIM_WINDING] = "winding", [CLAIM_REAL] = "real",
                                         [CLAIM_TIE] = "tie", [CLAIM_JORDAN] = "jordan", [CLAIM_MODULUS_ONE] = "modulus-one",
                                         [CLAIM_WINDOW] = "frequency", [CLAIM_GRADED] = "not-c0"};
    return names[c];
}

void choices_print_growth(char text[CHOICES_GROWTH_TEXT], const choices *c)
{
    const graded_choice *g = &c->graded;
    text[0] = '\0';
    if (c->claim == CLAIM_GRADED && g->degree == 1)
        snprintf(text, CHOICES_GROWTH_TEXT, "(k/%ld)", g->unit);
    else if (c->claim == CLAIM_GRADED && g->degree > 1)
        snprintf(text, CHOICES_GROWTH_TEXT, "(k/%ld)^%d", g->unit, g->degree);
}

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
    eigenpair_choice_init(&z->limit.eigenpair);
    rise_list_init(&z->rise);
    span_list_init(&z->spans);
    window_choice_init(&z->window);
    graded_choice_init(&z->graded);
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
    eigenpair_choice_clear(&z->limit.eigenpair);
    rise_list_clear(&z->rise);
    span_list_clear(&z->spans);
    window_choice_clear(&z->window);
    graded_choice_clear(&z->graded);
    tree_clear(&z->regularity);
    tree_clear(&z->boundary);
    choices_init(z);
}
