/* fmb-qualify.c: studies of the library: a table of subcommands, one a question. */
#include <stdlib.h>
#include <string.h>

#include "common/dispatch.h"
#include "common/message.h"
#include "qualify/study.h"

static int run_table1(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_table1, argc, argv);
}

static int run_near(int argc, char **argv)
{
    return qualify_study_main(&qualify_study_near, argc, argv);
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

static const app_command commands[] = {
    {"all", "fmb-qualify all", "all of them in one report: what is done without a STUDY",
     qualify_all},
    {"table1", "fmb-qualify table1", "verdicts by FMB and by SAT: the article's 24 cells",
     run_table1},
    {"near", "fmb-qualify near", "the same on pairs whose axis-aligned boxes meet", run_near},
    {"faces", "fmb-qualify faces", "the same on faces with their unit normals", run_faces},
    {"boxes", "fmb-qualify boxes", "how large boxes of the common points are, over the tight one",
     run_boxes},
    {"scaling", "fmb-qualify scaling", "what more dimensions cost: 2 to 8", run_scaling},
    {"rules", "fmb-qualify rules", "pruning rules x orders x systems: rows, time, errors",
     qualify_rules},
    {"peers", "fmb-qualify peers", "other libraries on the same pairs: time, wrong answers",
     run_peers},
};

static const char doc[] =
    "Measure the library on random frames and on files, with seeds and against exact answers."
    "\v"
    "`fmb-qualify STUDY --help` tells the options of a study.\n"
    "\n"
    "Exit codes: 0 done, 1 a wrong answer was found, 2 interrupted, 64 usage, 65 bad input, 66 "
    "cannot open, 70 internal error, 74 cannot write.\n"
    "\n"
    "Examples:\n"
    "  fmb-qualify\n"
    "  fmb-qualify table1 --json\n"
    "  fmb-qualify rules --out report\n";

/* Is that an option of the program as a whole? */
static bool is_about(const char *word)
{
    static const char *const ABOUT[] = {"--help", "-?", "--usage", "--version", "-V"};
    for (size_t i = 0; i < sizeof ABOUT / sizeof *ABOUT; i++)
        if (strcmp(word, ABOUT[i]) == 0)
            return true;
    return false;
}

/* [give, free()] The command line with the word "all" in front of its options. */
static char **with_all(int argc, char **argv)
{
    static char all[] = "all";
    char **words = app_need(malloc(((size_t)argc + 2) * sizeof *words));
    words[0] = argv[0];
    words[1] = all;
    memcpy(words + 2, argv + 1, (size_t)argc * sizeof *words);
    return words;
}

int main(int argc, char **argv)
{
    static char name[] = "fmb-qualify";
    const app_program program = {.name = name,
                                 .word = "study",
                                 .heading = "Studies",
                                 .args = "[STUDY] [OPTION...]",
                                 .doc = doc,
                                 .command = commands,
                                 .commands = sizeof commands / sizeof *commands};
    if (argc > 1 && (argv[1][0] != '-' || is_about(argv[1])))
        return app_dispatch(&program, argc, argv);
    char **words = with_all(argc, argv);
    int code = app_dispatch(&program, argc + 1, words);
    free(words);
    return code;
}
