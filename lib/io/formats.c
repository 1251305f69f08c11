/* formats.c: the table of formats, and what is looked up in it; see formats.h and sniff.c. */
#include <string.h>

#include "io/formats.h"
#include "io/sniff.h"

/* Guessing takes the first that fits. */
static const fmb_codec table[] = {
    {FMB_FORMAT_INE, "ine", fmb_read_ine, fmb_write_ine, fmb_sniff_ine},
    {FMB_FORMAT_IEQ, "ieq", fmb_read_ieq, NULL, fmb_sniff_ieq},
    {FMB_FORMAT_SMT2, "smt2", fmb_read_smt2, fmb_write_smt2, fmb_sniff_smt2},
    {FMB_FORMAT_MPS, "mps", fmb_read_mps, fmb_write_mps, fmb_sniff_mps},
    {FMB_FORMAT_LP, "lp", fmb_read_lp, fmb_write_lp, fmb_sniff_lp},
    {FMB_FORMAT_TEXT, "fmb", fmb_read_text, fmb_write_text, NULL},
};

#define TABLE_SIZE (sizeof table / sizeof *table)

const fmb_codec *fmb_codec_of(fmb_format f)
{
    for (size_t i = 0; i < TABLE_SIZE; i++)
        if (table[i].format == f)
            return &table[i];
    return NULL;
}

const fmb_codec *fmb_codec_guess(const fmb_cursor *c)
{
    for (size_t i = 0; i < TABLE_SIZE; i++)
        if (table[i].sniff && table[i].sniff(c))
            return &table[i];
    return fmb_codec_of(FMB_FORMAT_TEXT);
}

const char *fmb_format_text(fmb_format f)
{
    const fmb_codec *codec = fmb_codec_of(f);
    return codec ? codec->name : "auto";
}

bool fmb_format_parse(const char *word, fmb_format *out)
{
    fmb_format f = FMB_FORMAT_AUTO;
    if (!word || !out)
        return false;
    for (size_t i = 0; i < TABLE_SIZE; i++)
        if (strcmp(table[i].name, word) == 0)
            f = table[i].format;
    if (f == FMB_FORMAT_AUTO && strcmp(word, "auto") != 0)
        return false;
    *out = f;
    return true;
}

fmb_format fmb_format_of_name(const char *path)
{
    const char *dot = path ? strrchr(path, '.') : NULL;
    if (!dot || strchr(dot, '/'))
        return FMB_FORMAT_AUTO;
    fmb_span ending = {dot + 1, strlen(dot + 1)};
    for (size_t i = 0; i < TABLE_SIZE; i++)
        if (fmb_span_is_nocase(ending, table[i].name))
            return table[i].format;
    return FMB_FORMAT_AUTO;
}
