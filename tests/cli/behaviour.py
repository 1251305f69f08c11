"""What a transcript cannot show: JSON for programs, Ctrl-C, progress on a terminal.
usage: behaviour.py FMB EXAMPLES"""

import contextlib
import fractions
import json
import os
import pty
import random
import re
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

import default_signals  # noqa: F401
import under

FMB, EXAMPLES = under.command(sys.argv[1]), os.path.abspath(sys.argv[2])
RATIONAL = re.compile(r"-?[0-9]+(/[1-9][0-9]*)?")


def run(*words, text=None):
    return subprocess.run([*FMB, *words], cwd=EXAMPLES, input=text, capture_output=True)


def ask(code, *words, text=None):
    reply = run(*words, "--json", text=text)
    assert reply.returncode == code, (words, reply)
    return json.loads(reply.stdout)


def dense_system(n, m):
    """Random rows around the origin: eliminating n variables takes longer than anyone waits."""
    pick = random.Random(1)
    rows = [" + ".join(f"{pick.randint(-99, 99)} x{j}" for j in range(n)) for _ in range(m)]
    return "".join(f"{row} <= {pick.randint(1, 99)}\n" for row in rows).replace("+ -", "- ")


class Json(unittest.TestCase):
    def test_feasible(self):
        answer = ask(0, "solve", "breakfast.fmb")
        self.assertEqual(set(answer), {"verdict", "stop", "witness", "stats"})
        self.assertEqual((answer["verdict"], answer["stop"]), ("feasible", "done"))
        self.assertEqual(list(answer["witness"]), ["bread", "milk", "egg"])
        x = {name: fractions.Fraction(value) for name, value in answer["witness"].items()}
        self.assertGreaterEqual(250 * x["bread"] + 150 * x["milk"] + 90 * x["egg"], 600)

    def test_infeasible(self):
        answer = ask(1, "solve", "schedule.fmb")
        self.assertEqual(set(answer), {"verdict", "stop", "conflict", "stats"})
        self.assertEqual([r["label"] for r in answer["conflict"]],
                         ["opening", "drying", "glue", "closing"])
        for row in answer["conflict"]:
            self.assertEqual(set(row), {"row", "label", "multiplier"})
            self.assertRegex(row["multiplier"], RATIONAL)

    def test_bounds(self):
        answer = ask(0, "bounds", "breakfast.fmb")
        self.assertEqual(list(answer["bounds"]), ["bread", "milk", "egg"])
        for end in answer["bounds"].values():
            self.assertEqual(set(end), {"lower", "upper", "lower_attained", "upper_attained"})
            self.assertRegex(end["lower"], RATIONAL)
            self.assertIs(type(end["upper_attained"]), bool)
        answer = ask(0, "bounds", "-", text=b"x < 3\n")
        self.assertEqual(answer["bounds"]["x"], {"lower": "-inf", "upper": "3",
                                                 "lower_attained": False, "upper_attained": False})
        self.assertIn("conflict", ask(1, "bounds", "schedule.fmb"))

    def test_optimize(self):
        answer = ask(0, "optimize", "breakfast.fmb", "--min", "0.4 bread + 0.35 milk + 7")
        self.assertEqual(set(answer), {"verdict", "stop", "objective", "optimum", "witness",
                                       "multipliers", "stats"})
        self.assertEqual(answer["objective"], {"sense": "min", "coefficients": ["2/5", "7/20", "0"],
                                               "constant": "7"})
        best = fractions.Fraction(answer["optimum"]["value"])
        x = {name: fractions.Fraction(value) for name, value in answer["witness"].items()}
        self.assertEqual(x["bread"] * 2 / 5 + x["milk"] * 7 / 20 + 7, best)
        self.assertIs(answer["optimum"]["attained"], True)
        for row in answer["multipliers"]:
            self.assertEqual(set(row), {"row", "label", "multiplier"})
        answer = ask(0, "optimize", "-", "--min", "x", text=b"x < 3\n")
        self.assertEqual(answer["optimum"], {"value": "-inf", "attained": False})
        self.assertEqual(answer["ray"], {"x": "-1"})
        self.assertIn("conflict", ask(1, "optimize", "schedule.fmb", "--max", "carpet"))
        answer = ask(0, "reduce", "-", text=b"max: 2x\nx <= 3\nx <= 4\n")
        self.assertEqual(answer["objective"]["coefficients"], ["2"])

    def test_project_and_reduce(self):
        answer = ask(0, "project", "cube.ine")
        self.assertEqual(len(answer["variables"]), 2)
        for row in answer["rows"]:
            self.assertEqual(len(row["coefficients"]), 2)
            self.assertIn(row["relation"], ("<=", "<", "="))
            self.assertRegex(row["rhs"], RATIONAL)
        answer = ask(0, "reduce", "cube.ine")
        self.assertEqual([(r["row"], r["reason"]) for r in answer["removed"]], [(8, "redundant")])
        self.assertEqual({m["row"] for m in answer["removed"][0]["multipliers"]}, {2, 4})
        self.assertEqual(answer["equalities"], [])
        answer = ask(1, "project", "schedule.fmb", "--keep", "paint")
        self.assertEqual(answer["rows"], [{"coefficients": ["0"], "relation": "<=", "rhs": "-1"}])

    def test_equalities(self):
        answer = ask(0, "reduce", "-", text=b"x + y <= 1\nx + y >= 1\nx >= 0\n")
        self.assertEqual(answer["equalities"], [1])
        self.assertEqual([r["row"] for r in answer["removed"]], [2])

    def test_names_of_any_bytes(self):
        """Whatever a reader takes for a name, the JSON is valid UTF-8 and the point is complete."""
        mps = (b"NAME t\nROWS\n N obj\n L r\xff\nCOLUMNS\n x\xe9 r\xff 1\n y r\xff 1\nRHS\n"
               b" b r\xff 4\nENDATA\n")
        reply = run("solve", "--format", "mps", "--json", "-", text=mps)
        if reply.returncode in (64, 65):  # it will not have such names
            self.assertIn(b"mps" if reply.returncode == 64 else b"<stdin>", reply.stderr)
        else:
            self.assertEqual(len(json.loads(reply.stdout.decode("utf-8"))["witness"]), 2)

    def test_check(self):
        with tempfile.TemporaryDirectory() as folder:
            proof = os.path.join(folder, "p")
            ask(1, "solve", "schedule.fmb", "--proof", proof)
            self.assertEqual(ask(0, "check", "schedule.fmb", proof),
                             {"accepted": True, "verdict": "infeasible", "over": "reals",
                              "stop": "done", "claims": 1, "kinds": {"infeasible": 1}})
            with open(proof) as f:
                wrong = re.sub("row 4 .*", "row 4 77", f.read())
            answer = ask(1, "check", "schedule.fmb", "-", text=wrong.encode())
            self.assertEqual(answer["accepted"], False)
            self.assertTrue(answer["reason"])

    def test_trace(self):
        with tempfile.TemporaryDirectory() as folder:
            trace = os.path.join(folder, "t")
            run("solve", "breakfast.fmb", "--method", "fm", "--trace", trace)
            with open(trace) as lines:
                events = [json.loads(line) for line in lines]
            self.assertGreaterEqual(len(events), 2)


