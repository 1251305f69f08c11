/* script_private.h: a script; script.c steps through its commands, ask.c makes systems of them. */
#ifndef FMB_IO_SCRIPT_PRIVATE_H
#define FMB_IO_SCRIPT_PRIVATE_H

#include "io/smt2/script/reading.h"

typedef struct fmb_script_command {
    fmb_span word, text;
    size_t inner; /* check-sat-assuming, get-value: offset of the list in text; 0: none */
    bool counts;  /* it is in force at the current place */
} fmb_script_command;

typedef struct fmb_script_level {
    size_t at; /* number of commands before its push */
    fmb_smt_mark mark;
} fmb_script_level;

struct fmb_script {
    fmb_mem mem;
    fmb_reader how;
    char *text; /* [size] */
    size_t size;
    fmb_smt_reading reading;
    size_t read;   /* commands that the reading has executed */
    size_t marked; /* levels whose mark the reading has set */
    size_t told;   /* commands up to the last that gave a fact */
    size_t knew;   /* like told, for its initial facts; SIZE_MAX: a question gave some */
    size_t heard;  /* commands whose warnings have been given */
    struct {
        size_t command, i;
        const char *at;
    } term;         /* the next term of get-value */
    size_t scanned; /* tokens of the text, when its commands were found */
    fmb_script_command *command;
    size_t commands, capacity;
    fmb_script_level *level; /* one a push */
    size_t levels, level_capacity;
    size_t at;    /* the next command */
    size_t asked; /* the last check command, or SIZE_MAX */
    bool global;  /* declarations outlive pop */
};

/* The kind of question that a command asks; END: none. */
fmb_script_kind fmb_script_kind_of(const fmb_script_command *k);
/* Discard the reading; the next question reads all commands in force there again. */
void fmb_script_drop_reading(fmb_script *s);

/* Tokens read, repetitions included, since the script was opened; for tests. */
size_t fmb_script_tokens(const fmb_script *s);

#endif
