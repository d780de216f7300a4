"""Which face is the nearest at each pixel, by comparing all faces there; and how much of a picture shows another one.
It shares nothing with xnewell, and sorts nothing. The face with the largest z at the centre of a pixel is right, in
doubles. Beside all faces there must be paper: if more than a thousandth of it is painted, the run fails. The 100 judged
pixels of each scene whose two nearest faces are closest are computed again in fractions."""
from fractions import Fraction

import numpy as np

SIZE = 600      # pixels of a picture's side
AWAY = 1.5      # pixels nearer than this to an edge in sight, or to a line where two faces cross, are not judged
NEAR = 1e-6     # nor where the two nearest faces are no farther apart than this; z goes from -0.95 to 0.95


def on_screen(corners):
    return np.c_[(corners[:, 0] + 1) * SIZE / 2, (1 - corners[:, 1]) * SIZE / 2]


def window(points, margin):
    """The pixels in the box of the points: slices, and the places of the pixels' centres."""
    low = np.clip(np.floor(points.min(0) - margin).astype(int), 0, SIZE)
    high = np.clip(np.ceil(points.max(0) + margin).astype(int) + 1, 0, SIZE)
    y, x = np.mgrid[low[1]:high[1], low[0]:high[0]]
    return (slice(low[1], high[1]), slice(low[0], high[0])), x + 0.5, y + 0.5


def around(values, radius, combine):
    """Combines the values of all pixels within the radius."""
    result = None
    for y in range(-radius, radius + 1):
        for x in range(-radius, radius + 1):
            moved = np.roll(np.roll(values, y, 0), x, 1)
            result = moved if result is None else combine(result, moved)
    return result


def near_edges(faces, z1):
    """Where an edge is near that is in sight: one that is not behind all that shows within 2 pixels."""
    lowest, result = around(z1, 2, np.minimum), np.zeros(z1.shape, bool)
    for corners in faces:
        p = np.c_[on_screen(corners), corners[:, 2]]
        for a, b in zip(p, np.roll(p, -1, 0)):
            at, x, y = window(np.array([a, b])[:, :2], AWAY)
            u = b - a
            length = max(np.hypot(u[0], u[1]), 1e-9)
            along = np.clip(((x - a[0]) * u[0] + (y - a[1]) * u[1]) / length ** 2, 0, 1)
            close = np.hypot(x - a[0] - along * u[0], y - a[1] - along * u[1]) <= AWAY
            z = np.minimum(a[2] + along * u[2] + AWAY * abs(u[2]) / length, max(a[2], b[2]))
            result[at] |= close & (z >= lowest[at])
    return result


class Truth:
    """nearest: the number of the nearest face at each pixel, -1 where there is none; judged: where that is certain."""

    def __init__(self, faces):
        self.faces = faces
        shape = (SIZE, SIZE)
        self.nearest, second = np.full(shape, -1), np.full(shape, -1)
        z1, z2 = np.full(shape, -np.inf), np.full(shape, -np.inf)
        slope = np.zeros((len(faces) + 1, 2))  # of z along x and y, a pixel; the last row belongs to -1
        for number, corners in enumerate(faces):
            p = on_screen(corners)
            area = np.cross(p[1:-1] - p[0], p[2:] - p[0]).sum()
            if abs(area) < 1e-6:  # seen from its edge
                continue
            plane = np.linalg.lstsq(np.c_[p, np.ones(len(p))], corners[:, 2], rcond=None)[0]
            slope[number] = plane[:2]
            at, x, y = window(p, 0)
            inside = np.ones(x.shape, bool)
            for a, b in zip(p, np.roll(p, -1, 0)):
                inside &= ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) * area >= 0
            z = np.where(inside, plane[0] * x + plane[1] * y + plane[2], -np.inf)
            first = z > z1[at]
            other = ~first & (z > z2[at])
            z2[at] = np.where(first, z1[at], np.where(other, z, z2[at]))
            second[at] = np.where(first, self.nearest[at], np.where(other, number, second[at]))
            z1[at] = np.where(first, z, z1[at])
            self.nearest[at] = np.where(first, number, self.nearest[at])
        across = np.linalg.norm(slope[self.nearest] - slope[second], axis=2)
        self.gap = np.where(second < 0, np.inf, np.where(self.nearest < 0, np.inf, z1) - z2)
        self.judged = ~near_edges(faces, z1) & (self.gap > AWAY * across + NEAR)
        self.covered = self.judged & (self.nearest >= 0)

    def wrong(self, shown):
        """Where a picture, an array of face numbers, shows another face than the nearest, or none; and the number of
        such pixels that stand alone. These are cracks between pieces of a face, whose corners a file rounds."""
        wrong = self.covered & (shown != self.nearest)
        alone = wrong & (around(wrong.astype(int), 1, np.add) == 1)
        return wrong & ~alone, int(alone.sum())

    def outside(self, shown):
        """The share of the judged pixels beside all faces where the picture shows something."""
        bare = self.judged & (self.nearest < 0)
        return (bare & (shown != -1)).sum() / max(1, bare.sum())

    def by_fractions(self, count):
        """Computes the `count` narrowest judged pixels again, in fractions: how many of them are otherwise."""
        gap = np.where(self.covered, self.gap, np.inf)
        differ = 0
        for k in np.argsort(gap, axis=None)[:count]:
            y, x = divmod(int(k), SIZE)
            if np.isfinite(gap[y, x]):
                differ += exact_nearest(self.faces, x, y) != self.nearest[y, x]
        return differ


def exact_nearest(faces, column, row):
    """The nearest face at a pixel's centre. Each face is a fan of triangles with the corners' decimals."""
    column, row = int(column), int(row)
    x, y = Fraction(2 * column + 1, SIZE) - 1, 1 - Fraction(2 * row + 1, SIZE)
    best, best_z = -1, None
    for number, corners in enumerate(faces):
        low, high = corners.min(0), corners.max(0)
        if not (low[0] <= x <= high[0] and low[1] <= y <= high[1]):
            continue
        p = [[Fraction(repr(float(c))) for c in corner] for corner in corners]
        for b, c in zip(p[1:-1], p[2:]):
            u, v = [b[i] - p[0][i] for i in range(3)], [c[i] - p[0][i] for i in range(3)]
            area = u[0] * v[1] - u[1] * v[0]
            if area == 0:
                continue
            s = ((x - p[0][0]) * v[1] - (y - p[0][1]) * v[0]) / area
            t = (u[0] * (y - p[0][1]) - u[1] * (x - p[0][0])) / area
            if s >= 0 and t >= 0 and s + t <= 1:
                z = p[0][2] + s * u[2] + t * v[2]
                if best_z is None or z > best_z:
                    best, best_z = number, z
    return best
