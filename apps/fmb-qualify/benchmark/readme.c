/* readme.c: see readme.h. */
#include "fmb-qualify/benchmark/readme.h"

#include "study/benchmark/benchmark.h"

static const char HEAD[] = "# " STUDY_BENCHMARK_VERSION ": projections and verdicts\n"
                           "\n"
                           "Made by `fmb-qualify benchmark`: the same bytes on every machine. To "
                           "the extent possible under law, "
                           "who made it has waived all copyright and related or neighbouring "
                           "rights to these files: CC0 1.0, "
                           "<https://creativecommons.org/publicdomain/zero/1.0/>.\n"
                           "\n"
                           "- `NAME.ine`: a system, as cddlib and lrslib read it, with the line "
                           "`project` where a projection is "
                           "asked for; without it the question is whether there is a solution. "
                           "Some have `strict_inequality` "
                           "rows, which these two do not know.\n"
                           "- `NAME.json`: what is known of it.\n"
                           "- `manifest.csv`: the same of all, a line each.\n"
                           "\n"
                           "NAME is family, size from 1 to 5, and instance. A digest is the "
                           "SHA-256 of the projection as `fmb "
                           "project NAME.ine --to ine` prints it: irredundant, in its canonical "
                           "form (equations in reduced echelon "
                           "form first, numbers coprime integers, rows in order); of a verdict, "
                           "that of the word `feasible` or "
                           "`infeasible` and a newline. Every answer was accepted by the checker, "
                           "and of every projection that "
                           "no row is missing.\n"
                           "\n"
                           "| family | field | what it is |\n"
                           "|---|---|---|\n";

void qualify_put_readme(FILE *f, const void *what)
{
    (void)what;
    fputs(HEAD, f);
    for (int k = 0; k < study_benchmark_families(); k++)
        fprintf(f, "| %s | %s | %s |\n", study_benchmark_name(k), study_benchmark_field(k),
                study_benchmark_about(k));
}
