"""What fmb-qualify found, to be looked at: report.html (one file, nothing outside it) and each figure
as SVG and PNG, beside the gnuplot script that draws it, all made of report.json alone.
usage: report.py FOLDER"""

import html
import json
import pathlib
import re
import subprocess
import sys

STYLE = """
body { font: 16px/1.5 sans-serif; max-width: 64em; margin: 2em auto; padding: 0 1em; color: #222 }
table { border-collapse: collapse; margin: .5em 0 1.5em; font-size: 14px; font-variant-numeric: tabular-nums }
caption { text-align: left; font-weight: bold; padding: .5em 0 }
th, td { padding: .15em .6em; border-bottom: 1px solid #ddd; text-align: left; white-space: nowrap }
th { border-bottom: 2px solid #888 } .r { text-align: right } .wide { overflow-x: auto }
figure { margin: 1em 0 2em } figure svg { width: 100%; height: auto } figcaption { font-size: 14px }
.missing { background: #fee; padding: .5em } a { color: #058 }
"""
# Dark enough for thin lines on white, and different to the colour-blind.
PALETTE = "#0072b2 #d55e00 #009e73 #aa3377 #997700 #332288 #666666 #000000".split()

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
# A figure: name, caption, settings of gnuplot, and curves (title, [(x, y), ...], style, colour). Bars
# have no style.


def range_of_curves(curves):
    """A logarithmic axis that ends where the curves end, not at powers of ten."""
    values = [y for _, points, _, _ in curves for _, y in points if y > 0]
    low, high = min(values, default=1), max(values, default=1)
    ticks = ", ".join(f"{digit}e{power}" for power in range(-4, 7) for digit in (1, 2, 5))
    return f"set yrange [{0.8 * low}:{1.25 * high}]" + (f"\nset ytics ({ticks})" if high < 1e4 * low else "")


def curve(rows, x, y, title, colour, style="linespoints linewidth 2"):
    return title, [(row[x], row[y]) for row in rows if row.get(y) is not None], style, colour


def verdict_figures(study):
    for mix in study["mixes"]:
        rows = mix["fmb_over_sat"]
        low, high = min(0.5, *(0.9 * row["least"] for row in rows)), max(2, *(1.1 * row["most"] for row in rows))
        yield (f'ratio-{mix["case"]}',
               f'FMB over SAT, {mix["case"]}: {mix["queries"]} distinct pairs of all kinds at each share, those '
               f'that meet at random places. Average: of all pairs; least and most: over {mix["groups"]} groups of '
               'pairs, as they come.',
               f'set logscale y\nset xrange [0:100]\nset yrange [{low}:{high}]\nset xlabel "pairs that meet [%]"\n'
               'set ylabel "time of FMB / time of SAT"\nset ytics (0.1,0.2,0.5,0.6,0.7,0.8,0.9,1,1.2,1.5,2,3,5,10)',
               [("equal", [(0, 1), (100, 1)], "lines dashtype 2", -1),
                curve(rows, "percent_meeting", "most", "most", 1),
                curve(rows, "percent_meeting", "total", "average", 0, "linespoints linewidth 4"),
                curve(rows, "percent_meeting", "least", "least", 2)])


def article_figures(study):
    # As the article draws it: ratios of pairs that meet and of those that do not, mixed. Ratios of ours are of times.
    def mixed(meeting, apart, share):
        return [share * m + (1 - share) * a for m, a in zip(meeting, apart)]

    def ratio(of, cells, share):
        if of == "published":
            return mixed(*([cell[of]] for cell in cells), share)[0]
        if of == "repeated":
            return mixed(*([cell[of]["mean"]] for cell in cells), share)[0]
        fmb, sat = mixed(*([cell[of]["fmb_ns"], cell[of]["sat_ns"]] for cell in cells), share)
        return fmb / sat

    ways = (("published", "published", "lines dashtype 2 linewidth 2"), ("repeated", "listed, repeated", "linespoints linewidth 2"),
            ("packed", "ours, packed", "lines dashtype 4 linewidth 3"))
    for case in dict.fromkeys(cell["case"] for cell in study["cells"]):
        curves = [("equal", [(0, 1), (100, 1)], "lines", 7)]
        for i, kind in enumerate(("CC", "CT", "TT")):
            cells = sorted((cell for cell in study["cells"] if cell["case"] == case and cell["pair"] == kind),
                           key=lambda cell: not cell["meeting"])
            if len(cells) == 2:
                curves += [(f"{kind}, {title}", [(10 * x, ratio(of, cells, x / 10)) for x in range(11)], style, i)
                           for of, title, style in ways]
        yield (case, f"FMB over SAT, {case}, by the share of pairs that meet: the article's Table 1, its program's ways by its "
               "method, ours on sets of frames.",
               'set logscale y\nset xrange [0:100]\nset yrange [0.15:4]\nset xlabel "pairs that meet [%]"\n'
               'set ylabel "time of FMB / time of SAT"\nset ytics (0.2,0.3,0.4,0.5,0.6,0.8,1,1.5,2,3,4)', curves)


