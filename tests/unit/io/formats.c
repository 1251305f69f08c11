/* formats.c: names of formats, guessing, streams, and the systems that each writer refuses. */
#include <criterion/criterion.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "io/core/utf8.h"
#include "parse.h"

Test(formats, names)
{
    for (int f = FMB_FORMAT_AUTO; f <= FMB_FORMAT_IEQ; f++) {
        fmb_format back = FMB_FORMAT_LP;
        cr_expect(fmb_format_parse(fmb_format_text((fmb_format)f), &back) && back == (fmb_format)f);
    }
    fmb_format untouched = FMB_FORMAT_INE;
    cr_expect(!fmb_format_parse("pdf", &untouched) && untouched == FMB_FORMAT_INE);
    cr_expect(fmb_format_of_name("a/b.ine") == FMB_FORMAT_INE);
    cr_expect(fmb_format_of_name("B.INE") == FMB_FORMAT_INE);
    cr_expect(fmb_format_of_name("x.ine.ieq") == FMB_FORMAT_IEQ);
    cr_expect(fmb_format_of_name("x.fmb") == FMB_FORMAT_TEXT);
    cr_expect(fmb_format_of_name("a.ine/b") == FMB_FORMAT_AUTO);
    cr_expect(fmb_format_of_name("ine") == FMB_FORMAT_AUTO);
    cr_expect(fmb_format_of_name("-") == FMB_FORMAT_AUTO);
}

Test(formats, guesses)
{
    static const meaning table[] = {
        {"DIM <= 3\n", "vars: DIM\nDIM <= 3\n"},
        {"begin <= 3\n", "vars: begin\nbegin <= 3\n"},
        {"(x + y) <= 3\n", "vars: x y\nx + y <= 3\n"},
        {"\xEF\xBB\xBFmin + st <= 3\n", "vars: min st\nmin + st <= 3\n"},
        {"name\nbegin\n1 2 integer\n1 1\nend\n", "vars: x1\n-x1 <= 1\n"},
        {"DIM = 1\nINEQUALITIES_SECTION\nx1 <= 1\nEND\n", "vars: x1\nx1 <= 1\n"},
    };
    check_meanings(FMB_FORMAT_AUTO, table, sizeof table / sizeof *table);
}

Test(formats, writing_arguments)
{
    fmb_system *s = NULL;
    cr_assert(fmb_system_new(1, NULL, &s) == FMB_OK);
    cr_expect(fmb_system_write(s, FMB_FORMAT_IEQ, stdout) == FMB_ERR_ARG);
    cr_expect(fmb_system_write(s, FMB_FORMAT_AUTO, stdout) == FMB_ERR_ARG);
    cr_expect(fmb_system_write(s, (fmb_format)99, stdout) == FMB_ERR_ARG);
    cr_expect(fmb_system_write(NULL, FMB_FORMAT_INE, stdout) == FMB_ERR_ARG);
    cr_expect(fmb_system_write(s, FMB_FORMAT_INE, NULL) == FMB_ERR_ARG);
    fmb_system_free(s);
    fmb_format untouched = FMB_FORMAT_INE;
    cr_expect(!fmb_format_parse(NULL, &untouched) && untouched == FMB_FORMAT_INE);
    cr_expect(!fmb_format_parse("ine", NULL));
    cr_expect(fmb_format_of_name(NULL) == FMB_FORMAT_AUTO);
    cr_expect(strcmp(fmb_format_text((fmb_format)-7), "auto") == 0);
}

static void expect_blame(fmb_status st, const fmb_where *w, const char *piece)
{
    cr_expect(st == FMB_ERR_ARG && w->line == 0 && strstr(w->text, piece), "%s: %s",
              fmb_status_text(st), w->text);
}

