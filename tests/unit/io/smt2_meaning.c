/* smt2_meaning.c: the meaning of SMT-LIB scripts, as .fmb text: terms, comparisons, connectives,
 * names. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "parse.h"

#define D "(declare-fun x () Real)(declare-fun y () Real)(declare-fun z () Real)"
#define V "vars: x y z\n"

#define CHECK(table) check_meanings(FMB_FORMAT_SMT2, table, sizeof table / sizeof *table)

Test(smt2_meaning, terms)
{
    static const meaning table[] = {
        {D "(assert (<= x y))", V "x - y <= 0\n"},
        {D "(assert (< x y))", V "x - y < 0\n"},
        {D "(assert (>= x y))", V "-x + y <= 0\n"},
        {D "(assert (> x y))", V "-x + y < 0\n"},
        {D "(assert (= x y))", V "x - y = 0\n"},
        {D "(assert (<= 0 x y 1))", V "-x <= 0\n"
                                      "x - y <= 0\n"
                                      "y <= 1\n"},
        {D "(assert (> 3 x y z))", V "x < 3\n"
                                     "-x + y < 0\n"
                                     "-y + z < 0\n"},
        {D "(assert (= x y z))", V "x - y = 0\n"
                                   "y - z = 0\n"},
        {D "(assert (< (+ x y 1) (- z)))", V "x + y + z < -1\n"},
        {D "(assert (<= (- x y 2.50) (* 3 (+ x 1) (/ 1 2))))", V "-1/2 x - y <= 4\n"},
        {D "(assert (<= (/ x 2 3) (/ (- 1) 3)))", V "1/6 x <= -1/3\n"},
        {D "(assert (<= (to_real x) (+ y)))", V "x - y <= 0\n"},
        {D "(assert (= (* 2 3 x) (- (- 4))))", V "6 x = 4\n"},
        {D "(assert (= (* (- x x 3) y) 6))", V "-3 y = 6\n"},
        {D "(assert (<= (- x x) 1))", V "0 <= 1\n"},
    };
    CHECK(table);
}

Test(smt2_meaning, connectives)
{
    static const meaning table[] = {
        {D "(assert (not (<= x y)))", V "-x + y < 0\n"},
        {D "(assert (not (< x y)))", V "-x + y <= 0\n"},
        {D "(assert (not (> x y)))", V "x - y <= 0\n"},
        {D "(assert (not (not (= x y))))", V "x - y = 0\n"},
        {D "(assert (not (or (< x 0) (< y 0) (= 1 2))))", V "-x <= 0\n"
                                                            "-y <= 0\n"},
        {D "(assert (not (and (< x 0))))", V "-x <= 0\n"},
        {D "(assert (not (and (< x 0) true)))", V "-x <= 0\n"},
        {D "(assert (not (=> (and (< x 0) (< y 0)) (< z 0))))", V "x < 0\n"
                                                                  "y < 0\n"
                                                                  "-z <= 0\n"},
        {D "(assert (=> (< x 0) false))", V "-x <= 0\n"},
        {D "(assert (=> true (< y 0) false))", V "-y <= 0\n"},
        {D "(assert (or false (< x 0)))", V "x < 0\n"},
        {D "(assert (or (< x 0) true))", V},
        {D "(assert (xor (< x 0) true))", V "-x <= 0\n"},
        {D "(assert (xor true false (< x 0) true))", V "x < 0\n"},
        {D "(assert (= (< x 0) true))", V "x < 0\n"},
        {D "(assert (= (< x 0) (< y 0) false))", V "-x <= 0\n"
                                                   "-y <= 0\n"},
        {D "(assert (= (< x 0) true (< y 0)))", V "x < 0\n"
                                                  "y < 0\n"},
        {D "(assert (distinct (< x 0) true))", V "-x <= 0\n"},
        {D "(assert (not (distinct x y)))", V "x - y = 0\n"},
        {D "(assert (distinct 1 2))", V},
        {D "(assert (ite true (< x 0) (< y 0)))", V "x < 0\n"},
        {D "(assert (ite (< x 0) (< y 0) false))", V "x < 0\n"
                                                     "y < 0\n"},
        {D "(assert (ite (< x 0) false (< y 0)))", V "-x <= 0\n"
                                                     "y < 0\n"},
        {D "(assert (not (ite (< x 0) (< y 0) true)))", V "x < 0\n"
                                                          "-y <= 0\n"},
        {D "(assert (not (ite (< x 0) true (< y 0))))", V "-x <= 0\n"
                                                          "-y <= 0\n"},
        {D "(assert (< (ite (< 1 2) x y) 0))", V "x < 0\n"},
        {D "(assert (< (ite (< x 2) y y) 0))", V "y < 0\n"},
        {D "(assert true)", V},
        {D "(assert false)", V "0 <= -1\n"},
        {D "(assert (< 1 0))", V "0 < -1\n"},
        {D "(assert (and (< 1 0) (or (< x 0) (< y 0))))", V "0 < -1\n"},
        {D "(assert (and true (<= 0 1) (and (< x 0) (and (< y 0)))))", V "0 <= 1\n"
                                                                         "x < 0\n"
                                                                         "y < 0\n"},
    };
    CHECK(table);
}

Test(smt2_meaning, names)
{
    static const meaning table[] = {
        {D "(assert (let ((a x) (b y)) (< a b)))", V "x - y < 0\n"},
        {D "(assert (let ((x y) (y x)) (< x y)))", V "-x + y < 0\n"},
        {D "(assert (let ((a (+ x 1))) (let ((a (+ a a)) (b a)) (< a b))))", V "x < -1\n"},
        {D "(assert (let ((p (< x y)) (q true)) (and p q p)))", V "x - y < 0\n"
                                                                  "x - y < 0\n"},
        {D "(assert (let ((and x)) (< and 1)))", V "x < 1\n"},
        {D "(assert (! (< x 0) :named first))", V "first: x < 0\n"},
        {D "(assert (! (and (< x 0) (! (< y 0) :named inner :pattern (x y) :foo)) :named outer))",
         V "outer: x < 0\n"
           "inner: y < 0\n"},
        {D "(assert (not (! (< x 0) :named n)))(assert n)", V "n: -x <= 0\n"
                                                              "x < 0\n"},
        {D "(assert (< (! (+ x 1) :named t) y))(assert (< t 0))", V "x - y < -1\n"
                                                                    "x < -1\n"},
        {D "(declare-const |x y| Real)(assert (< |x y| |x|))", "vars: x y z \"x y\"\n"
                                                               "-x + \"x y\" < 0\n"},
        {D "(declare-const ?v!0 Real)(assert (< ?v!0 3))", "vars: x y z \"?v!0\"\n"
                                                           "\"?v!0\" < 3\n"},
        {D "(define-fun f () Real (+ x y))(assert (< f f))(assert (< f 0))", V "0 < 0\n"
                                                                               "x + y < 0\n"},
        {D "(define-fun p () Bool (< x y))(assert (not p))", V "-x + y <= 0\n"},
        {D "(define-fun f ((a Real) (b Real)) Real (* a b))(assert (< (f 2 x) (f y 3)))",
         V "2 x - 3 y < 0\n"},
        {D "(define-fun f ((x Real)) Real (+ x y))(assert (let ((y 5)) (< (f z) y)))",
         V "y + z < 5\n"},
        {D "(define-fun imp ((a Bool) (b Bool)) Bool (=> a b))(assert (imp true (< x 0)))(assert "
           "(not (imp (< x 0) (< y 0))))",
         V "x < 0\n"
           "x < 0\n"
           "-y <= 0\n"},
        {D "(define-fun f ((a Real)) Real (+ a 1))(define-fun g ((a Real)) Real (f (f a)))(assert "
           "(< (g (f x)) 0))",
         V "x < -3\n"},
        {D "(define-sort R () Real)(declare-fun w () R)(define-const c R 3)(assert (< w c))",
         "vars: x y z w\n"
         "w < 3\n"},
        {D "(assert (< x 1))(check-sat)(get-model)(get-value (x (+ x y)))(exit)(nonsense",
         V "x < 1\n"},
        {D "(declare-fun b () Bool)(assert (< x 0))", V "x < 0\n"},
    };
    CHECK(table);
}

/* Commands that ask, set or print; comments; nothing after exit. */
Test(smt2_meaning, commands)
{
    static const meaning table[] = {
        {"(set-logic QF_LRA) ; comment )\n(set-info :source |a ( b|)(set-option :x \"a \"\" ) b\")"
         "(echo \"hi\")(declare-const x Real)(assert (< x 1))(check-sat)(get-model)"
         "(get-value (x (+ x 1)))(exit)(nonsense",
         "vars: x\nx < 1\n"},
        {"(declare-const a Int)(declare-const b Bool)(minimize a)(assert (>= (* 2 a) 1))",
         "vars: a\ninteger: a\nmin: a\n-2 a <= -1\n"},
        {"(declare-const x Real)(declare-const y Real)(maximize (+ (* 2 (- x y)) (let ((z y)) z) 7)"
         ":id goal)(minimize x)(check-sat)",
         "vars: x y\nmax: 2 x - y + 7\n"},
        {"(declare-const c Bool)(declare-const x Real)(maximize (ite c x 3))(assert c)",
         "vars: x\nmax: x\n"},
        {"\r\n(declare-const x Real)\r\n\t(assert\f(< x\v1))\r\n", "vars: x\nx < 1\n"},
    };
    CHECK(table);
}