def box_figures(study):
    # Some curves nearly coincide: the wider ones are drawn first. The last percent, which goes on to the largest of
    # all, would stretch the axis; the table has it.
    wide, shown = {"both AABBs": 9, "article, clipped to both AABBs": 6, "ours": 3}, 99
    for case in study["quantiles"]:
        curves = [(box, [point for point in zip(case["percent"], ratios) if point[0] <= shown],
                   f"lines linewidth {wide.get(box, 2)}", i) for i, (box, ratios) in enumerate(case["ratio"].items())]
        yield (case["case"],
               f'Volumes of boxes over the tight one, {case["case"]}: quantiles over the pairs, up to {shown} %.',
               f'set logscale y\nset xrange [0:100]\n{range_of_curves(curves)}\nset xlabel "pairs with at most that ratio [%]"\n'
               'set ylabel "volume of the box over the tight one"',
               sorted(curves, key=lambda c: -wide.get(c[0], 2)))


def scaling_figures(study):
    for motion in ("static", "dynamic"):
        rows = [row for row in study["cells"] if row["motion"] == motion]
        curves = []
        for i, kind in enumerate(("CC", "CT", "TT")):
            of_kind = [row for row in rows if row["pair"] == kind]
            curves += [curve(of_kind, "dim", "fmb_ns", kind, i),
                       curve(of_kind, "dim", "lp_ns", f"{kind}, LP", i, "linespoints dashtype 2")]
        yield (motion, f"Time of a verdict by dimension, {motion} frames. LP: a linear program, on some of the pairs.",
               'set logscale y\nset xlabel "D"\nset xtics 1\nset xrange [1.8:8.2]\nset ylabel "time of a verdict [ns]"', curves)


def rule_figures(study):
    # Only where every system was decided: a mean over the easy ones would lie.
    kinds = (("rows", "sum", "Rows alive after a round, added up over the rounds, mean", "rows",
              lambda row: row["stopped"] == 0 and row["sum"] > 0),
             ("time", "time_median.ratio", "Time over that without rules, median of the systems (at most that, where "
              "these gave up)", "time / time without rules",
              lambda row: row["timed"] == row["n"] and row["this_gave_up"] == 0))
    for name, path, title, label, is_shown in kinds:
        key = path.partition(".")[0]
        for motion in ("static", "dynamic"):
            rows = [row for row in study.get("order-" + study["orders"][0], [])
                    if row.get("motion") == motion and is_shown(row)]
            rows = [{**row, key: value_at(row, path)} for row in rows if value_at(row, path) is not None]
            sets = list(dict.fromkeys(row["rules"] for row in rows))
            if rows:
                low, high = min(row["dim"] for row in rows) - 0.2, max(row["dim"] for row in rows) + 0.2
                # Many sets do the same: the first ones are wider, and seen behind the others.
                curves = [curve([row for row in rows if row["rules"] == s], "dim", key, s, i,
                                f"linespoints linewidth {max(2, 8 - 2 * i)}") for i, s in enumerate(sets)]
                yield (f"{name}-{motion}", f'{title}; {motion} frames, order {study["orders"][0]}.',
                       f'set logscale y\nset xlabel "D"\nset xtics 1\nset xrange [{low}:{high}]\n'
                       f'{range_of_curves(curves)}\nset ylabel "{label}"', curves)


def peer_figures(study):
    cells = list(dict.fromkeys(row["cell"] for row in study["times"]))
    times = {(row["cell"], row["peer"]): row["ns"] for row in study["times"]}
    bars = [(cell, [(f'"{peer}"', times.get((cell, peer), "NaN")) for peer in study["peers"]], None, i)
            for i, cell in enumerate(cells)]
    yield ("ns", "Time of a query on static pairs in three dimensions.",
           'set style data histogram\nset style histogram clustered gap 1\nset style fill solid 0.8\n'
           'set logscale y\nset yrange [5:*]\nset xtics rotate by -20\nset ylabel "time of a query [ns]"', bars)


def bunny_figures(study):
    dots = "points pointtype 7 pointsize "
    sets = (("the mesh", "dots_a", 0.15, 0), ("its mirror image", "dots_b", 0.15, 2), ("faces that meet", "dots_meeting", 0.45, 1))
    yield ("faces", f'Faces that meet the mirror image, seen along z: {len(study["faces_of_A_that_meet"])} of {study["faces"]}.',
           'set size ratio -1\nset xlabel "x"\nset ylabel "y"',
           [("", study[key], dots + str(size), colour) for _, key, size, colour in sets] +
           [(title, [("NaN", "NaN")], dots + "1", colour) for title, _, _, colour in sets]) # as the key shows them