/* The message says which argument is wrong. */
Test(formats, reading_arguments)
{
    const fmb_reader none = {.size = sizeof none, .format = (fmb_format)99};
    fmb_system *s = NULL;
    fmb_where w;
    expect_blame(fmb_system_parse(NULL, 1, NULL, &s, &w), &w, "text is NULL");
    expect_blame(fmb_system_parse("", 0, NULL, NULL, &w), &w, "out is NULL");
    expect_blame(fmb_system_parse("", 0, &none, &s, &w), &w, "how->format");
    expect_blame(fmb_system_read(NULL, NULL, &s, &w), &w, "in is NULL");
    expect_blame(fmb_system_read(stdin, NULL, NULL, &w), &w, "out is NULL");
    expect_blame(fmb_system_read(stdin, &none, &s, &w), &w, "how->format");
    cr_expect(fmb_system_parse(NULL, 1, NULL, NULL, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_system_parse("x", 1, NULL, &s, NULL) == FMB_ERR_PARSE);
    cr_expect(!s);
}

/* A text without rows and variables is no system, in any format. */
Test(formats, nothing)
{
    static const struct {
        fmb_format format;
        const char *text;
    } table[] = {
        {FMB_FORMAT_AUTO, ""},
        {FMB_FORMAT_AUTO, "\n\n"},
        {FMB_FORMAT_AUTO, "\xEF\xBB\xBF"},
        {FMB_FORMAT_TEXT, "# only words\n"},
        {FMB_FORMAT_TEXT, "vars:\nproject:\n"},
        {FMB_FORMAT_IEQ, "DIM = 0\nINEQUALITIES_SECTION\nEND\n"},
        {FMB_FORMAT_SMT2, "; only words\n"},
        {FMB_FORMAT_SMT2, "(set-logic QF_LRA)(assert true)(check-sat)"},
        {FMB_FORMAT_AUTO, NULL},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        fmb_system *s = NULL;
        fmb_where w = {0};
        size_t size = table[i].text ? strlen(table[i].text) : 0;
        fmb_reader how = {.size = sizeof how, .format = table[i].format};
        cr_expect(fmb_system_parse(table[i].text, size, &how, &s, &w) == FMB_ERR_PARSE && !s);
        cr_expect(w.line == 0 && strstr(w.text, "rows or variables, found none"), "%zu: %s", i,
                  w.text);
    }
    static const meaning legal[] = {{"begin\n0 3 integer\nend\n", "vars: x1 x2\n"},
                                    {"vars: x\n", "vars: x\n"},
                                    {"0 <= 1", "0 <= 1\n"},
                                    {"(declare-const x Real)", "vars: x\n"}};
    check_meanings(FMB_FORMAT_AUTO, legal, sizeof legal / sizeof *legal);
}

static fmb_status read_at_most(const char *text, size_t most, fmb_where *w)
{
    fmb_reader how = {.size = sizeof how, .max_bytes = most};
    fmb_system *s = NULL;
    FILE *in = fmemopen((void *)(uintptr_t)text, strlen(text), "r");
    fmb_status parsed = fmb_system_parse(text, strlen(text), &how, &s, NULL);
    fmb_system_free(s);
    s = NULL;
    fmb_status read = fmb_system_read(in, &how, &s, w);
    fmb_system_free(s);
    fclose(in);
    cr_expect(parsed == read);
    return read;
}

Test(formats, longest_text)
{
    fmb_where w = {0};
    cr_expect(read_at_most("x <= 1\n", 7, &w) == FMB_OK);
    cr_expect(read_at_most("x <= 1\n", 0, &w) == FMB_OK);
    cr_expect(read_at_most("x <= 1\n", 6, &w) == FMB_ERR_PARSE);
    cr_expect(w.line == 0 && strstr(w.text, "at most 6 bytes"), "%s", w.text);
}

/* A reader stops at the limit, however much a stream holds. */
Test(formats, endless_stream)
{
    FILE *in = fopen("/dev/zero", "r");
    fmb_system *s = NULL;
    fmb_where w = {0};
    if (!in)
        cr_skip_test("no /dev/zero here");
    cr_expect(fmb_system_read(in, &(fmb_reader){.size = sizeof(fmb_reader), .max_bytes = 100000},
                              &s, &w) == FMB_ERR_PARSE);
    cr_expect(strstr(w.text, "at most 100000 bytes"), "%s", w.text);
    fclose(in);
}

Test(formats, characters)
{
    cr_expect(fmb_utf8_length("a", 1) == 1 && fmb_utf8_printable("a", 1) == 1);
    cr_expect(fmb_utf8_length("\xC3\xA9", 2) == 2 && fmb_utf8_printable("\xC3\xA9", 2) == 2);
    cr_expect(fmb_utf8_length("\x1b", 1) == 1 && fmb_utf8_printable("\x1b", 1) == 0);
    cr_expect(fmb_utf8_printable("\x7f", 1) == 0);
    cr_expect(fmb_utf8_length("\xC2\x9B", 2) == 2 && fmb_utf8_printable("\xC2\x9B", 2) == 0);
    cr_expect(fmb_utf8_printable("\xC2\xA0", 2) == 2);
    cr_expect(fmb_utf8_length("\xE2\x82\xAC", 2) == 0 && fmb_utf8_length("\xED\xA0\x80", 3) == 0);
    cr_expect(fmb_utf8_printable("\xF0\x9F\x98\x80", 4) == 4);
    cr_expect(fmb_utf8_length("a", 0) == 0 && fmb_utf8_length(NULL, 4) == 0);
}

/* What reorders a text or is not seen in it; and its neighbours, which are letters and signs. */
Test(formats, invisible_characters)
{
    static const char *const hidden[] = {
        "\xE2\x80\x8B", "\xE2\x80\x8F", "\xE2\x80\xA8", "\xE2\x80\xAA",     "\xE2\x80\xAE",
        "\xE2\x81\xA0", "\xE2\x81\xA9", "\xEF\xBB\xBF", "\xD8\x9C",         "\xC2\xAD",
        "\xE1\xA0\x8E", "\xEF\xBF\xB9", "\xEF\xB8\x8F", "\xF3\xA0\x80\xA1", "\xCD\x8F",
    };
    static const char *const shown[] = {"\xE2\x80\x90",    "\xE2\x80\xA7", "\xE2\x81\xB0",
                                        "\xD8\x9B",        "\xC2\xAE",     "\xEF\xBB\xBE",
                                        "\xF3\xA1\x80\x80"};
    for (size_t i = 0; i < sizeof hidden / sizeof *hidden; i++) {
        size_t size = strlen(hidden[i]);
        cr_expect(fmb_utf8_length(hidden[i], size) == size, "%zu", i);
        cr_expect(fmb_utf8_printable(hidden[i], size) == 0, "%zu", i);
    }
    for (size_t i = 0; i < sizeof shown / sizeof *shown; i++)
        cr_expect(fmb_utf8_printable(shown[i], strlen(shown[i])) == strlen(shown[i]), "%zu", i);
}

/* No message holds what a terminal could obey: U+009B begins an escape sequence. */
Test(formats, harmless_messages)
{
    static const char *const texts[] = {
        "x <= \xC2\x9B"
        "2J\n",
        "vars: x\n\"a\xC2\x9B"
        "5m\" <= 1\n",
        "(declare-const |a\xC2\x9B"
        "5m| Real)(declare-const |a\xC2\x9B"
        "5m| Real)",
        "H-representation\nbegin\n1 2 real\n1 \xC2\x9B\nend\n",
        "\x1b[2J",
        "x <= \xE2\x80\xAE"
        "1\n",
        "vars: x\n\"a\xE2\x81\xA6"
        "5m\" <= 1\n",
        "vars: x\na\xEF\xBB\xBF"
        "b <= 1\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        fmb_system *s = NULL;
        fmb_where w = {0};
        cr_expect(fmb_system_parse(texts[i], strlen(texts[i]), NULL, &s, &w) == FMB_ERR_PARSE);
        size_t left = strlen(w.text), n = 1;
        for (const char *p = w.text; left > 0 && n > 0; p += n, left -= n)
            n = fmb_utf8_printable(p, left);
        cr_expect(*w.text && left == 0, "%zu: %s", i, w.text);
    }
}

/* A long text arrives in pieces. */
Test(formats, stream)
{
    enum { ROWS = 20000 };
    int end[2];
    fmb_system *s = NULL;
    cr_assert(pipe(end) == 0);
    pid_t child = fork();
    if (child == 0) {
        FILE *out = fdopen(end[1], "w");
        for (int i = 0; i < ROWS; i++)
            fprintf(out, "row %d: x%d <= %d\n", i, i % 10, i);
        fclose(out);
        _exit(0);
    }
    close(end[1]);
    FILE *in = fdopen(end[0], "r");
    cr_assert(fmb_system_read(in, NULL, &s, NULL) == FMB_OK);
    cr_expect(fmb_system_rows(s) == ROWS && fmb_system_dim(s) == 10);
    cr_expect(strcmp(fmb_system_label(s, ROWS - 1), "row 19999") == 0);
    fclose(in);
    fmb_system_free(s);
}

Test(formats, directory)
{
    fmb_system *s = NULL;
    fmb_where w = {.line = 7};
    FILE *in = fopen(".", "r");
    cr_assert(in);
    cr_expect(fmb_system_read(in, NULL, &s, &w) == FMB_ERR_IO && errno == EISDIR);
    cr_expect(!s && w.line == 7);
    fclose(in);
}

Test(formats, full_disk)
{
    fmb_system *s;
    FILE *out = fopen("/dev/full", "w");
    if (!out)
        cr_skip_test("no /dev/full here");
    cr_assert(fmb_system_new(3, NULL, &s) == FMB_OK);
    cr_expect(fmb_system_write(s, FMB_FORMAT_TEXT, out) == FMB_ERR_IO && errno == ENOSPC);
    fclose(out);
    fmb_system_free(s);
}

/* Reading a stream also survives every failing request. */
Test(formats, failing_stream)
{
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 0; st == FMB_ERR_MEMORY; k++) {
        countdown c = {.left = k};
        fmb_alloc mem = countdown_alloc(&c);
        char text[] = "cap: 2(x - \"y z\") <= 3/7 <= 1e30\nproject: x\n";
        fmb_system *s = NULL;
        FILE *in = fmemopen(text, sizeof text - 1, "r");
        st = fmb_system_read(in, &(fmb_reader){.size = sizeof(fmb_reader), .mem = &mem}, &s, NULL);
        fclose(in);
        fmb_system_free(s);
        cr_assert(c.live == 0);
    }
    cr_expect(st == FMB_OK);
}
