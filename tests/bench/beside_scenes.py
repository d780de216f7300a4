"""The scenes of beside.py, as OBJ files for xnewell and as .sk files for Sketch. Every seed is fixed.

A scene is (points, faces): lists of (x, y, z), and of tuples of indices into them."""
import math
import random

SEED = 1972
FOV = 30  # degrees; xnewell's default
HALF = 30  # half the height of Sketch's picture, in units of which it writes three decimals
DIRECTION = (0.22, 0.52, 1)  # from the scene to the eye
# Sketch does not make its axes unit vectors. So `up` must be one, and at a right angle to the direction.
LENGTH, SPAN = math.hypot(*DIRECTION), math.hypot(DIRECTION[0], DIRECTION[2])
UP = (-DIRECTION[0] * DIRECTION[1] / (LENGTH * SPAN), SPAN / LENGTH, -DIRECTION[2] * DIRECTION[1] / (LENGTH * SPAN))


def tube(around, across, centre, radius):
    """A closed tube about centre(t), 0 <= t < 1, of quadrilaterals cut in two."""
    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    def unit(a):
        return tuple(x / math.hypot(*a) for x in a)
    points = []
    for i in range(around):
        here, there = centre(i / around), centre((i + 1e-4) / around)
        along = unit([b - a for a, b in zip(here, there)])
        side = unit(cross(along, (0, 0, 1)))
        up = cross(side, along)
        for j in range(across):
            c, s = math.cos(2 * math.pi * j / across), math.sin(2 * math.pi * j / across)
            points.append(tuple(p + radius * (c * u + s * v) for p, u, v in zip(here, side, up)))
    return points, halves(around, across)


def halves(around, across):
    faces = []
    for i in range(around):
        for j in range(across):
            a, b, c, d = ((i + m) % around * across + (j + n) % across for m, n in ((0, 0), (1, 0), (1, 1), (0, 1)))
            faces += [(a, b, c), (a, c, d)]
    return faces


def knot():
    """The trefoil as a tube of 65,536 triangles."""
    def centre(t):
        a = 2 * math.pi * t
        r = 1 + 0.4 * math.cos(3 * a)
        return (r * math.cos(2 * a), r * math.sin(2 * a), 0.4 * math.sin(3 * a))
    return tube(512, 64, centre, 0.18)


def torus(side):
    """torus() of geometry/model/solids.cpp, its faces cut in two."""
    points = []
    for i in range(side):
        for j in range(side):
            a, b = 2 * math.pi * i / side, 2 * math.pi * j / side
            r = 1 + 0.4 * math.cos(b)
            points.append((r * math.cos(a), r * math.sin(a), 0.4 * math.sin(b)))
    return points, halves(side, side)


def separate(polygons):
    """Faces that share no corner."""
    points, faces = [], []
    for corners in polygons:
        faces.append(tuple(range(len(points), len(points) + len(corners))))
        points += corners
    return points, faces


