"""What fmb-qualify found, to be looked at: report.html (one file, nothing outside it), which opens with what came out, and each
figure as SVG and PDF, all made of report.json (and bunny-mesh.csv) alone. Figures need matplotlib.
usage: report.py FOLDER"""

import html
import json
import math
import pathlib
import re
import sys

STYLE = """
body { font: 16px/1.5 sans-serif; max-width: 44em; margin: 1.5em auto; padding: 0 1em; color: #222; overflow-wrap: break-word }
h2 { font-size: 1.15em; margin: 2em 0 .4em } ul { columns: 3 7em; padding-left: 1.2em }
table { border-collapse: collapse; margin: .5em 0 1.5em; font-size: 14px; font-variant-numeric: tabular-nums }
caption { text-align: left; font-weight: bold; padding: .5em 0 }
th, td { padding: .15em .6em; border-bottom: 1px solid #ddd; text-align: left; white-space: nowrap }
th { border-bottom: 2px solid #888 } .r { text-align: right } .wide { overflow-x: auto }
figure { margin: 1em 0; max-width: 34em } figure svg { width: 100%; height: auto } figcaption { font-size: 14px; color: #444 }
summary { cursor: pointer; color: #058; padding: .3em 0 } .missing { background: #fee; padding: .5em } a { color: #058 }
"""

# ---- tables ---------------------------------------------------------------------------------------


def value_at(row, key):
    for name in key.split("."):
        row = row.get(name) if isinstance(row, dict) else None
    return row


def cell_text(value, form):
    if value is None or isinstance(value, bool):
        return {None: "-", True: "yes", False: "no"}[value]
    return form % value if form and not isinstance(value, str) else str(value)


def table_html(study, part):
    def line(tag, cells):
        return "<tr>" + "".join(f'<{tag}{" class=r" if form else ""}>{html.escape(text)}</{tag}>'
                                for text, (_, _, form) in zip(cells, part["columns"])) + "</tr>\n"
    body = "".join(line("td", [cell_text(value_at(row, key), form) for key, _, form in part["columns"]])
                   for row in study.get(part["rows"], []))
    head = line("th", [title for _, title, _ in part["columns"]])
    name = f'{study["study"]}-{part["table"]}.csv'
    return (f'<div class="wide"><table>\n<caption>{html.escape(part["caption"])} '
            f'<a href="{name}">CSV</a></caption>\n{head}{body}</table></div>\n')


# ---- figures --------------------------------------------------------------------------------------


def inline(folder, base):
    """The SVG, as it stands in a page: names of one figure must not clash with those of the next."""
    svg = (folder / f"{base}.svg").read_text()
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg[svg.index("<svg"):], flags=re.S)
    return re.sub(r'\b(id="|href="#|url\(#)', rf"\g<1>{base}-", svg)


def figures_html(folder, study):
    """All figures of a study; without what draws, a line that says so."""
    if not pictures:
        return f'<p class="missing"><strong>Not drawn: {figures_html.fault}.</strong></p>\n'
    parts = []
    for name, figure, caption in pictures.FIGURES[study["study"]](study, folder):
        base = f'{study["study"]}-{name}'
        pictures.plotting.save(figure, folder / f"{base}.svg", folder / f"{base}.pdf")
        parts.append(f'<figure>\n{inline(folder, base)}<figcaption>{html.escape(caption)} <a href="{base}.svg">SVG</a> '
                     f'<a href="{base}.pdf">PDF</a></figcaption>\n</figure>\n')
    return "".join(parts)


try:
    import pictures
    figures_html.fault = None
except ImportError as why:
    pictures = None
    figures_html.fault = f"python3 has no {why.name}"

# ---- what came out --------------------------------------------------------------------------------


def mean(values):
    values = [v for v in values if v and v > 0]
    return math.exp(sum(map(math.log, values)) / len(values)) if values else math.nan


def of_verdicts(study):
    ratios = [cell["fmb_over_sat"]["ratio"] for cell in study["cells"]]
    wins, differ = sum(r < 1 for r in ratios), sum(cell["different"] for cell in study["cells"])
    return (f"FMB took {mean(ratios):.2f} of the time of SAT in the mean of {len(ratios)} cells, {min(ratios):.2f} to {max(ratios):.2f}; it "
            f"was faster in {wins}. {differ} verdicts differ.")


def of_article(study):
    of = {key: [value_at(cell, key) for cell in study["cells"]] for key in ("published", "repeated.mean", "packed.fmb_over_sat.ratio")}
    listed, packed = of["repeated.mean"], of["packed.fmb_over_sat.ratio"]
    return (f'Time of FMB over that of SAT, mean of {len(listed)} cells: {mean(of["published"]):.2f} as published, {mean(listed):.2f} for the '
            f"article's program by its method here, {mean(packed):.2f} for ours on sets of frames, which was faster in {sum(r < 1 for r in packed)}.")


