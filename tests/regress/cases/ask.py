"""Run the fmb command once, with a limit, and say what came back."""

import json
import os
import signal
import subprocess
import time

YES, NO, UNDECIDED = 0, 1, 2


class Reply:
    """One run: exit code, parsed JSON (or None), what it complained of, seconds, and why it
    counts as a crash (None if it does not)."""

    def __init__(self, code, out, err, seconds, crash):
        self.code, self.out, self.err, self.seconds, self.crash = code, out, err, seconds, crash

    def undecided(self):
        return self.code == UNDECIDED

    def stop(self):
        return "stop: " + str((self.out or {}).get("stop", "no reason given"))


class Fmb:
    """The program under test. grace [s] is what a run may take beyond its own limit before it is
    killed, and a kill counts as a crash."""

    def __init__(self, path, grace, max_bytes):
        self.path, self.grace, self.max_bytes = os.path.abspath(path), grace, max_bytes

    def ask(self, args, seconds):
        """A query with --json, --max-seconds and --max-bytes."""
        limits = ["--json", "--max-seconds", f"{seconds:.3f}", "--max-bytes", str(self.max_bytes)]
        reply = self.run([*args, *limits], seconds + self.grace)
        if reply.crash is None and reply.code in (YES, NO, UNDECIDED):
            try:
                reply.out = json.loads(reply.out)
            except ValueError as e:
                reply.crash = f"output is not JSON: {e}"
        return reply

    def run(self, args, limit):
        """A run that is killed after limit seconds."""
        begin = time.monotonic()
        with subprocess.Popen([self.path, *args], stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as p:
            try:
                out, err = p.communicate(timeout=limit)
                crash = None
            except subprocess.TimeoutExpired:
                p.kill()
                out, err = p.communicate()
                crash = f"did not end within {limit:.1f} s"
        if crash is None and p.returncode < 0:
            crash = "killed by " + signal.Signals(-p.returncode).name
        if crash is None and p.returncode not in (0, 1, 2, 64, 65, 66, 74):
            crash = f"exit {p.returncode}: {err.decode(errors='replace').strip()[-200:]}"
        return Reply(p.returncode, out.decode(errors="replace"),
                     err.decode(errors="replace").strip(), time.monotonic() - begin, crash)
