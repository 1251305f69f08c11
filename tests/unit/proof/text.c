/* text.c: the text form of evidence: round trips, and the places of errors. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "proof/evidence/form.h"
#include "samples.h"

/* ---- round trips ----------------------------------------------------------------------------- */

static void round_trip(const fmb_system *s, const fmb_evidence *e)
{
    fmb_evidence *back = NULL;
    fmb_where where = {0};
    char *text = proof_text(s, e);
    fmb_status st = proof_parse(s, text, &back, &where);
    cr_assert_eq(st, FMB_OK, "%s\n%ld:%ld: %s", text, where.line, where.column, where.text);
    char *again = proof_text(s, back);
    cr_expect_str_eq(again, text);
    free(text);
    free(again);
    fmb_evidence_free(back);
}

Test(text, round_trips)
{
    for (size_t i = 0; i < proof_samples_count; i++) {
        fmb_system *s = proof_system(proof_samples[i].system, NULL);
        fmb_evidence *e = proof_claims(s, proof_samples[i].claims);
        round_trip(s, e);
        fmb_evidence_free(e);
        fmb_system_free(s);
    }
}

/* Any name that a system can have comes back. */
Test(text, odd_names)
{
    static const char *const name[] = {
        "end",           "#",        "a b", "say \"x\"", "back\\slash", "tab\tnewline\n", "\x7f",
        "z\xc3\xa4hler", "\xff\xfe", "1/2", "row",       "<="};
    int dim = (int)(sizeof name / sizeof *name);
    fmb_system *s = NULL;
    fmb_evidence *e = NULL;
    fmb_claim *c = NULL;
    cr_assert_eq(fmb_system_new(dim, NULL, &s), FMB_OK);
    cr_assert_eq(fmb_evidence_new(dim, 0, NULL, &e), FMB_OK);
    cr_assert_eq(fmb_evidence_claim(e, FMB_CLAIM_FEASIBLE, &c), FMB_OK);
    mpq_t q;
    mpq_init(q);
    for (int j = 0; j < dim; j++) {
        cr_assert_eq(fmb_system_set_name(s, j, name[j]), FMB_OK);
        mpq_set_si(q, j - 5, 7);
        mpq_canonicalize(q);
        cr_assert_eq(fmb_evidence_push(e, &c->point, (size_t)j, q), FMB_OK);
    }
    mpq_clear(q);
    round_trip(s, e);
    fmb_evidence_free(e);
    fmb_system_free(s);
}

/* A bound of a variable that is called like a relation is not one of a form. */
Test(text, variables_called_like_relations)
{
    fmb_system *s = proof_system("<= >\n1 1 <= 1\n-1 0 <= 0", NULL);
    fmb_evidence *e =
        proof_claims(s, "claim bound upper <= <= 5/2\nend\nclaim bound lower > > 3\nend\n"
                        "claim bound upper \"<=\" < 1\nend\nclaim unbounded upper <=\nend\n"
                        "claim bound upper <= 7\nterm <= 1\nend\nclaim unbounded lower\nend\n");
    static const int var[] = {0, 1, 0, 0, -1, -1};
    for (size_t i = 0; i < sizeof var / sizeof *var; i++)
        cr_expect_eq(fmb_evidence_var(e, i), var[i], "claim %zu: %d", i, fmb_evidence_var(e, i));
    cr_expect_eq(fmb_evidence_rel(e, 2), FMB_LT);
    cr_expect_eq(fmb_evidence_terms(e, 4), 1);
    round_trip(s, e);
    fmb_evidence_free(e);
    fmb_system_free(s);
}

Test(text, comments_and_blanks)
{
    fmb_system *s = proof_system("x\n1 <= 1\n-1 <= 0", NULL);
    fmb_evidence *e = NULL;
    fmb_where where = {0};
    fmb_status st = proof_parse(
        s,
        "# a proof\r\n\n \t fmb-proof   2 # version\r\nsystem 2 rows 1 "
        "variables\n#claim\nclaim feasible\n\tpoint \"x\" 3/6\nend\n claims  1 # in all",
        &e, &where);
    cr_assert_eq(st, FMB_OK, "%ld:%ld: %s", where.line, where.column, where.text);
    cr_expect_eq(fmb_evidence_coordinate(e, 0, 0), 0.5);
    fmb_evidence_free(e);
    fmb_system_free(s);
}

/* ---- malformed text -------------------------------------------------------------------------- */

