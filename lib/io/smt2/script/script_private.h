/* script_private.h: a script, whose commands script.c follows, and of which ask.c makes systems. */
#ifndef FMB_IO_SCRIPT_PRIVATE_H
#define FMB_IO_SCRIPT_PRIVATE_H

#include "io/smt2/script/reading.h"

typedef struct fmb_script_command {
    fmb_span word, text;
    size_t inner; /* check-sat-assuming, get-value: offset of the list in text; 0: none */
    bool counts;  /* at the place that has been reached */
} fmb_script_command;

typedef struct fmb_script_level {
    size_t at; /* commands in front of its push */
    fmb_smt_mark mark;
} fmb_script_level;

struct fmb_script {
    fmb_mem mem;
    fmb_reader how;
    char *text; /* [size] */
    size_t size;
    fmb_smt_reading reading;
    size_t read;   /* commands that it has passed */
    size_t marked; /* levels whose mark it has set */
    size_t told;   /* commands up to the last that told a fact */
    size_t knew;   /* the same, of the facts it began with; SIZE_MAX: a question told some */
    size_t heard;  /* commands whose warnings have been given */
    struct {
        size_t command, i;
        const char *at;
    } term;         /* the term of get-value that comes next */
    size_t scanned; /* tokens of the text, when its commands were found */
    fmb_script_command *command;
    size_t commands, capacity;
    fmb_script_level *level; /* one a push */
    size_t levels, level_capacity;
    size_t at;    /* the next command */
    size_t asked; /* the last check, or SIZE_MAX */
    bool global;  /* declarations outlive pop */
};

/* What a command asks for; END: nothing. */
fmb_script_kind fmb_script_kind_of(const fmb_script_command *k);
/* The next question reads all that holds there once more. */
void fmb_script_drop_reading(fmb_script *s);

/* Tokens that have been read, over and over, since the script was opened; for tests. */
size_t fmb_script_tokens(const fmb_script *s);

#endif