FIGURES = {"table1": verdict_figures, "article": article_figures, "near": verdict_figures, "touching": verdict_figures,
           "slender": verdict_figures, "mesh": verdict_figures, "faces": verdict_figures,
           "boxes": box_figures, "scaling": scaling_figures, "rules": rule_figures, "peers": peer_figures,
           "bunny": bunny_figures}


def gnuplot_script(base, settings, curves):
    data = "".join(f"$data{i} << END\n" + "".join(f"{x} {y}\n" for x, y in points) + "END\n"
                   for i, (_, points, _, _) in enumerate(curves))
    plots = []
    for i, (title, _, style, colour) in enumerate(curves):
        how = f"using 1:2 with {style}" if style else "using 2:xtic(1)"
        plots.append(f"$data{i} {how} linecolor rgb '{PALETTE[colour % len(PALETTE)]}' title {json.dumps(title)}")
    plot = "plot " + ", \\\n  ".join(plots)
    return (f"# gnuplot {base}.gp\n{data}set key outside right noenhanced\nset grid linecolor rgb 'gray80'\n"
            f"set xtics noenhanced\n{settings}\n"
            f"set terminal svg size 900,540 dynamic background 'white'\nset output '{base}.svg'\n{plot}\n"
            f"set terminal pngcairo size 1350,810 fontscale 1.2\nset output '{base}.png'\nreplot\n")


def draw(folder, base, script):
    """The SVG, as it stands in a page: names of one figure must not clash with those of the next."""
    (folder / f"{base}.gp").write_text(script)
    subprocess.run(["gnuplot", f"{base}.gp"], cwd=folder, check=True)
    svg = (folder / f"{base}.svg").read_text()
    svg = re.sub(r'\b(id=["\']|href=["\']#|url\(#)', rf"\g<1>{base}-", svg[svg.index("<svg"):])
    return re.sub(r"<title>.*?</title>|<desc>.*?</desc>", "", svg, flags=re.S)


def figure_html(folder, study, figure):
    name, caption, settings, curves = figure
    curves = [c for c in curves if c[1]]
    base = f'{study["study"]}-{name}'
    if not curves:
        return ""
    caption = html.escape(caption)
    try:
        svg = draw(folder, base, gnuplot_script(base, settings, curves))
    except (FileNotFoundError, subprocess.CalledProcessError) as why:
        missing = isinstance(why, FileNotFoundError)
        figure_html.fault = "gnuplot is not installed" if missing else f"gnuplot failed on {base}.gp"
        return f'<p class="missing">{caption} <strong>Not drawn: {figure_html.fault}.</strong></p>\n'
    return (f'<figure>\n{svg}<figcaption>{caption} <a href="{base}.svg">SVG</a> <a href="{base}.png">PNG</a>'
            f"</figcaption>\n</figure>\n")


figure_html.fault = None

# ---- the page -------------------------------------------------------------------------------------


def machine_html(study):
    m = study["machine"]
    return html.escape(f'fmb {study["version"]} ({study["commit"]}); {m["cpu"]}, {m["cores"]} cores, '
                       f'{m["memory_bytes"] / 2**30:.1f} GiB; {m["os"]}, Linux {m["kernel"]}; {m["compiler"]}, '
                       f'{m["flags"]}; load {m["load"]:.2f} when it began')


def study_html(folder, study):
    parts = [f'<h2 id="{study["study"]}">{study["study"]}: {html.escape(study["title"])}</h2>\n',
             f"<p>{machine_html(study)}</p>\n"]
    for part in study["page"]:
        parts.append(table_html(study, part) if "table" in part else f'<p>{html.escape(part["text"])}</p>\n')
    parts += [figure_html(folder, study, figure) for figure in FIGURES[study["study"]](study)]
    return "".join(parts)


def main(folder):
    report = json.loads((folder / "report.json").read_text())
    studies = report.get("studies", [report])
    contents = "".join(f'<li><a href="#{s["study"]}">{s["study"]}</a>: {html.escape(s["title"])}</li>\n' for s in studies)
    body = "".join(study_html(folder, study) for study in studies)
    (folder / "report.html").write_text(
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>fmb-qualify</title>\n'
        f"<style>{STYLE}</style>\n</head>\n<body>\n<h1>fmb-qualify</h1>\n"
        + (f"<ul>\n{contents}</ul>\n" if len(studies) > 1 else "") + body + "</body>\n</html>\n")
    if figure_html.fault:
        print(f"fmb-qualify: {figure_html.fault}: pictures are missing; with it, `gnuplot *.gp` in {folder} makes them",
              file=sys.stderr)
    return 0 if figure_html.fault in (None, "gnuplot is not installed") else 1


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
