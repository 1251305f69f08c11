/* smt2_mistakes.c: SMT-LIB scripts that are refused: no conjunction, not linear, malformed; the
 * place of the error, and failing allocations. */
#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

#include "parse.h"

#define D "(declare-fun x () Real)(declare-fun y () Real)\n"

#define B "(declare-const b Bool)(declare-const c Bool)" D

#define CHECK(table) check_mistakes(FMB_FORMAT_SMT2, table, sizeof table / sizeof *table)

Test(smt2_mistakes, not_a_conjunction)
{
    static const mistake table[] = {
        {D "(assert (or (< x 0) (< y 0)))", 2, 9, "not a conjunction: 'or'"},
        {D "(assert (and (< x 0)\n (or (< x 0) (< y 0))))", 3, 2, "not a conjunction: 'or'"},
        {D "(assert (not (and (< x 0) (< y 0))))", 2, 14, "not a conjunction: 'and'"},
        {D "(assert (not (< x y 0)))", 2, 14, "not a conjunction: '<'"},
        {D "(assert (not (= x y)))", 2, 14, "not a conjunction: the negation of '='"},
        {D "(assert (distinct x y))", 2, 9, "not a conjunction: the negation of '='"},
        {D "(assert (distinct x y 1))", 2, 9, "not a conjunction: 'distinct'"},
        {D "(assert (=> (< x 0) (< y 0)))", 2, 9, "not a conjunction: '=>'"},
        {D "(assert (not (=> (< x 0) (and (< x 0) (< y 0)))))", 2, 26, "not a conjunction: 'and'"},
        {D "(assert (xor (< x 0) (< y 0)))", 2, 9, "not a conjunction: 'xor'"},
        {D "(assert (= (< x 0) (< y 0)))", 2, 9, "not a conjunction: '='"},
        {D "(assert (ite (< x 0) (< y 0) (< y 1)))", 2, 9, "not a conjunction: 'ite'"},
        {D "(assert (ite (< x 0) (< y 0) true))", 2, 9, "not a conjunction: 'ite'"},
        {D "(assert (< (ite (< x 0) x y) 0))", 2, 12, "not a conjunction: 'ite'"},
        {D "(assert (forall ((z Real)) (< z x)))", 2, 9, "not a conjunction: a quantifier"},
        {D "(assert (exists ((z Real)) (< z x)))", 2, 9, "not a conjunction: a quantifier"},
        {B "(assert (ite b (< x 1) (< y 1)))", 2, 9, "not a conjunction: 'ite' here"},
        {B "(assert (or b (< x 1)))(assert c)", 2, 9, "not a conjunction: 'or' here"},
        {B "(assert (or b c))(assert (or b (< x 1)))", 2, 9, "not a conjunction: 'or' here"},
        {B "(assert (= b c))", 2, 9, "not a conjunction: '=' between formulas"},
        {B "(assert (< x (ite b 1 2)))(assert (< z 1))(assert c)", 2, 14, "not a conjunction"},
        {B "(assert (< x (ite b 1 2)))(assert (< z 1))(assert b)", 2, 38,
         "declared name, found 'z"},
        {B "(assert (or b (< x 1)))(assert (not b)", 2, 9, "not a conjunction: 'or' here"},
        {D "(assert (let ((p (or (< x 0) (< y 0)))) (and p (< x 1))))", 2, 18,
         "not a conjunction: 'or'"},
    };
    CHECK(table);
}

/* What is not asked for may be anything. */
Test(smt2_mistakes, unused)
{
    static const meaning table[] = {
        {D "(assert (let ((p (or (< x 0) (< y 0)))) (< x 1)))", "vars: x y\nx < 1\n"},
        {"(declare-fun b () Bool)(declare-const x Real)(assert (or b true))", "vars: x\n"},
        {D "(define-fun f ((a Real)) Real (* a a))(assert (< (f 3) x))", "vars: x y\n-x < -9\n"},
    };
    check_meanings(FMB_FORMAT_SMT2, table, sizeof table / sizeof *table);
}

