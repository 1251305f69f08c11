"""What is asked about a file, and how its reply is judged against the recorded answer.

A question returns (outcome, note): ANSWERED, UNDECIDED (a limit), WRONG (a statement that is not
true, a proof that does not check, a file not read) or CRASHED.
"""

import os
from fractions import Fraction

import rows as exact
from ask import NO, YES

ANSWERED, UNDECIDED, WRONG, CRASHED = "answered", "undecided", "wrong", "crashed"
VERDICT_OF = {"sat": "feasible", "unsat": "infeasible"}
TOLERANCE = Fraction(1, 10**6)  # of optimal values: two floating-point solvers agree so far
CHECK_LIMIT = 120  # [s] a check is short; this only keeps a broken one from hanging the run


class Ask:
    """Questions about one file. budget [s] is shared by all its queries: each may use what the
    earlier ones left. Time spent on checking proofs is measured apart."""

    def __init__(self, fmb, path, name, folder, budget):
        self.fmb, self.path, self.name, self.folder = fmb, path, name, folder
        self.left, self.query_seconds, self.check_seconds = budget, 0.0, 0.0

    def query(self, args):
        """(reply, None), or (reply, what ends the question)."""
        if self.left < 0.01:
            return None, (UNDECIDED, "no time left")
        reply = self.fmb.ask(args, self.left)
        self.left -= reply.seconds
        self.query_seconds += reply.seconds
        if reply.crash is not None:
            return reply, (CRASHED, reply.crash)
        if reply.code not in (YES, NO, 2):
            return reply, (WRONG, f"exit {reply.code}: {reply.err[-200:]}")
        if reply.undecided() and not reply.out.get("relaxed"):
            return reply, (UNDECIDED, reply.stop())
        return reply, None

    def prove(self, proof, *expect):
        """None if `fmb check` accepts the proof, else what is wrong."""
        if not os.path.exists(proof):
            return WRONG, "no proof was written"
        reply = self.fmb.run(["check", self.path, proof, *expect], CHECK_LIMIT)
        self.check_seconds += reply.seconds
        if reply.crash is not None:
            return CRASHED, "check: " + reply.crash
        if reply.code != YES:
            return WRONG, f"check: exit {reply.code}: {reply.err[-200:]} {reply.out[-200:]}".strip()
        return None

    def proof_path(self, verb):
        return os.path.join(self.folder, f"{self.name}.{verb}.proof".replace("/", "_"))


def judge_verdict(reply, recorded, rows):
    """Reply of `fmb solve` against "sat"/"unsat" (or None), and its witness or multipliers against
    our own rows (or None). With integers, feasible over the reals is told by another exit code."""
    verdict = reply.out.get("verdict")
    relaxed = reply.out.get("relaxed", False)
    if reply.code != (2 if relaxed else YES if verdict == "feasible" else NO):
        return WRONG, f"exit {reply.code} but verdict {verdict}"
    if recorded is not None and verdict != VERDICT_OF[recorded]:
        return WRONG, f"says {verdict}, truth is {VERDICT_OF[recorded]}"
    if rows is not None:
        why = judge_evidence(reply.out, verdict, rows)
        if why:
            return WRONG, "exact recheck: " + why
    return ANSWERED, verdict + (", rechecked" if rows is not None else "")


def judge_evidence(out, verdict, rows):
    if verdict == "feasible":
        point = [Fraction(v) for v in out["witness"].values()]
        if rows and len(point) != len(rows[0][0]):
            return f"the witness has {len(point)} coordinates"
        broken = exact.holds(rows, point)
        return broken and f"the witness breaks row {broken}"
    multipliers = {}
    for part in out["conflict"]:
        if part["row"] in multipliers or not 1 <= part["row"] <= len(rows):
            return f"row {part['row']} is named twice, or is not there"
        multipliers[part["row"]] = Fraction(part["multiplier"])
    return exact.refutes(rows, multipliers)


def ask_verdict(ask, recorded, rows):
    proof = ask.proof_path("solve")
    reply, end = ask.query(["solve", ask.path, "--proof", proof])
    if end:
        return end
    outcome, note = judge_verdict(reply, recorded, rows)
    return (outcome, note) if outcome != ANSWERED else ask.prove(proof) or (outcome, note)


def end_of(text):
    """An end of an interval as a number or an infinity."""
    return float(text) if text in ("inf", "-inf", "+inf") else Fraction(text)


def ask_box(ask, box):
    proof = ask.proof_path("bounds")
    reply, end = ask.query(["bounds", ask.path, "--proof", proof])
    if end:
        return end
    found = reply.out.get("bounds", {})
    if reply.code != YES or len(found) != len(box):
        return WRONG, f"exit {reply.code}, {len(found)} intervals for {len(box)} variables"
    for (name, interval), (lower, upper) in zip(found.items(), box):
        for side, truth in (("lower", lower), ("upper", upper)):
            if end_of(interval[side]) != end_of(truth):
                return WRONG, f"{side} end of {name}: {interval[side]}, truth is {truth}"
    return ask.prove(proof) or (ANSWERED, "")


