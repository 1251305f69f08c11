/* form.c: see form.h. */
#include "common/form.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"
#include "common/nearest.h"
#include "common/text.h"

/* "; did you mean 'y'?" for a name at `at` that no variable has. */
static const char *hint_at_name(const fmb_system *s, const char *at, char hint[APP_HINT_SIZE])
{
    char word[64];
    snprintf(word, sizeof word, "%.*s", (int)strcspn(at, " \t+-*/()\""), at);
    app_nearest near = app_nearest_to(word);
    for (int j = 0; *word && j < fmb_system_dim(s); j++)
        app_nearest_try(&near, fmb_system_name(s, j));
    return app_nearest_hint(&near, hint);
}

/* Print the text with a caret below the wrong byte; nothing if one line cannot show it.
 */
static void show_place(const char *text, size_t at)
{
    char *shown = app_text(text, APP_TEXT_TERMINAL);
    if (*text && at <= strlen(text) && strcmp(shown, text) == 0) {
        char *before = app_need(strndup(text, at));
        fprintf(stderr, "  %s\n  %*s\n", text, (int)app_text_width(before) + 1, "^");
        free(before);
    }
    free(shown);
}

int app_form_read(const char *option, const char *text, fmb_sense sense, fmb_system *s)
{
    char hint[APP_HINT_SIZE] = "";
    fmb_where w = {0};
    fmb_status st = fmb_system_parse_objective(s, sense, text, strlen(text), &w);
    if (st == FMB_OK)
        return APP_YES;
    if (st != FMB_ERR_PARSE)
        return app_status_error(st);
    size_t at = w.column > 0 ? (size_t)w.column - 1 : 0;
    bool name = strstr(w.text, "a variable of the system") && at < strlen(text);
    char *end = strstr(w.text, "end of file");
    if (end)
        strcpy(end, "its end");
    app_error_at((app_place){.column = w.column}, APP_USAGE, "%s: %s%s", option, w.text,
                 name ? hint_at_name(s, text + at, hint) : "");
    if (!app_errors_are_json())
        show_place(text, at);
    return APP_USAGE;
}
