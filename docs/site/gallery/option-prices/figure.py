"""The price of a call as a function of its strike, between no-arbitrage bounds: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

market = fmb.System.read(drawing.HERE / "market.fmb")
states = (80, 90, 100, 110, 120)
strikes = range(80, 121)
ends = []
for strike in strikes:
    pays = fmb.total(max(0, s - strike) * fmb.Variable(f"q{s}") for s in states)
    if pays.coefficients:
        ends.append([float(fmb.optimize(market, min=pays)), float(fmb.optimize(market, max=pays))])
    else:
        ends.append([0.0, 0.0])
figure, axes = drawing.start(4.8, 3.4)
axes.fill_between(strikes, *zip(*ends), color="#9cc6e2", edgecolor=drawing.BLUE)
for strike, price in ((90, 12), (110, 3)):
    axes.plot(strike, price, "o", color=drawing.RED)
axes.annotate("traded", (90, 12), (6, 6), textcoords="offset points", color=drawing.RED)
axes.annotate("traded", (110, 3), (6, 6), textcoords="offset points", color=drawing.RED)
low, high = ends[strikes.index(100)]
axes.annotate(f"strike 100:\nbetween {low:g} and {high:g}", (100, high), (30, 40),
              textcoords="offset points", arrowprops={"arrowstyle": "-"})
axes.set(xlabel="strike", ylabel="price of the call")
drawing.save(figure)
