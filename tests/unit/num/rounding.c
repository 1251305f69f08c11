/* rounding.c: each operation on doubles is rounded once, to 53 bits: the bounds of
 * docs/error-bounds.md require that. Built with FMA on x86-64, like the kernels. */
#include <criterion/criterion.h>

static volatile double third = 1.0 / 3, ten = 10, huge = 0x1p60, one = 1;

Test(rounding, products_are_not_fused_with_sums)
{
#if defined __x86_64__ && defined __FMA__
    if (!__builtin_cpu_supports("fma"))
        cr_skip_test("this processor has no FMA");
#endif
    double a = third, b = ten, c = -(third * ten);
    volatile double product = a * b;
    double sum = a * b + c;
    cr_assert(sum == product + c, "%a", sum);
    cr_assert(sum == 0, "%a", sum);
}

Test(rounding, sums_have_53_bits)
{
    double sum = huge + one - huge;
    cr_assert(sum == 0, "%a", sum);
}
