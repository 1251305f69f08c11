/* growth.c: twice the text takes about twice the work, for every reader and every kind of long
 * text: many lines, one line of many terms, many names, deep nesting, long numbers. Work is counted
 * (steps.h): a quadratic reader takes four times as much. */
#include <criterion/criterion.h>
#include <stdlib.h>

#include <fmb/gmp.h>
#include <fmb/mesh.h>

#include "steps.h"

/* Twice the text is less than so many times the work: where things are sorted it is n log n, and
 * GMP turns digits into an integer in n log n log log n, and a factor more to reduce a fraction. */
#define FOR_SORTING 2.5
#define FOR_GMP     3.0

/* A text of size n. */
typedef void writer(FILE *out, size_t n);

typedef struct text {
    char *p;
    size_t size;
} text;

static text write_one(writer *w, size_t n)
{
    text t = {NULL, 0};
    FILE *out = open_memstream(&t.p, &t.size);
    w(out, n);
    fclose(out);
    return t;
}

/* Read it; steps. The status is noted. */
typedef uint64_t reader(int kind, text t, fmb_status *st, fmb_where *where);

static uint64_t read_system(int format, text t, fmb_status *st, fmb_where *where)
{
    fmb_reader how = {.size = sizeof how, .format = (fmb_format)format};
    fmb_system *s = NULL;
    steps_start();
    *st = fmb_system_parse(t.p, t.size, &how, &s, where);
    uint64_t steps = steps_stop();
    fmb_system_free(s);
    return steps;
}

static uint64_t read_mesh(int format, text t, fmb_status *st, fmb_where *where)
{
    fmb_mesh *m = NULL;
    steps_start();
    *st = fmb_mesh_parse(t.p, t.size, (fmb_mesh_format)format, NULL, &m, where);
    uint64_t steps = steps_stop();
    fmb_mesh_free(m);
    return steps;
}

static uint64_t read_frames(int kind, text t, fmb_status *st, fmb_where *where)
{
    const fmb_frame_line *line = NULL;
    fmb_frame_reader *r = NULL;
    (void)kind;
    steps_start();
    *st = fmb_frame_reader_from_text(t.p, t.size, NULL, &r);
    do
        *st = *st == FMB_OK ? fmb_frame_reader_next(r, &line, where) : *st;
    while (*st == FMB_OK && line);
    fmb_frame_reader_free(r);
    return steps_stop();
}

typedef struct growing {
    const char *name;
    reader *read;
    int kind;
    writer *write;
    fmb_status status;
} growing;

/* From n to 2 n and from there to 4 n. Where reading ends well all of the text is read: then the
 * count cannot stand still. */
static void expect_linear(const growing *g, size_t n, double most)
{
    uint64_t last = 0;
    for (int k = 0; k < 3; k++, n *= 2) {
        fmb_where where = {0};
        fmb_status st;
        text t = write_one(g->write, n);
        uint64_t steps = g->read(g->kind, t, &st, &where);
        cr_expect_eq(st, g->status, "%s: %ld:%ld: %s", g->name, where.line, where.column,
                     where.text);
        if (k > 0) {
            double ratio = (double)steps / (double)last;
            cr_expect_lt(ratio, most, "%s, %zu: %g times the work", g->name, n, ratio);
            if (g->status == FMB_OK)
                cr_expect_gt(ratio, 1.5, "%s, %zu: %g times the work", g->name, n, ratio);
        }
        last = steps;
        free(t.p);
    }
}

static void expect_all_linear(const growing *g, size_t count, size_t n, double most)
{
    for (size_t i = 0; i < count; i++)
        expect_linear(&g[i], n, most);
}

#define SYSTEM(FORMAT, WRITE)                                                                      \
    {                                                                                              \
#WRITE, read_system, FMB_FORMAT_##FORMAT, WRITE, FMB_OK                                    \
    }
#define WRONG(FORMAT, WRITE)                                                                       \
    {                                                                                              \
#WRITE, read_system, FMB_FORMAT_##FORMAT, WRITE, FMB_ERR_PARSE                             \
    }
#define MESH(FORMAT, WRITE)                                                                        \
    {                                                                                              \
#WRITE, read_mesh, FMB_MESH_##FORMAT, WRITE, FMB_OK                                        \
    }
#define FRAMES(WRITE, STATUS)                                                                      \
    {                                                                                              \
#WRITE, read_frames, 0, WRITE, STATUS                                                      \
    }

