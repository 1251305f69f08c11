#!/usr/bin/env python3
"""Twenty everyday tasks in Python, with fmb and with others: lines of code, and time.

usage: compare.py PACKAGE_FOLDER [OUT.md]

Lines are those of the function of the task, without its head, and of the helpers of its file that it
calls; no blank ones, no comments. Times are of the processor, medians over rounds in which libraries take
turns; a call makes all of its objects anew. Answers are compared. A library that is not installed is
compared by its lines alone, which are then written from its documentation and were never run."""

import ast
import importlib
import pathlib
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
LIBRARIES = {"fmb": ("fmb", "fmb"), "ppl": ("pplpy", "ppl"), "cdd": ("pycddlib 3", "cdd"),
             "isl": ("islpy", "islpy"), "sympy": ("SymPy", "sympy")}
ROUNDS, SECONDS = 15, 0.004


def lines_of(path):
    """Of each function of a file: its lines of code and those of the helpers that it calls, names first."""
    text = path.read_text(encoding="utf-8")
    source = text.splitlines()
    functions = {node.name: node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)}

    def own(node):
        body = [line for line in source[node.body[0].lineno - 1:node.end_lineno] if line.strip()]
        return sum(not line.strip().startswith("#") for line in body)

    def used(node, known):
        for call in ast.walk(node):
            if isinstance(call, ast.Name) and call.id in functions and call.id not in known:
                known.add(call.id)
                used(functions[call.id], known)
        return known
    return {name: own(node) + sum(own(functions[helper]) + 1 for helper in used(node, {name}) - {name})
            for name, node in functions.items()}


def installed(key):
    """The functions of a library, or None where it is not there."""
    try:
        return importlib.import_module(f"with_{key}")
    except ImportError as e:
        print(f"{LIBRARIES[key][0]}: {e}: lines alone", file=sys.stderr)
        return None


def works(function, given):
    """Does this version have what it needs?"""
    try:
        function(*given)
        return True
    except ImportError:
        return False


def once(function, given):
    begin = time.process_time()
    function(*given)
    return time.process_time() - begin


def times(functions, given):
    """Medians of the seconds of a call, in turns; a turn is as many calls as take a while."""
    calls = {key: max(1, int(SECONDS / max(once(function, given), 1e-6))) for key, function in functions.items()}
    taken = {key: [] for key in functions}
    for _ in range(ROUNDS):
        for key, function in functions.items():
            begin = time.process_time()
            for _ in range(calls[key]):
                function(*given)
            taken[key].append((time.process_time() - begin) / calls[key])
    return {key: sorted(some)[len(some) // 2] for key, some in taken.items()}


def answers(functions, given, judge, name):
    """All are right: the same, or such as the task wants."""
    found = {key: judge(function(*given)) for key, function in functions.items()}
    for key, value in found.items():
        if value != found["fmb"] or value is False and name in ("solution", "conflict", "multipliers"):
            sys.exit(f"{name}: {key} says {value}, fmb {found['fmb']}")


def human(seconds):
    return f"{seconds * 1e6:.0f} µs" if seconds < 1e-3 else f"{seconds * 1e3:.2f} ms"


def cell(key, lines, seconds):
    """Lines and time of a library at a task."""
    if lines is None:
        return "–"
    return f"{lines}, {human(seconds[key])}" if key in seconds else f"{lines}"


def table(tasks, modules, lines):
    ahead = {key: [0, 0, 0, 0] for key in lines if key != "fmb"}  # lines, time, both, timed
    yield "| | " + " | ".join(LIBRARIES[key][0] for key in lines) + " |"
    yield "|---|" + "---:|" * len(lines)
    for name, question, given, judge in tasks:
        functions = {key: getattr(module, name) for key, module in modules.items()
                     if module and hasattr(module, name) and works(getattr(module, name), given)}
        answers(functions, given, judge, name)
        seconds = times(functions, given)
        yield f"| {question} | " + " | ".join(cell(key, own.get(name), seconds)
                                             for key, own in lines.items()) + " |"
        for key, counts in ahead.items():
            shorter = name not in lines[key] or lines["fmb"][name] <= lines[key][name]
            faster = key in seconds and seconds["fmb"] <= seconds[key]
            counts[0] += shorter
            counts[1] += faster
            counts[2] += shorter and faster
            counts[3] += key in seconds
    for word, place in (("no more lines", 0), ("no more time", 1), ("both", 2)):
        yield f"| **{word}** | | " + " | ".join(
            f"{c[place]} of {len(tasks) if place == 0 else c[3]}" if place == 0 or c[3] else "not run"
            for c in ahead.values()) + " |"


def main():
    sys.path[:0] = [str(HERE), sys.argv[1]]
    from tasks import TASKS
    keys = [key for key in LIBRARIES if (HERE / f"with_{key}.py").exists()]
    modules = {key: installed(key) for key in keys}
    lines = {key: lines_of(HERE / f"with_{key}.py") for key in keys}
    made = "\n".join(table(TASKS, modules, lines))
    if len(sys.argv) > 2:
        page = pathlib.Path(sys.argv[2])
        text = page.read_text(encoding="utf-8")
        head, _, rest = text.partition("<!-- table -->")
        page.write_text(head + "<!-- table -->\n" + made + "\n<!-- end -->" + rest.partition("<!-- end -->")[2],
                        encoding="utf-8")
    print(made)


if __name__ == "__main__":
    main()