Test(smt2_mistakes, not_linear)
{
    static const mistake table[] = {
        {D "(assert (< (* x y) 0))", 2, 12, "not linear: expected a product"},
        {D "(assert (< (* 2 x 3 x) 0))", 2, 12, "not linear: expected a product"},
        {D "(assert (< (/ 1 x) 0))", 2, 17, "not linear: expected a number as divisor"},
        {D "(assert (< (/ x 0) 0))", 2, 17, "a divisor other than zero"},
        {D "(assert (< (/ x (- 1 1)) 0))", 2, 17, "a divisor other than zero"},
        {D "(assert (< (mod x 2) 0))", 2, 12, "not linear: 'mod'"},
        {D "(assert (< (abs x) 0))", 2, 12, "not linear: 'abs'"},
        {"(declare-fun f (Real) Real)", 1, 17, "unknown functions are not linear"},
    };
    CHECK(table);
}

Test(smt2_mistakes, scripts)
{
    static const mistake table[] = {
        {"x", 1, 1, "expected '(' of a command"},
        {"((", 1, 2, "expected a command"},
        {"(check-sat", 1, 1, "expected ')' to match"},
        {"(check-sat))", 1, 12, "expected '(' of a command"},
        {"(frobnicate)", 1, 2, "expected a command that can be read"},
        {"(push 1)", 1, 1, "expected one question a script"},
        {"(reset)", 1, 1, "expected one question a script"},
        {"(declare-sort S 0)", 1, 2, "expected a command that can be read"},
        {"(declare-fun x () String)", 1, 19, "expected the sort Real, Int or Bool"},
        {"(declare-fun x Real)", 1, 16, "expected '(' and ')'"},
        {"(declare-fun x () Real)(declare-fun |x| () Real)", 1, 37, "expected a new name"},
        {"(declare-fun + () Real)", 1, 14, "expected a new name"},
        {"(declare-fun || () Real)", 1, 14, "expected a name that is not empty"},
        {"(declare-const 3x Real)", 1, 16, "expected a number or a name"},
        {"(define-fun f ((x Real) Real x)", 1, 25, "expected '(' of a parameter"},
        {"(define-fun f ((x Real)) Real)", 1, 30, "expected the body"},
        {"(define-fun f () Real true)", 1, 23, "expected a number, found a formula"},
        {"(define-sort S (T) Real)", 1, 17, "sorts with parameters"},
        {"(define-sort Real () Int)", 1, 14, "expected a new name for a sort"},
        {"(set-info :a \"b", 1, 14, "to end this string"},
        {"(set-info :a |b", 1, 14, "to end this symbol"},
        {"(set-info :a |b\\c|)", 1, 16, "no '\\'"},
        {"(set-info :a :)", 1, 14, "expected '(', ')', a name or a number"},
        {"(set-info :a [)", 1, 14, "expected '(', ')', a name or a number"},
    };
    CHECK(table);
}

