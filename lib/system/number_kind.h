/* number_kind.h: operations of add.c on numbers in arrays of a caller, whatever their type. */
#ifndef FMB_SYSTEM_NUMBER_KIND_H
#define FMB_SYSTEM_NUMBER_KIND_H

#include <gmp.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define FMB_WRONG_NUMBER 40

/* Numbers of one kind in an array. */
typedef struct fmb_number_kind {
    /* Why number i is refused, in a few words, or NULL. */
    const char *(*wrong)(const void *numbers, size_t i, char buf[FMB_WRONG_NUMBER]);
    bool (*is_zero)(const void *numbers, size_t i);
    /* The denominator of number i in lowest terms; 0 if the number may not be small (num/vec.h).
     */
    uint64_t (*denominator)(const void *numbers, size_t i);
    /* Number i times a factor, a small multiple of its denominator; false if that is not small. */
    bool (*times)(const void *numbers, size_t i, uint64_t factor, int64_t *out);
    void (*get)(mpq_t q, const void *numbers, size_t i);
} fmb_number_kind;

extern const fmb_number_kind fmb_doubles, fmb_integers, fmb_given_rationals;

#endif
