/* fuzz_proof.c: the reader of proofs on any bytes, and the judge on whatever it lets through.
 *
 * The text is a system in .fmb form and, from the first line that begins with "fmb-proof", a proof
 * about it. A proof that can be read is judged like the naive judge does, proves no verdict that
 * the ground truth denies, and comes back the same from what is written of it.
 */
#include "round.h"
#include "study/textbook/exact.h"
#include "unit/proof/naive.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_VARIABLES = 5, MOST_ROWS = 9, TRUTH_ROWS = 500, MOST_OF_WHOLE = 14 };

static void demand(bool ok)
{
    if (!ok)
        abort();
}

static void judge(const fmb_system *s, const fmb_evidence *e)
{
    fmb_judgement j = {.size = sizeof j};
    fmb_verdict truth;
    demand(fmb_check(s, e, &j) == FMB_OK);
    demand(j.claim == naive_first_failing(s, e));
    demand(j.accepted == (e->claims > 0 && j.claim == SIZE_MAX));
    demand(study_textbook_solve(s, TRUTH_ROWS, &truth) == FMB_OK);
    demand(j.verdict == FMB_UNKNOWN || truth == FMB_UNKNOWN || j.verdict == truth);
}

/* The naive judge tries all choices of rows and corners of a projection. */
static bool is_small(const fmb_evidence *e)
{
    int corners = 0, rows = 0;
    for (size_t i = 0; i < e->claims; i++) {
        corners += e->claim[i].kind == FMB_CLAIM_CORNER;
        rows += e->claim[i].kind == FMB_CLAIM_IMPLIED;
    }
    return corners <= MOST_OF_WHOLE && rows <= MOST_OF_WHOLE;
}

static char *written(const fmb_system *s, const fmb_evidence *e)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    demand(out && fmb_evidence_write(e, s, out) == FMB_OK && fclose(out) == 0);
    return text;
}

/* NULL if the text is malformed. */
static fmb_evidence *parsed(const fmb_system *s, const char *text, size_t size)
{
    fmb_evidence *e = NULL;
    fmb_where where = {.line = -1};
    fmb_status st = fmb_evidence_parse(text, size, s, &e, &where);
    demand(st == FMB_OK ? e && where.line == -1 : st == FMB_ERR_PARSE && !e && where.line > 0);
    return e;
}

static void read_proof(const fmb_system *s, const char *text, size_t size)
{
    fmb_evidence *e = parsed(s, text, size);
    if (!e)
        return;
    if (is_small(e))
        judge(s, e);
    char *once = written(s, e);
    fmb_evidence *back = parsed(s, once, strlen(once));
    demand(back != NULL);
    char *twice = written(s, back);
    demand(strcmp(once, twice) == 0);
    free(once);
    free(twice);
    fmb_evidence_free(back);
    fmb_evidence_free(e);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char border[] = "\nfmb-proof";
    const char *text = (const char *)data, *end = memmem(data, size, border, sizeof border - 1);
    fmb_system *s;
    if (!end)
        return 0;
    size_t length = (size_t)(end - text) + 1;
    fmb_reader how = {.size = sizeof how, .format = FMB_FORMAT_TEXT};
    if (fmb_system_parse(text, length, &how, &s, NULL) != FMB_OK)
        return 0;
    if (fmb_system_dim(s) <= MOST_VARIABLES && fmb_system_rows(s) <= MOST_ROWS)
        read_proof(s, text + length, size - length);
    fmb_system_free(s);
    return 0;
}