def of_boxes(study):
    ours = [row for row in study["sizes"] if row["box"] == "ours"]
    worst = max(row["max"] for row in ours) - 1
    costs = mean([row["box_over_verdict"]["ratio"] for row in study["times"]])
    return (f"Our boxes have the tightest volume up to {worst:.1g} of it at worst, and cost {costs:.1f} times a verdict; {study['wrong']} are "
            "wrong. The others are larger by what the figure shows.")


def of_scaling(study):
    largest = max(row["dim"] for row in study["cells"])
    times = ", ".join(f'{mean([row["fmb_ns"] for row in study["cells"] if row["dim"] == dim]):.3g} ns in {dim}D'
                      for dim in sorted({2, 3, largest}))
    return f"A verdict took {times}, means over shapes and motion."


def of_rules(study):
    rows = [row for row in study["classes"] if row["order"] == study["orders"][0]]
    wrong = sum(row["wrong"] for row in study["classes"])
    sets = {row["rules"]: [] for row in rows if row["rules"] != "none"}
    for row in rows:
        if row["rules"] in sets and row["stopped"] == 0 and row.get("sum_ratio"):
            sets[row["rules"]].append(row["sum_ratio"])
    best = min(sets, key=lambda name: mean(sets[name]) if sets[name] else math.inf, default=None)
    return (f"{wrong} answers are wrong. " +
            (f"Fewest rows were alive with {best}: {mean(sets[best]):.2f} of those without rules." if best and sets[best] else ""))


def of_peers(study):
    wins = [row["over_fmb"]["ratio"] for row in study["times"] if row["peer"] != study["peers"][0]]
    missing = f' Not installed: {study["missing"]}.' if study.get("missing") else ""
    return (f'Others took {min(wins):.2g} to {max(wins):.2g} times the time of {study["peers"][0]}, {mean(wins):.2g} in the mean.' if wins else "") + missing


def of_bunny(study):
    trees = study["ways"][0]
    return (f'{len(study["faces_of_A_that_meet"])} of {study["faces"]} faces meet the mirror image; trees of boxes tell in '
            f'{trees["seconds"]:.3f} s, by {trees["tests"]:.0f} tests of pairs. {study["wrong"]} verdicts differ.')


OUTCOMES = {**dict.fromkeys(("table1", "near", "touching", "slender", "mesh", "faces"), of_verdicts), "article": of_article, "boxes": of_boxes,
            "scaling": of_scaling, "rules": of_rules, "peers": of_peers, "bunny": of_bunny}


def outcome(study):
    """A sentence; of a study that did not come to its end, that."""
    if not study["complete"]:
        return "Interrupted: what was not complete is left out."
    return OUTCOMES[study["study"]](study)


# ---- the page -------------------------------------------------------------------------------------


def machine_html(study):
    m = study["machine"]
    return html.escape(f'fmb {study["version"]} ({study["commit"]}); {m["cpu"]}, {m["cores"]} cores, '
                       f'{m["memory_bytes"] / 2**30:.1f} GiB; {m["os"]}, Linux {m["kernel"]}; {m["compiler"]}, '
                       f'{m["flags"]}; load {m["load"]:.2f} when it began')


def study_html(folder, study):
    """What came out, its figures; and folded, what it rests on."""
    parts = [f'<section>\n<h2 id="{study["study"]}">{study["study"]}: {html.escape(study["title"])}</h2>\n',
             f'<p class="outcome">{html.escape(outcome(study))}</p>\n', figures_html(folder, study),
             "<details><summary>All numbers</summary>\n", f"<p>{machine_html(study)}</p>\n"]
    for part in study["page"]:
        parts.append(table_html(study, part) if "table" in part else f'<p>{html.escape(part["text"])}</p>\n')
    return "".join(parts) + "</details>\n</section>\n"


def main(folder):
    report = json.loads((folder / "report.json").read_text())
    studies = report.get("studies", [report])
    contents = "".join(f'<li><a href="#{s["study"]}">{s["study"]}</a></li>\n' for s in studies)
    body = "".join(study_html(folder, study) for study in studies)
    (folder / "report.html").write_text(
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>fmb-qualify</title>\n'
        f"<style>{STYLE}</style>\n</head>\n<body>\n<h1>fmb-qualify</h1>\n"
        + (f"<ul>\n{contents}</ul>\n" if len(studies) > 1 else "") + body + "</body>\n</html>\n")
    if figures_html.fault:
        print(f"fmb-qualify: {figures_html.fault}: pictures are missing; with matplotlib, `python3 {__file__} {folder}` makes them",
              file=sys.stderr)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