/* All about the system "x y" with 2 rows; the position and a part of what was expected. */
static const struct malformed {
    const char *text;
    long line, column;
    const char *expected;
} MALFORMED[] = {
#define HEADER "fmb-proof 2\nsystem 2 rows 2 variables\n"
    {"", 1, 1, "'fmb-proof'"},
    {"# nothing\n\n", 3, 1, "'fmb-proof'"},
    {"claim feasible\n", 1, 1, "'fmb-proof'"},
    {"fmb-proof 1\n", 1, 11, "'3' or '2'"},
    {"fmb-proof 2 1\n", 1, 13, "end of the line"},
    {"fmb-proof 2", 1, 12, "'system'"},
    {"fmb-proof 2\nclaim\n", 2, 1, "'system'"},
    {"fmb-proof 2\nsystem 3 rows 2 variables\n", 2, 8, "'system 2 rows 2 variables'"},
    {"fmb-proof 2\nsystem 2 rows 999999999999 variables\n", 2, 15, "'system 2 rows 2 variables'"},
    {"fmb-proof 2\nsystem 2 rows 2\n", 2, 16, "'system 2 rows 2 variables'"},
    {"fmb-proof 2\nsystem 2 rows 2 variables claim\n", 2, 27, "end of the line"},
    {HEADER "point x 1\n", 3, 1, "'claim' or, at the end, 'claims 0'"},
    {HEADER "", 3, 1, "'claim' or, at the end, 'claims 0'"},
    {HEADER "claims 1\n", 3, 8, "'claims 0', as there are"},
    {HEADER "claims\n", 3, 7, "'claims 0', as there are"},
    {HEADER "claims 0 0\n", 3, 10, "end of the line"},
    {HEADER "claim infeasible\nend\n", 5, 1, "'claim' or, at the end, 'claims 1'"},
    {HEADER "claim infeasible\nend\nclaims 2\n", 5, 8, "'claims 1', as there are"},
    {HEADER "claim infeasible\nend\nclaims 1\nclaim\n", 6, 1, "the end of the text"},
    {HEADER "claim\n", 3, 6, "a kind of claim"},
    {HEADER "claim true\n", 3, 7, "a kind of claim"},
    {HEADER "claim \"feasible\"\n", 3, 7, "a kind of claim"},
    {HEADER "claim feasible now\n", 3, 16, "end of the line"},
    {HEADER "claim feasible\n", 4, 1, "'point' or 'end'"},
    {HEADER "claim feasible\npoint x 1\n", 5, 1, "'point' or 'end'"},
    {HEADER "claim feasible\npoint x 1\npoint x 1\nend\n", 5, 7, "each variable at most once"},
    {HEADER "claim feasible\npoint z 1\n", 4, 7, "name of a variable"},
    {HEADER "claim feasible\npoint 1\n", 4, 7, "name of a variable"},
    {HEADER "claim feasible\npoint\n", 4, 6, "name of a variable"},
    {HEADER "claim feasible\nrow 1 1\n", 4, 1, "'point' or 'end'"},
    {HEADER "claim feasible\npoint x\n", 4, 8, "exact number"},
    {HEADER "claim feasible\npoint x 1.5\n", 4, 9, "exact number"},
    {HEADER "claim feasible\npoint x 1e9\n", 4, 9, "exact number"},
    {HEADER "claim feasible\npoint x 1e999999999\n", 4, 9, "exact number"},
    {HEADER "claim feasible\npoint x +1\n", 4, 9, "exact number"},
    {HEADER "claim feasible\npoint x --1\n", 4, 9, "exact number"},
    {HEADER "claim feasible\npoint x 1/-2\n", 4, 9, "exact number"},
    {HEADER "claim feasible\npoint x 1/\n", 4, 9, "exact number"},
    {HEADER "claim feasible\npoint x 1/2/3\n", 4, 9, "exact number"},
    {HEADER "claim feasible\npoint x 0x10\n", 4, 9, "exact number"},
    {HEADER "claim feasible\npoint x 1/0\n", 4, 9, "not zero"},
    {HEADER "claim feasible\npoint x \"1\"\n", 4, 9, "exact number"},
    {HEADER "claim feasible\npoint x nan\n", 4, 9, "exact number"},
    {HEADER "claim feasible\npoint x 1 2\n", 4, 11, "end of the line"},
    {HEADER "claim feasible\npoint x 1\npoint y 2\nend end\n", 6, 5, "end of the line"},
    {HEADER "claim feasible\npoint x 1\npoint y 2\nend\nend\n", 7, 1, "'claim' or, at the end"},
    {HEADER "claim feasible\npoint x 1\npoint y 2\nclaim feasible\n", 6, 1, "'point' or 'end'"},
    {HEADER "claim infeasible\nrow 0 1\n", 4, 5, "a row from 1 to 2"},
    {HEADER "claim infeasible\nrow 3 1\n", 4, 5, "a row from 1 to 2"},
    {HEADER "claim infeasible\nrow -1 1\n", 4, 5, "a row from 1 to 2"},
    {HEADER "claim infeasible\nrow 18446744073709551617 1\n", 4, 5, "a row from 1 to 2"},
    {HEADER "claim infeasible\nrow x 1\n", 4, 5, "a row from 1 to 2"},
    {HEADER "claim infeasible\nrow 1 1\nrow 1 0\n", 5, 5, "each row at most once"},
    {HEADER "claim infeasible\nreverse 1 1\n", 4, 1, "'row' or 'end'"},
    {HEADER "claim bound\n", 3, 12, "'lower' or 'upper'"},
    {HEADER "claim bound middle x <= 1\n", 3, 13, "'lower' or 'upper'"},
    {HEADER "claim bound upper z <= 1\n", 3, 19, "name of a variable"},
    {HEADER "claim bound upper x >= 1\n", 3, 21, "'<=' or '<'"},
    {HEADER "claim bound lower x < 1\n", 3, 21, "'>=' or '>'"},
    {HEADER "claim bound upper x = 1\n", 3, 21, "'<=' or '<'"},
    {HEADER "claim bound upper x <= inf\n", 3, 24, "exact number"},
    {HEADER "claim bound upper x <= 1\nray x 1\n", 4, 1, "'point', 'row' or 'end'"},
    {HEADER "claim bound upper\n", 3, 18, "name of a variable"},
    {HEADER "claim bound upper <= <= 1\n", 3, 22, "a number"},
    {HEADER "claim bound upper < x\n", 3, 21, "exact number"},
    {HEADER "claim bound upper <= 1 2\n", 3, 24, "end of the line"},
    {HEADER "claim bound upper x <= 1\nterm x 1\n", 4, 1, "'point', 'row' or 'end'"},
    {HEADER "claim bound lower >= 1\nray x 1\n", 4, 1, "'point', 'term', 'row' or 'end'"},
    {HEADER "claim bound lower >= 1\nterm x 1\nterm x 1\n", 5, 6, "each variable at most once"},
    {HEADER "claim unbounded upper x <= 1\n", 3, 25, "end of the line"},
    {HEADER "claim unbounded upper x\nterm x 1\n", 4, 1, "'ray' or 'end'"},
    {HEADER "claim unbounded upper <=\n", 3, 23, "name of a variable"},
    {HEADER "claim implied\n", 3, 14, "'<=', '<' or '='"},
    {HEADER "claim implied >= 1\n", 3, 15, "'<=', '<' or '='"},
    {HEADER "claim implied <= 1\nterm x 1\nterm x 2\n", 5, 6, "each variable at most once"},
    {HEADER "claim implied = 1\nreverse 1 1\nreverse 1 1\n", 5, 9, "each row at most once"},
    {HEADER "claim redundant\n", 3, 16, "a row from 1 to 2"},
    {HEADER "claim redundant 3\n", 3, 17, "a row from 1 to 2"},
    {HEADER "claim equality 1\npoint x 1\n", 4, 1, "'row' or 'end'"},
    {HEADER "claim feasible\npoint \"x 1\n", 4, 11, "a closing '\"'"},
    {HEADER "claim feasible\npoint \"\" 1\n", 4, 7, "a name that is not empty"},
    {HEADER "claim feasible\npoint \"x\"1\n", 4, 10, "a blank"},
    {HEADER "claim feasible\npoint x#1\n", 4, 8, "a blank"},
    {HEADER "claim feasible\npoint \\x 1\n", 4, 7, "a word"},
    {HEADER "claim feasible\npoint \"\\n\" 1\n", 4, 9, "after a backslash"},
    {HEADER "claim feasible\npoint \"\\x7\" 1\n", 4, 11, "two digits 0-9a-f"},
    {HEADER "claim feasible\npoint \"\\x00\" 1\n", 4, 7, "without NUL"},
    {HEADER "claim feasible\n\x01\n", 4, 1, "a word"},
#undef HEADER
};

