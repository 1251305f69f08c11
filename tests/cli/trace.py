"""--trace with --trace-rows on all verbs: every line is JSON, and what the lines say fits together.
usage: trace.py FMB EXAMPLES"""

import json
import pathlib
import subprocess
import sys
import tempfile

import under

fmb, examples = under.command(sys.argv[1]), pathlib.Path(sys.argv[2])
SOME = """vars: x y z w
x + y + z <= 6
x - y <= 1
-x + z <= 1
y - z <= 1
-x - y <= 3
-y - z <= 3
x + z <= 4
-x + y - z <= 2
w <= 3
x + w >= -5
"""
KEYS = {
    "begin": {"name"}, "end": {"name"}, "lp": {"rows_in", "rows_out"},
    "round": {"round", "var", "rows_in", "rows_out", "pairs", "made", "dropped", "widened"},
    "rule": {"name", "round", "var", "dropped"}, "rebase": {"round", "rows"},
    "engine": {"name", "task", "columns", "rows", "ended"},
    "row": {"round", "var", "row", "parents", "dropped_by", "minimal"},
}
HISTORY = {"history", "effective", "implicit"}
MORE = {"row": HISTORY, "engine": {"part", "budget", "unit", "spent", "left"}}
seen = dict.fromkeys([*KEYS, "dropped", "histories", "implicit", "not minimal"], 0)


def trace(folder, *words):
    out = folder / "trace"
    run = subprocess.run([*fmb, *words, "--trace", str(out), "--trace-rows", "true"],
                         capture_output=True, text=True)
    assert run.returncode in (0, 1), f"{words}: {run}"
    return [json.loads(line) for line in out.read_text().splitlines()]


def look_at_row(e, rows, dims):
    """A history is the union of the parents'. One query may eliminate several times, also on from
    the middle of what it did before, so a number may have stood for several rows, or a base row."""
    assert all(0 < p for p in e["parents"]) and 1 <= e["var"] <= dims, e
    if "history" not in e:
        assert e["minimal"] is None and not HISTORY & set(e), e
        return
    assert HISTORY <= set(e) and isinstance(e["minimal"], bool), e
    p, q = ([{n}, *rows.get(n, [])] for n in e["parents"])
    assert any(set(e["history"]) == a | b for a in p for b in q), (e, p, q)
    assert e["var"] in e["effective"] and not set(e["effective"]) & set(e["implicit"]), e
    assert all(1 <= v <= dims for v in e["effective"] + e["implicit"]), e
    seen["histories"] += 1
    seen["implicit"] += bool(e["implicit"])
    seen["not minimal"] += not e["minimal"]
    if e["dropped_by"] is None:
        rows.setdefault(e["row"], []).append(set(e["history"]))


def look(events, dims):
    rows, made, dropped, time = {}, 0, 0, 0.0
    for e in events:
        kind = e["event"]
        extra = set(e) - {"event", "seconds"} - KEYS[kind]
        assert KEYS[kind] <= set(e) and extra <= MORE.get(kind, set()), e
        assert e["seconds"] >= time, e
        time = e["seconds"]
        seen[kind] += 1
        if kind == "row":
            look_at_row(e, rows, dims)
            made += 1
            dropped += e["dropped_by"] not in (None, "constant")
        elif kind == "round":
            assert e["made"] >= made and e["dropped"] >= dropped, (e, made, dropped)
            made = dropped = 0
        elif kind == "begin":
            assert e is events[0]
        elif kind == "end":
            assert e is events[-1]
    seen["dropped"] += sum(e.get("dropped", 0) for e in events if e["event"] == "rule")


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    some = folder / "some.fmb"
    some.write_text(SOME)
    for file, dims, keep in ((some, 4, "x"), (examples / "breakfast.fmb", 3, "milk")):
        for verb in (["solve"], ["bounds"], ["reduce"], ["project", "--keep", keep],
                     ["optimize", "--max", " + ".join(keep.split(","))]):
            for rules in ("none", "kohler", "imbert,box", "kohler,duplicate"):
                for more in ([], ["--rebase", "always", "--method", "fm"],
                             ["--presolve", "none", "--method", "fm"]):
                    look(trace(folder, verb[0], str(file), *verb[1:], "--rules", rules, *more), dims)
assert all(seen.values()), f"nothing to look at: {seen}"
print(seen)
