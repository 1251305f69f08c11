"""Tables of measurements in the pages of the site, made of the CSV files in data/: tables.py [--write] [DATA]

A page has `<!-- table: NAME -->`, the table and `<!-- end -->`. Without --write it is an error if a table is not what the
files say; with it, the pages are written anew."""

import csv
import math
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
MARK = re.compile(r"(<!-- table: ([\w-]+) -->\n).*?(<!-- end -->)", re.S)
# Libraries by the first word of their drivers in bench-peers.
LIBRARIES = {"cdd": "cddlib", "glpk": "GLPK", "isl": "isl", "lrs": "lrslib", "normaliz": "Normaliz", "ppl": "PPL",
             "qsopt": "QSopt_ex", "z3": "z3"}
QUESTIONS = {"projections": "projections", "verdicts": "verdicts", "vertices": "vertices of rows",
             "hulls": "rows of vertices"}


class Data:
    """The files of a folder, as lists of dictionaries."""

    def __init__(self, folder):
        self.folder = folder

    def __getitem__(self, name):
        path = self.folder / f"{name}.csv"
        if not path.exists():
            return []
        with open(path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))


def number(value, digits=3):
    """A number with so many significant digits, and no exponent."""
    value = float(value)
    places = max(0, digits - 1 - math.floor(math.log10(abs(value)))) if value else 0
    return f"{value:.{places}f}"


def markdown(head, rows):
    """A table; columns of numbers stand on the right."""
    numbers = [rows and all(re.fullmatch(r"[\d.]+", str(row[i])) for row in rows) for i in range(len(head))]
    lines = [head, ["---:" if right else ":---" for right in numbers], *rows]
    return "\n" + "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines) + "\n"


def is_of(driver, library):
    """Is a column of times that of a driver of this library?"""
    return driver.split("-")[0] in (library, LIBRARIES.get(library))


def best(line, library):
    """The least time of a library's drivers on a problem; None where none of them ended."""
    return min((float(time) for driver, time in line.items() if time and is_of(driver, library)), default=None)


def compared(lines, library):
    """Problems, how often libfmb was faster, who alone ended, and the other's time over libfmb's."""
    asked = [line for line in lines if any(is_of(d, library) for d in line)]
    ratios = sorted((best(line, library) / best(line, "fmb"), line["problem"]) for line in asked
                    if best(line, library) and best(line, "fmb"))
    alone = sum(1 for line in asked if best(line, "fmb") and not best(line, library))
    lost = sum(1 for line in asked if best(line, library) and not best(line, "fmb"))
    if not ratios:
        return None
    mean = math.exp(sum(math.log(ratio) for ratio, _ in ratios) / len(ratios))
    faster = sum(1 for ratio, _ in ratios if ratio >= 1)
    return [len(asked), faster, alone, lost, number(mean), number(ratios[0][0]), ratios[0][1]]


HEAD = ["problems", "libfmb faster", "only libfmb ended", "only the other ended", "mean ratio", "least ratio", "on"]


def of_question(data, name):
    """One question, a row for each library."""
    lines = data[name]
    rows = [[title, *found] for library, title in LIBRARIES.items()
            if (found := compared(lines, library)) is not None]
    return markdown(["library", *HEAD], rows)


def of_library(data, library):
    """One library, a row for each question that it answers."""
    rows = [[title, *found] for name, title in QUESTIONS.items()
            if (found := compared(data[name], library)) is not None]
    return markdown(["question", *HEAD], rows)


def of_pairs(data):
    """Nanoseconds a pair."""
    return markdown(["case, pair, meeting", "libfmb [ns]", "separating axes [ns]", "ratio"],
                    [[f"{c['case']}, {c['pair']}, {c['meeting']}", c["fmb_ns"], c["sat_ns"],
                      number(float(c["fmb_ns"]) / float(c["sat_ns"]))] for c in data["pairs"]])


def of_shapes(data, only=""):
    """Other libraries on the same pairs."""
    lines = data["shapes"]
    ours = {line["cell"]: float(line["ns"]) for line in lines if line["peer"] == "FMB"}
    return markdown(["pairs", "way", "time [ns]", "time over libfmb's"],
                    [[line["cell"], line["peer"], number(line["ns"]), number(float(line["ns"]) / ours[line["cell"]])]
                     for line in lines if line["peer"] == "FMB" or only in line["peer"]])


def of_faults(data, only=""):
    """Their wrong answers, on easy pairs and on hard ones."""
    keys = ["queries", "false_meet", "false_apart", "unknown"]
    return markdown(["family, way", "asked", "wrongly said to meet", "wrongly said to be apart", "given up"],
                    [[f"{line['family']}, {line['peer']}", *(line[key] for key in keys)] for line in data["faults"]
                     if line["peer"] == "FMB" or only in line["peer"]])


def of_programs(data):
    """Linear programs."""
    return markdown(["rows × variables", "HiGHS [ms]", "libfmb with proof [ms]", "time over HiGHS's", "check of the proof [ms]"],
                    [[f"{p['rows']} × {p['variables']}", number(p["highs_ms"]), number(p["fmb_ms"]),
                      number(float(p["fmb_ms"]) / float(p["highs_ms"])), number(p["check_ms"])] for p in data["programs"]])


def of_symbols(data):
    """Rows in one variable."""
    return markdown(["rows in one variable", "SymPy [ms]", "libfmb [ms]", "SymPy's time over libfmb's", "version of SymPy"],
                    [[p["rows"], number(p["sympy_ms"]), number(p["fmb_ms"]),
                      number(float(p["sympy_ms"]) / float(p["fmb_ms"])), p["version"]] for p in data["symbols"]])


def table(data, name):
    """The table of that name."""
    if name in QUESTIONS:
        return of_question(data, name)
    if name in LIBRARIES.values() or name in LIBRARIES:
        return of_library(data, next(key for key, title in LIBRARIES.items() if name in (key, title)))
    if name == "machine":
        return markdown(["record", "value"], [[line["what"], line["value"]] for line in data["machine"]])
    return {"pairs": of_pairs, "shapes": of_shapes, "faults": of_faults, "programs": of_programs, "symbols": of_symbols,
            "libccd": lambda d: of_shapes(d, "libccd"), "libccd-faults": lambda d: of_faults(d, "libccd")}[name](data)


def main():
    rewrite = "--write" in sys.argv
    folder = next((arg for arg in sys.argv[1:] if not arg.startswith("-")), HERE / "data")
    data, faults = Data(pathlib.Path(folder)), []
    for page in [HERE / "index.md", *sorted((HERE.parent / "coming-from").glob("*.md"))]:
        text = page.read_text(encoding="utf-8")
        now = MARK.sub(lambda found: found[1] + table(data, found[2]) + found[3], text)
        if rewrite:
            page.write_text(now, encoding="utf-8")
        elif now != text:
            faults.append(f"{page}: not what the files in {folder} say; tables.py --write")
    print("\n".join(faults) or "tables: as in the files")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
