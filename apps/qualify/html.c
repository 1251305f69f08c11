/* html.c: see html.h. Pictures are held in data: addresses, each a document of its own, as names
 * inside of an SVG would clash with those of the next one. */
#include "qualify/html.h"

#include <string.h>

static const char STYLE[] =
    "body{font:16px/1.5 sans-serif;max-width:64em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:.5em 0 1.5em;font-size:14px;"
    "font-variant-numeric:tabular-nums}"
    "caption{text-align:left;font-weight:bold;padding:.5em 0}"
    "th,td{padding:.15em .6em;border-bottom:1px solid #ddd;text-align:left;white-space:nowrap}"
    "th{border-bottom:2px solid #888}.r{text-align:right}"
    "figure{margin:1em 0 2em}img{max-width:100%}figcaption{font-size:14px}"
    ".missing{background:#fee;padding:.5em}a{color:#058}"
    ".wide{overflow-x:auto}";

void qualify_html_head(FILE *f, const char *title)
{
    fprintf(f,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<title>%s</title>\n<style>%s</style>\n</head>\n<body>\n<h1>%s</h1>\n",
            title, STYLE, title);
}

void qualify_html_foot(FILE *f)
{
    fputs("</body>\n</html>\n", f);
}

void qualify_html_text(FILE *f, const char *text)
{
    for (; *text; text++)
        switch (*text) {
        case '<':
            fputs("&lt;", f);
            break;
        case '>':
            fputs("&gt;", f);
            break;
        case '&':
            fputs("&amp;", f);
            break;
        case '"':
            fputs("&quot;", f);
            break;
        default:
            fputc(*text, f);
        }
}

void qualify_html_paragraph(FILE *f, const char *text)
{
    fputs("<p>", f);
    qualify_html_text(f, text);
    fputs("</p>\n", f);
}

/* ---- tables ---------------------------------------------------------------------------------- */

static void put_line(FILE *f, const app_table *t, size_t first, const char *tag)
{
    fputs("<tr>", f);
    for (size_t c = 0; c < t->columns; c++) {
        fprintf(f, "<%s%s>", tag, t->align[c] == 'r' ? " class=\"r\"" : "");
        qualify_html_text(f, t->cell[first + c]);
        fprintf(f, "</%s>", tag);
    }
    fputs("</tr>\n", f);
}

void qualify_html_table(FILE *f, const char *caption, const app_table *t, const char *csv)
{
    fputs("<div class=\"wide\"><table>\n<caption>", f);
    qualify_html_text(f, caption);
    if (csv)
        fprintf(f, " <a href=\"%s\">CSV</a>", csv);
    fputs("</caption>\n", f);
    for (size_t i = 0; i + t->columns <= t->cells; i += t->columns)
        put_line(f, t, i, i == 0 ? "th" : "td");
    fputs("</table></div>\n", f);
}

/* ---- pictures -------------------------------------------------------------------------------- */

/* RFC 4648, section 4. */
static void put_base64(FILE *out, FILE *in)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    unsigned char b[3];
    size_t n;
    while ((n = fread(b, 1, sizeof b, in)) > 0) {
        memset(b + n, 0, sizeof b - n);
        unsigned bits = (unsigned)b[0] << 16 | (unsigned)b[1] << 8 | b[2];
        for (size_t i = 0; i < 4; i++)
            fputc(i <= n ? digit[bits >> (18 - 6 * i) & 63] : '=', out);
    }
}

bool qualify_html_figure(FILE *f, const char *caption, const char *path, const char *name)
{
    FILE *svg = fopen(path, "rb");
    if (!svg)
        return false;
    fputs("<figure>\n<img alt=\"", f);
    qualify_html_text(f, caption);
    fputs("\" src=\"data:image/svg+xml;base64,", f);
    put_base64(f, svg);
    fputs("\">\n<figcaption>", f);
    qualify_html_text(f, caption);
    fprintf(f, " <a href=\"%s.svg\">SVG</a> <a href=\"%s.png\">PNG</a></figcaption>\n</figure>\n",
            name, name);
    bool good = !ferror(svg);
    fclose(svg);
    return good;
}
