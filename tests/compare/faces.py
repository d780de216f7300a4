"""The faces of a scene as every program gets them: x and y of the picture from -1 to 1; z is larger where nearer.
xnewell is asked for the camera's matrix alone (`explain --viewing`). All programs look along z behind this matrix, with
parallel rays. No face is culled, none has an edge, and each has a colour of its own."""
import json
import subprocess
from pathlib import Path

import numpy as np

DATA = Path(__file__).resolve().parents[2] / 'data'
DECIMALS = 16  # of all numbers, for every program and for the judge
FLAT = 2e-3   # a face whose corners are farther off one plane becomes triangles


def torus(around, across):
    """Quadrilaterals of a torus about the z axis, with radii 1 and 0.4."""
    u, v = np.arange(around) * 2 * np.pi / around, np.arange(across) * 2 * np.pi / across
    r = 1 + 0.4 * np.cos(v)
    at = np.stack([np.outer(np.cos(u), r), np.outer(np.sin(u), r), np.tile(0.4 * np.sin(v), (around, 1))], 2)
    return [[at[(i + a) % around, (j + b) % across] for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            for i in range(around) for j in range(across)]


def cube():
    """The squares of the cube from -1 to 1."""
    square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    return [[np.roll((w, u, v), axis) for u, v in square] for axis in range(3) for w in (-1, 1)]


def patches(file, divisions):
    """Quadrilaterals of the bicubic Bezier patches of a .bpt file."""
    numbers = [float(word) for word in file.read_text().split()]
    t = np.linspace(0, 1, divisions + 1)
    bernstein = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3], 1)
    faces = []
    for k in range(int(numbers[0])):
        net = np.reshape(numbers[1 + 50 * k + 2:1 + 50 * (k + 1)], (4, 4, 3))
        at = np.einsum('ai,bj,ijk->abk', bernstein, bernstein, net)
        faces += [[at[i, j], at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]]
                  for i in range(divisions) for j in range(divisions)]
    return faces


def in_world(scene):
    """(object, corners) of each face of a scene file."""
    faces = []
    for number, thing in enumerate(scene['objects']):
        if 'polygons' in thing:
            polygons = thing['polygons']
        elif 'file' in thing:
            polygons = patches(DATA / 'scenes' / thing['file'], thing['divisions'])
        else:
            polygons = cube() if thing['solid'] == 'cube' else torus(thing['around'], thing['across'])
        if 'rotate' in thing:
            raise SystemExit('compare: faces.py does not turn objects')
        scale, move = np.array(thing.get('scale', 1.0)), np.array(thing.get('move', [0, 0, 0]))
        faces += [(number, np.array(polygon, float) * scale + move) for polygon in polygons]
    return faces


def flat_parts(corners):
    """The face, its corners moved into their best plane; or triangles, if they are far off it. Corners that fall
    together (at the poles of a patch) count once; what has no area is left out."""
    corners = [p for k, p in enumerate(corners) if np.abs(p - corners[k - 1]).max() > 1e-7]
    if len(corners) < 3:
        return []
    middle = np.mean(corners, 0)
    normal = np.linalg.svd(corners - middle)[2][2]
    off = (corners - middle) @ normal
    if np.abs(off).max() < FLAT:
        return [corners - np.outer(off, normal)]
    return [np.array([corners[0], corners[k], corners[k + 1]]) for k in range(1, len(corners) - 1)]


def faces_of(name, program):
    """(object, corners) of each face of a built-in scene, seen by the scene's camera. It is the camera that `xnewell
    explain --viewing` prints. The picture fills a square, and z the same range."""
    scene = json.loads((DATA / 'scenes' / f'{name}.json').read_text())
    shown = subprocess.run([program, 'explain', name, '--viewing', '0.1', '--json', '--size', '600x600'],
                           check=True, capture_output=True, text=True)
    stages = json.loads(shown.stdout)['stages']
    matrix = np.array(next(stage['so_far'] for stage in stages if stage['name'] == 'warped'))
    seen = []
    for number, corners in in_world(scene):
        image = np.c_[corners, np.ones(len(corners))] @ matrix.T
        if image[:, 3].min() <= 0:
            raise SystemExit(f'compare: {name} has corners behind the eye')
        seen.append((number, image[:, :3] / image[:, 3:]))
    every = np.concatenate([corners for _, corners in seen])
    low, high = every.min(0), every.max(0)
    half = (high - low) / 2
    half[:2] = half[:2].max()
    half[half == 0] = 1
    parts = [(number, part) for number, corners in seen
             for part in flat_parts((corners - (low + high) / 2) / half * 0.95)]
    return [(number, np.round(part, DECIMALS)) for number, part in parts]
