/* risks.c: portfolios, prices of options, decisions and solutions that hold for all errors.
 *
 * Sources: Dentcheva, Ruszczynski 2003 (dominance by shortfalls, doi 10.1137/S1052623402420528);
 * Bertsimas, Popescu 2002 (prices of options, doi 10.1287/opre.50.2.358.424); Bertsimas, Sim 2004
 * (a few errors at once, doi 10.1287/opre.1030.0065); Oettli, Prager 1964 (solutions of equations
 * with errors, doi 10.1007/BF01386090); Chen, Donoho, Saunders 1998 (short sums of absolute values,
 * doi 10.1137/S1064827596304010).
 */
#include "study/program/writer.h"

/* Portfolios whose shortfalls below some targets are no more than those of a benchmark. */
void study_image_dominance(study_writer *w)
{
    int assets = study_draw(w, 2, 4), cases = study_draw(w, 3, 6), targets = study_draw(w, 1, 4);
    if (!study_write_image(w, assets + cases * targets, assets))
        return;
    int gain[6][4];
    for (int c = 0; c < cases; c++)
        for (int a = 0; a < assets; a++)
            gain[c][a] = study_draw(w, -150, 250);
    for (int t = 0; t < targets; t++) {
        int first = assets + t * cases, target = study_draw(w, -20, 60);
        for (int c = 0; c < cases; c++) {
            study_write_least(w, first + c, 0);
            study_write_term(w, first + c, 1);
            for (int a = 0; a < assets; a++)
                study_write_term(w, a, gain[c][a]);
            study_write_end(w, FMB_GE, target);
        }
        study_write_sum(w, first, cases, 1);
        study_write_end(w, FMB_LE, study_draw(w, 60, 240) * cases / 2);
    }
    for (int a = 0; a < assets; a++)
        study_write_least(w, a, study_random_chance(&w->g, 70) ? 0 : -1);
    study_write_sum(w, 0, assets, 1);
    study_write_end(w, study_random_chance(&w->g, 50) ? FMB_EQ : FMB_LE, 1);
}

/* Prices of some options, by those of others: the probabilities of ends go. */
void study_image_quotes(study_writer *w)
{
    int kept = study_draw(w, 1, 4), ends = study_draw(w, 5, 14), quoted = study_draw(w, 1, 4);
    int64_t price[16], unit = study_random_chance(&w->g, 50) ? 1 : 10007;
    if (!study_write_image(w, kept + ends, kept))
        return;
    for (int e = 0; e < ends; e++) {
        price[e] = (40 + 8 * e) * unit + study_random_between(&w->g, 0, 4 * unit);
        study_write_least(w, kept + e, 0);
    }
    study_write_sum(w, kept, ends, 1);
    study_write_end(w, FMB_EQ, 1);
    for (int o = 0; o < kept + quoted; o++) {
        int64_t strike = price[study_draw(w, 0, ends - 2)] + (o % 2) * unit, middle = 0;
        for (int side = 0; side < (o < kept ? 1 : 2); side++) {
            middle = 0;
            study_write_term(w, o < kept ? o : 0, o < kept ? -unit : 0);
            for (int e = 0; e < ends; e++) {
                int64_t pays = price[e] > strike ? price[e] - strike : 0;
                middle += pays;
                study_write_term(w, kept + e, pays);
            }
            if (o < kept)
                study_write_end(w, FMB_EQ, 0);
            else
                study_write_end_q(w, side ? FMB_LE : FMB_GE, (side ? 12 : 8) * middle,
                                  10 * (uint64_t)ends);
        }
    }
}

