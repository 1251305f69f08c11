/* frames.c: pairs of frames from text: their numbers, and the places of errors. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include <fmb/gmp.h>

#include "counted_clock.h"
#include "frame_reading.h"
#include "parse.h"

#define LINE 1024

/* ---- what they say --------------------------------------------------------------------------- */

Test(frames, numbers)
{
    static const char text[] =
        "\xEF\xBB\xBF{\"id\": \"one\", \"A\": {\"type\": \"cuboid\", \"vel\": [0, 0.0, -0e5], "
        "\"comp\": [[1e-2, \"-1/3\", 0.125], [\"0.5/1.5\", 2E+1, -3]], \"orig\": [0.1, -7, 12]}, "
        "\"note\": {\"vel\": [[{}]], \"x\": [true, false, null, 1e999999, \"\\\"\\u12aF\"]},\r\n"
        "\n  \t\r\n"
        "{\"B\": {\"t\\u0079pe\": \"tetrahedron\", \"orig\": [0.5], \"comp\": [], \"vel\": [3]}, "
        "\"A\": {\"type\": \"simplex\", \"orig\": [1], \"comp\": [[-0.25]], \"vel\": null}, "
        "\"id\": 17}";
    const char *broken = strchr(text, '\n');
    /* the first line lacks its B */
    frame_reading a = frame_reading_begin(text, (size_t)(broken - text), NULL);
    const fmb_frame_line *line = NULL;
    fmb_where w = {0};
    cr_expect_eq(fmb_frame_reader_next(a.r, &line, &w), FMB_ERR_PARSE);
    cr_expect(w.line == 1 && strstr(w.text, "key in quotes, found"), "%ld: %s", w.line, w.text);
    frame_reading_end(&a);
    a = frame_reading_begin(text, sizeof text - 1, NULL);
    cr_expect_eq(fmb_frame_reader_next(a.r, &line, &w), FMB_ERR_PARSE);
    line = frame_reading_next(&a);
    cr_assert(line);
    cr_expect_eq(line->number, 4);
    cr_expect_str_eq(line->id, "17");
    cr_expect_eq(line->dim, 1);
    cr_expect(line->are_doubles);
    cr_expect_eq(line->body[0].frame.shape, FMB_SIMPLEX);
    cr_expect_null(line->body[0].frame.speed);
    cr_expect_null(line->frame[0].speed);
    expect_rationals(line->body[0].frame.axes, (const char *[]){"-1/4"}, 1);
    cr_expect_eq(line->frame[0].axes[0], -0.25);
    cr_expect_eq(line->body[1].frame.naxes, 0);
    expect_rationals(line->body[1].frame.speed, (const char *[]){"3"}, 1);
    cr_expect_eq(line->frame[1].speed[0], 3);
    cr_expect_null(frame_reading_next(&a));
    cr_expect_null(frame_reading_next(&a));
    frame_reading_end(&a);
}

#define POINT "{\"type\": \"cuboid\", \"orig\": [0, 0, 0], \"comp\": []}"

Test(frames, rationals)
{
    static const char text[] =
        "{\"A\": {\"type\": \"cuboid\", \"vel\": [0, 0.0, -0e5], \"comp\": [[1e-2, \"-1/3\", "
        "0.125], [\"0.5/1.5\", 2E+1, -3]], \"orig\": [0.1, -7, 12]}, \"B\": " POINT "}\n";
    frame_reading a = frame_reading_begin(text, sizeof text - 1, NULL);
    const fmb_frame_line *line = frame_reading_next(&a);
    cr_assert(line && !line->id && !line->are_doubles);
    const fmb_frame_q *f = &line->body[0].frame;
    cr_expect(f->dim == 3 && f->naxes == 2 && f->shape == FMB_CUBOID);
    cr_expect_null(f->speed, "a speed of 0 is none");
    expect_rationals(f->axes, (const char *[]){"1/100", "-1/3", "1/8", "1/3", "20", "-3"}, 6);
    expect_rationals(f->origin, (const char *[]){"1/10", "-7", "12"}, 3);
    frame_reading_end(&a);
}

