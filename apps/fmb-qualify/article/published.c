/* published.c: the figures of the article. */
#include "fmb-qualify/article/article.h"

/* [2D, 3D static, 2D, 3D dynamic][CC, CT, TT][apart, meeting]: Baillehache 2020, Table 1. */
static const double PUBLISHED[4][3][2] = {
    {{1.22, 2.58}, {1.29, 1.86}, {1.32, 1.33}},
    {{0.50, 0.72}, {0.66, 0.41}, {0.89, 0.24}},
    {{1.50, 3.12}, {1.50, 2.22}, {1.50, 1.67}},
    {{0.71, 2.58}, {0.81, 1.37}, {0.95, 0.54}},
};

double article_published(const verdict_class *c)
{
    return PUBLISHED[2 * c->moves + c->dim - 2][c->kind][c->meets];
}
