"""Draws faces with each program, as vectors, and makes pictures of them without antialiasing. Seconds are the
processor's, for the program alone. The programs get all digits of the numbers, because Asymptote's `bsp` draws parallel
cards wrong if their normals are rounded."""
import json
import re
import resource
import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image

from judge import SIZE

HERE = Path(__file__).resolve().parent
LIMIT = 120 # seconds for a program and a scene


class NoPicture(Exception):
    """A program took too long, or gave up; says which."""


def processor():
    """Seconds of the processor that all commands took so far."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(command, folder):
    """What a command prints, and the seconds of the processor that it took."""
    began = processor()
    try:
        done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True,
                              timeout=LIMIT)
    except subprocess.TimeoutExpired as late:
        raise NoPicture(f'> {LIMIT} s') from late
    if done.returncode:
        print(f'{" ".join(map(str, command))}: status {done.returncode}\n{done.stderr[-400:]}')
        raise NoPicture('gives up')
    return done.stdout, processor() - began


def rgb(number):
    """A colour for each face: 16 levels a channel, so that no rounding makes one face look like another."""
    return tuple(17 * (number + 1 >> shift & 15) for shift in (8, 4, 0))


def hexadecimal(number):
    return '#%02x%02x%02x' % rgb(number)


def numbers_in(png, count):
    """The face at each pixel: -1 for paper, -2 for a colour of no face."""
    image = np.asarray(Image.open(png).convert('RGB')).astype(int)
    level = (image + 8) // 17
    number = level[..., 0] * 256 + level[..., 1] * 16 + level[..., 2] - 1
    strange = (np.abs(level * 17 - image).max(2) > 3) | (number < 0) | (number >= count)
    return np.where((image == 255).all(2), -1, np.where(strange, -2, number))


def raster(svg, png, box):
    """An SVG file as pixels, without antialiasing. box: what part of it is the picture."""
    text = Path(svg).read_text()
    root = (f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="{SIZE}"'
            f' height="{SIZE}" viewBox="{box[0]} {box[1]} {box[2]} {box[3]}" shape-rendering="crispEdges">')
    Path(svg).with_suffix('.crisp.svg').write_text(re.sub(r'<svg\b[^>]*>', root, text, count=1, flags=re.S))
    run(['rsvg-convert', '--background-color', 'white', Path(svg).with_suffix('.crisp.svg'), '-o', png], '.')


def points(corners, between=' '):
    return ''.join('%.16f %.16f %.16f' % tuple(p) + between for p in corners)


def tuples(corners, between=''):
    return between.join('(%.16f,%.16f,%.16f)' % tuple(p) for p in corners)


def xnewell(*options):
    """The scene in front of a parallel camera. The figure is in the colours of the faces' numbers."""
    def draw(folder, faces, program):
        scene = {'shows': 'faces', 'camera': {'eye': [0, 0, 10], 'look_at': [0, 0, 0], 'parallel': 2},
                 'objects': [{'polygons': [corners.tolist() for _, corners in faces]}]}
        (folder / 'scene.json').write_text(json.dumps(scene))
        _, seconds = run([program, 'figure', 'scene.json', '--size', f'{SIZE}x{SIZE}', '--shade', 'none', '--bare',
                          *options, '-o', 'figure.svg', '--ids', 'ids.svg'], folder)

        def recoloured(match):  # the file has #003 for #000033
            digits = match[1] if len(match[1]) == 6 else ''.join(2 * digit for digit in match[1])
            return hexadecimal(int(digits, 16) - 1) if 0 < int(digits, 16) <= len(faces) else match[0]
        text = re.sub(r'#([0-9a-f]{6}|[0-9a-f]{3})\b', recoloured, (folder / 'ids.svg').read_text())
        (folder / 'xnewell.svg').write_text(text)
        raster(folder / 'xnewell.svg', folder / 'shown.png', (0, 0, SIZE, SIZE))
        return seconds
    return draw


def matplotlib(how):
    def draw(folder, faces, _):
        lines = [{'object': number, 'colour': hexadecimal(k), 'corners': corners.tolist()}
                 for k, (number, corners) in enumerate(faces)]
        (folder / 'faces.json').write_text(json.dumps(lines))
        said, seconds = run([sys.executable, HERE / 'draw_matplotlib.py', 'faces.json', 'matplotlib.svg', how], folder)
        left, bottom, right, top = map(float, said.split())
        raster(folder / 'matplotlib.svg', folder / 'shown.png', (left, top, right - left, bottom - top))
        return seconds
    return draw


GNUPLOT = """set terminal svg size 1200,1200
set output 'gnuplot.svg'
set view 0,0
set view equal xyz
unset border; unset tics; unset key; unset colorbox
set margins 0,0,0,0
set xrange [-1:1]; set yrange [-1:1]; set zrange [-1:1]; set xyplane at -1
set pm3d depthorder noborder
splot """


def gnuplot(folder, faces, _):
    """`with polygons` in `pm3d depthorder`: one plot for each face, because each has a colour of its own. A square of
    the picture's size, drawn first and alone, shows where gnuplot puts it."""
    def plot(polygons):
        (folder / 'faces.dat').write_text('\n\n'.join(points(corners, '\n') for corners in polygons))
        (folder / 'faces.gp').write_text(GNUPLOT + ', \\\n'.join(
            f"'faces.dat' index {k} with polygons lc rgb '{hexadecimal(k)}'" for k in range(len(polygons))) + '\n')
        return run(['gnuplot', 'faces.gp'], folder)[1]
    plot([np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)])])
    drawn = re.search(r"<polygon fill = '[^']*' points = '([^']*)'", (folder / 'gnuplot.svg').read_text())[1]
    square = np.array([pair.split(',') for pair in drawn.split()], float)
    low, high = square.min(0), square.max(0)
    seconds = plot([corners for _, corners in faces])
    raster(folder / 'gnuplot.svg', folder / 'shown.png', (*low, *(high - low)))
    return seconds


