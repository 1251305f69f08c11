/* data.c: sets left open by measurements, choices and distributions.
 *
 * Sources: Rockafellar, Uryasev 2000 (tails by auxiliary variables, doi 10.21314/JOR.2000.038);
 * Milanese, Belforte 1982 (parameters that bounded errors leave, doi 10.1109/TAC.1982.1102942);
 * Wainwright, Jordan 2008 (local consistency, doi 10.1561/2200000001); Afriat 1967 (weights behind
 * preferences, doi 10.2307/2525382).
 */
#include "study/program/writer.h"

/* Parameters of a model that measurements with bounded errors leave, some of which are not asked
 * for; numbers of ten digits. */
void study_image_parameters(study_writer *w)
{
    int n = study_draw(w, 4, 7), kept = study_draw(w, 2, 3), measured = study_draw(w, n + 1, 3 * n);
    if (!study_write_image(w, n, kept))
        return;
    for (int i = 0; i < measured; i++) {
        int64_t coef[8], right = 0;
        for (int j = 0; j < n; j++) {
            coef[j] = study_random_between(&w->g, -9999999999, 9999999999);
            right += coef[j] / 7 * (j % 3);
        }
        for (int side = 0; side < 2; side++) {
            for (int j = 0; j < n; j++)
                study_write_term(w, j, coef[j]);
            int64_t error = study_random_between(&w->g, 1000000000, 9999999999);
            study_write_end(w, side ? FMB_LE : FMB_GE, side ? right + error : right - error);
        }
    }
}

/* Lines and planes close to points of ten digits: some coefficients and the greatest error are
 * kept, the errors of points are not. */
void study_image_fits(study_writer *w)
{
    int n = study_draw(w, 2, 4), points = study_draw(w, 3, 7), kept = study_draw(w, 1, n) + 1;
    if (!study_write_image(w, n + 1 + points, kept))
        return;
    for (int p = 0; p < points; p++) {
        int64_t x[4], y = study_random_between(&w->g, -9999999999, 9999999999);
        for (int j = 0; j < n; j++)
            x[j] = study_random_between(&w->g, -9999999999, 9999999999);
        for (int side = -1; side <= 1; side += 2) {
            study_write_term(w, n + 1 + p, 1000000000);
            for (int j = 0; j < n; j++)
                study_write_term(w, 1 + j, side * x[j]);
            study_write_end(w, FMB_GE, side * y);
        }
        study_write_term(w, n + 1 + p, study_draw(w, 1, 3));
        study_write_term(w, 0, -1);
        study_write_end(w, FMB_LE, 0);
    }
    study_write_sum(w, n + 1, points, 1);
    study_write_end(w, FMB_LE, study_draw(w, 40, 400));
    study_write_box(w, 1, n, -99, 99);
}

/* Moments of a distribution on some numbers, in units of powers of 2, and bounds on tails. */
void study_image_moments(study_writer *w)
{
    int moments = study_draw(w, 2, 4), numbers = study_draw(w, 5, 12), shift = study_draw(w, 0, 8);
    if (!study_write_image(w, moments + numbers, moments))
        return;
    for (int m = 0; m < moments; m++) {
        int64_t unit = (int64_t)1 << (shift * (m % 3));
        study_write_term(w, m, m % 2 ? unit : -unit);
        for (int k = 0; k < numbers; k++) {
            int64_t power = 1;
            for (int e = 0; e <= m; e++)
                power *= 2 * k - numbers + 2;
            study_write_term_q(w, moments + k, m % 2 ? -power : power, (uint64_t)1 << (2 * m));
        }
        study_write_end(w, FMB_EQ, 0);
    }
    study_write_sum(w, moments, numbers, 1);
    study_write_end(w, FMB_EQ, 1);
    for (int k = 0; k < numbers; k++)
        study_write_least(w, moments + k, 0);
    for (int tail = study_draw(w, 1, 4); tail > 0; tail--) {
        int from = study_draw(w, 1, numbers - 2);
        study_write_sum(w, moments + from, numbers - from, 20);
        study_write_end(w, FMB_LE, study_draw(w, 4, 19));
    }
}

/* Values whose largest ones do not sum up to more than a bound: tails, by auxiliary variables. */
void study_image_tails(study_writer *w)
{
    int values = study_draw(w, 3, 6), bounds = study_draw(w, 1, 2);
    if (!study_write_image(w, values + bounds * (values + 1), values))
        return;
    for (int b = 0; b < bounds; b++) {
        int level = values + b * (values + 1);
        study_write_term(w, level, study_draw(w, 1, values - 1));
        for (int x = 0; x < values; x++)
            study_write_term(w, level + 1 + x, study_draw(w, 1, 2));
        study_write_end(w, FMB_LE, study_draw(w, 5, 20));
        for (int x = 0; x < values; x++) {
            study_write_least(w, level + 1 + x, 0);
            study_write_term(w, level + 1 + x, 1);
            study_write_term(w, x, -study_draw(w, 1, 3));
            study_write_term(w, level, 1);
            study_write_end(w, FMB_GE, 0);
        }
    }
    for (int x = 0; x < values; x++)
        study_write_least(w, x, 0);
}

