/* formats.c: names of formats, guessing, streams, and what each writer refuses. */
#include <criterion/criterion.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

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

Test(formats, arguments)
{
    fmb_system *s = NULL;
    cr_assert(fmb_system_parse(NULL, 0, NULL, &s, NULL) == FMB_OK);
    cr_expect(fmb_system_dim(s) == 0 && fmb_system_rows(s) == 0);
    cr_expect(fmb_system_write(s, FMB_FORMAT_IEQ, stdout) == FMB_ERR_ARG);
    cr_expect(fmb_system_write(s, FMB_FORMAT_AUTO, stdout) == FMB_ERR_ARG);
    cr_expect(fmb_system_write(s, (fmb_format)99, stdout) == FMB_ERR_ARG);
    cr_expect(fmb_system_write(NULL, FMB_FORMAT_INE, stdout) == FMB_ERR_ARG);
    fmb_system *kept = s;
    cr_expect(fmb_system_parse(NULL, 1, NULL, &s, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_system_parse("", 0, NULL, NULL, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_system_read(NULL, NULL, &s, NULL) == FMB_ERR_ARG);
    cr_expect(fmb_system_parse("", 0, &(fmb_reader){.format = (fmb_format)99}, &s, NULL) ==
              FMB_ERR_ARG);
    cr_expect(fmb_system_parse("x", 1, NULL, &s, NULL) == FMB_ERR_PARSE);
    cr_expect(s == kept);
    fmb_system_free(s);
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
        st = fmb_system_read(in, &(fmb_reader){.mem = &mem}, &s, NULL);
        fclose(in);
        fmb_system_free(s);
        cr_assert(c.live == 0);
    }
    cr_expect(st == FMB_OK);
}
