/* status.c: names of statuses, verdicts and stops; the version. */
#include <fmb/base.h>

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
