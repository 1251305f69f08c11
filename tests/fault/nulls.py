"""Calls with NULL in place of each pointer in turn, of every function that the public headers declare:
writes the C text that nulls.h runs. usage: nulls.py INCLUDE OUT

What a function is handed otherwise follows from the types and names of its parameters (nulls.h, `world`), or
stands in GIVEN. A function with a parameter of which neither says anything is a fault here: no function is left
out, and none can be added without being asked."""

import pathlib
import re
import sys

FUNCTION = re.compile(r"FMB_API\b([^;{]*?)\b(fmb_\w+)\s*\(([^;{]*)\)\s*;", re.S)
COMMENT = re.compile(r"/\*.*?\*/", re.S)

# Arguments by the name of the function and of the parameter.
GIVEN = {
    ("fmb_mesh_new", "corners"): "3", ("fmb_mesh_new", "vertices"): "3",
    ("fmb_mesh_new", "cells"): "1",
    ("fmb_mesh_distance", "b"): "w->other_mesh",
    ("fmb_mesh_meet_pairs", "from"): "0", ("fmb_mesh_meet_pairs", "to"): "1",
    ("fmb_options_set", "name"): '"max_rows"', ("fmb_options_set", "value"): '"1"',
    ("fmb_system_add_rows", "start"): "w->start", ("fmb_system_add_rows_int", "start"): "w->start",
    ("fmb_system_set_name", "name"): '"y"', ("fmb_system_add_variable", "name"): '"y"',
    ("fmb_solver_add_variable", "name"): '"y"', ("fmb_system_find", "name"): '"x1"',
    ("fmb_rule_find", "name"): '"box"',
    ("fmb_frames_meet", "told"): "hear_of_pairs", ("fmb_frames_meet", "self"): "w",
    ("fmb_system_from_frames", "n"): "2", ("fmb_system_from_frames_q", "n"): "2",
    ("fmb_frames_new", "dim"): "1", ("fmb_frames_from_arrays", "dim"): "1", ("fmb_pair_new", "dim"): "1",
    ("fmb_frame_reader_from_text", "text"): '" "', ("fmb_frame_reader_from_text", "size"): "1",
    ("fmb_rows_classes", "projection"): "w->line", ("fmb_image", "graph"): "w->graph",
    ("fmb_separates", "row"): "w->line", ("fmb_separates_q", "row"): "w->line",
    ("fmb_generators_get", "n"): "1", ("fmb_lift_generators", "like"): "w->line",
    ("fmb_permutations_add", "image"): "w->order",
    ("fmb_mesh_parse_tetgen", "points_size"): "1", ("fmb_mesh_parse_tetgen", "cells_size"): "1",
}
# By the name of the parameter alone, where its type says too little.
NAMED = {
    "text": '"x1 >= 1"', "word": '"fmb"', "path": '"a.fmb"', "name": '"a"', "label": '"a"', "b text": '"1"',
    "points text": '"0"', "cells text": '"0"', "number text": '"1"',
}
# By type. Numbers that count something of arrays are 1, all that are indices 0.
TYPED = {
    "FILE *": "w->stream", "bool *": "&w->yes", "char *": "w->text", "const char *const *": "w->words",
    "const char **": "&w->said", "const double *": "w->numbers", "double *": "w->numbers",
    "const fmb_alloc *": "&w->alloc", "const fmb_event *": "&w->event",
    "const fmb_frame *": "w->frames", "const fmb_frame_arrays *": "&w->arrays",
    "const fmb_frame_line *": "w->of_text", "const fmb_frame_line **": "&w->next_line",
    "const fmb_frame_q *": "w->frames_q", "const fmb_frames *": "w->set",
    "const fmb_frames_pair *": "&w->couple", "const fmb_mesh_options *": "&w->mesh_options",
    "const fmb_mesh_place *": "&w->place", "const fmb_number_style *": "&w->style",
    "const fmb_objective *": "&w->objective", "const fmb_objective_q *": "&w->objective_q",
    "const fmb_options *": "&w->options", "fmb_options *": "&w->options",
    "const fmb_pair_answers *": "&w->answers", "const fmb_pair_answers_q *": "&w->answers_q",
    "const fmb_pair_options *": "&w->pair_options", "const fmb_patience *": "&w->patience",
    "const fmb_reader *": "&w->reader", "const fmb_rel *": "w->rels", "const fmb_rule *": "&w->rule",
    "const fmb_system *const *": "w->systems", "const fmb_where *": "&w->where",
    "const int *": "w->indices", "const int64_t *": "w->integers", "const mpq_t": "w->q[0]",
    "const size_t *": "w->sizes", "const uint32_t *": "w->corners", "fmb_fate *": "w->fates",
    "fmb_format *": "&w->format", "fmb_frames_told *": "hear_of_pairs",
    "fmb_generator_kind *": "&w->kind", "fmb_judgement *": "&w->judgement",
    "fmb_mesh_answer *": "&w->mesh_answer", "fmb_mesh_nearest *": "&w->mesh_nearest",
    "fmb_mesh_format *": "&w->mesh_format",
    "fmb_pair_counts *": "&w->counts", "fmb_rel *": "w->rels", "fmb_result *": "&w->result",
    "fmb_script_kind *": "&w->script_kind", "fmb_stop *": "&w->stop", "fmb_verdict *": "w->verdicts",
    "fmb_where *": "&w->where", "int *": "w->indices", "int64_t *": "w->integers", "mpq_t": "w->q[0]",
    "mpq_t *": "w->q", "mpz_t": "w->z", "size_t *": "w->sizes", "uint64_t *": "w->bits", "void *": "w",
    "fmb_chooser": "(fmb_chooser){0}", "fmb_sink": "(fmb_sink){0}", "fmb_row": "1", "double": "1",
    "int64_t": "1", "bool": "true", "const fmb_view *": "w->view",
}
OBJECT = {"system": "s", "solver": "v", "evidence": "e", "box": "box", "optimum": "best", "generators": "g",
          "mesh": "mesh", "pair": "k", "frames": "set", "frame_reader": "lines", "permutations": "p",
          "proximity": "near", "script": "script", "matrix": "matrix"}