/* The double nearest to a decimal: ties to even, denormals, the largest. */
Test(frames, nearest)
{
    static const char text[] =
        "{\"A\": {\"type\": \"cuboid\", \"orig\": [0.1, 9007199254740993, -9007199254740995], "
        "\"comp\": [[5e-324, 2.4703282292062327e-324, 2.4703282292062328e-324], "
        "[1.7976931348623157e308, -0.3, 1e22], [\"1/3\", 1e-400, 123456789.123456789]]}, "
        "\"B\": " POINT "}";
    static const double want[] = {0.1,
                                  9007199254740992,
                                  -9007199254740996,
                                  0x1p-1074,
                                  0,
                                  0x1p-1074,
                                  1.7976931348623157e308,
                                  -0.3,
                                  1e22,
                                  1.0 / 3,
                                  0,
                                  123456789.123456789};
    for (int nearest = 0; nearest < 2; nearest++) {
        frame_reading a =
            frame_reading_begin(text, sizeof text - 1,
                                &(fmb_reader){.size = sizeof(fmb_reader), .nearest = nearest != 0});
        const fmb_frame_line *line = frame_reading_next(&a);
        mpq_t q;
        mpq_init(q);
        cr_assert_eq(line->are_doubles, nearest != 0);
        cr_expect_eq(line->body[0].frame.origin == NULL, nearest != 0, "not before they are asked");
        cr_assert_eq(fmb_frame_reader_rationals(a.r), FMB_OK);
        for (int i = 0; i < 12; i++) {
            double d = i < 3 ? line->frame[0].origin[i] : line->frame[0].axes[i - 3];
            cr_expect_eq(d, want[i], "%d: %.17g", i, d);
            mpq_set_d(q, d);
            if (nearest)
                cr_expect(mpq_equal(q, i < 3 ? line->body[0].frame.origin[i]
                                             : line->body[0].frame.axes[i - 3]));
        }
        mpq_clear(q);
        frame_reading_end(&a);
    }
}

Test(frames, polytopes_nearest)
{
    static const char text[] =
        "{\"A\": {\"rows\": [{\"relation\": \"<\", \"rhs\": 0.1, \"coefficients\": [\"1/3\"]}], "
        "\"type\": \"polytope\"}, \"B\": {\"type\": \"cuboid\", \"orig\": [0.1], \"comp\": []}}";
    frame_reading a = frame_reading_begin(
        text, sizeof text - 1, &(fmb_reader){.size = sizeof(fmb_reader), .nearest = true});
    const fmb_frame_line *line = frame_reading_next(&a);
    mpq_t q, want;
    mpq_inits(q, want, NULL);
    cr_assert_eq(fmb_frame_reader_rationals(a.r), FMB_OK);
    cr_assert(line->body[0].rows && !line->are_doubles && line->dim == 1);
    fmb_system_term_q(line->body[0].rows, 0, 0, q);
    mpq_set_d(want, 1.0 / 3);
    cr_expect(mpq_equal(q, want));
    fmb_system_rhs_q(line->body[0].rows, 0, q);
    mpq_set_d(want, 0.1);
    cr_expect(mpq_equal(q, want) && mpq_equal(line->body[1].frame.origin[0], want));
    mpq_clears(q, want, NULL);
    frame_reading_end(&a);
}

/* Lines of many lengths, so that they end at any place of what is fetched at once; the last one may
 * have no end, and bytes that are NUL are found where they are. */
Test(frames, lengths_of_lines)
{
    static const char pair[] = "{\"A\": " POINT ", \"B\": " POINT "}";
    static char text[3 * 5000];
    for (size_t n = sizeof pair; n < 4200;
         n = n < 1000 || (n > 1060 && n < 2020) ? n + 97 : n + 1) {
        for (size_t i = 0; i < 3; i++) {
            memset(text + i * n, ' ', n);
            memcpy(text + i * n, pair, sizeof pair - 1);
            text[(i + 1) * n - 1] = '\n';
        }
        text[2 * n - 2] = '\0';
        frame_reading a = frame_reading_begin(text, 3 * n - n % 2, NULL);
        const fmb_frame_line *line = frame_reading_next(&a);
        fmb_where w = {0};
        cr_assert(line && line->number == 1, "%zu", n);
        cr_assert(fmb_frame_reader_next(a.r, &line, &w) == FMB_ERR_PARSE && w.line == 2 &&
                      w.column == (long)n - 1,
                  "%zu: %ld:%ld", n, w.line, w.column);
        line = frame_reading_next(&a);
        cr_assert(line && line->number == 3 && !frame_reading_next(&a), "%zu", n);
        frame_reading_end(&a);
    }
}

Test(frames, polytopes)
{
    static const char text[] =
        "{\"A\": {\"rows\": [{\"relation\": \"<\", \"rhs\": \"1/2\", \"coefficients\": [1, 0, "
        "0.1]}, {\"coefficients\": [0, 1, 0], \"relation\": \"=\", \"rhs\": -2, \"label\": "
        "\"x\"}], \"type\": \"polytope\"}, \"B\": " POINT "}";
    frame_reading a = frame_reading_begin(text, sizeof text - 1, NULL);
    const fmb_frame_line *line = frame_reading_next(&a);
    cr_assert(line->body[0].rows && !line->body[1].rows && !line->are_doubles);
    char *rows = write_text(line->body[0].rows, FMB_FORMAT_TEXT);
    cr_expect_str_eq(rows, "vars: x1 x2 x3\nx1 + 1/10 x3 < 1/2\nx2 = -2\n");
    free(rows);
    for (int contact = 0; contact < 2; contact++) {
        fmb_system *s = NULL;
        cr_assert_eq(fmb_system_from_line(line, (fmb_contact)contact, NULL, &s), FMB_OK);
        cr_expect_eq(fmb_system_dim(s), 3);
        cr_expect_eq(fmb_system_rows(s), 5u);
        cr_expect_eq(fmb_system_rel(s, 3), FMB_LT);
        cr_expect_eq(fmb_system_rel(s, 4), FMB_EQ);
        fmb_system_free(s);
    }
    frame_reading_end(&a);
}

