/* status.c: names of statuses, verdicts and stops; the version. */
#include <fmb/base.h>

#include <string.h>

const char *fmb_version(void)
{
    return FMB_VERSION;
}

const char *fmb_status_text(fmb_status st)
{
    switch (st) {
    case FMB_OK:
        return "ok";
    case FMB_ERR_ARG:
        return "argument out of range, of the wrong shape, or not a finite number";
    case FMB_ERR_MEMORY:
        return "out of memory";
    case FMB_ERR_PARSE:
        return "malformed text";
    case FMB_ERR_IO:
        return "reading or writing failed";
    case FMB_ERR_RULE:
        return "pruning rule unknown, or unsound here";
    case FMB_ERR_STATE:
        return "not now: no query has finished, it kept no evidence, nothing is loaded or pushed";
    case FMB_ERR_RANGE:
        return "a number does not fit the type asked for";
    }
    return "unknown status";
}

const char *fmb_verdict_text(fmb_verdict v)
{
    switch (v) {
    case FMB_UNKNOWN:
        return "unknown";
    case FMB_FEASIBLE:
        return "feasible";
    case FMB_INFEASIBLE:
        return "infeasible";
    }
    return "unknown";
}

const char *fmb_stop_text(fmb_stop s)
{
    switch (s) {
    case FMB_STOP_DONE:
        return "done";
    case FMB_STOP_TIME:
        return "time";
    case FMB_STOP_ROWS:
        return "rows";
    case FMB_STOP_BYTES:
        return "bytes";
    case FMB_STOP_CANCELLED:
        return "cancelled";
    }
    return "unknown stop";
}

const char *fmb_rel_text(fmb_rel r)
{
    static const char *const text[] = {"<=", "<", "=", ">=", ">"};
    return (unsigned)r <= FMB_GT ? text[r] : "?";
}

size_t fmb_where_text(const fmb_where *where, const char *name, char *text, size_t size)
{
    char place[64] = "";
    if (!where)
        return 0;
    if (where->line > 0 && where->column > 0)
        snprintf(place, sizeof place, "%ld:%ld:", where->line, where->column);
    else if (where->line > 0)
        snprintf(place, sizeof place, "%ld:", where->line);
    const char *colon = name ? ":" : "", *blank = name || *place ? " " : "";
    name = name ? name : "";
    size_t length = strlen(name) + strlen(colon) + strlen(place) + strlen(blank) +
                    strnlen(where->text, sizeof where->text);
    if (text && length < size)
        snprintf(text, size, "%s%s%s%s%.*s", name, colon, place, blank, (int)sizeof where->text,
                 where->text);
    return length;
}