ENUM = {"fmb_sense": "FMB_SENSE_MAX", "fmb_mesh_format": "FMB_MESH_OFF", "fmb_format": "FMB_FORMAT_TEXT"}
COUNTS = {"n": "1", "size": "sizeof w->text", "rows": "1", "dim": "2", "room": "1"}
# Where NULL has a meaning.
MAY_BE_NULL = {"where", "mem", "res", "how", "o", "patience", "lift", "index", "label", "self", "in_cells", "fate",
               "rel", "why", "like"}
MAY_BE_NULL_IN = {
    ("fmb_system_add_variable", "name"), ("fmb_solver_add_variable", "name"), ("fmb_mesh_meet", "b"),
    ("fmb_mesh_meet_pairs", "b"), ("fmb_frames_meet", "b"), ("fmb_bound", "vars"),
    ("fmb_evidence_meets", "image"), ("fmb_evidence_meets_within", "image"), ("fmb_optimize", "objective"), ("fmb_optimize_q", "objective"), ("fmb_system_join", "var"),
    ("fmb_solver_set_symmetries", "p"), ("fmb_box_ends", "lower"), ("fmb_box_ends", "upper"),
    ("fmb_generators_get", "kind"), ("fmb_generators_get", "x"),
    *((f"fmb_system_get_rows{kind}", name) for kind in ("", "_int") for name in ("start", "var", "coef", "b")),
    *(("fmb_system_get_objective_int", name) for name in ("var", "coef", "constant")),
}


def split_parameter(text):
    """(type, name) of a parameter; an array is a pointer."""
    match = re.fullmatch(r"(.*?)(\w+)(\[\w*\])?", " ".join(text.split()))
    kind = match.group(1).strip() + (" *" if match.group(3) else "")
    return kind, match.group(2)


