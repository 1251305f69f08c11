/* bad.c: the malformed files of tests/bad, each with the place and the text of its error; and texts
 * of a megabyte, malformed or not, that must not take long. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "parse.h"

#define LINE 1024

/* A line of expect.tsv. */
typedef struct entry {
    char path[LINE], format[16], piece[LINE];
    long line, column;
} entry;

static void run_on_entries(void check(const entry *e, fmb_format f, const char *text, size_t size))
{
    char line[LINE];
    size_t count = 0;
    FILE *list = fopen(TESTS_BAD "/expect.tsv", "r");
    cr_assert(list, "%s is missing", TESTS_BAD "/expect.tsv");
    while (fgets(line, sizeof line, list)) {
        entry e;
        char name[LINE / 2];
        if (*line == '#')
            continue;
        cr_assert(sscanf(line, "%511[^\t]\t%15[^\t]\t%ld\t%ld\t%1023[^\n]", name, e.format, &e.line,
                         &e.column, e.piece) == 5,
                  "not five columns: %s", line);
        snprintf(e.path, sizeof e.path, "%s/%s", TESTS_BAD, name);
        size_t size;
        char *text = slurp_file(e.path, &size);
        fmb_format f;
        cr_assert(text, "%s is missing", e.path);
        cr_assert(fmb_format_parse(e.format, &f), "%s: unknown format", e.path);
        check(&e, f, text, size);
        free(text);
        count++;
    }
    fclose(list);
    cr_expect(count >= 145);
}

static void check_complaint(const entry *e, fmb_format f, const char *text, size_t size)
{
    fmb_system *s = NULL;
    fmb_where w = {0};
    FILE *in = fopen(e->path, "rb");
    (void)text;
    (void)size;
    fmb_status st =
        fmb_system_read(in, &(fmb_reader){.size = sizeof(fmb_reader), .format = f}, &s, &w);
    fclose(in);
    cr_expect(st == FMB_ERR_PARSE && !s, "%s: %s", e->path, fmb_status_text(st));
    cr_expect(w.line == e->line && w.column == e->column && strstr(w.text, e->piece),
              "%s complains at %ld:%ld: %s\nnot at %ld:%ld: %s", e->path, w.line, w.column, w.text,
              e->line, e->column, e->piece);
    fmb_system_free(s);
}

Test(bad, complaints)
{
    run_on_entries(check_complaint);
}

/* Any reader must survive any text. */
static void check_other_formats(const entry *e, fmb_format f, const char *text, size_t size)
{
    (void)f;
    for (int g = FMB_FORMAT_AUTO; g <= FMB_FORMAT_LP; g++) {
        fmb_system *s = NULL;
        fmb_status st = fmb_system_parse(
            text, size, &(fmb_reader){.size = sizeof(fmb_reader), .format = (fmb_format)g}, &s,
            NULL);
        cr_expect(st == FMB_OK || st == FMB_ERR_PARSE || st == FMB_ERR_ARG, "%s as %s: %s", e->path,
                  fmb_format_text((fmb_format)g), fmb_status_text(st));
        fmb_system_free(s);
    }
}

Test(bad, other_formats)
{
    run_on_entries(check_other_formats);
}

static void check_failures(const entry *e, fmb_format f, const char *text, size_t size)
{
    (void)e;
    check_every_failure(f, text, size, FMB_ERR_PARSE);
}

Test(bad, failing_allocations)
{
    run_on_entries(check_failures);
}

/* ---- a megabyte ------------------------------------------------------------------------------ */

typedef struct heap {
    fmb_format format;
    const char *before, *unit,
        *after; /* unit is repeated up to a megabyte, less under sanitizers */
    fmb_status expected;
} heap;

static char *pile_up(const heap *h, size_t *size)
{
    size_t before = strlen(h->before), unit = strlen(h->unit), after = strlen(h->after);
    size_t n = ((size_t)1 << 20) / WATCHED / unit;
    char *text = malloc(before + n * unit + after);
    cr_assert(text);
    memcpy(text, h->before, before);
    for (size_t i = 0; i < n; i++)
        memcpy(text + before + i * unit, h->unit, unit);
    memcpy(text + before + n * unit, h->after, after);
    *size = before + n * unit + after;
    return text;
}

