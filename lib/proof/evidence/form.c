/* form.c: the tables of the text form; see form.h. */
#include "proof/evidence/form.h"

const fmb_part_form fmb_part_forms[FMB_PARTS] = {
    [FMB_PART_POINT] = {"point", FMB_KEY_VARIABLE}, [FMB_PART_RAY] = {"ray", FMB_KEY_VARIABLE},
    [FMB_PART_TERM] = {"term", FMB_KEY_VARIABLE},   [FMB_PART_ROW] = {"row", FMB_KEY_ROW},
    [FMB_PART_REVERSE] = {"reverse", FMB_KEY_ROW},  [FMB_PART_STEP] = {"step", FMB_KEY_VARIABLE},
    [FMB_PART_CLAIM] = {"implied", FMB_KEY_CLAIM},
};

const fmb_claim_form fmb_claim_forms[FMB_CLAIM_FOLLOWS + 1] = {
    [FMB_CLAIM_FEASIBLE] = {"feasible", FMB_HEADING_NONE, {[FMB_PART_POINT] = true}},
    [FMB_CLAIM_INFEASIBLE] = {"infeasible", FMB_HEADING_NONE, {[FMB_PART_ROW] = true}},
    [FMB_CLAIM_BOUND] = {"bound",
                         FMB_HEADING_BOUND,
                         {[FMB_PART_TERM] = true, [FMB_PART_ROW] = true, [FMB_PART_POINT] = true}},
    [FMB_CLAIM_UNBOUNDED] = {"unbounded",
                             FMB_HEADING_END,
                             {[FMB_PART_TERM] = true, [FMB_PART_RAY] = true}},
    [FMB_CLAIM_IMPLIED] =
        {"implied",
         FMB_HEADING_INEQUALITY,
         {[FMB_PART_TERM] = true, [FMB_PART_ROW] = true, [FMB_PART_REVERSE] = true}},
    [FMB_CLAIM_REDUNDANT] = {"redundant",
                             FMB_HEADING_ROW,
                             {[FMB_PART_ROW] = true, [FMB_PART_REVERSE] = true}},
    [FMB_CLAIM_EQUALITY] = {"equality", FMB_HEADING_ROW, {[FMB_PART_ROW] = true}},
    [FMB_CLAIM_IRREDUNDANT] = {"irredundant", FMB_HEADING_ROW, {[FMB_PART_POINT] = true}},
    [FMB_CLAIM_CORNER] = {"corner",
                          FMB_HEADING_NONE,
                          {[FMB_PART_POINT] = true, [FMB_PART_RAY] = true}},
    [FMB_CLAIM_WHOLE] = {"whole", FMB_HEADING_VARIABLES, {[FMB_PART_STEP] = true}},
    [FMB_CLAIM_FOLLOWS] = {"follows",
                           FMB_HEADING_INEQUALITY,
                           {[FMB_PART_TERM] = true, [FMB_PART_CLAIM] = true}},
};

const char *fmb_form_relation(fmb_rel rel, fmb_side side)
{
    static const char *const text[][2] = {
        [FMB_LE] = {">=", "<="}, [FMB_LT] = {">", "<"}, [FMB_EQ] = {"=", "="}};
    return text[rel][side];
}

bool fmb_form_allows(const fmb_claim *c, fmb_form_part part)
{
    return fmb_claim_forms[c->kind].part[part] && (part != FMB_PART_TERM || c->var < 0);
}

fmb_sparse_vector *fmb_form_list(fmb_claim *c, fmb_form_part part)
{
    fmb_sparse_vector *const list[FMB_PARTS] = {
        [FMB_PART_POINT] = &c->point,      [FMB_PART_RAY] = &c->ray,
        [FMB_PART_TERM] = &c->terms,       [FMB_PART_ROW] = &c->multipliers,
        [FMB_PART_REVERSE] = &c->reverse,  [FMB_PART_STEP] = &c->point,
        [FMB_PART_CLAIM] = &c->multipliers};
    return list[part];
}
