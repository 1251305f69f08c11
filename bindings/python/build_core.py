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
void pyfmb_begin(fmb_solver *v);
void pyfmb_end(void);

extern "Python" void pyfmb_tell(void *self, const fmb_event *e);
extern "Python" bool pyfmb_told(void *self, fmb_verdict verdict, size_t n, const fmb_frames_pair *pair);
extern "Python" void pyfmb_warn(void *self, const fmb_where *where);
"""

# While a query of the main thread runs, Ctrl-C first asks it to stop, and then does what it did
# before. Everything in the handler may be called in one.
SOURCE = """
#include <signal.h>
#include <fmb/fmb.h>
#include <fmb/geometry.h>

static fmb_solver *volatile asked;
static struct sigaction before;

static void stop_query(int number, siginfo_t *info, void *context)
{
    if (asked)
        fmb_solver_cancel(asked);
    if (before.sa_flags & SA_SIGINFO)
        before.sa_sigaction(number, info, context);
    else if (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN)
        before.sa_handler(number);
}

static void pyfmb_begin(fmb_solver *v)
{
    struct sigaction own;
    own.sa_sigaction = stop_query;
    sigemptyset(&own.sa_mask);
    own.sa_flags = SA_SIGINFO | SA_RESTART;
    asked = v;
    sigaction(SIGINT, &own, &before);
}

static void pyfmb_end(void)
{
    sigaction(SIGINT, &before, NULL);
    asked = NULL;
}
"""


def declarations(include):
    """What the headers declare, as cffi can read it."""
    compiler = os.environ.get("CC", "cc").split()
    text = "".join(f"#include <fmb/{name}.h>\n" for name in ("fmb", "geometry"))
    plain = subprocess.run(compiler + ["-E", "-P", "-DFMB_DECLARATIONS_ONLY", "-I", include, "-"],
                           input=text, stdout=subprocess.PIPE, check=True, text=True).stdout
    # What a library of rules defines itself is not there to be called.
    return re.sub(r"^[^;{}]*\bfmb_rule_library\b[^;]*;", "", plain, flags=re.M)


def main():
    include, output = sys.argv[1:]
    ffi = cffi.FFI()
    ffi.cdef(declarations(include) + EXTRA)
    ffi.set_source("fmb._core", SOURCE, py_limited_api=True)
    ffi.emit_c_code(output)


if __name__ == "__main__":
    main()
