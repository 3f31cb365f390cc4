/* cover.c: the proof for one box, and the search for boxes as wide as possible. */
#include "cover.h"

#include "spectrum.h"
#include "stop.h"
#include "stride.h"

#include <math.h>

/* What is known of one box. */
typedef struct {
    block_status status;
    spectral_answer answer;
} box_answer;

/* sharpen: least = 0. */
static spectral_answer contract(const number *matrix, const number *scale, int size, int least, int limit, bool sharpen, long prec)
{
    return sharpen ? spectral_contraction_sharp(matrix, scale, size, limit, prec) : spectral_contraction(matrix, scale, size, least, limit, prec);
}

/* The blocks of the frequencies m, squared at least `least` and at most `limit` times. */
static box_answer prove_range(scheme_numbers *numbers, frequencies m, const number *scale, int least, int limit, bool sharpen, diagnostic *d)
{
    box_answer z = {BLOCK_OK, {TRUTH_UNKNOWN, 0, false, INFINITY}};
    block b;
    z.status = block_make_range(&b, numbers, m, numbers->scheme->mirror_symmetric && !numbers->complex_form, d);
    if (z.status == BLOCK_OK && !b.imaginary) {
        z.answer = contract(b.entry, scale, b.n, least, limit, sharpen, numbers->prec);
    } else if (z.status == BLOCK_OK) {
        int size;
        number *matrix = block_real_matrix(&size, &b);
        z.answer.contracts = TRUTH_FALSE;
        if (matrix) {
            z.answer = contract(matrix, scale, size, least, limit, sharpen, numbers->prec);
            number_array_free(matrix, (size_t)size * (size_t)size);
        }
    }
    if (z.status == BLOCK_OK && z.answer.contracts == TRUTH_FALSE)
        z.status = BLOCK_NO_MEMORY;
    block_free(&b);
    return z;
}

/* The one proof.  A weight may have too long an exact value at one frequency, such as 2^-m, and an enclosure over two of
   them; what is proved of both holds for one. */
static box_answer prove_box(scheme_numbers *numbers, frequencies m, const number *scale, int least, int limit, bool sharpen, diagnostic *d)
{
    box_answer z = prove_range(numbers, m, scale, least, limit, sharpen, d);
    if (z.status == BLOCK_BAD_INPUT && m.first == m.last && m.first > 1) {
        diagnostic unused;
        box_answer two = prove_range(numbers, (frequencies){m.first - 1, m.last}, scale, least, limit, sharpen, &unused);
        if (two.status == BLOCK_OK)
            return two;
    }
    return z;
}

static void note_radius(cover_answer *z, const box_answer *b, frequencies m)
{
    if (b->answer.radius > z->radius) {
        z->radius = b->answer.radius;
        z->largest = m.first;
    }
}

static void leave_open(cover_answer *z, frequencies m)
{
    if (z->proved)
        z->open.first = m.first;
    z->open.last = m.last;
    z->proved = false;
}

/* Asked when a box is not proved, perhaps because something gave up on the way. */
static bool stops(cover_answer *z)
{
    if (stop_now()) {
        z->stopped = true;
        z->proved = false;
        z->status = BLOCK_OK;
    }
    return z->stopped;
}

cover_answer cover_search(cover_list *list, scheme_numbers *numbers, const number *scale, frequencies m, const cover_limits *limits, diagnostic *d)
{
    cover_answer z = {.status = BLOCK_OK, .proved = true};
    stride s = stride_start(1);
    long failures = 0, skip = 1; /* failures in a row leave more and more open */
    while (m.first <= m.last) {
        long width = stride_width(&s, m.last - m.first + 1);
        frequencies here = {m.first, m.first + width - 1};
        box_answer b = prove_box(numbers, here, scale, 0, limits->power, limits->sharpen, d);
        bool proved = b.answer.contracts == TRUTH_TRUE;
        if (!proved && stops(&z)) {
            z.open = z.open.first ? z.open : here;
            return z;
        }
        z.tries++;
        z.status = b.status;
        if (b.status != BLOCK_OK)
            return z;
        if (!proved && width > 1 && z.tries < limits->tries) {
            stride_after_failure(&s, (double)width);
            continue;
        }
        z.exhausted = z.tries >= limits->tries && !proved;
        if (proved) {
            stride_after_success(&s, (double)width);
            note_radius(&z, &b, here);
            skip = 1;
        } else {
            z.diverges = z.diverges || (width == 1 && b.answer.diverges);
            if (z.tries >= limits->tries)
                here.last = m.last;
            else
                here.last = skip < m.last - m.first + 1 ? m.first + skip - 1 : m.last;
            leave_open(&z, here);
            if (failures++ == limits->open)
                return z;
            skip *= 2;
            s = stride_start(1);
        }
        if (!cover_list_add(list, here, proved ? b.answer.power : COVER_OPEN)) {
            z.status = BLOCK_NO_MEMORY;
            return z;
        }
        m.first = here.last + 1;
    }
    return z;
}

cover_answer cover_verify(const cover_list *list, scheme_numbers *numbers, const number *scale, frequencies m, diagnostic *d)
{
    cover_answer z = {.status = BLOCK_OK, .proved = true};
    if (!cover_list_partitions(list, m)) {
        leave_open(&z, m);
        return z;
    }
    for (size_t i = 0; i < list->count; i++) {
        const cover_box *box = &list->box[i];
        box_answer b;
        if (box->power < 0) {
            leave_open(&z, box->m);
            continue;
        }
        b = prove_box(numbers, box->m, scale, box->power, box->power, false, d);
        if (b.answer.contracts != TRUTH_TRUE && stops(&z))
            return z;
        z.tries++;
        z.status = b.status;
        if (b.status != BLOCK_OK)
            return z;
        if (b.answer.contracts != TRUTH_TRUE)
            leave_open(&z, box->m);
        else
            note_radius(&z, &b, box->m);
    }
    return z;
}
