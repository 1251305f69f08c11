/* cases.c: the collected .ine and .ieq files have the variables, rows and linearities of
 * answers.json; the rows of the transcribed cases are .fmb rows. */
#include <criterion/criterion.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "parse.h"

static size_t equalities(const fmb_system *s)
{
    size_t n = 0;
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        n += fmb_system_rel(s, i) == FMB_EQ;
    return n;
}

static size_t number(const json_t *said, const char *key)
{
    return (size_t)json_integer_value(json_object_get(said, key));
}

/* The marks are those of keep_1based, where the answer comes from the file itself. */
static void check_marks(const char *path, const fmb_system *s, const json_t *keep)
{
    size_t i;
    const json_t *v;
    for (int j = 0; j < fmb_system_dim(s); j++) {
        bool kept = false;
        json_array_foreach(keep, i, v) kept = kept || json_integer_value(v) == j + 1;
        cr_expect(fmb_system_is_kept(s, j) == kept, "%s: variable %d", path, j + 1);
    }
}

static void check_file(const char *path, const json_t *said)
{
    size_t size;
    char *text = slurp_file(path, &size);
    cr_assert(text, "%s is missing", path);
    fmb_format f = fmb_format_of_name(path);
    fmb_system *s = parse(f, text, size), *guessed = parse(FMB_FORMAT_AUTO, text, size);
    cr_expect(same_system(s, guessed, true), "%s is taken for another format", path);
    cr_expect((size_t)fmb_system_dim(s) == number(said, "n"), "%s has %d variables", path,
              fmb_system_dim(s));
    cr_expect(fmb_system_rows(s) == number(said, "m"), "%s has %zu rows", path, fmb_system_rows(s));
    const char *key = json_object_get(said, "linearity") ? "linearity" : "equalities";
    if (json_object_get(said, key))
        cr_expect(equalities(s) == number(said, key), "%s has %zu equalities", path, equalities(s));
    const json_t *projection = json_object_get(said, "projection");
    const json_t *keep = json_object_get(projection, "keep_1based");
    if (keep)
        check_marks(path, s, keep);
    fmb_system_free(guessed);
    fmb_system_free(s);
    free(text);
}

/* Every file that family/answers.json names; the number of files. */
static size_t check_family(const char *family, const char *prefix, const char *ending)
{
    char path[1024];
    const char *key;
    json_t *said;
    snprintf(path, sizeof path, CASES "/%s/answers.json", family);
    json_t *answers = json_load_file(path, 0, NULL);
    if (!answers)
        cr_skip_test("no collected cases here");
    size_t n = json_object_size(answers);
    json_object_foreach(answers, key, said)
    {
        snprintf(path, sizeof path, CASES "/%s%s%s", prefix, key, ending);
        check_file(path, said);
    }
    json_decref(answers);
    return n;
}

Test(cases, cdd)
{
    cr_expect(check_family("cdd", "", "") >= 110);
}

Test(cases, fm)
{
    cr_expect(check_family("fm", "fm/", ".ine") >= 125);
}

/* "vars: ..." and the indented lines below "system:" of a wrapped case are a .fmb text; the number
 * of these lines in *rows. */
static char *unwrap(const char *text, size_t *rows)
{
    char *out = NULL;
    size_t size;
    FILE *f = open_memstream(&out, &size);
    bool inside = false;
    *rows = 0;
    for (const char *line = text; *line;) {
        size_t n = strcspn(line, "\n");
        bool row = inside && line[0] == ' ';
        if (row || strncmp(line, "vars:", 5) == 0)
            fprintf(f, "%.*s\n", (int)n, line);
        *rows += row;
        inside = row || strncmp(line, "system:", 7) == 0;
        line += n + (line[n] == '\n');
    }
    fclose(f);
    return out;
}

static void fail_with_warning(void *path, const fmb_where *where)
{
    cr_expect(false, "%s:%ld: %s", (const char *)path, where->line, where->text);
}

/* Names that nobody declared are no slips. */
static void expect_no_warning(char *path, const char *text)
{
    fmb_system *s = NULL;
    fmb_reader how = {
        .size = sizeof how, .format = FMB_FORMAT_TEXT, .warn = fail_with_warning, .self = path};
    const char *rows = text + (strncmp(text, "vars:", 5) == 0 ? strcspn(text, "\n") : 0);
    cr_expect(fmb_system_parse(rows, strlen(rows), &how, &s, NULL) == FMB_OK);
    fmb_system_free(s);
}

Test(cases, proj)
{
    const char *key;
    json_t *said, *answers = json_load_file(CASES "/proj/answers.json", 0, NULL);
    if (!answers)
        cr_skip_test("no collected cases here");
    json_object_foreach(answers, key, said)
    {
        char path[1024];
        size_t size, rows;
        snprintf(path, sizeof path, CASES "/%s", key);
        char *wrapped = slurp_file(path, &size);
        cr_assert(wrapped, "%s is missing", path);
        char *text = unwrap(wrapped, &rows);
        fmb_system *s = parse(FMB_FORMAT_TEXT, text, strlen(text));
        cr_expect(rows > 0 && fmb_system_rows(s) == rows, "%s has %zu rows", path,
                  fmb_system_rows(s));
        cr_expect((size_t)fmb_system_dim(s) == json_array_size(json_object_get(said, "vars")));
        expect_no_warning(path, text);
        fmb_system_free(s);
        free(text);
        free(wrapped);
    }
    json_decref(answers);
}
