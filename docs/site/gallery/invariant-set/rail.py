"""From which positions and speeds can a cart stay on its rail for ever? The sets K_0, K_1, ... of
states from which it can stay for so many seconds shrink, until one lies within the next: that one
is the answer."""

import fmb

p, v, a = fmb.vars("p v a")
after = {"p": p + v + a / 2, "v": v + a}  # one second later
rail = fmb.System([(-5 <= p <= 5).named("rail")], "p v")


def before(states):
    """The states from which some acceleration leads into the set within a second, as rows over
    p, v and a."""
    out = fmb.System([(-1 <= a <= 1).named("motor")], "p v a")
    for row in states:
        moved = fmb.total(c * after[name] for name, c in row.coefficients.items())
        out.add(moved <= row.right)
    out.join(rail)
    return out


states, seconds = rail, 0
while True:
    lift = before(states)
    answer = fmb.project(lift, "p v", evidence="whole")
    if fmb.Polyhedron(states) <= answer.system:
        break
    states, seconds = answer.system, seconds + 1
    print(f"{seconds} s: {len(states)} rows, proof {answer.proof.check()}")
print("the same ever after:")
print(states)
