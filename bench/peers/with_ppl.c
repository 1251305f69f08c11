/* with_ppl.c: see with_ppl.h. */
#include "with_ppl.h"

ppl_Linear_Expression_t ppl_expression(const problem_row *r, int n, bool negate, bool constant)
{
    ppl_Linear_Expression_t e;
    ppl_Coefficient_t v;
    mpz_t z;
    mpz_init(z);
    ppl_new_Coefficient(&v);
    ppl_new_Linear_Expression_with_dimension(&e, (ppl_dimension_type)n);
    for (int j = 0; j < n; j++) {
        mpz_set(z, r->a[j]);
        if (negate)
            mpz_neg(z, z);
        ppl_assign_Coefficient_from_mpz_t(v, z);
        ppl_Linear_Expression_add_to_coefficient(e, (ppl_dimension_type)j, v);
    }
    ppl_assign_Coefficient_from_mpz_t(v, r->a[n]);
    if (constant)
        ppl_Linear_Expression_add_to_inhomogeneous(e, v);
    ppl_delete_Coefficient(v);
    mpz_clear(z);
    return e;
}

static void insert_row(ppl_Constraint_System_t rows, const problem_row *r, int n)
{
    static const enum ppl_enum_Constraint_Type type[] = {
        [FMB_LE] = PPL_CONSTRAINT_TYPE_GREATER_OR_EQUAL,
        [FMB_LT] = PPL_CONSTRAINT_TYPE_GREATER_THAN,
        [FMB_EQ] = PPL_CONSTRAINT_TYPE_EQUAL,
    };
    ppl_Constraint_t c;
    ppl_Linear_Expression_t e = ppl_expression(r, n, true, true);
    ppl_new_Constraint(&c, e, type[r->rel]);
    ppl_Constraint_System_insert_Constraint(rows, c);
    ppl_delete_Constraint(c);
    ppl_delete_Linear_Expression(e);
}

ppl_Constraint_System_t ppl_rows(const problem *p)
{
    ppl_Constraint_System_t rows;
    ppl_new_Constraint_System(&rows);
    for (size_t i = 0; i < p->m; i++)
        insert_row(rows, &p->rows[i], p->n);
    return rows;
}

static fmb_rel relation_of(int type)
{
    return type == PPL_CONSTRAINT_TYPE_EQUAL          ? FMB_EQ
           : type == PPL_CONSTRAINT_TYPE_GREATER_THAN ? FMB_LT
                                                      : FMB_LE;
}

static void add_constraint(fmb_system *out, ppl_const_Constraint_t c, ppl_Coefficient_t v, mpz_t *a)
{
    int n = fmb_system_dim(out);
    ppl_dimension_type dim;
    ppl_Constraint_space_dimension(c, &dim);
    for (int j = 0; j < n; j++) {
        mpz_set_ui(a[j], 0);
        if ((ppl_dimension_type)j >= dim)
            continue;
        ppl_Constraint_coefficient(c, (ppl_dimension_type)j, v);
        ppl_Coefficient_to_mpz_t(v, a[j]);
        mpz_neg(a[j], a[j]);
    }
    ppl_Constraint_inhomogeneous_term(c, v);
    ppl_Coefficient_to_mpz_t(v, a[n]);
    system_add_row(out, a, relation_of(ppl_Constraint_type(c)));
}

fmb_system *ppl_system(ppl_const_Constraint_System_t rows, int n)
{
    fmb_system *out = system_of_dim(n);
    mpz_t *a = integers_new((size_t)n + 1);
    ppl_Coefficient_t v;
    ppl_Constraint_System_const_iterator_t at, end;
    ppl_new_Coefficient(&v);
    ppl_new_Constraint_System_const_iterator(&at);
    ppl_new_Constraint_System_const_iterator(&end);
    ppl_Constraint_System_begin(rows, at);
    ppl_Constraint_System_end(rows, end);
    for (; !ppl_Constraint_System_const_iterator_equal_test(at, end);
         ppl_Constraint_System_const_iterator_increment(at)) {
        ppl_const_Constraint_t c;
        ppl_Constraint_System_const_iterator_dereference(at, &c);
        add_constraint(out, c, v, a);
    }
    ppl_delete_Constraint_System_const_iterator(at);
    ppl_delete_Constraint_System_const_iterator(end);
    ppl_delete_Coefficient(v);
    integers_free(a, (size_t)n + 1);
    return out;
}
