"""page.py FOLDER: writes tables (table.md) and pictures (compare-*.png) of what compare.py found into FOLDER."""
import colorsys
import json
import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

SMALL, STEP = 120, 5   # a thumbnail's side; it shows every fifth pixel
LEFT, TOP = 108, 34    # room for the names
PICTURES = {
    'reports': 'matplotlib-3894 matplotlib-13728 matplotlib-16071 matplotlib-29060 makie-4693 cetz-1040 threejs-6887',
    'orders': 'three-cards five-tests shingles sheets cycle',
    'cuts': 'nested-cycles penetrate crossing-sheets coarse-teapot tori',
}
SHORT = ['xnewell', 'xnewell\n--order zmean', 'matplotlib, one\ncollection', 'matplotlib, one\nfor each object',
         'gnuplot', 'Asymptote\nthree', 'Asymptote\nbsp', 'Sketch', 'Sketch -b', 'gl2ps\nsimple', 'gl2ps\nBSP']


def folder_of(scene, name):
    return f'{scene}-{name}'.replace(' ', '-').replace(',', '')


def cell(found):
    """The share of wrong pixels in percent; 0 stands for none at all."""
    if 'none' in found:
        return found['none']
    if found['pixels'] == 0:
        return '0'
    return f'{found["wrong"]:.2f}' if found['wrong'] >= 0.005 else f'{found["wrong"]:.4f}'


def tables(results):
    names = list(next(iter(results['scenes'].values()))['programs'])
    lines = ['| scene | faces | pixels judged | ' + ' | '.join(names) + ' |', '| --- |' + ' ---: |' * (2 + len(names))]
    for scene, row in results['scenes'].items():
        lines.append(f'| {scene} | {row["faces"]:,} | {row["judged"]:,} | '
                     + ' | '.join(cell(row['programs'][name]) for name in names) + ' |')
    lines += ['', '| program | version | right in | pixels alone | seconds, all scenes | slowest scene |',
              '| --- | --- | --- | ---: | ---: | --- |']
    for name in names:
        found = {scene: row['programs'][name] for scene, row in results['scenes'].items()}
        done = {scene: one for scene, one in found.items() if 'none' not in one}
        slowest = max(done, key=lambda scene: done[scene]['seconds'])
        late = f', without {len(found) - len(done)}' if len(done) < len(found) else ''
        right = sum(one['pixels'] == 0 for one in done.values())
        alone, seconds = (sum(one[key] for one in done.values()) for key in ('alone', 'seconds'))
        lines.append(f'| {name} | {results["versions"][name]} | {right} of {len(found)} | {alone} | {seconds:.1f}{late}'
                     f' | {done[slowest]["seconds"]:.2f} ({slowest}) |')
    return '\n'.join(lines) + '\n'


def colours(faces):
    """A colour for each face: the hue says which face or, where there are many, which object; none is red."""
    result = []
    for number, (group, corners) in enumerate(faces):
        p = np.array(corners)
        normal = np.cross(p[1] - p[0], p[2] - p[0])
        facing = abs(normal[2]) / max(np.linalg.norm(normal), 1e-12)
        hue = 0.12 + 0.6 * ((number if len(faces) <= 64 else group) * 0.382 % 1)
        value = 0.55 + 0.4 * facing if len(faces) > 2 else 0.9
        result.append([round(255 * c) for c in colorsys.hsv_to_rgb(hue, 0.45, value)])
    return np.array(result + [[255, 255, 255], [255, 255, 255]])  # -2 and -1: no face


def thumbnail(shown, wrong, palette):
    """Every fifth pixel, and red where one of the 5 x 5 is wrong."""
    image = palette[shown[STEP // 2::STEP, STEP // 2::STEP]]
    image[wrong.reshape(SMALL, STEP, SMALL, STEP).any((1, 3))] = (225, 0, 0)
    return Image.fromarray(image.astype(np.uint8))


def picture(folder, results, scenes):
    names = list(SHORT)
    programs = list(next(iter(results['scenes'].values()))['programs'])
    image = Image.new('RGB', (LEFT + (SMALL + 4) * (1 + len(names)), TOP + (SMALL + 18) * len(scenes)), 'white')
    pen = ImageDraw.Draw(image)
    for k, name in enumerate(['right'] + names):
        pen.multiline_text((LEFT + (SMALL + 4) * k + 4, 4), name, fill='black')
    for row, scene in enumerate(scenes):
        y = TOP + (SMALL + 18) * row
        pen.text((4, y + SMALL // 2), scene, fill='black')
        nearest, certain = np.load(folder / f'{scene}.truth.npy'), np.load(folder / f'{scene}.npy')
        palette = colours(json.loads((folder / f'{scene}.faces.json').read_text()))
        image.paste(thumbnail(nearest, np.zeros(nearest.shape, bool), palette), (LEFT, y))
        for k, name in enumerate(programs):
            x, found = LEFT + (SMALL + 4) * (k + 1), results['scenes'][scene]['programs'][name]
            if 'none' not in found:
                shown = np.load(folder / 'work' / folder_of(scene, name) / 'shown.npy')
                image.paste(thumbnail(shown, (certain >= 0) & (shown != certain), palette), (x, y))
            pen.text((x + 4, y + SMALL + 2), cell(found) + ('' if 'none' in found else ' %'), fill='black')
    return image.quantize(64, dither=Image.Dither.NONE)


def main(folder):
    results = json.loads((folder / 'results.json').read_text())
    (folder / 'table.md').write_text(tables(results))
    for name, scenes in PICTURES.items():
        drawn = [scene for scene in scenes.split() if scene in results['scenes']]
        if drawn:
            picture(folder, results, drawn).save(folder / f'compare-{name}.png', optimize=True)


if __name__ == '__main__':
    main(Path(sys.argv[1]))