/* Probabilities of pairs along a chain of three values each that agree where pairs meet; those of
 * some values at both ends stay, with bounds on others. */
void study_image_beliefs(study_writer *w)
{
    enum { VALUES = 3 };
    int links = study_draw(w, 2, 3), kept = study_draw(w, 2, 4), pair = VALUES * VALUES;
    if (!study_write_image(w, kept + links * pair, kept))
        return;
    for (int k = 0; k < kept; k++) {
        int first = kept + (k % 2 ? links - 1 : 0) * pair;
        study_write_term(w, k, -1);
        for (int v = 0; v < VALUES; v++)
            study_write_term(w, first + (k % 2 ? v * VALUES + k / 2 : k / 2 * VALUES + v), 1);
        study_write_end(w, FMB_EQ, 0);
    }
    for (int l = 0; l + 1 < links; l++)
        for (int v = 0; v + 1 < VALUES; v++) {
            for (int u = 0; u < VALUES; u++) {
                study_write_term(w, kept + l * pair + u * VALUES + v, 1);
                study_write_term(w, kept + (l + 1) * pair + v * VALUES + u, -1);
            }
            study_write_end(w, FMB_EQ, 0);
        }
    for (int l = 0; l < links; l++) {
        for (int x = 0; x < pair; x++) {
            study_write_least(w, kept + l * pair + x, 0);
            if (study_random_chance(&w->g, 25)) {
                study_write_term(w, kept + l * pair + x, study_draw(w, 3, 9));
                study_write_end(w, FMB_LE, 2);
            }
        }
        for (int x = 0; x < pair; x++)
            study_write_term(w, kept + l * pair + x, 1);
        study_write_end(w, FMB_EQ, 1);
    }
}

/* Weights of criteria behind choices: what was preferred weighs more. Some weights are kept. */
void study_image_votes(study_writer *w)
{
    int criteria = study_draw(w, 4, 7), choices = study_draw(w, criteria, 3 * criteria);
    if (!study_write_image(w, criteria, study_draw(w, 2, criteria - 2)))
        return;
    for (int c = 0; c < choices; c++) {
        int64_t all = 0;
        for (int x = 0; x < criteria; x++) {
            int64_t better = study_random_between(&w->g, -9, 9);
            if (x + 1 == criteria && all + better * (x + 1) <= 0)
                better = 1 - all / (x + 1);
            all += better * (x + 1); /* weights 1, 2, 3, ... agree with all choices */
            study_write_term(w, x, better);
        }
        study_write_end(w, study_random_chance(&w->g, 50) ? FMB_GT : FMB_GE, 0);
    }
    for (int x = 0; x < criteria; x++)
        study_write_least(w, x, 0);
    for (int x = 0; x < criteria; x++)
        study_write_term(w, x, 1);
    if (study_random_chance(&w->g, 70))
        study_write_end(w, FMB_EQ, 100);
    else
        study_write_end(w, FMB_GE, 1);
}

/* Shares that sum up to 1, and whose ratios are bounded. */
void study_image_shares(study_writer *w)
{
    int n = study_draw(w, 4, 9), ratios = study_draw(w, n, 3 * n);
    if (!study_write_image(w, n, study_draw(w, 2, n - 2)))
        return;
    for (int r = 0; r < ratios; r++) {
        int x = study_draw(w, 0, n - 1);
        study_write_term_q(w, x, 1, (uint64_t)study_draw(w, 1, 12));
        study_write_term(w, (x + study_draw(w, 1, n - 1)) % n, -1);
        study_write_end(w, FMB_LE, 0);
    }
    for (int x = 0; x < n; x++)
        study_write_least(w, x, 0);
    study_write_sum(w, 0, n, 1);
    study_write_end(w, FMB_EQ, 1);
}

/* Numbers in order, the sums of whose first ones are bounded. */
void study_image_sorted(study_writer *w)
{
    int n = study_draw(w, 5, 9), kept = study_draw(w, 2, 4), step = n % 2 ? 2 : n % 3 ? 3 : 5;
    if (!study_write_image(w, n, kept))
        return;
    for (int i = 0; i + 1 < n; i++) {
        study_write_term(w, i * step % n, 1);
        study_write_term(w, (i + 1) * step % n, -study_draw(w, 1, 2));
        study_write_end(w, study_random_chance(&w->g, 20) ? FMB_LT : FMB_LE, 2);
    }
    for (int size = 2; size <= n; size += study_draw(w, 1, 2)) {
        for (int i = 0; i < size; i++)
            study_write_term(w, i * step % n, i % 2 ? 3 : 2);
        study_write_end(w, FMB_LE, study_draw(w, 5, 10) * size);
    }
    study_write_least(w, 0, -study_draw(w, 1, 50));
}
