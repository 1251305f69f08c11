"""A program that is watched on a terminal of its own: what it shows there tells that it is at work, and no time does.
Importing this gives SIGINT its default action: a shell has its background jobs ignore it, and children inherit that."""

import contextlib
import os
import pty
import signal
import subprocess

signal.signal(signal.SIGINT, signal.SIG_DFL)


class Watched:
    def __init__(self, args, **how):
        self.ours, theirs = pty.openpty()
        self.child = subprocess.Popen(args, stdout=subprocess.PIPE, stderr=theirs, **how)
        os.close(theirs)
        self.shown = b""

    def at_work(self):
        """Wait until there is a bar of progress."""
        while b"%" not in self.shown:
            self.shown += os.read(self.ours, 4096)

    def end(self):
        """Exit code, output, and what stands on the terminal where the bar was."""
        out = self.child.stdout.read()
        with contextlib.suppress(OSError):  # what a terminal has no more of
            while piece := os.read(self.ours, 4096):
                self.shown += piece
        os.close(self.ours)
        return self.child.wait(), out.decode(), self.shown.split(b"\r")[-1].decode()
