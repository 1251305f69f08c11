/* verdict.c: see verdict.h. */
#include "fmb/verdict.h"

#include <stdlib.h>

#include "common/message.h"
#include "common/table.h"
#include "fmb/show.h"

size_t app_verdict_claim(const app_session *s, fmb_claim_kind kind)
{
    for (size_t i = 0; s->evidence && i < fmb_evidence_claims(s->evidence); i++)
        if (fmb_evidence_kind(s->evidence, i) == kind)
            return i;
    return SIZE_MAX;
}

/* ---- text ------------------------------------------------------------------------------------ */

static void print_point(const app_session *s, size_t claim)
{
    app_table table = {.columns = 3, .align = "lll"};
    mpq_t q;
    mpq_init(q);
    for (int j = 0; j < fmb_system_dim(s->system); j++) {
        fmb_evidence_coordinate_q(s->evidence, claim, j, q);
        app_put_name(&table.text, s->system, j);
        app_table_end_cell(&table);
        app_table_put(&table, "=");
        app_put_number(&table.text, q, s->ask->digits);
        app_table_end_cell(&table);
    }
    mpq_clear(q);
    app_table_print(&table, stdout);
}

void app_verdict_print_multipliers(const app_session *s, size_t claim, mpq_t sum, bool *strict)
{
    app_table table = {.columns = 4, .align = "rlll"};
    mpq_t q, b;
    mpq_inits(q, b, NULL);
    mpq_set_ui(sum, 0, 1);
    *strict = false;
    for (size_t i = fmb_evidence_next_row(s->evidence, claim, 0); i != SIZE_MAX;
         i = fmb_evidence_next_row(s->evidence, claim, i + 1)) {
        fmb_evidence_multiplier_q(s->evidence, claim, i, q);
        app_put_number(&table.text, q, s->ask->digits);
        app_table_end_cell(&table);
        app_table_put(&table, "*");
        app_put_row_name(&table.text, s->system, i);
        app_table_end_cell(&table);
        app_put_row(&table.text, s->system, i, s->ask->digits);
        app_table_end_cell(&table);
        *strict |= fmb_system_rel(s->system, i) == FMB_LT;
        fmb_system_rhs_q(s->system, i, b);
        mpq_mul(b, b, q);
        mpq_add(sum, sum, b);
    }
    app_table_print(&table, stdout);
    mpq_clears(q, b, NULL);
}

/* No variable is left, so only the right sides matter. */
static void print_conflict(const app_session *s, size_t claim)
{
    bool strict;
    mpq_t sum;
    mpq_init(sum);
    app_verdict_print_multipliers(s, claim, sum, &strict);
    char *text = app_number(sum, s->ask->digits, APP_NEAREST);
    printf("sum: 0 %s %s\n", strict ? "<" : "<=", text);
    free(text);
    mpq_clear(sum);
}

void app_verdict_print(const app_session *s)
{
    const fmb_result *res = &s->result;
    fputs(fmb_verdict_text(res->verdict), stdout);
    if (res->verdict == FMB_FEASIBLE && s->relaxed)
        fputs(" over the reals", stdout);
    if (res->verdict == FMB_UNKNOWN)
        printf(" (%s)", fmb_stop_text(res->stop));
    putchar('\n');
    size_t point = app_verdict_claim(s, FMB_CLAIM_FEASIBLE);
    size_t conflict = app_verdict_claim(s, FMB_CLAIM_INFEASIBLE);
    if (res->verdict == FMB_FEASIBLE && point != SIZE_MAX)
        print_point(s, point);
    if (res->verdict == FMB_INFEASIBLE && conflict != SIZE_MAX)
        print_conflict(s, conflict);
}

/* ---- JSON ------------------------------------------------------------------------------------ */

json_t *app_json_multipliers(const app_session *s, size_t claim)
{
    json_t *list = app_need(json_array());
    mpq_t q;
    mpq_init(q);
    for (size_t i = fmb_evidence_next_row(s->evidence, claim, 0); i != SIZE_MAX;
         i = fmb_evidence_next_row(s->evidence, claim, i + 1)) {
        fmb_evidence_multiplier_q(s->evidence, claim, i, q);
        json_t *item = app_json_row_name(s->system, i);
        app_json_set(item, "multiplier", app_json_number(q, s->ask->digits, APP_NEAREST));
        app_json_append(list, item);
    }
    mpq_clear(q);
    return list;
}

json_t *app_verdict_json(const app_session *s)
{
    json_t *obj = app_need(json_object());
    app_json_set(obj, "verdict", json_string(fmb_verdict_text(s->result.verdict)));
    if (s->relaxed && s->result.verdict == FMB_FEASIBLE)
        app_json_set(obj, "relaxed", json_true());
    app_json_set(obj, "stop", json_string(fmb_stop_text(s->result.stop)));
    size_t conflict = app_verdict_claim(s, FMB_CLAIM_INFEASIBLE);
    if (s->result.verdict == FMB_INFEASIBLE && conflict != SIZE_MAX)
        app_json_set(obj, "conflict", app_json_multipliers(s, conflict));
    return obj;
}

void app_json_set_witness(json_t *obj, const app_session *s)
{
    size_t claim = app_verdict_claim(s, FMB_CLAIM_FEASIBLE);
    if (claim == SIZE_MAX)
        return;
    json_t *point = app_need(json_object());
    mpq_t q;
    mpq_init(q);
    for (int j = 0; j < fmb_system_dim(s->system); j++) {
        fmb_evidence_coordinate_q(s->evidence, claim, j, q);
        app_json_set_variable(point, s->system, j, app_json_number(q, s->ask->digits, APP_NEAREST));
    }
    mpq_clear(q);
    app_json_set(obj, "witness", point);
}

static json_t *count(uint64_t n)
{
    return json_integer((json_int_t)n);
}

void app_json_set_stats(json_t *obj, const fmb_stats *stats)
{
    json_t *o = app_need(json_object());
    app_json_set(o, "rounds", count(stats->rounds));
    app_json_set(o, "pairs", count(stats->pairs));
    app_json_set(o, "rows_made", count(stats->rows_made));
    app_json_set(o, "rows_dropped", count(stats->rows_dropped));
    app_json_set(o, "rows_peak", count(stats->rows_peak));
    app_json_set(o, "promotions", count(stats->promotions));
    app_json_set(o, "pivots", count(stats->pivots));
    app_json_set(o, "lps", count(stats->lps));
    app_json_set(o, "bytes_peak", count(stats->bytes_peak));
    app_json_set(o, "seconds", json_real(stats->seconds));
    app_json_set(obj, "stats", o);
}