/* ---- where they go wrong --------------------------------------------------------------------- */

static void check_complaint(const char *path, long row, long column, const char *piece)
{
    FILE *in = fopen(path, "rb");
    fmb_frame_reader *r = NULL;
    const fmb_frame_line *line = NULL;
    fmb_where w = {0};
    cr_assert(in, "%s is missing", path);
    cr_assert_eq(fmb_frame_reader_new(in, NULL, &r), FMB_OK);
    fmb_status st;
    do
        st = fmb_frame_reader_next(r, &line, &w);
    while (st == FMB_OK && line);
    cr_expect(st == FMB_ERR_PARSE, "%s is read", path);
    cr_expect(w.line == row && w.column == column && strstr(w.text, piece),
              "%s complains at %ld:%ld: %s\nnot at %ld:%ld: %s", path, w.line, w.column, w.text,
              row, column, piece);
    cr_expect_eq(fmb_frame_reader_next(r, &line, NULL), FMB_OK, "the next line is another matter");
    fmb_frame_reader_free(r);
    fclose(in);
}

Test(frames, complaints)
{
    char text[LINE], name[LINE / 2], path[LINE], piece[LINE];
    long row, column;
    int count = 0;
    FILE *list = fopen(TESTS_BAD "/frames.tsv", "r");
    cr_assert(list);
    while (fgets(text, sizeof text, list)) {
        if (*text == '#')
            continue;
        cr_assert_eq(sscanf(text, "%511[^\t]\t%ld\t%ld\t%1023[^\n]", name, &row, &column, piece), 4,
                     "%s", text);
        snprintf(path, sizeof path, "%s/%s", TESTS_BAD, name);
        check_complaint(path, row, column, piece);
        count++;
    }
    fclose(list);
    cr_expect(count >= 45, "%d", count);
}

Test(frames, arguments)
{
    fmb_frame_reader *r = NULL;
    fmb_system *s = NULL;
    const fmb_frame_line *line = NULL;
    cr_expect_eq(fmb_frame_reader_new(NULL, NULL, &r), FMB_ERR_ARG);
    cr_expect_eq(fmb_frame_reader_new(stdin, NULL, NULL), FMB_ERR_ARG);
    cr_expect_eq(fmb_frame_reader_next(NULL, &line, NULL), FMB_ERR_ARG);
    fmb_where w = {.line = 3};
    cr_expect(fmb_frame_reader_next(NULL, &line, &w) == FMB_ERR_ARG && strstr(w.text, "reader") &&
              w.line == 0);
    cr_expect_eq(fmb_system_from_line(NULL, FMB_CONTACT_CLOSED, NULL, &s), FMB_ERR_ARG);
    fmb_frame_reader_free(NULL);
    FILE *in = fopen(TESTS_BAD, "rb"); /* a folder opens, but cannot be read */
    cr_assert(in);
    cr_assert_eq(fmb_frame_reader_new(in, NULL, &r), FMB_OK);
    cr_expect_eq(fmb_frame_reader_next(r, &line, NULL), FMB_ERR_IO);
    fmb_frame_reader_free(r);
    fclose(in);
}

