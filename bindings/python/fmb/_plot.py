"""Pictures of polyhedra, by matplotlib."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from fmb._lib import ArgumentError
from fmb._linear import Row, form
from fmb._system import System


def _cut(p: Any) -> Any:
    """The closure of p, clipped to a box around its vertices if it is unbounded."""
    from fmb._polyhedron import Polyhedron
    generators = p.generators()
    points = generators.vertices or [tuple(Fraction(0) for _ in p.names)]
    if not generators.rays and not generators.lines:
        return p
    boxed = System(p.system)
    size = max((max(x[j] for x in points) - min(x[j] for x in points) for j in range(p.dim)),
               default=Fraction(0)) or Fraction(2)
    for j, name in enumerate(p.names):
        for sign, end in (("<=", max(x[j] for x in points) + size / 2),
                          (">=", min(x[j] for x in points) - size / 2)):
            boxed.add(Row([(form(name), sign, form(end))]))
    return Polyhedron(boxed)


def _facets(p: Any, points: list[tuple[Fraction, ...]]) -> list[list[tuple[Fraction, ...]]]:
    """The vertices on each row that is a facet."""
    out = []
    for row in p.reduced().system:
        on = [x for x in points if row.left()(dict(zip(p.names, x))) == row.right]
        if len(on) >= p.dim and row.relation != "=":
            out.append(on)
    return out


def _around(points: list[tuple[Fraction, ...]]) -> list[tuple[float, ...]]:
    """Points of a polygon in the order around it."""
    import numpy as np
    x = np.array([[float(c) for c in p] for p in points])
    centre = x.mean(axis=0)
    _, _, axes = np.linalg.svd(x - centre)
    flat = (x - centre) @ axes[:2].T
    return [tuple(x[i]) for i in np.argsort(np.arctan2(flat[:, 1], flat[:, 0]))]


def polyhedron(p: Any, ax: Any = None, **style: Any) -> Any:
    """Draw p in two or three dimensions."""
    import matplotlib.pyplot as plt
    if p.dim not in (2, 3):
        raise ArgumentError(f"{p.dim} dimensions cannot be drawn: project on two or three")
    if ax is None:
        ax = plt.figure().add_subplot(projection="3d" if p.dim == 3 else None)
    shown = _cut(p)
    points = shown.vertices()
    style = {"alpha": 0.4, "edgecolor": "black", **style}
    if p.dim == 2:
        if points:
            ax.fill(*zip(*_around(points)), **style)
        ax.set(xlabel=p.names[0], ylabel=p.names[1])
        return ax
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection
    faces = _facets(shown, points) or ([points] if points else [])
    ax.add_collection3d(Poly3DCollection([_around(f) for f in faces], **style))
    for j, axis in enumerate("xyz"):
        ends = [float(x[j]) for x in points] or [0.0]
        getattr(ax, f"set_{axis}lim")(min(ends), max(ends) + (min(ends) == max(ends)))
    ax.set(xlabel=p.names[0], ylabel=p.names[1], zlabel=p.names[2])
    return ax
