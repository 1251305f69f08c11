/* smt2_cases.c: of the collected SMT-LIB files, those that answers.json calls conjunctions are
 * read, with its variables and rows, and written and read again; the others are refused.
 */
#include <criterion/criterion.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "parse.h"

static void check_conjunction(const char *key, const char *text, size_t size, const json_t *said)
{
    fmb_system *s = parse(FMB_FORMAT_AUTO, text, size);
    cr_expect(fmb_system_dim(s) == json_integer_value(json_object_get(said, "n")),
              "%s has %d variables", key, fmb_system_dim(s));
    cr_expect((json_int_t)fmb_system_rows(s) == json_integer_value(json_object_get(said, "m")),
              "%s has %zu rows", key, fmb_system_rows(s));
    char *again = write_text(s, FMB_FORMAT_SMT2);
    fmb_system *back = parse(FMB_FORMAT_SMT2, again, strlen(again));
    cr_expect(same_system(s, back, false), "%s comes back otherwise", key);
    free(again);
    fmb_system_free(back);
    fmb_system_free(s);
}

static void check_refusal(const char *key, const char *text, size_t size)
{
    fmb_system *s = NULL;
    fmb_where w = {0};
    fmb_status st = fmb_system_parse(text, size, NULL, &s, &w);
    cr_expect(st == FMB_ERR_PARSE && strncmp(w.text, "not a conjunction", 17) == 0 && w.line > 0,
              "%s: %s", key, w.text);
    fmb_system_free(s);
}

Test(smt2_cases, all)
{
    const char *key;
    json_t *said;
    json_t *answers = json_load_file(CASES "/smt/answers.json", 0, NULL);
    size_t conjunctions = 0;
    if (!answers)
        cr_skip_test("no collected cases here");
    json_object_foreach(answers, key, said)
    {
        char path[1024];
        size_t size;
        snprintf(path, sizeof path, CASES "/%s", key);
        char *text = slurp_file(path, &size);
        cr_assert(text, "%s is missing", path);
        bool pure = json_is_true(json_object_get(said, "pure_conjunction"));
        conjunctions += pure;
        if (pure)
            check_conjunction(key, text, size, said);
        else
            check_refusal(key, text, size);
        free(text);
    }
    cr_expect(conjunctions >= 259 && json_object_size(answers) >= 335);
    json_decref(answers);
}
