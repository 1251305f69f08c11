/* Criterion's tests one after another in one process, for builds with sanitizers. Criterion gives
   each test its own process, whose start and leak check take a tenth of a second under a sanitizer,
   a thousand times; builds without sanitizers do so. Here effects of a test on the next one show,
   too, and leaks are checked once, at the end: a report says where the memory was allocated.

   These are the functions that Criterion's macros call, with the same meaning; Criterion itself is
   not linked. A failing assertion ends the program. */
#include <criterion/criterion.h>
#include <criterion/logging.h>
#include <fnmatch.h>
#include <setjmp.h>
#include <stdio.h>
#include <unistd.h>

/* The linker's names for the ends of two sections, which a program may be without. */
#define ABSENT_IF_EMPTY __attribute__((weak))
extern struct criterion_test *__start_cr_tst[] ABSENT_IF_EMPTY, *__stop_cr_tst[] ABSENT_IF_EMPTY;
extern struct criterion_suite *__start_cr_sts[] ABSENT_IF_EMPTY, *__stop_cr_sts[] ABSENT_IF_EMPTY;

struct criterion_options criterion_options; /* the macros read its full_stats */

static struct {
    const struct criterion_test *test; /* the one that is running */
    const struct criterion_test_extra_data *suite;
    bool failed;
    jmp_buf skip;
} now;

/* ---- what assertions call ----------------------------------------------------------------- */

int cr_asprintf(char **out, const char *format, ...)
{
    va_list rest;
    va_start(rest, format);
    const int length = vasprintf(out, format, rest);
    va_end(rest);
    return length;
}

void cr_asprintf_free(char *text)
{
    free(text);
}

/* The text of an assertion without a message: the first argument, for every kind. */
char *cr_translate_assert_msg(int kind, ...)
{
    va_list rest;
    va_start(rest, kind);
    char *text = strdup(va_arg(rest, const char *));
    va_end(rest);
    return text;
}

void cri_asserts_passed_incr(void)
{
}

void criterion_send_assert(struct criterion_assert_stats *of)
{
    if (!of->passed)
        fprintf(stderr, "%s:%u: %s\n", of->file, of->line, of->message);
}

void criterion_continue_test(void)
{
    now.failed = true;
}

void criterion_abort_test(void)
{
    if (now.test)
        fprintf(stderr, "%s/%s failed\n", now.test->category, now.test->name);
    fflush(NULL);
    _exit(1); /* memory of the aborted test is no leak */
}

void criterion_skip_test(const char *format, ...)
{
    va_list rest;
    va_start(rest, format);
    fprintf(stderr, "%s/%s is skipped: ", now.test->category, now.test->name);
    vfprintf(stderr, format, rest);
    fputc('\n', stderr);
    va_end(rest);
    longjmp(now.skip, 1);
}

void criterion_test_die(const char *format, ...)
{
    va_list rest;
    va_start(rest, format);
    vfprintf(stderr, format, rest);
    va_end(rest);
    criterion_abort_test();
}

void cr_log(enum criterion_severity severity, const char *format, ...)
{
    va_list rest;
    va_start(rest, format);
    (void)severity;
    vfprintf(stderr, format, rest);
    fputc('\n', stderr);
    va_end(rest);
}

/* ---- a test ------------------------------------------------------------------------------- */

static void call(void (*fixture)(void))
{
    if (fixture)
        fixture();
}

void criterion_internal_test_setup(void)
{
    call(now.suite ? now.suite->init : NULL);
    call(now.test->data->init);
}

void criterion_internal_test_main(void (*test)(void))
{
    if (!setjmp(now.skip))
        test();
}

void criterion_internal_test_teardown(void)
{
    call(now.test->data->fini);
    call(now.suite ? now.suite->fini : NULL);
}

static const struct criterion_test_extra_data *suite_of(const struct criterion_test *test)
{
    for (struct criterion_suite **at = __start_cr_sts; at < __stop_cr_sts; at++)
        if (*at && strcmp((*at)->name, test->category) == 0)
            return (*at)->data;
    return NULL;
}

static bool is_wanted(const struct criterion_test *test, const char *pattern)
{
    return !test->data->disabled && (!pattern || fnmatch(pattern, test->data->identifier_, 0) == 0);
}

/* Runs all tests, or those that match `--filter SUITE/TEST`, a shell pattern; 1 if there are none.
   As with Criterion, a program may have a main of its own. */
__attribute__((weak)) int main(int argc, char **argv)
{
    const char *pattern = argc == 3 && strcmp(argv[1], "--filter") == 0 ? argv[2] : NULL;
    int run = 0, failed = 0;
    for (struct criterion_test **at = __start_cr_tst; at < __stop_cr_tst; at++)
        if (*at && is_wanted(*at, pattern)) {
            now.test = *at;
            now.suite = suite_of(*at);
            now.failed = false;
            now.test->test();
            run++;
            failed += now.failed;
        }
    fprintf(stderr, "%d tests, %d failed\n", run, failed);
    return failed > 0 || run == 0;
}
