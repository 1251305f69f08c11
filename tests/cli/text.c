/* text.c: whatever bytes a name has, what is shown of it is valid UTF-8 and harmless. */
#include <criterion/criterion.h>
#include <stdlib.h>

#include "common/text.h"

static void expect(const char *raw, app_text_use use, const char *shown)
{
    char *text = app_text(raw, use);
    cr_expect_str_eq(text, shown);
    free(text);
}

Test(text, keeps_what_is_valid)
{
    expect("x1", APP_TEXT_JSON, "x1");
    expect("\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80", APP_TEXT_TERMINAL,
           "\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80");
    expect("\xf4\x8f\xbf\xbf", APP_TEXT_JSON, "\xf4\x8f\xbf\xbf");
}

Test(text, escapes_what_is_not)
{
    expect("\xff", APP_TEXT_JSON, "\\xff");
    expect("a\x80z", APP_TEXT_JSON, "a\\x80z");
    expect("\xc0\xaf", APP_TEXT_JSON, "\\xc0\\xaf");                   /* overlong */
    expect("\xe0\x80\xaf", APP_TEXT_JSON, "\\xe0\\x80\\xaf");          /* overlong */
    expect("\xed\xa0\x80", APP_TEXT_JSON, "\\xed\\xa0\\x80");          /* surrogate */
    expect("\xf4\x90\x80\x80", APP_TEXT_JSON, "\\xf4\\x90\\x80\\x80"); /* beyond U+10FFFF */
    expect("\xe2\x82", APP_TEXT_JSON, "\\xe2\\x82");                   /* cut short */
    expect("\xf0\x9f\x98", APP_TEXT_JSON, "\\xf0\\x9f\\x98");
}

Test(text, different_names_stay_different)
{
    expect("\\xff", APP_TEXT_JSON, "\\x5cxff");
    expect("\\x0a", APP_TEXT_TERMINAL, "\\x5cx0a");
    expect("\\x\xff", APP_TEXT_JSON, "\\x\\xff");
    expect("\\xi \\x5", APP_TEXT_JSON, "\\xi \\x5");
}

Test(text, terminals_get_no_controls)
{
    expect("\x1b[7m", APP_TEXT_TERMINAL, "\\x1b[7m");
    expect("a\nb\x7f", APP_TEXT_TERMINAL, "a\\x0ab\\x7f");
    expect("\xc2\x9b", APP_TEXT_TERMINAL, "\\xc2\\x9b"); /* CSI in C1 */
    expect("a\xe2\x80\xae"
           "b",
           APP_TEXT_TERMINAL, "a\\xe2\\x80\\xaeb"); /* right to left from here */
    expect("a\nb", APP_TEXT_JSON, "a\nb");
    expect("\xe2\x80\xae", APP_TEXT_JSON, "\xe2\x80\xae");
}

Test(text, width_counts_characters)
{
    cr_expect_eq(app_text_width(""), 0);
    cr_expect_eq(app_text_width("a\xc3\xa9\xf0\x9f\x98\x80"), 3);
}
