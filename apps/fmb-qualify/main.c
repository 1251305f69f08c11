/* main.c: studies of the library: a table of subcommands, one for each study. */
#include "common/dispatch.h"
#include "fmb-qualify/experiment/experiment.h"
#include "fmb-qualify/render.h"
#include "fmb-qualify/study.h"

static int run_table1(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_table1, argc, argv);
}

static int run_article_study(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_article, argc, argv);
}

static int run_near(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_near, argc, argv);
}

static int run_touching(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_touching, argc, argv);
}

static int run_slender(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_slender, argc, argv);
}

static int run_mesh(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_mesh, argc, argv);
}

static int run_faces(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_faces, argc, argv);
}

static int run_boxes(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_boxes, argc, argv);
}

static int run_scaling(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_scaling, argc, argv);
}

static int run_peers(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_peers, argc, argv);
}

static int run_bunny_study(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_bunny, argc, argv);
}

static const app_command commands[] = {
    {"all", "fmb-qualify all", "all studies in one report, the default", qualify_all},
    {"table1", "fmb-qualify table1", "verdicts by FMB and by SAT: the article's 24 cells",
     run_table1},
    {"article", "fmb-qualify article", "table1 as published, by its program's method, and by ours",
     run_article_study},
    {"near", "fmb-qualify near", "table1 on pairs whose axis-aligned boxes meet", run_near},
    {"touching", "fmb-qualify touching", "table1 on pairs that touch, or nearly do", run_touching},
    {"slender", "fmb-qualify slender", "table1 on rods and blades", run_slender},
    {"mesh", "fmb-qualify mesh", "table1 on neighbouring and near cells of a mesh", run_mesh},
    {"faces", "fmb-qualify faces", "table1 on faces with their unit normals", run_faces},
    {"boxes", "fmb-qualify boxes", "how large boxes of the common points are, over the tight one",
     run_boxes},
    {"scaling", "fmb-qualify scaling", "what more dimensions cost: 2 to 8", run_scaling},
    {"rules", "fmb-qualify rules", "pruning rules x orders x systems: rows, time, errors",
     qualify_rules},
    {"peers", "fmb-qualify peers", "other libraries on the same pairs: time, wrong answers",
     run_peers},
    {"bunny", "fmb-qualify bunny", "a scan against its mirror image: trees, and all pairs",
     run_bunny_study},
    {"benchmark", "fmb-qualify benchmark", "600 problems of 40 families, with proved answers",
     qualify_benchmark},
    {"run", "fmb-qualify run", "an experiment from a plan: each run a line of CSV", qualify_run},
    {"merge", "fmb-qualify merge", "the shards of an experiment as one file", qualify_merge},
    {"bias", "fmb-qualify bias", "none against none: is the clock fair?", qualify_bias},
    {"plots", "fmb-qualify plots", "figures and tables of an experiment", qualify_plots},
    {"leaderboard", "fmb-qualify leaderboard", "rules and orders of an experiment, ranked",
     qualify_leaderboard},
};

static const char doc[] =
    "Measure the library on random frames and on files, with seeds and against exact answers."
    "\v"
    "`fmb-qualify STUDY --help` lists the options of a study.\n"
    "\n"
    "Exit codes: 0 done, 1 a wrong answer was found, 2 interrupted, 64 usage, 65 bad input, 66 "
    "cannot open, 70 internal error, 74 cannot write.\n"
    "\n"
    "Examples:\n"
    "  fmb-qualify\n"
    "  fmb-qualify table1 --json\n"
    "  fmb-qualify rules --out report\n";

int main(int argc, char **argv)
{
    static char name[] = "fmb-qualify";
    const app_program program = {.name = name,
                                 .word = "study",
                                 .heading = "Studies",
                                 .args = "[STUDY] [OPTION...]",
                                 .doc = doc,
                                 .command = commands,
                                 .commands = sizeof commands / sizeof *commands,
                                 .otherwise = &commands[0]};
    return app_dispatch(&program, argc, argv);
}
