/* t-certificate.c: what is written is read back the same; what is not exactly a certificate is not read. */
#include "verify/certificate.h"

#include "common.h"
#include "verify/sha256.h"

/* A certificate of Loop's scheme. */
static void make_certificate(decision *d, const subject *loop, long valence, limits l)
{
    decide(d, loop, valence, l);
    CHECK(d->verdict == VERDICT_PROVED && d->certificate.length > 0, "valence %ld is not proved: %s", valence, decision_obstacle(d)->reason);
}

/* Reads the bytes as a certificate of Loop's scheme and says in which line they are wrong, 0 if in none. */
static long wrong_line(const subject *loop, const char *bytes, size_t length)
{
    choices c;
    long line = -1;
    char *copy = malloc(length ? length : 1); /* so that reading too far can be seen */
    MUST(copy != NULL);
    memcpy(copy, bytes, length);
    choices_init(&c);
    MUST(certificate_read(&c, &line, &loop->scheme, copy, length));
    CHECK(line >= 0, "certificate_read sets no line");
    choices_clear(&c);
    free(copy);
    return line;
}

static void test_round_trip(void)
{
    static const long valence[] = {3, 4, 5, 6, 7, 20, 100};
    subject loop;
    test_begin("certificate-round-trip");
    subject_make(&loop, LOOP_MASK, LOOP_CENTRE);
    for (size_t i = 0; i < sizeof valence / sizeof *valence; i++)
        for (long precision = 0; precision <= 512; precision = precision ? 2 * precision : 64) {
            decision d;
            choices c;
            buffer again;
            long line = -1;
            make_certificate(&d, &loop, valence[i], precision ? balls(precision) : escalation(0));
            choices_init(&c);
            buffer_init(&again);
            MUST(certificate_read(&c, &line, &loop.scheme, d.certificate.bytes, d.certificate.length));
            CHECK(line == 0, "valence %ld, %ld bits: line %ld does not read back", valence[i], precision, line);
            CHECK(c.k.first == valence[i] && c.grid == (precision ? precision : CHOICES_MIN_GRID), "valence %ld on grid %ld", c.k.first, c.grid);
            certificate_write(&again, &loop.scheme, &c);
            CHECK(!again.failed && again.length == d.certificate.length && !memcmp(again.bytes, d.certificate.bytes, again.length),
                  "valence %ld, %ld bits: writing what was read gives other bytes", valence[i], precision);
            buffer_clear(&again);
            choices_clear(&c);
            decision_clear(&d);
        }
    subject_clear(&loop);
    test_end();
}

static bool is_clean_line(const char *line, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (line[i] < ' ' || line[i] > '~')
            return false;
    return length > 0 && line[0] != ' ' && line[length - 1] != ' ';
}

/* The form that section 1 of certificate.md demands of every line, the count and the hash. */
static void test_form(void)
{
    subject loop;
    decision d;
    long lines = 0, said = -1;
    char hex[65], end[160];
    test_begin("certificate-form");
    subject_make(&loop, LOOP_MASK, LOOP_CENTRE);
    make_certificate(&d, &loop, 7, escalation(0));
    for (const char *at = d.certificate.bytes, *stop; *at; at = stop + 1) {
        stop = strchr(at, '\n');
        CHECK(stop != NULL, "the last line has no end");
        if (!stop)
            break;
        CHECK(is_clean_line(at, (size_t)(stop - at)), "line %ld is not clean", lines + 1);
        if (!strncmp(at, "records ", 8)) {
            said = strtol(at + 8, NULL, 10);
            CHECK(said == lines, "%ld records are said to be above, %ld are", said, lines);
            sha256_hex(hex, d.certificate.bytes, (size_t)(stop + 1 - d.certificate.bytes));
            snprintf(end, sizeof end, "sha256 %s\n", hex);
            CHECK(!strcmp(stop + 1, end), "the last line is not the hash of those above");
        }
        lines++;
    }
    CHECK(said == lines - 2, "`records` is not the last line but one");
    decision_clear(&d);
    subject_clear(&loop);
    test_end();
}

