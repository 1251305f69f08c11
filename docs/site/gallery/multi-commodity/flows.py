"""Flows of several commodities in an undirected network: flows.py < network.txt > flows.fmb

Each line of the input is `edge A B CAPACITY` or `demand A B AMOUNT`. The variable fK_A_B is what
flows of demand K along an edge from A to B, less what flows back; its size is at most sK_A_B."""

import sys

edges, demands = [], []
for line in sys.stdin:
    word, a, b, amount = line.split()
    (edges if word == "edge" else demands).append((a, b, amount))
nodes = sorted({x for a, b, _ in edges for x in (a, b)})

for k, (source, sink, amount) in enumerate(demands, 1):
    for node in nodes:
        if node == sink:
            continue  # what the other nodes say implies it
        out = [f"f{k}_{a}_{b}" for a, b, _ in edges if a == node]
        into = [f"f{k}_{a}_{b}" for a, b, _ in edges if b == node]
        sent = amount if node == source else "0"
        print(f"demand {source}{sink} at {node}:",
              " + ".join(out or ["0"]), *(f"- {x}" for x in into), "=", sent)
    for a, b, _ in edges:
        print(f"-s{k}_{a}_{b} <= f{k}_{a}_{b} <= s{k}_{a}_{b}")
for a, b, capacity in edges:
    print(f"edge {a}{b}:", " + ".join(f"s{k}_{a}_{b}" for k in range(1, len(demands) + 1)),
          "<=", capacity)
