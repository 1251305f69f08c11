"""The figures of the studies: of a study's numbers, one figure or several, each with a name and a caption."""

import math

import numpy as np

import plotting
from solid import draw_bodies

CASES = {"2d-static": "2D, still", "3d-static": "3D, still", "2d-dynamic": "2D, moving", "3d-dynamic": "3D, moving",
         "4d-static": "4D, still"}


def value_at(row, key):
    for name in key.split("."):
        row = row.get(name) if isinstance(row, dict) else None
    return row


def panels_of(n, height, across, up, sharey=True):
    """n panels, two beside each other, each with its axes named where nothing is below or on the left of it."""
    columns = min(n, 2)
    rows = math.ceil(n / columns)
    figure, grid = plotting.start(0.45 + height * rows, nrows=rows, ncols=columns, sharex=True, sharey=sharey, squeeze=False)
    for k, axes in enumerate(grid.flat):
        axes.set_visible(k < n)
        if n - columns <= k < n:
            axes.tick_params(labelbottom=True)
            axes.set_xlabel(across)
        if k % columns == 0:
            axes.set_ylabel(up)
    return figure, list(grid.flat)[:n]


# ---- verdicts -------------------------------------------------------------------------------------


def draw_verdicts(study, _):
    mixes = study.get("mixes")
    if not mixes:
        return
    figure, panels = panels_of(len(mixes), 1.35 if len(mixes) > 1 else 1.9, "pairs that meet [%]", "time, FMB / SAT")
    ends = [row[end] for mix in mixes for row in mix["fmb_over_sat"] for end in ("least", "most")]
    for axes, mix in zip(panels, mixes):
        x, total, least, most = zip(*((row["percent_meeting"], row["total"], row["least"], row["most"]) for row in mix["fmb_over_sat"]))
        if mix["groups"] > 1:
            axes.fill_between(x, least, most, color=plotting.BLUE, alpha=0.2, linewidth=0, label=f'{mix["groups"]} groups of them, least to most')
        axes.plot(x, total, label="all pairs", **plotting.style(0))
        axes.set(title=CASES[mix["case"]], xlim=(0, 100))
        plotting.equal(axes)
        plotting.logarithmic(axes.yaxis, min(0.9, *ends), max(1.1, *ends))
    plotting.key(figure)
    yield ("ratio", figure, f'Time of FMB over that of SAT by the share of pairs that meet: {mixes[0]["queries"]} distinct pairs of all kinds '
           "at each share, those that meet at random places. Below 1 FMB is faster.")


# ---- the article's table --------------------------------------------------------------------------


def draw_article(study, _):
    cells = study.get("cells")
    if not cells:
        return
    ways = (("published", "as published", {"marker": "o", "color": plotting.BLACK, "fillstyle": "none"}),
            ("repeated.mean", "listed, its method", {"marker": "s", "color": plotting.BLUE}),
            ("listed.fmb_over_sat.ratio", "listed, distinct pairs", {"marker": "D", "color": plotting.GREEN, "fillstyle": "none"}),
            ("packed.fmb_over_sat.ratio", "ours, packed", {"marker": "^", "color": plotting.RED}))
    figure, axes = plotting.start(0.6 + 0.135 * (len(cells) + 4))
    rows, names, place, last = [], [], 0.0, None
    for cell in cells:
        place += 1 if cell["case"] == last else 2
        if cell["case"] != last:
            axes.text(0, place - 1, CASES[cell["case"]], transform=axes.get_yaxis_transform(), fontsize=7, fontweight="bold", va="center")
        last = cell["case"]
        rows.append(place)
        names.append(f'{cell["pair"]} {"meet" if cell["meeting"] else "apart"}')
    for key, label, how in ways:
        axes.plot([value_at(cell, key) for cell in cells], rows, linestyle="none", markersize=3.8, label=label, **how)
    values = [value_at(cell, key) for cell in cells for key, _, _ in ways]
    axes.set_yticks(rows, names)
    axes.set(ylim=(place + 0.7, 0.3), xlabel="time of FMB / time of SAT")
    axes.tick_params(axis="y", length=0)
    plotting.logarithmic(axes.xaxis, min(values), max(values))
    plotting.equal(axes, horizontal=False)
    plotting.key(figure)
    yield ("cells", figure, "Time of FMB over that of SAT in the article's cells: as published; its program's ways, a pair again and again as it "
           "does, and on distinct pairs; ours on sets of frames. Left of 1 FMB is faster.")


# ---- boxes ----------------------------------------------------------------------------------------

SHOWN = 99  # [%]: the last percent, up to the largest of all, would stretch the axis; the table has it


def draw_boxes(study, _):
    cases = study.get("quantiles")
    if not cases:
        return
    figure, panels = panels_of(len(cases), 1.35, "share of the pairs [%]", "volume / tightest", sharey=False)
    kinds = list(dict.fromkeys(box for case in cases for box in case["ratio"]))
    for axes, case in zip(panels, cases):
        most = 1.1
        for i, kind in enumerate(kinds):
            points = [p for p in zip(case["percent"], case["ratio"].get(kind, [])) if p[0] <= SHOWN]
            if points:
                most = max(most, max(y for _, y in points))
                axes.plot(*zip(*points), label=kind, markevery=(4 * i, 30), **plotting.style(i))
        axes.set(title=CASES[case["case"]], xlim=(0, 100))
        plotting.logarithmic(axes.yaxis, 1, most)
    plotting.key(figure)
    yield "sizes", figure, f"Volumes of boxes over those of the tightest ones, the least ratio first: quantiles over the pairs, up to {SHOWN} %."


# ---- dimensions -----------------------------------------------------------------------------------


