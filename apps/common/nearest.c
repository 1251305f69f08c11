/* nearest.c: see nearest.h. Near is a small optimal string alignment distance: the fewest
 * insertions, deletions, changes and swaps of neighbours, no place touched twice. Source: Damerau
 * 1964; Wagner and Fischer 1974 for the table.
 */
#include "common/nearest.h"

#include <stdio.h>
#include <string.h>

enum { MOST_LETTERS = 40 };

static size_t least_of(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Row i of the table: distances of the first i letters of a to each beginning of b. */
static size_t alignment_distance(const char *a, size_t m, const char *b, size_t n)
{
    size_t d[MOST_LETTERS + 1][MOST_LETTERS + 1];
    for (size_t i = 0; i <= m; i++)
        d[i][0] = i;
    for (size_t j = 0; j <= n; j++)
        d[0][j] = j;
    for (size_t i = 1; i <= m; i++)
        for (size_t j = 1; j <= n; j++) {
            d[i][j] = least_of(least_of(d[i - 1][j], d[i][j - 1]) + 1,
                               d[i - 1][j - 1] + (a[i - 1] != b[j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = least_of(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[m][n];
}

app_nearest app_nearest_to(const char *word)
{
    return (app_nearest){.word = word};
}

/* One slip in three letters may be a slip; more is another word. */
void app_nearest_try(app_nearest *n, const char *candidate)
{
    size_t own = strlen(n->word), other = strlen(candidate);
    if (own < 2 || own > MOST_LETTERS || other > MOST_LETTERS)
        return;
    size_t distance = alignment_distance(n->word, own, candidate, other);
    if (distance > (own + 1) / 3 || distance >= other || (n->best && distance >= n->distance))
        return;
    n->best = candidate;
    n->distance = distance;
}

const char *app_nearest_hint(const app_nearest *n, char hint[APP_HINT_SIZE])
{
    hint[0] = '\0';
    if (n->best)
        snprintf(hint, APP_HINT_SIZE, "; did you mean '%s'?", n->best);
    return hint;
}
