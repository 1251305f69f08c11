/* build.c: systems and evidence from short texts, and back; see samples.h. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "samples.h"

static fmb_rel relation(const char *word)
{
    return strcmp(word, "<") == 0 ? FMB_LT : strcmp(word, "=") == 0 ? FMB_EQ : FMB_LE;
}

/* One line "1 -2 <= 3/4"; it is cut up. */
static void add_row(fmb_system *s, char *line)
{
    int dim = fmb_system_dim(s), var[8];
    mpq_t value[9];
    char *rest = NULL, *word = strtok_r(line, " ", &rest);
    fmb_rel rel = FMB_LE;
    for (int j = 0; j <= dim; j++) {
        var[j % 8] = j;
        mpq_init(value[j]);
        if (j == dim) {
            rel = relation(word);
            word = strtok_r(NULL, " ", &rest);
        }
        cr_assert_eq(mpq_set_str(value[j], word, 10), 0, "number %s", word);
        mpq_canonicalize(value[j]);
        word = strtok_r(NULL, " ", &rest);
    }
    cr_assert_eq(fmb_system_add_q(s, (size_t)dim, var, value, rel, value[dim]), FMB_OK);
    for (int j = 0; j <= dim; j++)
        mpq_clear(value[j]);
}

fmb_system *proof_system(const char *text, const fmb_alloc *mem)
{
    fmb_system *s = NULL;
    char copy[2048], *line_rest = NULL, *word_rest = NULL;
    cr_assert_lt(strlen(text), sizeof copy);
    strcpy(copy, text);
    char *line = strtok_r(copy, "\n", &line_rest);
    cr_assert_eq(fmb_system_new(0, mem, &s), FMB_OK);
    for (char *w = strtok_r(line, " ", &word_rest); w; w = strtok_r(NULL, " ", &word_rest))
        cr_assert_eq(fmb_system_add_variable(s, w, NULL), FMB_OK);
    while ((line = strtok_r(NULL, "\n", &line_rest)))
        add_row(s, line);
    return s;
}

fmb_status proof_parse(const fmb_system *s, const char *text, fmb_evidence **out, fmb_where *where)
{
    FILE *in = fmemopen((void *)(uintptr_t)text, strlen(text), "r");
    cr_assert_not_null(in);
    fmb_status st = fmb_evidence_read(in, s, out, where);
    fclose(in);
    return st;
}

fmb_evidence *proof_claims(const fmb_system *s, const char *claims)
{
    fmb_evidence *e = NULL;
    fmb_where where = {0};
    char text[4096];
    size_t count = 0;
    for (const char *at = claims; (at = strstr(at, "claim ")); at++)
        count++;
    int n = snprintf(text, sizeof text, "fmb-proof 5\nsystem %zu rows %d variables\n%sclaims %zu\n",
                     fmb_system_rows(s), fmb_system_dim(s), claims, count);
    cr_assert_lt((size_t)n, sizeof text);
    fmb_status st = proof_parse(s, text, &e, &where);
    cr_assert_eq(st, FMB_OK, "%s\n%ld:%ld: %s", text, where.line, where.column, where.text);
    return e;
}

char *proof_text(const fmb_system *s, const fmb_evidence *e)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    cr_assert_not_null(out);
    cr_assert_eq(fmb_evidence_write(e, s, out), FMB_OK);
    fclose(out);
    return text;
}

fmb_evidence *proof_copy(const fmb_system *s, const fmb_evidence *e)
{
    fmb_evidence *copy = NULL;
    char *text = proof_text(s, e);
    cr_assert_eq(proof_parse(s, text, &copy, NULL), FMB_OK);
    free(text);
    return copy;
}
