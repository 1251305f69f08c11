/* utf8.h: UTF-8 characters, for readers, writers, and the programs, which compile it, too. */
#ifndef FMB_IO_CORE_UTF8_H
#define FMB_IO_CORE_UTF8_H

#include <stddef.h>

/* The length of the UTF-8 character at text, which has left bytes: shortest forms only, no
 * surrogates, at most U+10FFFF (Unicode Standard 15, table 3-7); 0 if there is none. The second
 * gives 0 for control characters, too (C0, DEL, C1), and for those that reorder a text or are not
 * seen in it (U+202E, U+200B, U+FEFF): names and labels may hold any bytes, and a terminal must not
 * obey them, nor a reader be misled. */
size_t fmb_utf8_length(const char *text, size_t left);
size_t fmb_utf8_printable(const char *text, size_t left);

#endif