/* `each` with the numbers from 0, `times` of them, as its arguments. */
static void repeat(FILE *out, const char *each, size_t times)
{
    for (size_t i = 0; i < times; i++)
        for (const char *p = each; *p; p++)
            if (*p == '#')
                fprintf(out, "%zu", i);
            else
                fputc(*p, out);
}

#define WRITER(NAME, HEAD, EACH, TAIL)                                                             \
    static void NAME(FILE *out, size_t n)                                                          \
    {                                                                                              \
        fputs(HEAD, out);                                                                          \
        repeat(out, EACH, n);                                                                      \
        fputs(TAIL, out);                                                                          \
    }

/* ---- lines ----------------------------------------------------------------------------------- */

WRITER(text_lines, "", "x + 2 y <= #\n", "")
WRITER(text_labels, "", "r#: x + 2 y <= 1\n", "")
WRITER(ieq_lines, "DIM = 2\nINEQUALITIES_SECTION\n", "(#) x1 - 2x2 <= 1\n", "END\n")
WRITER(smt2_lines, "(declare-const x Real)\n", "(assert (< (* 2 x) #))\n", "")
WRITER(mps_lines, "NAME\nROWS\n N o\n", " L r#\n", "COLUMNS\n x o 1\nENDATA\n")
WRITER(lp_lines, "min x st\n", " r#: x + y >= 1\n", "end\n")

static void ine_lines(FILE *out, size_t n)
{
    fprintf(out, "H-representation\nbegin\n %zu 3 rational\n", n);
    repeat(out, " # 1 -2/3\n", n);
    fprintf(out, "end\n");
}

static void off_lines(FILE *out, size_t n)
{
    fprintf(out, "OFF\n%zu %zu 0\n", n + 3, n);
    repeat(out, "# 0.5 1e-3\n", n + 3);
    repeat(out, "3 # 0 1\n", n + 3);
}

WRITER(obj_lines, "v 1 0 0\nv 0 1 0\n", "v 0.5 # 7\nf 1 2 -1\n", "")
WRITER(
    stl_lines, "solid s\n",
    "facet normal 0 0 1\nouter loop\nvertex # 0 0\nvertex 1 # 0\nvertex 0 0 1\nendloop\nendfacet\n",
    "endsolid s\n")
WRITER(frames_lines, "",
       "{\"A\": {\"type\": \"cuboid\", \"orig\": [#], \"comp\": [[1]]}, \"B\": {\"type\": "
       "\"cuboid\", \"orig\": [0.5], \"comp\": []}}\n",
       "")

Test(growth, lines)
{
    static const growing g[] = {
        SYSTEM(TEXT, text_lines), SYSTEM(TEXT, text_labels),   SYSTEM(INE, ine_lines),
        SYSTEM(IEQ, ieq_lines),   SYSTEM(SMT2, smt2_lines),    SYSTEM(MPS, mps_lines),
        SYSTEM(LP, lp_lines),     MESH(OFF, off_lines),        MESH(OBJ, obj_lines),
        MESH(STL, stl_lines),     FRAMES(frames_lines, FMB_OK)};
    expect_all_linear(g, sizeof g / sizeof *g, 1 << 14, FOR_SORTING);
}

/* ---- terms, each with a name of its own ------------------------------------------------------ */

WRITER(text_terms, "0", " + 2 x#", " <= 1\n")
WRITER(text_same_terms, "0", " + 2 x", " <= 1\n")
WRITER(text_names, "vars:", " x#", "\nx0 <= 1\n")
WRITER(smt2_names, "", "(declare-const x# Real)\n", "(assert (< x0 1))")
WRITER(mps_names, "NAME\nROWS\n N o\n L r\nCOLUMNS\n", " x# r 1\n", "RHS\nENDATA\n")
WRITER(lp_terms, "min x0 st 0 x0", " + 2 x#", " <= 1 end\n")

static void ine_terms(FILE *out, size_t n)
{
    fprintf(out, "H-representation\nbegin\n 1 %zu rational\n", n + 1);
    repeat(out, " #", n + 1);
    fprintf(out, "\nend\n");
}

static void ieq_terms(FILE *out, size_t n)
{
    fprintf(out, "DIM = %zu\nINEQUALITIES_SECTION\n", n);
    for (size_t i = 1; i <= n; i++)
        fprintf(out, "+ 2 x%zu ", i);
    fprintf(out, "<= 1\nEND\n");
}

