/* scenes.c: see scenes.h.
 *
 * Shannon's cone (Yeung, A framework for linear information inequalities, 1997, doi
 * 10.1109/18.641556): a variable h(S) for each nonempty set S of n random variables, and the
 * elemental inequalities, in which h(empty) = 0:
 *   h(N) >= h(N - i);  h(K + i) + h(K + j) >= h(K + i + j) + h(K), K without i and j.
 * The cone is not empty. Every h(S) ranges over [0, infinity): n independent bits times any factor
 * are in it, and h(S) >= 0 follows. With h(N) >= 1 and every h(i) <= 0 it is empty.
 */
#include "scenes.h"
#include "rows.h"
#include "support.h"

enum { MOST_SETS = 32 };

typedef struct shannon {
    fmb_system *s;
    int n, place[MOST_SETS]; /* of h(S), S a bit set; place[0] is no variable */
} shannon;

static void put(const shannon *c, int64_t *a, int set, int64_t value)
{
    if (set != 0)
        a[c->place[set]] += value;
}

static void monotone(const shannon *c, int i)
{
    int64_t a[MOST_SETS] = {0};
    int all = (1 << c->n) - 1;
    put(c, a, all, -1);
    put(c, a, all ^ 1 << i, 1);
    must(fmb_system_add_int(c->s, a, FMB_LE, 0));
}

static void submodular(const shannon *c, int i, int j)
{
    for (int k = 0; k < 1 << c->n; k++) {
        int64_t a[MOST_SETS] = {0};
        if (k >> i & 1 || k >> j & 1)
            continue;
        put(c, a, k | 1 << i, -1);
        put(c, a, k | 1 << j, -1);
        put(c, a, k | 1 << i | 1 << j, 1);
        put(c, a, k, 1);
        must(fmb_system_add_int(c->s, a, FMB_LE, 0));
    }
}

/* The entropies of the variables and of neighbours in a cycle come first: they are kept. */
static int number_sets(shannon *c)
{
    int next = 0;
    for (int i = 0; i < c->n; i++)
        c->place[1 << i] = next++;
    for (int i = 0; i < c->n; i++)
        c->place[1 << i | 1 << (i + 1) % c->n] = next++;
    int kept = next;
    for (int set = 1; set < 1 << c->n; set++)
        if (c->place[set] == 0 && set != 1)
            c->place[set] = next++;
    return kept;
}

static scene shannon_scene(int n, bool feasible)
{
    shannon c = {.n = n, .s = rows_none((1 << n) - 1)};
    scene out = {.s = c.s, .verdict = FMB_FEASIBLE, .cone = true, .name = "Shannon's cone"};
    out.kept = number_sets(&c);
    for (int j = 0; j < out.kept; j++)
        out.keep[j] = j;
    for (int i = 0; i < n; i++)
        monotone(&c, i);
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++)
            submodular(&c, i, j);
    if (feasible)
        return out;
    int64_t a[MOST_SETS] = {0};
    put(&c, a, (1 << n) - 1, -1);
    must(fmb_system_add_int(c.s, a, FMB_LE, -1));
    for (int i = 0; i < n; i++) {
        int64_t b[MOST_SETS] = {0};
        put(&c, b, 1 << i, 1);
        must(fmb_system_add_int(c.s, b, FMB_LE, 0));
    }
    out.verdict = FMB_INFEASIBLE;
    out.name = "Shannon's cone, cut empty";
    out.cone = false;
    return out;
}

/* m rows through which 0 passes, with slack or without; or, with a conflict among three rows. */
static scene random_scene(int n, int m, int zeros, bool feasible, uint64_t seed)
{
    support_rng g = {seed};
    scene out = {.s = rows_none(n), .verdict = feasible ? FMB_FEASIBLE : FMB_INFEASIBLE, .kept = 2};
    out.keep[1] = n - 1;
    out.name = feasible ? "random, feasible" : "random, infeasible";
    int64_t sum[MOST_SETS] = {0};
    for (int i = 0; i < m; i++) {
        int64_t a[MOST_SETS] = {0};
        for (int j = 0; j < n; j++)
            a[j] = support_chance(&g, zeros) ? 0 : support_between(&g, -9, 9);
        for (int j = 0; j < n && i < 3; j++)
            sum[j] -= a[j];
        must(fmb_system_add_int(out.s, a, i == 5 ? FMB_LT : FMB_LE, support_between(&g, 1, 20)));
    }
    if (!feasible)
        must(fmb_system_add_int(out.s, sum, FMB_LE, -100));
    return out;
}

int scenes_all(scene out[SCENES_MOST])
{
    int n = 0;
    out[n++] = random_scene(2, 3, 0, false, 1);
    out[n++] = random_scene(3, 8, 20, true, 2);
    out[n++] = random_scene(6, 20, 20, false, 4);
    out[n++] = shannon_scene(4, true);
    out[n++] = shannon_scene(4, false);
    out[n++] = random_scene(6, 20, 20, true, 3);
    out[n++] = random_scene(20, 80, 30, true, 5);
    out[n++] = random_scene(30, 120, 0, true, 6);
    out[n++] = random_scene(31, 150, 50, false, 7);
    out[n++] = shannon_scene(5, true);
    out[n++] = shannon_scene(5, false);
    return n;
}