def draw_scaling(study, _):
    if not study.get("cells"):
        return
    figure, grid = plotting.start(2.2, ncols=2, sharey=True, sharex=True)
    times = [row[way] for row in study["cells"] for way in ("fmb_ns", "lp_ns") if row.get(way)]
    for axes, motion in zip(grid, ("static", "dynamic")):
        for i, (kind, way) in enumerate((kind, way) for way in ("fmb_ns", "lp_ns") for kind in ("CC", "CT", "TT")):
            points = [(row["dim"], row[way]) for row in study["cells"]
                      if row["motion"] == motion and row["pair"] == kind and row.get(way) is not None]
            if points:
                axes.plot(*zip(*points), label=kind if way == "fmb_ns" else f"{kind}, linear program", **plotting.style(i))
        axes.set(title={"static": "still", "dynamic": "moving"}[motion], xlabel="dimensions, D")
        axes.xaxis.set_major_locator(plotting.ticker.MultipleLocator(1))
    plotting.logarithmic(axes.yaxis, min(times, default=1), max(times, default=10))
    grid[0].set_ylabel("time of a verdict [ns]")
    plotting.key(figure)
    yield "time", figure, "Time of a verdict by dimension. Linear programs: on some of the pairs."


# ---- rules ----------------------------------------------------------------------------------------


def rule_rows(study, is_shown, key):
    """By motion, the rows of a figure: rules, dimension, value."""
    found = {}
    for row in study.get("order-" + (study.get("orders") or [""])[0], []):
        if row.get("motion") in ("static", "dynamic") and row["rules"] != "none" and is_shown(row) and value_at(row, key):
            found.setdefault(row["motion"], []).append((row["rules"], row["dim"], value_at(row, key)))
    return found


def draw_rules(study, _):
    # Only where every system was decided: a mean over the easy ones would lie.
    kinds = (("rows", "sum_ratio", "rows / no rules", "Rows alive after a round, added up over the rounds, over those without rules",
              lambda row: row["stopped"] == 0 and row["sum"] > 0),
             ("time", "time_median.ratio", "time / no rules", "Time over that without rules, median of the systems (at most that, "
              "where these gave up)", lambda row: row["timed"] == row["n"] and row["this_gave_up"] == 0))
    for name, key, label, title, is_shown in kinds:
        found = rule_rows(study, is_shown, key)
        if not found:
            continue
        sets = list(dict.fromkeys(rules for rows in found.values() for rules, _, _ in rows))
        values = [value for rows in found.values() for _, _, value in rows]
        figure, grid = plotting.start(0.65 + 0.16 * len(sets), ncols=len(found), sharey=True, sharex=True, squeeze=False)
        for axes, (motion, rows) in zip(grid[0], found.items()):
            for rules, dim, value in rows:
                axes.plot(value, sets.index(rules), marker=f"${dim}$", color=plotting.COLOURS[(dim - 2) % 8], markersize=4.5, linestyle="none")
            axes.set(title={"static": "still, by D", "dynamic": "moving, by D"}[motion], xlabel=label)
            plotting.equal(axes, horizontal=False)
            plotting.logarithmic(axes.xaxis, min(values), max(1.0, *values), most=4)
        axes.set(ylim=(len(sets) - 0.4, -0.6))
        grid[0][0].set_yticks(range(len(sets)), [rules.replace(",", ", ") for rules in sets])
        grid[0][0].tick_params(axis="y", length=0)
        yield name, figure, f'{title}; order {study["orders"][0]}. The digit is the dimension of the frames. Left of 1 the rules pay.'


# ---- other libraries ------------------------------------------------------------------------------


def draw_peers(study, _):
    cells = list(dict.fromkeys(row["cell"] for row in study.get("times", [])))
    if not cells:
        return
    figure, axes = plotting.start(0.55 + 0.18 * len(cells))
    for i, peer in enumerate(study["peers"]):
        points = [(row["ns"], cells.index(row["cell"])) for row in study["times"] if row["peer"] == peer]
        if points:
            axes.plot(*zip(*points), label=peer, **{**plotting.style(i), "linestyle": "none"}, markersize=4, alpha=0.9)
    times = [row["ns"] for row in study["times"]]
    plotting.logarithmic(axes.xaxis, min(times, default=1), max(times, default=10))
    axes.set_yticks(range(len(cells)), cells)
    axes.tick_params(axis="y", length=0)
    axes.set(ylim=(len(cells) - 0.5, -0.5), xlabel="time of a query [ns]")
    plotting.key(figure)
    yield "times", figure, "Time of a query on still pairs in three dimensions."


# ---- the scan -------------------------------------------------------------------------------------


def draw_bunny(study, folder):
    mesh = folder / "bunny-mesh.csv"
    if "faces_of_B_that_meet" not in study or not mesh.exists():
        return
    body = np.loadtxt(mesh, delimiter=",", skiprows=1, ndmin=2).reshape(-1, 3, 3)
    figure = draw_bodies(body, study["faces_of_A_that_meet"], study["faces_of_B_that_meet"])
    yield ("contact", figure, f'The {study["faces"]} faces of the mesh and of its mirror image, and where they meet (red): '
           f'{len(study["faces_of_A_that_meet"])} faces of the mesh and {len(study["faces_of_B_that_meet"])} of the image. '
           "Below, the first of these alone, seen along x.")


FIGURES = {**dict.fromkeys(("table1", "near", "touching", "slender", "mesh", "faces"), draw_verdicts), "article": draw_article,
           "boxes": draw_boxes, "scaling": draw_scaling, "rules": draw_rules, "peers": draw_peers, "bunny": draw_bunny}
