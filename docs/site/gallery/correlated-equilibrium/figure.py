"""Payoffs of correlated equilibria of chicken, and of its Nash equilibria: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

game = fmb.System.read(drawing.HERE / "chicken.fmb")
figure, axes = drawing.start(6.4, 3.6)
outcomes = fmb.Polyhedron.from_generators([(6, 6), (2, 7), (7, 2), (0, 0)], names=["u1", "u2"])
outcomes.plot(axes, facecolor="#eeeeee", edgecolor=drawing.GREY, alpha=1, linewidth=0.8)
equilibria = fmb.Polyhedron(fmb.project(game, "u1 u2"))
equilibria.plot(axes, facecolor="#9cc6e2", edgecolor=drawing.BLUE, alpha=1, linewidth=1.5)
nash = [(2, 7), (7, 2), (14 / 3, 14 / 3)]
axes.plot(*zip(*nash), "o", color=drawing.RED, label="Nash equilibria")
axes.plot([], [], "s", color="#9cc6e2", label="correlated equilibria")
axes.plot([], [], "s", color="#dddddd", label="all mixtures of outcomes")
axes.set(xlabel="payoff of player 1", ylabel="payoff of player 2", aspect="equal")
axes.legend(loc="center left", frameon=False, fontsize=9, bbox_to_anchor=(1.02, 0.5))
drawing.save(figure)