Test(text, malformed)
{
    fmb_system *s = proof_system("x y\n1 1 <= 1\n-1 0 <= 0", NULL);
    for (size_t i = 0; i < sizeof MALFORMED / sizeof *MALFORMED; i++) {
        const struct malformed *m = &MALFORMED[i];
        fmb_evidence *const mark = (fmb_evidence *)s, *e = mark;
        fmb_where where = {0};
        fmb_status st = proof_parse(s, m->text, &e, &where);
        cr_expect_eq(st, FMB_ERR_PARSE, "%s: %s", m->text, fmb_status_text(st));
        cr_expect(where.line == m->line && where.column == m->column, "%s: %ld:%ld: %s", m->text,
                  where.line, where.column, where.text);
        cr_expect_not_null(strstr(where.text, m->expected), "%s: %s", m->text, where.text);
        cr_expect_eq(strncmp(where.text, "expected ", 9), 0);
        cr_expect_eq(e, mark);
        cr_expect_eq(proof_parse(s, m->text, &e, NULL), FMB_ERR_PARSE);
    }
    fmb_system_free(s);
}

/* NUL bytes and words without end. */
static fmb_status parse_bytes(const fmb_system *s, const char *text, size_t size, fmb_where *where)
{
    fmb_evidence *e = NULL;
    FILE *in = fmemopen((void *)(uintptr_t)text, size, "r");
    cr_assert_not_null(in);
    fmb_status st = fmb_evidence_read(in, s, &e, where);
    fclose(in);
    fmb_evidence_free(e);
    return st;
}