static void test_other_scheme(void)
{
    subject loop, other;
    decision d;
    test_begin("certificate-other-scheme");
    subject_make(&loop, LOOP_MASK, LOOP_CENTRE);
    subject_make(&other, LOOP_MASK, "3/8");
    make_certificate(&d, &loop, 5, escalation(0));
    CHECK(wrong_line(&other, d.certificate.bytes, d.certificate.length) != 0, "a certificate of another scheme is read");
    decision_clear(&d);
    subject_clear(&loop);
    subject_clear(&other);
    test_end();
}

/* Puts the right count and hash behind everything above `records`. */
static void seal(buffer *z)
{
    char hex[65];
    long lines = 0;
    for (size_t i = 0; i < z->length; i++)
        lines += z->bytes[i] == '\n';
    buffer_print(z, "records %ld\n", lines);
    sha256_hex(hex, z->bytes ? z->bytes : "", z->length);
    buffer_print(z, "sha256 %s\n", hex);
}

static void test_cut(void)
{
    subject loop;
    decision d;
    test_begin("certificate-cut");
    subject_make(&loop, LOOP_MASK, LOOP_CENTRE);
    make_certificate(&d, &loop, 3, escalation(0));
    for (size_t n = 0; n < d.certificate.length; n++)
        CHECK(wrong_line(&loop, d.certificate.bytes, n) > 0, "the first %zu bytes are read", n);
    decision_clear(&d);
    subject_clear(&loop);
    test_end();
}

/* One byte changed, left out or added: never read, whether the hash is made right or not, unless what results is what
   certificate_write would write for other choices. */
static void test_garbage(void)
{
    subject loop;
    decision d;
    test_begin("certificate-garbage");
    subject_make(&loop, LOOP_MASK, LOOP_CENTRE);
    make_certificate(&d, &loop, 3, escalation(0));
    for (test_cases(4000); test_next();) {
        static const char some[] = "0123456789abcdefABCDEF -\n\r\t#xkc1";
        const char *records = strstr(d.certificate.bytes, "\nrecords ");
        bool right = random_bool();
        size_t whole = right && records ? (size_t)(records + 1 - d.certificate.bytes) : d.certificate.length;
        size_t at = random_below(whole);
        char letter = random_below(8) ? some[random_below(sizeof some - 1)] : (char)random_below(256);
        int how = (int)random_below(3);
        choices c;
        long line = -1;
        buffer b, again;
        buffer_init(&b);
        buffer_append(&b, d.certificate.bytes, at);
        if (how > 0)
            buffer_append(&b, &letter, 1);
        buffer_append(&b, d.certificate.bytes + at + (how < 2), whole - at - (how < 2));
        if (right)
            seal(&b);
        choices_init(&c);
        MUST(certificate_read(&c, &line, &loop.scheme, b.bytes, b.length));
        if (line == 0) {
            buffer_init(&again);
            certificate_write(&again, &loop.scheme, &c);
            CHECK(again.length == b.length && !memcmp(again.bytes, b.bytes, b.length), "read, but not what would be written (byte %zu)", at);
            CHECK(right || (b.length == d.certificate.length && !memcmp(b.bytes, d.certificate.bytes, b.length)), "read with a wrong hash (byte %zu)", at);
            buffer_clear(&again);
        }
        choices_clear(&c);
        buffer_clear(&b);
    }
    decision_clear(&d);
    subject_clear(&loop);
    test_end();
}

static void test_random_bytes(void)
{
    subject loop;
    test_begin("certificate-random-bytes");
    subject_make(&loop, LOOP_MASK, LOOP_CENTRE);
    for (test_cases(2000); test_next();) {
        char bytes[600];
        size_t length = random_below(sizeof bytes);
        for (size_t i = 0; i < length; i++)
            bytes[i] = (char)(random_bool() ? random_below(256) : (uint64_t)(unsigned char)"01 \n"[random_below(4)]);
        CHECK(wrong_line(&loop, bytes, length) > 0, "random bytes are read as a certificate");
    }
    subject_clear(&loop);
    test_end();
}

int main(void)
{
    test_round_trip();
    test_form();
    test_other_scheme();
    test_cut();
    test_garbage();
    test_random_bytes();
    return test_status();
}