def judge_optimum(out, best):
    """Is the value the one recorded, which is rounded? None, or what is wrong."""
    found = out["optimum"]["value"]
    if found is None or "inf" in found:
        return f"{found}, truth is {best}"
    near = abs(Fraction(found) - Fraction(best)) <= TOLERANCE * max(1, abs(Fraction(best)))
    return None if near else f"about {float(Fraction(found))!r}, truth is {best}"


def ask_optimum(ask, best):
    """The objective of the file, integers as reals."""
    proof = ask.proof_path("optimize")
    reply, end = ask.query(["optimize", ask.path, "--relax", "--proof", proof])
    if end:
        return end
    if reply.code != YES or not reply.out["optimum"]["attained"]:
        return WRONG, f"exit {reply.code}, {reply.out.get('optimum')}"
    why = judge_optimum(reply.out, best)
    if why:
        return WRONG, why
    return ask.prove(proof, "--relax", "--expect", "optimum") or (ANSWERED, "")


def rows_of(out):
    """Rows of a JSON reply."""
    return [([Fraction(a) for a in r["coefficients"]], r["relation"], Fraction(r["rhs"]))
            for r in out["rows"]]


def sizes(rows):
    """(equalities, inequalities)"""
    equalities = sum(rel == "=" for _, rel, _ in rows)
    return equalities, len(rows) - equalities


def recorded_sizes(irredundant):
    """{(equalities, inequalities): names of the tools that say so}"""
    table = {}
    for tool, said in irredundant.items():
        size = (said["eq"], said["ineq"]) if tool == "ppl" else (said["lin"], said["rows"] - said["lin"])
        table.setdefault(size, []).append(tool)
    return table


def reduce_rows(ask):
    """(rows of the irredundant system, None) or (None, what ends the question)"""
    proof = ask.proof_path("reduce")
    reply, end = ask.query(["reduce", ask.path, "--proof", proof])
    if end:
        return None, end
    bad = ask.prove(proof)
    return (None, bad) if bad else (rows_of(reply.out), None)


def ask_size(ask, irredundant):
    found, end = reduce_rows(ask)
    if end:
        return end
    size, table = sizes(found), recorded_sizes(irredundant)
    if size not in table:
        return WRONG, f"{size[0]} equalities + {size[1]} inequalities, tools say {table}"
    return ANSWERED, "as " + "+".join(table[size])


def ask_reduced(ask, truth):
    """The irredundant system must be, as a set of rows modulo equalities, truth."""
    found, end = reduce_rows(ask)
    if end:
        return end
    if exact.canonical(found) != exact.canonical(truth) or sizes(found) != sizes(truth):
        return WRONG, f"{len(found)} rows, not those recorded ({len(truth)})"
    return ANSWERED, ""


def ask_minimal(ask, size):
    found, end = reduce_rows(ask)
    if end:
        return end
    return (ANSWERED, "") if sizes(found) == size else (WRONG, f"{sizes(found)}, truth is {size}")


def ask_projection(ask, keep, truth, size):
    """truth: the recorded rows, "empty", or None if only size, (equalities, inequalities), is
    known."""
    proof = ask.proof_path("project")
    reply, end = ask.query(["project", ask.path, "--keep", ",".join(keep), "--proof", proof])
    if end:
        return end
    found = rows_of(reply.out)
    if truth == "empty":
        if exact.canonical(found)[0] != "empty":
            return WRONG, "the projection is empty, not so the result"
    elif truth is None:
        if sizes(found) != size:
            return WRONG, f"{sizes(found)} rows, truth is {size}"
    elif exact.canonical(found) != exact.canonical(truth) or sizes(found) != sizes(truth):
        return WRONG, f"{len(found)} rows, not those recorded ({len(truth)})"
    return ask.prove(proof) or (ANSWERED, "")


def ask_rejection(ask, recorded):
    """A file that needs Boolean search: exit 65 and "not a conjunction"; a right verdict will do."""
    reply = ask.fmb.ask(["solve", ask.path], ask.left)
    ask.query_seconds += reply.seconds
    if reply.crash is not None:
        return CRASHED, reply.crash
    if reply.code == 65 and "not a conjunction" in reply.err:
        return ANSWERED, "rejected"
    if reply.code in (YES, NO) and reply.out.get("verdict") == VERDICT_OF[recorded]:
        return ANSWERED, "solved all the same"
    return WRONG, f"exit {reply.code}: {reply.err[-200:]}"
