/* compare_rows.c: an order of rows that depends on their contents only. */
#include "system/system_private.h"

static int compare_sizes(size_t a, size_t b)
{
    return (a > b) - (a < b);
}

int fmb_sysrow_compare(const fmb_sysrow *a, const fmb_sysrow *b)
{
    bool equations = a->rel == FMB_EQ && b->rel == FMB_EQ;
    int order = (b->rel == FMB_EQ) - (a->rel == FMB_EQ);
    if (order == 0 && !equations)
        order = compare_sizes(a->nnz, b->nnz);
    for (size_t k = 0; order == 0 && k < a->nnz && k < b->nnz; k++)
        order = compare_sizes((size_t)a->var[k], (size_t)b->var[k]);
    if (order == 0)
        order = compare_sizes(a->nnz, b->nnz);
    if (order == 0)
        order = -fmb_vec_compare(&a->val, &b->val, a->nnz + 1);
    return order != 0 ? order : (int)a->rel - (int)b->rel;
}