Test(smt2_mistakes, terms)
{
    static const mistake table[] = {
        {D "(assert)", 2, 8, "expected a term, found ')'"},
        {D "(assert x)", 2, 9, "expected a formula, found a number"},
        {D "(assert (< x 0) 1)", 2, 17, "expected ')' to end the command"},
        {D "(assert (< x w))", 2, 14, "expected a declared name, found 'w))'"},
        {D "(assert (f x))", 2, 10, "expected a declared name"},
        {D "(assert (x y))", 2, 10, "expected an operator or a function"},
        {D "(assert ((< x 0)))", 2, 10, "expected an operator"},
        {D "(assert ())", 2, 10, "expected an operator"},
        {D "(assert <)", 2, 9, "expected '(' and arguments around '<)'"},
        {D "(assert (< x))", 2, 9, "expected at least 2 arguments of '<', found 1"},
        {D "(assert (not (< x 0) (< y 0)))", 2, 9, "expected 1 argument of 'not', found 2"},
        {D "(assert (< x true))", 2, 14, "expected a number as argument of '<'"},
        {D "(assert (and x (< x 0)))", 2, 14, "expected a formula as argument of 'and'"},
        {D "(assert (= x true))", 2, 14, "expected a number as argument of '='"},
        {D "(assert (ite x x y))", 2, 9, "expected a formula, then"},
        {D "(assert (< x \"a\"))", 2, 14, "expected a term"},
        {D "(assert (< x #x1f))", 2, 14, "expected a term"},
        {D "(assert (< x 1.))", 2, 14, "expected a number or a name"},
        {D "(assert (< x -1))", 2, 14, "expected a declared name"},
        {D "(assert (let (a x) (< a 0)))", 2, 15, "expected '(' of a binding"},
        {D "(assert (let ((a x y)) (< a 0)))", 2, 20, "expected ')' after the binding"},
        {D "(assert (let ((a x) (a y)) (< a 0)))", 2, 9, "expected different names in one let"},
        {D "(define-fun f ((a Real) (a Real)) Real a)", 2, 26, "expected different names of param"},
        {D "(assert (let ((a x)) (< a 0) y))", 2, 30, "expected ')' after the body"},
        {D "(assert (let ((a x)) (< a 0)))(assert (< a 0))", 2, 42, "expected a declared name"},
        {D "(assert (! (< x 0) named))", 2, 20, "expected an attribute"},
        {D "(assert (! (< x 0) :named x))", 2, 27, "expected a new name"},
        {D "(assert ((_ f 1) x))", 2, 10, "expected an operator"},
        {D "(assert (< (as x Real) 0))", 2, 12, "expected linear arithmetic"},
        {D "(define-fun f ((a Real)) Real a)(assert (< (f) 0))", 2, 44,
         "expected 1 argument, found 0"},
        {D "(define-fun f ((a Bool)) Bool a)(assert (f x))", 2, 44,
         "expected a formula as argument"},
        {D "(define-fun f ((a Real)) Bool a)(assert (f x))", 2, 41, "expected a formula from this"},
        {D "(define-fun f ((a Real)) Real w)(assert (let ((w 1)) (< (f x) w)))", 2, 31,
         "expected a declared name"},
    };
    CHECK(table);
}

/* Each step from the end of the text back to its start is one more reading, which is paid for. */
Test(smt2_mistakes, long_way_back)
{
    char *text = NULL;
    size_t size = 0;
    FILE *f = open_memstream(&text, &size);
    enum { STEPS = 5000 };
    for (int i = 0; i <= STEPS; i++)
        fprintf(f, "(declare-const b%d Bool)\n", i);
    for (int i = 0; i < STEPS; i++)
        fprintf(f, "(assert (=> b%d b%d))\n", i + 1, i);
    fprintf(f, "(assert b%d)\n", STEPS);
    fclose(f);
    fmb_system *s = NULL;
    fmb_where w = {0};
    cr_expect(fmb_system_parse(text, size, NULL, &s, &w) == FMB_ERR_PARSE);
    cr_expect(w.line == 0 && strstr(w.text, "fewer steps"), "%ld: %s", w.line, w.text);
    free(text);
}

Test(smt2_mistakes, failing_allocations)
{
    static const char *const good[] = {
        D "(define-fun f ((a Real) (b Bool)) Real (ite b a (+ a y)))(define-sort R () Real)"
          "(declare-const w R)(assert (! (let ((a x) (b (* 2 (+ x y w 1)))) (and (< a b 3) (<= "
          "(f x true) (/ a 3)))) :named n))(assert (not (or (< x 0) (> (f w false) 1))))"
          "(assert (= (+ 1 2 3 4 5 6 7 8 9 x) 1234567890123456789012345678901234567890.5))"
          "(maximize (+ (f w true) (* 3 y) 1))(check-sat)",
        "(declare-const |a b| Int)(declare-const c Bool)(assert (or c (! (< |a b| 2) :named l)))",
        B
        "(define-fun f () Real (ite b x y))(assert (=> c b))(maximize f)(assert (< f 1))(assert c)",
    };
    check_every_failure(FMB_FORMAT_SMT2, good[0], strlen(good[0]), FMB_OK);
    check_every_failure(FMB_FORMAT_SMT2, good[1], strlen(good[1]), FMB_ERR_PARSE);
    check_every_failure(FMB_FORMAT_SMT2, good[2], strlen(good[2]), FMB_OK);
}
