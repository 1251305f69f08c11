"""Two bodies of triangles as a picture: shaded, what lies behind hidden, their contact in colour."""

import numpy as np

import plotting

DOTS = 1000  # of the picture, along the longer side
LIGHT = np.array([0.35, 0.55, 0.76])


def samples_of(corners, step):
    """Points of triangles, in steps of at most so much: coordinates, and whose they are."""
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    parts = np.maximum(1, np.ceil(longest / step)).astype(int)
    parts = np.where(parts > 16, 2 ** np.ceil(np.log2(parts)), parts).astype(int)  # few different numbers
    for n in np.unique(parts):
        mine = np.flatnonzero(parts == n)
        i, j = (a.ravel() for a in np.meshgrid(np.arange(n + 1), np.arange(n + 1)))
        inside = i + j <= n
        weights = np.stack([n - i - j, i, j], axis=1)[inside] / n
        for some in np.array_split(mine, max(1, len(mine) * len(weights) // 2000000)):
            yield np.einsum("wk,fkd->fwd", weights, corners[some]).reshape(-1, 3), np.repeat(some, len(weights))


def shade(corners, colour, extent):
    """The picture of triangles seen along the third coordinate, by depth: what is nearest is seen."""
    (left, right), (bottom, top) = extent
    step = max(right - left, top - bottom) / DOTS
    width, height = int((right - left) / step) + 1, int((top - bottom) / step) + 1
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    light = np.abs(normal / np.where(length > 0, length, 1) @ LIGHT)
    shaded = colour * (0.35 + 0.65 * light[:, None])
    image, depth = np.ones((height * width, 3)), np.full(height * width, -np.inf)
    for points, owner in samples_of(corners, 0.9 * step):
        place = ((points[:, 1] - bottom) / step).astype(int) * width + ((points[:, 0] - left) / step).astype(int)
        nearest = np.argsort(points[:, 2], kind="stable")
        place, owner, z = place[nearest], owner[nearest], points[nearest, 2]
        best = np.full(height * width, -1)
        best[place] = np.arange(len(place))  # the last one stays: the nearest
        seen = np.flatnonzero(best >= 0)
        seen = seen[z[best[seen]] > depth[seen]]
        depth[seen], image[seen] = z[best[seen]], shaded[owner[best[seen]]]
    return image.reshape(height, width, 3)


def rgb(colour):
    return np.array(plotting.matplotlib.colors.to_rgb(colour))


def panel(axes, corners, colour, names):
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    extent = [(low[k], high[k]) for k in (0, 1)]
    axes.imshow(shade(corners, colour, extent), origin="lower", extent=(*extent[0], *extent[1]), interpolation="antialiased")
    axes.set(xlabel=f"{names[0]} [mm]", ylabel=f"{names[1]} [mm]", aspect="equal")
    axes.grid(False)


def draw_bodies(body, meets_a, meets_b):
    """The body, its mirror image (50 - x, y - 10, z), and the faces of each that meet the other."""
    image = body * np.array([-1, 1, 1]) + np.array([50, -10, 0])
    colours = [np.tile(rgb(c), (len(body), 1)) for c in ("#9cc6e2", "#d9d2c0")]
    for colour, faces in zip(colours, (meets_a, meets_b)):
        colour[faces] = rgb(plotting.RED)
    figure, (above, below) = plotting.start(4.6, nrows=2, height_ratios=(1.35, 1))
    panel(above, np.concatenate([body, image]), np.concatenate(colours), "xy")
    contact = body[meets_a][:, :, [2, 1, 0]] if len(meets_a) else body[:0]
    if len(contact):
        lines = plotting.matplotlib.collections.PolyCollection(contact[:, :, :2], facecolor="#f3d5c2", edgecolor=plotting.RED, linewidth=0.25)
        below.add_collection(lines)
        below.autoscale_view()
        below.set(xlabel="z [mm]", ylabel="y [mm]", aspect="equal")
        below.invert_xaxis()
    else:
        below.set_visible(False)
    return figure