class Interruption(unittest.TestCase):
    """A long elimination is cut short."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.file = os.path.join(self.folder.name, "dense.fmb")
        with open(self.file, "w") as f:
            f.write(dense_system(20, 60))

    def tearDown(self):
        self.folder.cleanup()

    def start(self, *words, **streams):
        return subprocess.Popen([*FMB, *words, self.file, "--method", "fm"],
                                stdout=subprocess.PIPE, **streams)

    def stop(self, number, *words):
        """The signal comes when the terminal shows how far the run is."""
        try:
            ours, theirs = pty.openpty()
        except OSError as e:
            self.skipTest(f"no terminal to be had: {e}")
        with self.start(*words, stderr=theirs) as p:
            os.close(theirs)
            shown = b""
            while b"rows" not in shown:
                shown += os.read(ours, 4096)
            p.send_signal(number)
            with contextlib.suppress(OSError):  # what a terminal has no more of
                while piece := os.read(ours, 4096):
                    shown += piece
            os.close(ours)
            out = p.stdout.read()
        return p.returncode, out, shown

    def test_interrupt_and_terminate(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGXCPU):
            code, out, shown = self.stop(number, "solve", "--json")
            self.assertEqual(code, 2)
            self.assertTrue(shown.endswith(b"fmb: undecided (cancelled)\r\n"), shown)
            answer = json.loads(out)
            self.assertEqual((answer["verdict"], answer["stop"]), ("unknown", "cancelled"))

    def test_progress(self):
        """On a terminal a long run tells how far it is, and leaves nothing of that behind."""
        code, out, shown = self.stop(signal.SIGINT, "solve")
        self.assertEqual((code, out), (2, b"unknown (cancelled)\n"))
        *_, line, blank, last = shown.split(b"\r")[:-1]
        self.assertIn(b"rows", line)
        self.assertEqual(blank.strip(), b"", "the line was not erased")
        self.assertEqual(last, b"fmb: undecided (cancelled)")

    def test_limits(self):
        for option, value, stop in (("--max-seconds", "0.1", "time"), ("--max-rows", "200", "rows"),
                                    ("--max-bytes", "1000000", "bytes")):
            answer = ask(2, "solve", self.file, "--method", "fm", option, value)
            self.assertEqual((answer["verdict"], answer["stop"]), ("unknown", stop))


class Ids(unittest.TestCase):
    POINT = '{"type": "simplex", "orig": [0], "comp": []}'

    def lines(self, ids):
        pair = f'"A": {self.POINT}, "B": {self.POINT}'
        return "".join(f'{{"id": {word}, {pair}}}\n' for word in ids).encode()

    def test_json(self):
        """Whatever the ids are, the report is JSON and has them."""
        ids = [r'"a\"b\\c\u0000d\u001b"', r'"\ud800"', '"\u202ex"', "1e400", "-0.0", "null", '""',
               "1234567890123456789012345678901234567890", '{"k": [1, {"x": null}]}', '"%s%n"']
        for boxes in ("exact", "outward", "none"):
            answer = ask(0, "intersect", "-", "--boxes", boxes, text=self.lines(ids))
            self.assertEqual([p["id"] for p in answer["pairs"]], [json.loads(i) for i in ids])

    def test_text(self):
        """A name is not cut at a NUL, and has no control bytes."""
        text = self.lines([r'"a\u0000b"', r'"a\nb"'])
        reply = run("intersect", "-", "--boxes", "none", text=text)
        self.assertEqual(reply.stdout.splitlines()[:2],
                         [b'meet      "a\\u0000b"', b"meet      a\\x0ab"])


class Endless(unittest.TestCase):
    """Pairs of frames that never end, until a signal comes."""

    LINE = (b'{"A": {"type": "cuboid", "orig": [0, 0.1], "comp": [[1, 0], [0, 1]]}, '
            b'"B": {"type": "simplex", "orig": [0.5, 0.3], "comp": [[1, 0], [0, 1]]}}\n')

    ENOUGH = 1 << 20  # [bytes] more than a pipe holds: what was before has been read

    def feed(self, p, fed):
        """Lines as long as some that programs write, so that few pairs fill a pipe."""
        lines, written = (b" " * 2000 + self.LINE) * 20, 0
        try:
            while True:
                written += p.stdin.write(lines)
                if written > self.ENOUGH:
                    fed.set()
        except (OSError, ValueError):
            pass

    def play(self, *words, **streams):
        """The process while it is fed, its output in a file, and what is set when it has read enough."""
        out, fed = tempfile.TemporaryFile(), threading.Event()
        p = subprocess.Popen([*FMB, "intersect", "-", *words], stdin=subprocess.PIPE, stdout=out,
                             **streams)
        threading.Thread(target=self.feed, args=[p, fed], daemon=True).start()
        return p, out, fed

    def end(self, p, out):
        """Everything that it wrote, after a signal."""
        self.assertIsNone(p.poll(), "it was to go on")
        p.send_signal(signal.SIGINT)
        self.assertEqual(p.wait(), 2)
        with contextlib.suppress(OSError):
            p.stdin.close()
        with out:
            out.seek(0)
            return out.read()

    def test_interrupt(self):
        for boxes, threads in (("none", 1), ("exact", 1), ("none", 3), ("exact", 3)):
            p, out, fed = self.play("--json", "--boxes", boxes, "--threads", str(threads))
            fed.wait()
            answer = json.loads(self.end(p, out))
            self.assertEqual([pair["line"] for pair in answer["pairs"]],
                             list(range(1, answer["tested"] + 1)))
            self.assertEqual(len(answer["pairs"]), answer["tested"])
            self.assertGreater(answer["meeting"], 0)
            self.assertEqual(answer["pairs"][0].get("world") is None, boxes == "none")
            self.assertEqual(answer["meeting"] + answer["undecided"], answer["tested"])
            self.assertLess(answer["undecided"], 2)

    def test_progress(self):
        try:
            ours, theirs = pty.openpty()
        except OSError as e:
            self.skipTest(f"no terminal to be had: {e}")
        for threads in ("1", "2"):
            self.watch(ours, *self.play("--boxes", "none", "--threads", threads, stderr=theirs))
        os.close(theirs)
        os.close(ours)

    def watch(self, ours, p, out, _):
        shown = b""
        while shown.count(b"pairs") < 2:
            shown += os.read(ours, 4096)
        self.assertIn(b"meet", shown)
        self.assertTrue(self.end(p, out).endswith(b"undecided\n"))


class Crew(unittest.TestCase):
    """Several threads: the same output as one, mistakes and all."""

    BAD = (b"nonsense\n", b"\xef\xbb\xbf" + Endless.LINE, b"f" + Endless.LINE, b"\0\n", b"\n",
           Endless.LINE[:60] + b"\n", b" " * 5000 + b"\n")

    def pair(self, rng):
        def frame():
            return {"type": rng.choice(("cuboid", "simplex")), "orig": [rng.randint(-9, 9) / 4] * 3,
                    "comp": [[rng.uniform(-2, 2) for _ in range(3)] for _ in range(3)],
                    "vel": [rng.randint(-1, 1)] * 3}
        return (json.dumps({"id": rng.random(), "A": frame(), "B": frame()}) + "\n").encode()

    def expect_same(self, data, *words, crews=("2", "5")):
        replies = [run("intersect", "-", "--threads", n, *words, text=data) for n in ("1", *crews)]
        for reply in replies[1:]:
            self.assertEqual((reply.stdout, reply.stderr, reply.returncode),
                             (replies[0].stdout, replies[0].stderr, replies[0].returncode), words)

    def test_same_output(self):
        rng = random.Random(7)
        lines = [self.pair(rng) for _ in range(400)]
        for words in ((), ("--json", "--common"), ("--nearest", "--boxes", "outward"),
                      ("--boxes", "none", "--json", "--max-input", "4000")):
            self.expect_same(b"".join(lines[:100 if words[1:2] == ("--common",) else 400]), *words)
            for bad in self.BAD:
                text = lines[:rng.randrange(300)] + [bad] + lines[:rng.randrange(9)]
                self.expect_same(b"".join(text)[:-1], "--boxes", "none", *words[:1],
                                 crews=(rng.choice("25"),))

    def test_limits(self):
        """Touching boxes, which doubles leave open, without time: undecided."""
        square = '{"type": "cuboid", "orig": [%d, 0], "comp": [[1, 0], [0, 1]]}'
        lines = f'{{"A": {square % 0}, "B": {square % 1}}}\n'.encode() * 5
        limits = ("--max-seconds", "1e-9", "--contact", "open")
        self.expect_same(lines, *limits)
        self.assertEqual(run("intersect", "-", *limits, text=lines).returncode, 2)

    def test_binary(self):
        rng = random.Random(8)
        text = b"".join(self.pair(rng) for _ in range(300))
        packed = run("convert", "-", "--to", "pairs", "--nearest", text=text).stdout
        for size in (len(packed), len(packed) - 1, 33, 31):
            self.expect_same(packed[:size], "--boxes", "outward")


class Waiting(unittest.TestCase):
    """Pairs of frames that come one by one."""

    def expect(self, p, line):
        self.assertEqual(p.stdout.readline(), line)

    def test_answers_at_once(self):
        """Whoever sends a pair and waits gets its answer; then a signal ends the command at once."""
        for number, threads in ((signal.SIGINT, "1"), (signal.SIGTERM, "1"), (signal.SIGINT, "2")):
            for rest in (b"", Endless.LINE[:30]):
                with subprocess.Popen([*FMB, "intersect", "-", "--boxes", "none",
                                       "--threads", threads], bufsize=0,
                                      stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                      stderr=subprocess.PIPE) as p:
                    p.stdin.write(Endless.LINE)
                    self.expect(p, b"meet      line 1\n")
                    p.stdin.write(Endless.LINE + rest)
                    self.expect(p, b"meet      line 2\n")
                    p.send_signal(number)
                    self.assertEqual(p.wait(), 2)
                    self.assertEqual((p.stdout.read(), p.stderr.read()),
                                     (b"2 tested: 2 meet, 0 apart, 0 undecided\n",
                                      b"fmb: undecided (cancelled): 2 pairs tested, not all to the end\n"))


class Instructions(unittest.TestCase):
    def test_what_there_is(self):
        """Instructions that the processor has not got are refused in words."""
        answers = {level: run("solve", "schedule.fmb", "--simd", level)
                   for level in ("auto", "plain", "avx2", "avx512")}
        for level, reply in answers.items():
            if level in ("avx2", "avx512") and reply.returncode == 64:
                self.assertEqual(reply.stderr,
                                 b"fmb: --simd: this processor has no such instructions\n")
            else:
                self.assertEqual(reply.stdout, answers["plain"].stdout)
                self.assertEqual(reply.returncode, 1)


unittest.main(argv=sys.argv[:1])