/* Each level doubles what is shared: work must not. */
Test(smt2_meaning, sharing)
{
    char *text = NULL;
    size_t size = 0, levels = 2000;
    FILE *f = open_memstream(&text, &size);
    fputs("(declare-const x Real)(assert (let ((p0 (< x 0))) ", f);
    for (size_t i = 1; i <= levels; i++)
        fprintf(f, "(let ((p%zu (and p%zu p%zu))) ", i, i - 1, i - 1);
    fprintf(f, "p%zu", levels);
    for (size_t i = 0; i <= levels; i++)
        fputc(')', f);
    fputs(")(assert (let ((t0 x)) ", f);
    for (size_t i = 1; i <= 100; i++)
        fprintf(f, "(let ((t%zu (+ t%zu t%zu))) ", i, i - 1, i - 1);
    fputs("(<= t100 0)", f);
    for (size_t i = 0; i <= 100; i++)
        fputc(')', f);
    fputc(')', f);
    fclose(f);
    fmb_system *s = parse(FMB_FORMAT_SMT2, text, size);
    mpq_t q;
    mpq_init(q);
    cr_expect(fmb_system_rows(s) == 3);
    fmb_system_term_q(s, 2, 0, q);
    cr_expect(mpz_sizeinbase(mpq_numref(q), 2) == 101 && mpz_scan1(mpq_numref(q), 0) == 100);
    mpq_clear(q);
    fmb_system_free(s);
    free(text);
}