/* Decisions whose rows hold if a few of their coefficients are off; how much each costs goes. */
void study_image_protected(study_writer *w)
{
    int n = study_draw(w, 2, 4), rows = study_draw(w, 1, 4), each = n + 1;
    bool bounded = study_random_chance(&w->g, 60), tenths = study_random_chance(&w->g, 50);
    if (!study_write_image(w, n + n + rows * each, n))
        return;
    for (int j = 0; j < n; j++)
        for (int side = -1; side <= 1; side += 2) { /* absolute values */
            study_write_term(w, n + j, 1);
            study_write_term(w, j, side);
            study_write_end(w, FMB_GE, 0);
        }
    for (int i = 0; i < rows; i++) {
        int z = 2 * n + i * each;
        for (int j = 0; j < n; j++) {
            study_write_term(w, j, tenths ? study_draw(w, -9999, 9999) : study_draw(w, -9, 9));
            study_write_term(w, z + 1 + j, 1);
        }
        study_write_term(w, z, study_draw(w, 1, n));
        study_write_end(w, FMB_LE, tenths ? 50000 : 50);
        study_write_least(w, z, 0);
        for (int j = 0; j < n; j++) {
            study_write_least(w, z + 1 + j, 0);
            study_write_term(w, z, 1);
            study_write_term(w, z + 1 + j, 1);
            study_write_term(w, n + j, -(tenths ? study_draw(w, 1, 999) : study_draw(w, 1, 3)));
            study_write_end(w, FMB_GE, 0);
        }
    }
    for (int j = 0; bounded && j < n; j++)
        study_write_most(w, n + j, study_draw(w, 5, 20));
}

/* Solutions, none below 0, of equations whose numbers are known up to errors; some of them stay. */
void study_image_enclosures(study_writer *w)
{
    int n = study_draw(w, 3, 8), kept = study_draw(w, 1, n - 2 < 4 ? n - 2 : 4);
    int equations = study_draw(w, n - 2, n + 2), digits = study_draw(w, 1, 10);
    int64_t unit = 1;
    if (!study_write_image(w, n, kept))
        return;
    bool strict = study_random_chance(&w->g, 25);
    for (int d = 1; d < digits; d++)
        unit *= 10;
    for (int i = 0; i < equations; i++) {
        int64_t coef[8], right = 0;
        for (int j = 0; j < n; j++) {
            coef[j] = study_random_between(&w->g, -9 * unit, 9 * unit);
            right += coef[j] * (1 + j % 3);
        }
        int percent = study_draw(w, 2, 20);
        for (int side = -1; side <= 1; side += 2) {
            for (int j = 0; j < n; j++)
                study_write_term(w, j, 100 * coef[j] + side * percent * unit);
            study_write_end(w, side > 0 ? strict ? FMB_GT : FMB_GE : FMB_LE,
                            100 * right - side * unit);
        }
    }
    for (int j = 0; j < n; j++)
        study_write_least(w, j, 0);
}

/* What solves equations with a short sum of absolute values: some numbers of it stay. */
void study_image_codes(study_writer *w)
{
    int n = study_draw(w, 3, 8), kept = study_draw(w, 1, n - 2 < 4 ? n - 2 : 4), sum = 0;
    int equations = study_draw(w, 1, n / 2), entries = study_random_chance(&w->g, 50) ? 1 : 999;
    int code[8];
    if (!study_write_image(w, 2 * n, kept))
        return;
    for (int j = 0; j < n; j++) {
        code[j] = study_random_chance(&w->g, 40) ? study_draw(w, -9, 9) : 0;
        sum += code[j] < 0 ? -code[j] : code[j];
        for (int side = -1; side <= 1; side += 2) {
            study_write_term(w, n + j, 1);
            study_write_term(w, j, side);
            study_write_end(w, FMB_GE, 0);
        }
    }
    for (int i = 0; i < equations; i++) {
        int64_t right = 0;
        for (int j = 0; j < n; j++) {
            int coef = study_draw(w, -entries, entries);
            study_write_term(w, j, coef);
            right += coef * code[j];
        }
        study_write_end(w, FMB_EQ, right);
    }
    study_write_sum(w, n, n, 1);
    study_write_end(w, FMB_LE, sum + study_draw(w, 1, 9));
}
