/* library.c: the rivals' rules for --rule-library: first the sound ones, then the unsound ones. */
#include "study/rivals/rules/rivals.h"

const fmb_rule *const fmb_rule_library[] = {
    &rival_bastrakov_zolotykh, &rival_chernikov_sets,
    &rival_imbert_first,       &rival_quasi_syntactic,
    &rival_raytracing,         &rival_test_cone,
    &rival_imbert_printed,     &rival_linarith,
    &rival_simon_king,         NULL,
};
