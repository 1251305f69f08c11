"""build_core.py: the compiled core of the package, fmb._core, by cffi.

usage: build_core.py INCLUDE OUTPUT.c    (meson compiles it)

cffi reads the headers as the preprocessor leaves them; what is added here is what Python needs
besides: a query that ends at Ctrl-C, rows as flat arrays, and callbacks.
"""

import os
import re
import subprocess
import sys

import cffi

EXTRA = """
typedef enum pyfmb_query { PYFMB_SOLVER, PYFMB_PAIR, PYFMB_MESH } pyfmb_query;
void pyfmb_begin(pyfmb_query kind, void *query);
void pyfmb_end(void);
bool pyfmb_goes_on(void *self, double done);

typedef struct pyfmb_rule { fmb_rule table; void *self; } pyfmb_rule;

extern "Python" void pyfmb_tell(void *self, const fmb_event *e);
extern "Python" bool pyfmb_told(void *self, fmb_verdict verdict, size_t n, const fmb_frames_pair *pair);
extern "Python" void pyfmb_warn(void *self, const fmb_where *where);
extern "Python" fmb_status pyfmb_end_round(void *state, const fmb_view *w, bool *drop);
extern "Python" int pyfmb_choose(void *self, const fmb_view *w, const int *col, size_t n);
"""

# While queries of the main thread run (one may ask another from a callback), Ctrl-C first asks them
# to stop, and then does what it did before. Everything in the handler may be called in one. It runs
# in the main thread, which alone begins and ends queries, so that those it sees are there. Where
# Ctrl-C is ignored, or ends the process, it still does.
SOURCE = """
#include <pthread.h>
#include <signal.h>
#include <fmb/fmb.h>
#include <fmb/geometry.h>

typedef enum pyfmb_query { PYFMB_SOLVER, PYFMB_PAIR, PYFMB_MESH } pyfmb_query;
typedef struct pyfmb_rule { fmb_rule table; void *self; } pyfmb_rule;

enum { MOST_NESTED = 64 };
static struct { pyfmb_query kind; void *query; } asked[MOST_NESTED];
static volatile sig_atomic_t nested;
static int handles;
static pthread_t asking;
static struct sigaction before;

static void stop_queries(int number, siginfo_t *info, void *context)
{
    if (!pthread_equal(pthread_self(), asking)) {
        pthread_kill(asking, number);
        return;
    }
    for (int i = 0; i < nested && i < MOST_NESTED; i++) {
        if (asked[i].kind == PYFMB_SOLVER)
            fmb_solver_cancel(asked[i].query);
        else if (asked[i].kind == PYFMB_PAIR)
            fmb_pair_cancel(asked[i].query);
        else
            *(volatile bool *)asked[i].query = false;
    }
    if (before.sa_flags & SA_SIGINFO)
        before.sa_sigaction(number, info, context);
    else
        before.sa_handler(number);
}

static void begin_handling(void)
{
    struct sigaction own;
    own.sa_sigaction = stop_queries;
    sigemptyset(&own.sa_mask);
    own.sa_flags = SA_SIGINFO | SA_RESTART;
    asking = pthread_self();
    sigaction(SIGINT, &own, &before);
    handles = (before.sa_flags & SA_SIGINFO) ||
              (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN);
    if (!handles)
        sigaction(SIGINT, &before, NULL);
}

static void pyfmb_begin(pyfmb_query kind, void *query)
{
    if (nested < MOST_NESTED) {
        asked[nested].kind = kind;
        asked[nested].query = query;
    }
    if (nested == 0)
        begin_handling();
    nested++;
}

static void pyfmb_end(void)
{
    nested--;
    if (nested == 0 && handles)
        sigaction(SIGINT, &before, NULL);
}

static bool pyfmb_goes_on(void *self, double done)
{
    (void)done;
    return *(volatile bool *)self;
}
"""


def declarations(include):
    """What the headers declare, as cffi can read it."""
    compiler = os.environ.get("CC", "cc").split()
    text = "".join(f"#include <fmb/{name}.h>\n" for name in ("fmb", "geometry"))
    plain = subprocess.run(compiler + ["-E", "-P", "-DFMB_DECLARATIONS_ONLY", "-I", include, "-"],
                           input=text, stdout=subprocess.PIPE, check=True, text=True).stdout
    # Functions that a rule library itself defines cannot be called.
    return re.sub(r"^[^;{}]*\bfmb_(rule|chooser)_library\b[^;]*;", "", plain, flags=re.M)


def main():
    include, output = sys.argv[1:]
    ffi = cffi.FFI()
    ffi.cdef(declarations(include) + EXTRA)
    ffi.set_source("fmb._core", SOURCE, py_limited_api=True)
    ffi.emit_c_code(output)


if __name__ == "__main__":
    main()
