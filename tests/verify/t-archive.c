/* t-archive.c: what archives are made of: ranges of valences, heads of certificates, journals, indices, tar. */
#include "verify/archive_index.h"
#include "verify/journal.h"
#include "verify/statement.h"
#include "verify/tar.h"

#include "tests/harness.h"
#include "tests/bigfloat/random.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- ranges ---- */

static void check_range(const char *text, long first, long last)
{
    valence_range r = {0, 0};
    char again[VALENCE_RANGE_TEXT];
    const char *rest = valence_range_read(&r, text);
    CHECK(rest && *rest == '\0' && r.first == first && r.last == last, "'%s' is read as %ld..%ld", text, r.first, r.last);
    valence_range_print(again, r);
    CHECK(!strcmp(again, text), "'%s' is printed as '%s'", text, again);
}

static void test_ranges(void)
{
    static const char *const bad[] = {"", "0", "07", "-7", "x", "7..7", "8..7", "7..", "7..x", "7..07", "9223372036854775807", "99999999999999999999"};
    test_begin("archive-ranges");
    check_range("7", 7, 7);
    check_range("8..20", 8, 20);
    check_range("21..inf", 21, VALENCES_UNBOUNDED);
    check_range("9223372036854775806", VALENCES_UNBOUNDED - 1, VALENCES_UNBOUNDED - 1);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        valence_range r;
        CHECK(!valence_range_read(&r, bad[i]), "'%s' is read", bad[i]);
    }
    CHECK(valence_range_overlap((valence_range){3, 7}, (valence_range){7, VALENCES_UNBOUNDED}), "3..7 and 7..inf do not overlap");
    CHECK(!valence_range_overlap((valence_range){3, 7}, (valence_range){8, VALENCES_UNBOUNDED}), "3..7 and 8..inf overlap");
    test_end();
}

/* ---- heads of certificates ---- */

static void check_head(const char *valence, const char *claim, const char *complaint)
{
    char text[256];
    statement z;
    long line;
    const char *found;
    snprintf(text, sizeof text, "smoothcert-certificate 1\nscheme 2\nscheme x\nclaim c1\nclaim %s\nvalence %s\ngrid 64\n", claim, valence);
    found = statement_read(&z, &line, text, strlen(text));
    CHECK((found == NULL) == (complaint == NULL) && (!found || strstr(found, complaint)), "valence %s, claim %s: '%s'", valence, claim, found ? found : "");
    if (!found)
        CHECK(statement_is_about(&z, "scheme x\nclaim c1\n", 18) && z.c1 == !strcmp(claim, "c1") && z.grid == 64, "claim %s: another scheme or claim is read", claim);
}

static void test_heads(void)
{
    static const char whole[] = "smoothcert-certificate 0\nscheme 1\nscheme x\nclaim c1\nvalence 8 20\n";
    statement z;
    long line;
    test_begin("archive-heads");
    check_head("7", "c1", NULL);
    check_head("8 20", "not-c1", NULL);
    check_head("21 inf", "c1", NULL);
    check_head("8..20", "c1", "valence");
    check_head("20 8", "c1", "valence");
    check_head("8 8", "c1", "valence");
    check_head("7 ", "c1", "valence");
    check_head("7", "C1", "claim");
    for (size_t length = 0; length < strlen(whole); length++)
        CHECK(statement_read(&z, &line, whole, length) && line >= 1 && line <= 5, "the first %zu bytes are read", length);
    CHECK(!statement_read(&z, &line, whole, strlen(whole)) && z.version == 0 && z.valences.first == 8 && z.valences.last == 20, "version 0 is not read");
    CHECK(statement_read(&z, &line, "smoothcert-certificate 2\n", 25) && line == 1, "a later version is read");
    test_end();
}

/* ---- journals ---- */

/* Wherever it is cut off, the complete lines count, and no others. */
static void test_journals(void)
{
    buffer text;
    size_t first;
    test_begin("archive-journals");
    buffer_init(&text);
    journal_print(&text, "valence-3.cert", "abc", 3);
    first = text.length;
    journal_print(&text, "valence-8..20.log", "", 0);
    journal_print(&text, "valence-3.cert", "", 0);
    for (size_t length = 0; length <= text.length; length++) {
        journal z;
        const char *digest;
        bool ends_well = length == 0 || text.bytes[length - 1] == '\n';
        journal_init(&z);
        MUST(journal_read(&z, text.bytes, length));
        digest = journal_find(&z, "valence-3.cert");
        CHECK((digest != NULL) == (length >= first), "%zu bytes: valence-3.cert", length);
        CHECK(!digest || !strncmp(digest, length < text.length ? "ba7816bf" : "e3b0c442", 8), "%zu bytes: digest %s", length, digest);
        CHECK(z.tidy == ends_well, "%zu bytes are tidy or not", length);
        CHECK(!journal_find(&z, "valence-4.cert"), "%zu bytes: valence-4.cert", length);
        journal_clear(&z);
    }
    buffer_clear(&text);
    test_end();
}

/* ---- contradictions ---- */

/* Against all pairs. */
static void test_contradictions(void)
{
    test_begin("archive-contradictions");
    for (test_cases(2000); test_next();) {
        archive_index_entry entry[6];
        archive_index z = {.entry = entry};
        valence_range pair[2];
        bool expected = false, found;
        for (long first = 3, count = 0; count < 6; count++, first += random_range(0, 2)) {
            memset(&entry[z.count], 0, sizeof *entry);
            entry[z.count].valences = (valence_range){first, random_below(16) == 0 ? VALENCES_UNBOUNDED : first + random_range(0, 3)};
            entry[z.count++].verdict = (verdict)random_below(3);
        }
        for (size_t i = 0; i < z.count; i++)
            for (size_t j = 0; j < z.count; j++)
                if (entry[i].verdict == VERDICT_PROVED && entry[j].verdict == VERDICT_REFUTED && valence_range_overlap(entry[i].valences, entry[j].valences))
                    expected = true;
        found = archive_index_contradiction(pair, &z);
        CHECK(found == expected && (!found || valence_range_overlap(pair[0], pair[1])), "contradiction %d, expected %d", found, expected);
    }
    test_end();
}

/* ---- tar ---- */

static void test_tar(void)
{
    buffer z;
    unsigned sum = 0;
    test_begin("archive-tar");
    buffer_init(&z);
    tar_add(&z, "directory", "name", "content", 7, true);
    tar_end(&z);
    CHECK(!z.failed && z.length == 4 * 512, "%zu bytes", z.length);
    for (int i = 0; i < 512; i++)
        sum += i >= 148 && i < 156 ? ' ' : (unsigned char)z.bytes[i];
    CHECK(strtoul(z.bytes + 148, NULL, 8) == sum, "the checksum is %.6s, not %o", z.bytes + 148, sum);
    CHECK(!strcmp(z.bytes, "name") && !strcmp(z.bytes + 345, "directory") && strtoul(z.bytes + 124, NULL, 8) == 7 && strtoul(z.bytes + 100, NULL, 8) == 0755, "a field is wrong");
    CHECK(!memcmp(z.bytes + 512, "content", 8), "the content is wrong");
    buffer_clear(&z);
    test_end();
}

int main(void)
{
    test_ranges();
    test_heads();
    test_journals();
    test_contradictions();
    test_tar();
    return test_status();
}
