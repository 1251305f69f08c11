/* words.h: a text as lines of words, read one by one.
 *
 * A line is words between blanks (space, tab, carriage return). A word is bare, of printable bytes
 * and bytes above 127 but without '"', '#' and '\'; or it stands in double quotes, with any byte
 * but control bytes, where \" and \\ mean '"' and '\', and \x and two hexadecimal digits mean that
 * byte. '#' where a word could begin starts a comment up to the end of the line. Empty lines are
 * skipped.
 */
#ifndef FMB_PROOF_WORDS_H
#define FMB_PROOF_WORDS_H

#include <gmp.h>

#include "proof/evidence/guard.h"

typedef struct fmb_words {
    FILE *in;
    fmb_mem *mem;
    const fmb_poll *poll; /* asked every so many bytes; unless OK, the text ends there */
    bool is_cut;          /* poll has ended the text */
    fmb_where *where;     /* filled when FMB_ERR_PARSE is returned */
    char *text;           /* the current word, ending in NUL; empty at the end of a line */
    size_t size, capacity;
    bool quoted;
    long line, column; /* of the current word */
    int next;          /* the next byte, or EOF */
    long at_line, at;  /* its place */
    size_t bytes;      /* read so far */
} fmb_words;

void fmb_words_init(fmb_words *w, FILE *in, fmb_mem *mem, const fmb_poll *poll, fmb_where *where);
void fmb_words_clear(fmb_words *w);

/* Read the next word of this line; empty at its end. Errors: PARSE, MEMORY, IO. */
fmb_status fmb_words_next(fmb_words *w);
/* Move to the first word of the next line with words; empty at the end of the text. Only at the
 * beginning of the text or the end of a line. Errors: PARSE, MEMORY, IO. */
fmb_status fmb_words_line(fmb_words *w);
/* Expect the end of the line. Errors: PARSE, MEMORY, IO. */
fmb_status fmb_words_end(fmb_words *w);

/* Report "expected ..." at the current word; always FMB_ERR_PARSE. */
__attribute__((format(printf, 2, 3))) fmb_status fmb_words_expected(fmb_words *w, const char *what,
                                                                    ...);

/* Is the current word bare, and equal to this? */
bool fmb_words_is(const fmb_words *w, const char *word);
/* Read the current word as `what`, a number from 1 to max, or as an exact rational "-12/5". Errors:
 * PARSE. */
fmb_status fmb_words_count(fmb_words *w, const char *what, size_t max, size_t *out);
fmb_status fmb_words_rational(fmb_words *w, mpq_t out);

/* May this byte be in a bare word? */
bool fmb_words_is_bare(unsigned char byte);

#endif
