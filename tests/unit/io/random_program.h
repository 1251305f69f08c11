/* random_program.h: random linear programs as text, with all features of MPS and LP. */
#ifndef FMB_TEST_RANDOM_PROGRAM_H
#define FMB_TEST_RANDOM_PROGRAM_H

#include <stddef.h>
#include <stdint.h>

typedef enum program_form { MPS_FIXED, MPS_FREE, LP } program_form;

/* [give, free()] Numbers are multiples of 1/8. The same seed gives the same text. */
char *random_program(uint64_t seed, program_form form, size_t *size);

#endif