def is_pointer(kind):
    return kind.endswith("*") or kind in ("mpq_t", "const mpq_t", "mpz_t")


def argument(function, kind, name):
    if (function, name) in GIVEN:
        return GIVEN[function, name]
    match = re.fullmatch(r"(?:const )?fmb_(\w+) (\*\*?)", kind)
    if match and match.group(1) in OBJECT:
        return f"&w->out.{match.group(1)}" if match.group(2) == "**" else "w->" + OBJECT[match.group(1)]
    if kind == "const char *":
        return NAMED.get(name, '"1"')
    if kind in TYPED:
        return TYPED[kind]
    if name == "size" and "_parse" in function:
        return 'sizeof "x1 >= 1" - 1'
    if kind in ("size_t", "int"):
        return COUNTS.get(name, "0")
    if kind.startswith("fmb_") and "*" not in kind:
        return ENUM.get(kind, f"({kind})0")
    sys.exit(f"nulls.py: {function}: what is a {kind}, {name}? Say so in TYPED or GIVEN.")


def optional(function, name):
    return (name in MAY_BE_NULL or (function, name) in MAY_BE_NULL_IN)


def neutral(kind, name):
    """An expression that says whether `got` says nothing."""
    if kind == "const char *":
        return "!got || !*got"
    if name in ("fmb_view_stop", "fmb_view_minimal"):
        return "got"
    if kind.endswith("*") or kind == "bool":
        return "!got"
    if kind == "size_t" and name.endswith("_text"):
        return 'got == 0 || (got == 1 && strcmp(w->text, "0") == 0)'
    if kind == "double":
        return "!(got < 0) && !(got > 0)"
    if kind in ("size_t", "int"):
        return f"got == 0 || got == ({kind})-1"
    return None


def declarations(include):
    for header in sorted(pathlib.Path(include).glob("fmb/*.h")):
        for kind, name, parameters in FUNCTION.findall(COMMENT.sub("", header.read_text())):
            kind = " ".join(kind.replace("FMB_CHECKED", "").split())
            parameters = [split_parameter(p) for p in parameters.split(",") if p.strip() != "void"]
            yield header.name, kind, name, parameters


def text_of_call(kind, name, parameters):
    pointers, values = [], []
    for type_of, parameter in parameters:
        value = argument(name, type_of, parameter)
        if is_pointer(type_of):
            value = f"P({len(pointers)}, {value})"
            pointers.append(parameter)
        values.append(value)
    call = f"{name}({', '.join(values)})"
    lines = ["    (void)w, (void)null;"]
    says = "true"
    if kind == "void":
        lines.append(f"    {call};")
    elif kind == "fmb_status":
        lines.append(f"    answer->status = {call};")
    else:
        lines.append(f"    {kind} got = {call};")
        says = neutral(kind, name) or "((void)got, true)"
    lines.append(f"    answer->is_neutral = {says};")
    return pointers, f"static void on_{name}(world *w, int null, nulls_answer *answer)\n{{\n" + "\n".join(lines) + "\n}\n"


def main():
    include, out = sys.argv[1:]
    texts, entries, tests = [], [], []
    for header, kind, name, parameters in declarations(include):
        pointers, text = text_of_call(kind, name, parameters)
        if not pointers:
            continue
        needed = [0 if optional(name, p) else 1 for p in pointers]
        flags = [kind == "fmb_status", name.endswith("_free"),
                 any(t == "const fmb_view *" for t, _ in parameters)]
        texts.append(text)
        entries.append(f'    {{"{name}", {len(pointers)}, {{{", ".join(map(str, needed))}}}, on_{name}'
                       + "".join(f", {str(f).lower()}" for f in flags) + "},")
        tests.append(f"Test(nulls, {name[4:]})\n{{\n    sweep(&CALLS[{len(tests)}]);\n}}\n")
    pathlib.Path(out).write_text("\n".join(
        ['/* Made by nulls.py. */', '#include "nulls.h"', "", *texts, "static const nulls_call CALLS[] = {",
         *entries, "};", "", *tests]))


main()
