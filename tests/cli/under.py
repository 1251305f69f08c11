"""The command as tests run it: FMB_UNDER is put in front of it ("valgrind -q")."""

import os
import shlex


def command(fmb):
    return [*shlex.split(os.environ.get("FMB_UNDER", "")), os.path.abspath(fmb)]
