"""The files of each family, and the questions that answers.json records about each.

A case is (name, path, questions): questions is a list of (kind, function of an Ask). Files that
must be written first (the proj family is wrapped text) are written to the scratch folder.
"""

import json
import os
import re
from functools import partial

import programs
import questions as q
import rows as exact

FAMILIES = ("cdd", "proj", "lp", "fm", "smt")


def answers(root, family):
    with open(os.path.join(root, family, "answers.json"), encoding="utf-8") as f:
        return json.load(f)


def text_of(path):
    with open(path, encoding="utf-8", errors="replace") as f:
        return f.read()


def default_names(n):
    return [f"x{j}" for j in range(1, n + 1)]


def row_of(words, sign):
    """A recorded row "b a1..an" with the relation's word in front; sign -1: b + a.x >= 0."""
    rel = {"I": "<=", "E": "="}.get(words[0], words[0])
    numbers = [exact.Fraction(w) for w in words[1:]]
    return [sign * a for a in numbers[1:]], rel, numbers[0]


def cdd(root, _):
    recorded = answers(root, "cdd")
    for key, said in sorted(recorded.items()):
        path = os.path.join(root, key)
        is_ine = key.endswith(".ine")
        rows = exact.read_ine(text_of(path)) if is_ine else None
        asked = [("verdict", partial(q.ask_verdict, recorded=said.get("feasible"), rows=rows))]
        if "box" in said:
            asked.append(("box", partial(q.ask_box, box=said["box"])))
        if "irredundant" in said:
            asked.append(("reduce", partial(q.ask_size, irredundant=said["irredundant"])))
        projection = said.get("projection")
        if projection and isinstance(projection["ppl"], dict):
            asked.append(("project", cdd_projection(root, said, projection)))
        yield key, path, asked


def cdd_projection(root, said, projection):
    """Recorded rows read "REL b a..", a.x REL b; else the source's own result file; else sizes."""
    names = default_names(said["n"])
    keep = [names[j - 1] for j in projection["keep_1based"]]
    size = (projection["ppl"]["eq"], projection["ppl"]["ineq"])
    truth = None
    if "rows" in projection:
        truth = [row_of(r.split(), 1) for r in projection["rows"]]
    elif "source_expected" in projection:
        path = os.path.join(root, "cdd", "cdd_" + projection["source_expected"])
        truth = exact.read_ine(text_of(path)) if os.path.exists(path) else None
    return partial(q.ask_projection, keep=keep, truth=truth, size=size)


def fm(root, _):
    for key, said in sorted(answers(root, "fm").items()):
        path = os.path.join(root, "fm", key + ".ine")
        rows = exact.read_ine(text_of(path))
        asked = [("verdict", partial(q.ask_verdict, recorded=said["feasible"], rows=rows))]
        if "box" in said:
            asked.append(("box", partial(q.ask_box, box=said["box"])))
        if said["projection"] is not None:
            asked.append(("project", fm_projection(said)))
        yield "fm/" + key, path, asked


def fm_projection(said):
    """Recorded rows read "I b a..", b + a.x >= 0, over the first keep variables."""
    projection, truth, size = said["projection"], "empty", None
    if isinstance(projection, dict):
        size = (projection["equalities"], projection["inequalities"])
        listed = projection["rows"]
        truth = None if listed is None else [row_of(r.split(), -1) for r in listed]
    keep = default_names(said["n"])[: said["keep"]]
    return partial(q.ask_projection, keep=keep, truth=truth, size=size)


def optima(root):
    """{name: recorded value}"""
    path, table = os.path.join(root, "lp", "optima.json"), {}
    if os.path.exists(path):
        with open(path, encoding="utf-8") as f:
            for name, said in json.load(f).items():
                table[name] = programs.ODD.get(name, next(iter(said.values())))
    return table


def lp(root, _):
    optimal = optima(root)
    for key, said in sorted(answers(root, "lp").items()):
        asked = [("verdict", partial(q.ask_verdict, recorded=said["answer"], rows=None))]
        name = os.path.splitext(os.path.basename(key))[0]
        if name in optimal:
            asked.append(("optimum", partial(q.ask_optimum, best=optimal[name])))
        yield key, os.path.join(root, key), asked


def smt(root, _):
    for key, said in sorted(answers(root, "smt").items()):
        if said["pure_conjunction"]:
            ask = partial(q.ask_verdict, recorded=said["answer"], rows=None)
            yield key, os.path.join(root, key), [("verdict", ask)]


def smt_other(root, _):
    for key, said in sorted(answers(root, "smt").items()):
        if not said["pure_conjunction"]:
            ask = partial(q.ask_rejection, recorded=said["answer"])
            yield key, os.path.join(root, key), [("rejection", ask)]


def proj(root, scratch):
    for key, said in sorted(answers(root, "proj").items()):
        names, lines = said["vars"], wrapped(text_of(os.path.join(root, key)))
        path = os.path.join(scratch, os.path.basename(key)[:-4] + ".fmb")
        with open(path, "w", encoding="utf-8") as f:
            f.write("vars: " + " ".join(names) + "\n" + "\n".join(lines) + "\n")
        rows = [exact.read_line(line, names) for line in lines]
        asked = [("verdict", partial(q.ask_verdict, recorded=said["feasible"], rows=rows))]
        asked += proj_question(said, rows)
        yield key, path, asked


def wrapped(text):
    """The indented lines below "system:"."""
    lines = text.split("\nsystem:\n", 1)[1].splitlines()
    end = next((i for i, line in enumerate(lines) if not line.startswith("  ")), len(lines))
    return [line.strip() for line in lines[:end]]


def proj_question(said, rows):
    if said["question"] == "project":
        truth = [exact.read_line(r, said["exact_vars"]) for r in said["exact_projection"]]
        ask = partial(q.ask_projection, keep=said["exact_vars"], truth=truth, size=None)
        return [("project", ask)]
    if said["question"].startswith("redundant rows"):
        stay = [r for i, r in enumerate(rows) if i not in said["source_answer"]]
        return [("reduce", partial(q.ask_reduced, truth=stay))]
    if said["question"] == "minimal rows":
        size = tuple(int(n) for n in re.findall(r"\d+", said["source_answer"]))
        return [("reduce", partial(q.ask_minimal, size=size))]
    return []