def splitmix64(seed):
    """The numbers of triangleSoup() in geometry/model/solids.cpp: in [-1, 1)."""
    mask = (1 << 64) - 1
    while True:
        seed = (seed + 0x9E3779B97F4A7C15) & mask
        z = ((seed ^ (seed >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        yield ((z ^ (z >> 31)) >> 11) * 2.0 ** -52 - 1


def dense_soup(count):
    """denseSoup() of depthsort_bench.cpp: triangles as large as the room that each has, in a cube."""
    number = splitmix64(SEED)
    size, polygons = 2 / count ** (1 / 3), []
    for _ in range(count):
        centre = [next(number) for _ in range(3)]
        polygons.append([tuple(c + size * next(number) for c in centre) for _ in range(3)])
    return separate(polygons)


def large_triangles(count):
    """Triangles whose corners lie anywhere in a cube."""
    draw = random.Random(SEED)
    return separate([[tuple(draw.uniform(-1, 1) for _ in range(3)) for _ in range(3)] for _ in range(count)])


def direction(draw):
    """A unit vector, equally likely everywhere on the sphere."""
    z, a = draw.uniform(-1, 1), draw.uniform(0, 2 * math.pi)
    r = math.sqrt(1 - z * z)
    return (r * math.cos(a), r * math.sin(a), z)


def square(centre, N, turn):
    """A square about `centre` whose corners are 1 from it; `turn` turns it in its plane."""
    least = min(range(3), key=lambda k: abs(N[k]))
    along = [-N[least] * n for n in N]
    along[least] += 1
    u = [a / math.hypot(*along) for a in along]
    v = (N[1] * u[2] - N[2] * u[1], N[2] * u[0] - N[0] * u[2], N[0] * u[1] - N[1] * u[0])
    angles = [turn + k * math.pi / 2 for k in range(4)]
    return [tuple(c + math.cos(t) * a + math.sin(t) * b for c, a, b in zip(centre, u, v)) for t in angles]


def quads_through_a_point(count):
    draw = random.Random(SEED)
    return separate([square((0, 0, 0), direction(draw), draw.uniform(0, 2 * math.pi)) for _ in range(count)])


def planes(count):
    """Two families of `count` parallel squares each. Every square crosses all of the other family."""
    polygons = []
    for N in ((0.96, 0, 0.28), (0, 0.6, 0.8)):
        for k in range(count):
            height = 0.8 * ((k + 0.5) / count - 0.5)
            polygons.append(square([height * n for n in N], N, math.pi / 4))
    return separate(polygons)


def ball(count):
    """Triangles with centres in the unit ball. Their corners are 0.25 from these."""
    draw = random.Random(SEED)
    polygons = []
    for _ in range(count):
        r, towards = draw.random() ** (1 / 3), direction(draw)
        polygons.append([tuple(r * c + 0.25 * d for c, d in zip(towards, direction(draw))) for _ in range(3)])
    return separate(polygons)


def outline(kind, count=1_000_000):
    """One face in the plane z = 0: convex, a star, or a comb."""
    def at(k, r):
        return (r * math.cos(2 * math.pi * k / count), r * math.sin(2 * math.pi * k / count), 0.0)
    if kind == 'convex':
        points = [at(k, 1) for k in range(count)]
    elif kind == 'star':
        points = [at(k, 1 if k % 2 else 0.5) for k in range(count)]
    else:  # the back of the comb, and its teeth
        teeth = count - 2
        points = [(-1.0, -1.0, 0.0), (1.0, -1.0, 0.0)]
        points += [(1 - 2 * k / (teeth - 1), -0.8 if k % 2 else 1.0, 0.0) for k in range(teeth)]
    return points, [tuple(range(count))]


def eye_of(points):
    """The eye looks at the origin. It is where a ball about all points fills the picture."""
    radius = max(math.hypot(*p) for p in points)
    distance = 1.02 * radius / math.sin(math.radians(FOV / 2))
    return tuple(round(distance * d / LENGTH, 9) for d in DIRECTION)


def write(scene, folder, name, for_sketch):
    """Writes NAME.obj and, if asked, NAME.sk; returns where the eye is."""
    points, faces = scene
    decimals = '%.17g %.17g %.17g' if len(faces) == 1 else '%.9f %.9f %.9f'
    eye = eye_of(points)
    with open(folder / f'{name}.obj', 'w', encoding='ascii') as obj:
        obj.writelines('v ' + decimals % p + '\n' for p in points)
        obj.writelines('f ' + ' '.join([str(k + 1) for k in face]) + '\n' for face in faces)
    if for_sketch:
        text = ['(%.9f,%.9f,%.9f)' % p for p in points]
        distance = HALF / math.tan(math.radians(FOV / 2))
        with open(folder / f'{name}.sk', 'w', encoding='ascii') as sk:
            sk.write('def scene {\n')
            sk.writelines('polygon[cull=false]' + ''.join([text[k] for k in face]) + '\n' for face in faces)
            sk.write('}\nput { view((%.9f,%.9f,%.9f),(0,0,0),[%.9f,%.9f,%.9f])' % (*eye, *UP))
            sk.write(f' then perspective({distance:.9f}) }} {{scene}}\nglobal {{ language tikz }}\n')
    return eye