/* A sum longer than what is copied goes by reference, and cancels none the less. */
Test(smt2_meaning, long_sums)
{
    char *text = NULL;
    size_t size = 0;
    FILE *f = open_memstream(&text, &size);
    for (int j = 0; j < 20; j++)
        fprintf(f, "(declare-const x%d Real)", j);
    for (int k = 0; k < 2; k++) {
        fprintf(f, "(define-fun s%d () Real (+ 1", k);
        for (int j = 0; j < 20; j++)
            fprintf(f, " (* %d x%d)", j + 1, j);
        fputs("))", f);
    }
    fputs("(assert (<= (- (* 3 s0) s1 s1) x0))"
          "(assert (<= (* (- (+ s0 2) s1) x1) 6))"
          "(assert (<= (/ x2 (- s0 s1 4)) (- (+ s0 s0) s1 s0)))",
          f);
    fclose(f);
    fmb_system *s = parse(FMB_FORMAT_SMT2, text, size);
    char *says = write_text(s, FMB_FORMAT_TEXT);
    const char *rows = strchr(says, '\n') + 1;
    cr_expect(strncmp(rows, "2 x1 + 3 x2 + ", 14) == 0 && strstr(rows, " + 20 x19 <= -1\n"), "%s",
              rows);
    cr_expect(strstr(rows, "\n2 x1 <= 6\n-1/4 x2 <= 0\n"), "%s", rows);
    free(says);
    fmb_system_free(s);
    free(text);
}