ASYMPTOTE = """settings.outformat="eps"; settings.render=0; settings.prc=false;
import {module};
unitsize({unit});
currentprojection=orthographic(0,0,1,up=Y,center=false); currentlight=nolight;
"""


def asymptote(module):
    """three: one surface, whose patches `three` sorts. bsp: the module that cuts faces by the planes of others."""
    def draw(folder, faces, _):
        lines = [ASYMPTOTE.format(module=module, unit=SIZE / 2)]
        lines += ['surface s; pen[] pens;' if module == 'three' else 'face[] faces;'
                  ' void add(path3 p, pen q) {face f=face(p); faces.push(f); filldraw(f,project(p),q,nullpen);}']
        for k, (_, corners) in enumerate(faces):
            path = tuples(corners, '--') + '--cycle'
            pen = 'rgb(%.6f,%.6f,%.6f)' % tuple(c / 255 for c in rgb(k))
            lines.append(f's.append(surface({path})); pens.push({pen});' if module == 'three' else
                         f'add({path},{pen});')
        lines.append('draw(s,pens,nolight);' if module == 'three' else 'add(faces);')
        (folder / 'faces.asy').write_text('\n'.join(lines) + '\n')
        _, seconds = run(['asy', 'faces.asy', '-o', 'asymptote.eps'], folder)
        eps = (folder / 'asymptote.eps').read_text()
        x, y = map(float, re.search(r'(\S+) (\S+) translate', eps).groups())  # of the origin on the page
        begin = f'0 0 .setfilladjust2 {SIZE / 2 - x} {SIZE / 2 - y} translate'  # paints what holds a pixel's centre
        run(['gs', '-q', '-dBATCH', '-dNOPAUSE', '-dSAFER', '-sDEVICE=png16m', '-r72', f'-g{SIZE}x{SIZE}',
             '-sOutputFile=shown.png', '-c', begin, '-f', 'asymptote.eps'], folder)
        return seconds
    return draw


def sketch(*options):
    """Sketch writes TikZ. Its filled polygons, in their order, become an SVG file here, so that no TeX is needed.
    The scene is 100 times as large, because Sketch writes three decimals."""
    def draw(folder, faces, _):
        large = 100
        lines = [f'polygon[cull=false,fill=c{k},draw=none]{tuples(corners * large)}\n'
                 for k, (_, corners) in enumerate(faces)]
        (folder / 'faces.sk').write_text(''.join(lines) + 'global { language tikz }\n')
        _, seconds = run(['sketch', *options, 'faces.sk', '-o', 'sketch.tex'], folder)
        tikz, body = (folder / 'sketch.tex').read_text(), []
        for k, path in re.findall(r'\\(?:filldraw|fill)\[fill=c(\d+)[^]]*\](.*?)--cycle', tikz, re.S):
            corners = re.findall(r'\(([^,]+),([^)]+)\)', path)
            body.append('<polygon fill="%s" points="%s"/>\n' % (
                hexadecimal(int(k)), ' '.join(f'{float(x)},{-float(y)}' for x, y in corners)))
        (folder / 'sketch.svg').write_text(f'<svg>{"".join(body)}</svg>')
        raster(folder / 'sketch.svg', folder / 'shown.png', (-large, -large, 2 * large, 2 * large))
        return seconds
    return draw


def gl2ps(how):
    def draw(folder, faces, _):
        (folder / 'faces.txt').write_text(''.join('%d %d %d ' % rgb(k) + f'{len(corners)} {points(corners)}\n'
                                                  for k, (_, corners) in enumerate(faces)))
        _, seconds = run([folder.parents[1] / 'draw_gl2ps', 'faces.txt', 'gl2ps.svg', how], folder)
        raster(folder / 'gl2ps.svg', folder / 'shown.png', (0, 0, SIZE, SIZE))
        return seconds
    return draw


PROGRAMS = {
    'xnewell': xnewell(),
    'xnewell --order zmean': xnewell('--order', 'zmean'),
    'matplotlib, one collection': matplotlib('one'),
    'matplotlib, one for each object': matplotlib('each'),
    'gnuplot': gnuplot,
    'Asymptote three': asymptote('three'),
    'Asymptote bsp': asymptote('bsp'),
    'Sketch': sketch(),
    'Sketch -b': sketch('-b'),
    'gl2ps simple': gl2ps('simple'),
    'gl2ps BSP': gl2ps('bsp'),
}


def versions(folder, program):
    """What each program says of its version."""
    def said(*command):
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
        return re.search(r'\d+(\.\d+)+( patchlevel \d+| \(build \w+)?', done.stdout + done.stderr)[0].replace(' (', ' ')
    of = {'xnewell': said(program, '--version'), 'gnuplot': said('gnuplot', '--version'),
          'matplotlib,': said(sys.executable, '-c', 'import matplotlib; print(matplotlib.__version__)'),
          'Asymptote': said('asy', '--version'), 'Sketch': said('sketch', '-v'),
          'gl2ps': said(folder / 'draw_gl2ps', 'version')}
    return {name: of[name.split()[0]] for name in PROGRAMS}
