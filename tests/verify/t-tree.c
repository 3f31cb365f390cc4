/* t-tree.c: words of refinement trees. */
#include "verify/tree.h"

#include "common.h"

static void test_write_and_read(void)
{
    tree_word w;
    test_begin("tree-write-and-read");
    tree_init(&w);
    CHECK(tree_at_end(&w) && tree_get(&w) == '\0', "a new word is not empty");
    for (test_cases(200); test_next();) {
        char expected[2000];
        size_t length = random_below(sizeof expected);
        tree_reset(&w);
        CHECK(tree_at_end(&w) && tree_get(&w) == '\0', "a word is not empty after tree_reset");
        for (size_t i = 0; i < length; i++) {
            expected[i] = "012"[random_below(3)];
            CHECK(tree_is_letter(expected[i]), "'%c' is no letter", expected[i]);
            MUST(tree_put(&w, expected[i]));
            CHECK(w.letter[w.length] == '\0', "no NUL behind the word");
        }
        CHECK(w.length == length, "%zu letters instead of %zu", w.length, length);
        CHECK(tree_at_end(&w) == (length == 0), "reading begins at the end");
        for (size_t i = 0; i < length; i++)
            CHECK(tree_get(&w) == expected[i], "letter %zu of %zu has changed", i, length);
        CHECK(tree_at_end(&w), "the word is not at its end");
        CHECK(tree_get(&w) == '\0' && tree_get(&w) == '\0' && tree_at_end(&w), "there is something behind the end");
    }
    tree_clear(&w);
    CHECK(w.letter == NULL && w.length == 0 && tree_at_end(&w), "a word is not empty after tree_clear");
    tree_clear(&w);
    test_end();
}

static void test_letters(void)
{
    test_begin("tree-letters");
    for (int c = 0; c < 256; c++)
        CHECK(tree_is_letter((char)c) == (c == '0' || c == '1' || c == '2'), "the letter %d", c);
    test_end();
}

static void test_long_word(void)
{
    tree_word w;
    test_begin("tree-long-word");
    tree_init(&w);
    for (long i = 0; i < TREE_MAX_LETTERS; i++)
        MUST(tree_put(&w, i % 3 ? '0' : '1'));
    for (long i = 0; i < TREE_MAX_LETTERS; i++)
        CHECK(tree_get(&w) == (i % 3 ? '0' : '1'), "letter %ld has changed", i);
    CHECK(tree_at_end(&w), "the word is longer than it was made");
    tree_clear(&w);
    test_end();
}

int main(void)
{
    test_write_and_read();
    test_letters();
    test_long_word();
    return test_status();
}
