/* verdicts.h: a study of verdicts: cells and tables. */
#ifndef QUALIFY_VERDICTS_H
#define QUALIFY_VERDICTS_H

#include "fmb-qualify/verdicts/duel.h"

enum { VERDICT_CASES = 4, VERDICT_CELLS = VERDICT_CASES * VERDICT_ANY * 2 };

typedef struct verdict_study {
    verdict_duel duel[VERDICT_CELLS];
    verdict_mix mix[VERDICT_CASES];
    size_t duels, mixes; /* complete ones */
} verdict_study;

/* Classes of the cases for which is_case is true (by number: 2D, 3D static, 2D, 3D dynamic). An
 * exit code. */
int verdict_study_run(const verdict_source *from, const bool is_case[VERDICT_CASES],
                      const qualify_setup *o, qualify_page *page);

/* The results: add the numbers first, then their tables. */
void verdict_numbers(const verdict_study *s, qualify_page *page);
void verdict_tables(const verdict_study *s, qualify_page *page);

#endif