Test(bad, megabytes)
{
    static const heap heaps[] = {
        {FMB_FORMAT_TEXT, "x <= ", "7", "\n", FMB_OK},
        {FMB_FORMAT_TEXT, "x <= 0.", "125", "\n", FMB_OK},
        {FMB_FORMAT_TEXT, "x <= 1/", "3", "\n", FMB_OK},
        {FMB_FORMAT_TEXT, "x <= 1e", "9", "\n", FMB_ERR_PARSE},
        {FMB_FORMAT_TEXT, "", "name", " <= 1\n", FMB_OK},
        {FMB_FORMAT_TEXT, "", "label", ": x <= 1\n", FMB_OK},
        {FMB_FORMAT_TEXT, "", "l", ": x <= 1 <= 2 <= 3 <= 4\n", FMB_OK},
        {FMB_FORMAT_TEXT, "label: 0", " < 1", "\n", FMB_OK},
        {FMB_FORMAT_TEXT, "", "x + ", "x\n", FMB_ERR_PARSE},
        {FMB_FORMAT_TEXT, "", "x + ", "x <= 1\n", FMB_OK},
        {FMB_FORMAT_TEXT, "", "(", "x <= 1\n", FMB_ERR_PARSE},
        {FMB_FORMAT_TEXT, "", "-", "x <= 1\n", FMB_OK},
        {FMB_FORMAT_TEXT, "x", "*1", " <= 1\n", FMB_OK},
        {FMB_FORMAT_TEXT, "x", "*3", " <= 1\n", FMB_ERR_PARSE},
        {FMB_FORMAT_TEXT, "x", "*1e99999", " <= 1\n", FMB_ERR_PARSE},
        {FMB_FORMAT_TEXT, "1", " + 1e-99999 y", " <= 1\n", FMB_ERR_PARSE},
        {FMB_FORMAT_TEXT, "", "# comment\n", "x <= 1\n", FMB_OK},
        {FMB_FORMAT_TEXT, "", "\"", " <= 1\n", FMB_ERR_PARSE},
        {FMB_FORMAT_TEXT, "", "vars:\n", "", FMB_ERR_PARSE},
        {FMB_FORMAT_TEXT, "", "\xCE\xB1", " <= 1\n", FMB_OK},
        {FMB_FORMAT_INE, "", "title\n", "", FMB_ERR_PARSE},
        {FMB_FORMAT_INE, "linearity 99999999999", " 1", "\n", FMB_ERR_PARSE},
        {FMB_FORMAT_INE, "begin\n1 2 integer\n1 ", "8", "\nend\n", FMB_OK},
        {FMB_FORMAT_INE, "begin\n1 999999999999 integer\n", "1 ", "\nend\n", FMB_ERR_PARSE},
        {FMB_FORMAT_INE, "begin\n9999999999 3 integer\n", "1 1 1\n", "end\n", FMB_ERR_PARSE},
        {FMB_FORMAT_INE, "begin\n*** 3 integer\n", "1 1 1\n", "end\n", FMB_OK},
        {FMB_FORMAT_INE, "begin\n*** 3 real\n", "1e99999 ", "end\n", FMB_ERR_PARSE},
        {FMB_FORMAT_INE, "begin\n0 2 integer\nend\n", "option\n", "", FMB_OK},
        {FMB_FORMAT_IEQ, "DIM = 2\nINEQUALITIES_SECTION\n", "+1x1", "<= 1\nEND\n", FMB_OK},
        {FMB_FORMAT_IEQ, "DIM = 2\nINEQUALITIES_SECTION\n", "x1<=1\n", "END\n", FMB_OK},
        {FMB_FORMAT_IEQ, "DIM = 2\nINEQUALITIES_SECTION\nx", "1", " <= 1\nEND\n", FMB_ERR_PARSE},
        {FMB_FORMAT_IEQ, "DIM = 99999\nINEQUALITIES_SECTION\n", "x9<=1\n", "END\n", FMB_OK},
        {FMB_FORMAT_SMT2, "", "(", "", FMB_ERR_PARSE},
        {FMB_FORMAT_SMT2, "(assert (< 0 ", "(+ ", "", FMB_ERR_PARSE},
        {FMB_FORMAT_SMT2, "(assert ", "(let ((a 1)) ", "", FMB_ERR_PARSE},
        {FMB_FORMAT_SMT2, "(assert ", "(! ", "", FMB_ERR_PARSE},
        {FMB_FORMAT_SMT2, "(assert (not ", "(and true) ", "(< 1 0)))", FMB_ERR_PARSE},
        {FMB_FORMAT_SMT2, "(assert (< 0 ", "7", "))", FMB_OK},
        {FMB_FORMAT_SMT2, "(assert (< 0 0.", "7", "))", FMB_OK},
        {FMB_FORMAT_SMT2, "(assert (< 0 (+ 1", " (/ 1 7)", ")))", FMB_OK},
        {FMB_FORMAT_SMT2, "(declare-const x Real)(assert (< x (*", " 3", ")))", FMB_ERR_PARSE},
        {FMB_FORMAT_SMT2, "(declare-const |", "name", "| Real)", FMB_OK},
        {FMB_FORMAT_SMT2, "(set-info :source |", "name ", "", FMB_ERR_PARSE},
        {FMB_FORMAT_SMT2, "", "(check-sat)\n", "", FMB_ERR_PARSE},
        {FMB_FORMAT_SMT2, "", "; comment\n", "", FMB_ERR_PARSE},
    };
    for (size_t i = 0; i < sizeof heaps / sizeof *heaps; i++) {
        size_t size;
        char *text = pile_up(&heaps[i], &size);
        fmb_system *s = NULL;
        fmb_status st = fmb_system_parse(
            text, size, &(fmb_reader){.size = sizeof(fmb_reader), .format = heaps[i].format}, &s,
            NULL);
        cr_expect(st == heaps[i].expected, "%s %s...: %s", heaps[i].before, heaps[i].unit,
                  fmb_status_text(st));
        fmb_system_free(s);
        free(text);
    }
}
