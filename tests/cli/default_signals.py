"""Importing this gives signals their default actions again. A shell has its background jobs ignore SIGINT, nohup
SIGHUP; children inherit that, and fmb goes on ignoring what was ignored when it started."""

import signal

for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGXCPU):
    signal.signal(number, signal.SIG_DFL)
