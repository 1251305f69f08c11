"""Afriat's inequalities of observed purchases: purchases.py < purchases.txt > purchases.fmb

Each line of the input is an observation: prices, a bar, and the quantities that were bought."""

import sys

observations = []
for line in sys.stdin:
    if line.strip() and not line.startswith("#"):
        observations.append([[int(x) for x in part.split()] for part in line.split("|")])

numbers = range(1, len(observations) + 1)
print("vars:", *(f"u{t}" for t in numbers), *(f"l{t}" for t in numbers))
for t in numbers:
    print(f"l{t} >= 1")
for t, (prices, bought) in zip(numbers, observations):
    for s, (_, other) in zip(numbers, observations):
        if s != t:
            worth = sum(p * (y - x) for p, x, y in zip(prices, bought, other))
            print(f"{t} over {s}: u{s} <= u{t} + {worth} l{t}".replace("+ -", "- "))