/* ---- warnings -------------------------------------------------------------------------------- */

/* What assertions say of Boolean unknowns holds everywhere, whichever comes first. */
Test(smt2_meaning, boolean_unknowns)
{
#define B "(declare-const b Bool)(declare-const c Bool)(declare-const d Bool)" D
    static const meaning table[] = {
        {B "(assert b)", V},
        {B "(assert (and (not b) (= c true)))", V},
        {B "(assert (not b))(assert (ite b (< x 1) (< y 1)))", V "y < 1\n"},
        {B "(assert (< z 0))(assert (ite b (< x 1) (< y 1)))(assert b)", V "z < 0\nx < 1\n"},
        {B "(assert (< (* (ite b 2 3) x) (ite c 4 5)))(assert (= b true))(assert (not c))",
         V "2 x < 5\n"},
        {B "(define-fun k () Real (ite b 1 2))(define-fun f ((t Real)) Bool (< t k))"
           "(assert (f x))(assert (! (f y) :named l))(assert (not b))",
         V "x < 2\nl: y < 2\n"},
        {B "(assert (let ((k (or b c))) (ite k (< x 1) (< y 1))))(assert (not (or b c)))",
         V "y < 1\n"},
        {B "(assert (=> b (< x 1)))(assert (=> c b))(assert (=> d c))(assert d)", V "x < 1\n"},
        {B "(assert (xor b c))(assert (= c (not d)))(assert d)(assert (or (not b) (< x 1)))",
         V "x < 1\n"},
        {B "(assert (= b (< x 1)))(assert (not b))", V "-x <= -1\n"},
        {B "(assert (and b (or (not b) (< x 1))))", V "x < 1\n"},
        {B "(assert b)(assert (! (not b) :named no))", V "no: 0 <= -1\n"},
        {B "(assert (and b (not b)))", V "0 <= -1\n"},
        {B "(assert (let ((k b)) (and (not k) (< x 1) k)))", V "x < 1\n0 <= -1\n"},
    };
    CHECK(table);
}

Test(smt2_meaning, warnings)
{
    warnings h =
        parse_warnings(FMB_FORMAT_SMT2, "(declare-const x Real)(assert (< x 1))(check-sat)");
    cr_expect(h.n == 0);
    h = parse_warnings(FMB_FORMAT_SMT2,
                       "(declare-const a Int)\n(declare-fun b () Int)(assert (< a b))");
    cr_expect(h.n == 0); /* a mark, not a warning */
    h = parse_warnings(FMB_FORMAT_SMT2,
                       "(declare-const x Real)(check-sat)\n (assert (< x 1))(assert (< x 2))");
    cr_expect(h.n == 1 && h.at[0].line == 2 && h.at[0].column == 2 &&
              strstr(h.at[0].text, "after a check-sat"));
    h = parse_warnings(FMB_FORMAT_SMT2, "(declare-const x Real)(maximize x)");
    cr_expect(h.n == 0);
    h = parse_warnings(FMB_FORMAT_SMT2,
                       "(declare-const x Real)(maximize x)\n (minimize x)(assert (< x 2))");
    cr_expect(h.n == 1 && h.at[0].line == 2 && h.at[0].column == 2 &&
              strstr(h.at[0].text, "another objective"));
}

/* Int is a mark, which text and scripts keep. */
Test(smt2_meaning, integers)
{
    static const char text[] = "(declare-const a Int)(declare-fun b () Real)(declare-fun c () Int)"
                               "(assert (<= (+ (to_real a) (* 2 b) (/ c 2)) 1))";
    static const fmb_format through[] = {FMB_FORMAT_TEXT, FMB_FORMAT_SMT2};
    fmb_system *s = parse(FMB_FORMAT_SMT2, text, sizeof text - 1);
    for (size_t k = 0; k < 2; k++) {
        char *written = write_text(s, through[k]);
        fmb_system *back = parse(through[k], written, strlen(written));
        cr_expect(same_system(s, back, true), "%s", written);
        for (int j = 0; j < 3; j++)
            cr_expect(fmb_system_is_integer(back, j) == (j != 1), "%s", written);
        fmb_system_free(back);
        free(written);
    }
    fmb_system_free(s);
}