static void smt2_terms(FILE *out, size_t n)
{
    smt2_names(out, n);
    fprintf(out, "(assert (< (+ 0 ");
    repeat(out, " x#", n);
    fprintf(out, ") 1))");
}

static void frames_terms(FILE *out, size_t n)
{
    fprintf(out, "{\"A\": {\"type\": \"cuboid\", \"comp\": [], \"orig\": [0");
    repeat(out, ", #", n);
    fprintf(out, "]}, \"B\": {\"type\": \"cuboid\", \"comp\": [], \"orig\": [0");
    repeat(out, ", #", n);
    fprintf(out, "]}}\n");
}

Test(growth, terms)
{
    static const growing g[] = {
        SYSTEM(TEXT, text_terms), SYSTEM(TEXT, text_same_terms), SYSTEM(TEXT, text_names),
        SYSTEM(SMT2, smt2_names), SYSTEM(MPS, mps_names),        SYSTEM(LP, lp_terms),
        SYSTEM(INE, ine_terms),   SYSTEM(IEQ, ieq_terms),        SYSTEM(SMT2, smt2_terms)};
    static const growing wide = FRAMES(frames_terms, FMB_OK); /* 10,000 numbers at most */
    expect_linear(&wide, 1 << 11, FOR_SORTING);
    expect_all_linear(g, sizeof g / sizeof *g, 1 << 14, FOR_SORTING);
}

/* ---- nesting, up to a depth that a reader may refuse ----------------------------------------- */

WRITER(text_parentheses, "", "(", "x <= 1\n")
WRITER(json_arrays, "{\"note\": ", "[", "")

static void smt2_ands(FILE *out, size_t n)
{
    fprintf(out, "(declare-const x Real)\n(assert ");
    repeat(out, "(and ", n);
    fprintf(out, "(< x 1)");
    repeat(out, ")", n);
    fprintf(out, ")");
}

/* Each term is used twice: written out there were 2^n. */
static void smt2_lets(FILE *out, size_t n)
{
    fprintf(out, "(declare-const x Real)\n(assert (let ((y x)) ");
    repeat(out, "(let ((y (- y 1))) ", n);
    fprintf(out, "(< y 1)");
    repeat(out, ")", n);
    fprintf(out, "))");
}

Test(growth, nesting)
{
    static const growing g[] = {WRONG(TEXT, text_parentheses), FRAMES(json_arrays, FMB_ERR_PARSE),
                                SYSTEM(SMT2, smt2_ands), SYSTEM(SMT2, smt2_lets)};
    expect_all_linear(g, sizeof g / sizeof *g, 1 << 14, FOR_SORTING);
}

/* ---- long numbers ---------------------------------------------------------------------------- */

WRITER(text_digits, "x <= 1", "7", "\n")
WRITER(text_decimals, "x <= 0.", "7", "\n")
WRITER(ine_digits, "H-representation\nbegin\n 1 2 rational\n1 1", "7", "\nend\n")
WRITER(ieq_digits, "DIM = 1\nINEQUALITIES_SECTION\nx1 <= 1", "7", "\nEND\n")
WRITER(smt2_digits, "(declare-const x Real)\n(assert (< x 1", "7", "))")
WRITER(mps_digits, "NAME\nROWS\n N o\n L r\nCOLUMNS\n x r 1", "7", "\nRHS\nENDATA\n")
WRITER(lp_digits, "min x st x <= 1", "7", " end\n")
WRITER(frames_digits, "{\"A\": {\"type\": \"cuboid\", \"comp\": [], \"orig\": [1", "7",
       "]}, \"B\": {\"type\": \"cuboid\", \"comp\": [], \"orig\": [1]}}\n")

Test(growth, digits)
{
    static const growing g[] = {SYSTEM(TEXT, text_digits), SYSTEM(TEXT, text_decimals),
                                SYSTEM(INE, ine_digits),   SYSTEM(IEQ, ieq_digits),
                                SYSTEM(SMT2, smt2_digits), SYSTEM(MPS, mps_digits),
                                SYSTEM(LP, lp_digits),     FRAMES(frames_digits, FMB_OK)};
    expect_all_linear(g, sizeof g / sizeof *g, 1 << 15, FOR_GMP);
}