/* A reader that was cancelled gives no line more; limits hold for the system of a line. */
Test(frames, limits)
{
    static const char text[] =
        "{\"A\": " POINT ", \"B\": " POINT "}\n{\"A\": " POINT ", \"B\": " POINT "}\n";
    frame_reading a = frame_reading_begin(text, sizeof text - 1, NULL);
    const fmb_frame_line *line = NULL;
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_system *s = NULL;
    fmb_stop stop = FMB_STOP_ROWS;
    cr_assert(fmb_frame_reader_next(a.r, &line, NULL) == FMB_OK && line);
    for (int limit = 0; limit < 4; limit++) {
        static const fmb_stop due[] = {FMB_STOP_DONE, FMB_STOP_TIME, FMB_STOP_BYTES,
                                       FMB_STOP_CANCELLED};
        o.max_seconds = limit == 1 ? 1 : 0;
        o.max_bytes = limit == 2 ? 10 : 0;
        cr_assert_eq(fmb_solver_new(&o, NULL, &v), FMB_OK);
        if (limit == 3)
            fmb_solver_cancel(v);
        for (int in = FMB_COORDINATES_WORLD; in <= FMB_COORDINATES_ALL; in++) {
            counted_clock_start(0, NULL, NULL);
            fmb_status st = fmb_system_from_line_within(line, (fmb_coordinates)in,
                                                        FMB_CONTACT_CLOSED, v, &s, &stop);
            counted_clock_stop();
            cr_expect_eq(st, FMB_OK);
            cr_expect(stop == due[limit] && (limit > 0) == (s == NULL), "limit %d: %s", limit,
                      fmb_stop_text(stop));
            fmb_system_free(s);
            s = NULL;
        }
        fmb_solver_free(v);
    }
    cr_expect_eq(
        fmb_system_from_line_within(line, FMB_COORDINATES_ALL, FMB_CONTACT_CLOSED, NULL, &s, &stop),
        FMB_ERR_ARG);
    fmb_frame_reader_cancel(a.r);
    cr_expect(fmb_frame_reader_next(a.r, &line, NULL) == FMB_OK && !line);
    fmb_frame_reader_cancel(NULL);
    frame_reading_end(&a);
}

/* A line beyond the limit is an error; the next one is read. */
Test(frames, longest_line)
{
    static const char text[] =
        "{\"A\": " POINT ", \"B\": " POINT "}\n{\"A\": " POINT ", \"B\":         " POINT
        "}\n{\"A\": " POINT ", \"B\": " POINT "}\n";
    size_t most = (size_t)(strchr(text, '\n') - text) + 1;
    frame_reading a = frame_reading_begin(
        text, sizeof text - 1, &(fmb_reader){.size = sizeof(fmb_reader), .max_bytes = most});
    const fmb_frame_line *line = NULL;
    fmb_where w = {0};
    cr_expect(fmb_frame_reader_next(a.r, &line, &w) == FMB_OK && line->number == 1);
    cr_expect(fmb_frame_reader_next(a.r, &line, &w) == FMB_ERR_PARSE && w.line == 2 &&
              strstr(w.text, "expected at most"));
    cr_expect(fmb_frame_reader_next(a.r, &line, &w) == FMB_OK && line && line->number == 3);
    cr_expect(fmb_frame_reader_next(a.r, &line, &w) == FMB_OK && !line);
    frame_reading_end(&a);
}

/* Whichever request fails: nothing is lost. */
Test(frames, memory)
{
    static const char text[] =
        "{\"id\": \"x\", \"A\": {\"type\": \"polytope\", \"rows\": [{\"coefficients\": [1, 2, 3], "
        "\"relation\": \"<\", \"rhs\": 1}]}, \"B\": " POINT "}\n{}\n";
    fmb_status st = FMB_ERR_MEMORY;
    for (size_t k = 0; st == FMB_ERR_MEMORY; k++) {
        countdown c = {.left = k};
        fmb_alloc mem = countdown_alloc(&c);
        FILE *in = fmemopen((void *)(uintptr_t)text, sizeof text - 1, "rb");
        fmb_frame_reader *r = NULL;
        const fmb_frame_line *line = NULL;
        st = fmb_frame_reader_new(in, &(fmb_reader){.size = sizeof(fmb_reader), .mem = &mem}, &r);
        while (st == FMB_OK && (!line || line->number < 2)) {
            fmb_system *s = NULL;
            st = fmb_frame_reader_next(r, &line, NULL);
            if (st == FMB_OK)
                st = fmb_system_from_line(line, FMB_CONTACT_CLOSED, &mem, &s);
            fmb_system_free(s);
        }
        fmb_frame_reader_free(r);
        cr_assert_eq(c.live, 0, "%zu bytes lost when request %zu failed", c.live, k);
        fclose(in);
    }
    cr_expect_eq(st, FMB_ERR_PARSE);
}

/* A megabyte, less under sanitizers, of anything is refused, and not by running out of stack. */
Test(frames, megabyte)
{
    static const char *const unit[] = {"[", "{\"a\": ", "1", "\"", "[1],", "1e99999,", " "};
    for (size_t u = 0; u < sizeof unit / sizeof *unit; u++) {
        size_t n = strlen(unit[u]), most = ((size_t)1 << 20) / WATCHED, at = 0;
        char *text = malloc(most + 64);
        at += (size_t)sprintf(text, "{\"A\": {\"type\": \"cuboid\", \"orig\": [");
        for (; at + n < most; at += n)
            memcpy(text + at, unit[u], n);
        frame_reading a = frame_reading_begin(text, at, NULL);
        const fmb_frame_line *line = NULL;
        cr_expect_eq(fmb_frame_reader_next(a.r, &line, NULL), FMB_ERR_PARSE);
        frame_reading_end(&a);
        free(text);
    }
}
