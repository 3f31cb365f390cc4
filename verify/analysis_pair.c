/* analysis_pair.c: an analysis with two eigenpairs looks at one of them at a time.  Compiled once per number system. */
#include "tests.h"

static analysis_pair take_pair(const analysis *a)
{
    return (analysis_pair){a->dominant, a->matrix, a->order, a->box, a->net, a->net_made};
}

/* The twist of a net is its block's, wherever that is. */
static void put_pair(analysis *a, const analysis_pair *p)
{
    a->dominant = p->dominant;
    a->matrix = p->matrix;
    a->order = p->order;
    a->box = p->box;
    a->net = p->net;
    a->net_made = p->net_made;
    if (a->net.twist)
        a->net.twist = &a->dominant.twist;
}

void analysis_exchange(analysis *a)
{
    choices *c = a->choices;
    analysis_pair here = take_pair(a);
    eigenpair_choice e = c->eigenpair;
    long m = c->frequency;
    put_pair(a, &a->other);
    a->other = here;
    if (a->other.net.twist)
        a->other.net.twist = &a->other.dominant.twist;
    c->eigenpair = c->second;
    c->second = e;
    c->frequency = c->second_frequency;
    c->second_frequency = m;
}