Test(text, nul_byte)
{
    static const char text[] = "fmb-proof 2\nsystem 1 rows 1 variables\nclaim\0feasible\n";
    fmb_system *s = proof_system("x\n1 <= 1", NULL);
    fmb_where where = {0};
    cr_expect_eq(parse_bytes(s, text, sizeof text - 1, &where), FMB_ERR_PARSE);
    cr_expect(where.line == 3 && where.column == 6, "%ld:%ld", where.line, where.column);
    fmb_system_free(s);
}

Test(text, endless_words)
{
    static const char *const head[] = {
        "", "# ", "fmb-proof 2\nsystem 1 rows 1 variables\nclaim feasible\npoint x ",
        "fmb-proof 2\nsystem 1 rows 1 variables\nclaim feasible\npoint \""};
    size_t size = 8 * FMB_PROOF_WORD_MAX;
    char *text = malloc(size);
    fmb_system *s = proof_system("x\n1 <= 1", NULL);
    cr_assert_not_null(text);
    for (size_t i = 0; i < sizeof head / sizeof *head; i++) {
        fmb_where where = {0};
        memset(text, '7', size);
        memcpy(text, head[i], strlen(head[i]));
        cr_expect_eq(parse_bytes(s, text, size, &where), FMB_ERR_PARSE);
        const char *expected = i == 1 ? "'fmb-proof'" : "a word of at most 1048576 bytes";
        cr_expect_not_null(strstr(where.text, expected), "%s", where.text);
    }
    free(text);
    fmb_system_free(s);
}

/* The longest number that may be written can be read back; a longer one is not written. */
Test(text, long_numbers)
{
    fmb_system *s = proof_system("x\n1 <= 1", NULL);
    fmb_evidence *e = proof_claims(s, "claim feasible\npoint x 1\nend\n");
    mpz_ui_pow_ui(mpq_numref(e->claim[0].point.value[0]), 10, 500000);
    round_trip(s, e);
    mpz_ui_pow_ui(mpq_numref(e->claim[0].point.value[0]), 10, 2000000);
    FILE *out = tmpfile();
    cr_assert_not_null(out);
    cr_expect_eq(fmb_evidence_write(e, s, out), FMB_ERR_RANGE);
    fclose(out);
    fmb_evidence_free(e);
    fmb_system_free(s);
}

/* ---- streams that fail ----------------------------------------------------------------------- */

Test(text, failing_streams)
{
    fmb_system *s = proof_system("x\n1 <= 1", NULL);
    fmb_evidence *e = proof_claims(s, "claim feasible\npoint x 0\nend\n"), *none = NULL;
    FILE *directory = fopen("/", "r"), *full = fopen("/dev/full", "w");
    cr_assert_not_null(directory);
    cr_expect_eq(fmb_evidence_read(directory, s, &none, NULL), FMB_ERR_IO);
    cr_expect_null(none);
    if (full) {
        setvbuf(full, NULL, _IONBF, 0);
        cr_expect_eq(fmb_evidence_write(e, s, full), FMB_ERR_IO);
        fclose(full);
    }
    fclose(directory);
    fmb_evidence_free(e);
    fmb_system_free(s);
}
