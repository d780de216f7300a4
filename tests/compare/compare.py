"""compare.py OUTPUT_FOLDER XNEWELL [SCENE]...: who draws a scene right; see run.sh."""
import json
import sys
import time
from pathlib import Path

import numpy as np

from faces import faces_of
from judge import Truth
from page import folder_of
from programs import PROGRAMS, NoPicture, numbers_in, versions

SCENES = ('three-cards five-tests matplotlib-3894 matplotlib-13728 matplotlib-16071 matplotlib-29060 makie-4693'
          ' cetz-1040 threejs-6887 shingles sheets cycle nested-cycles penetrate crossing-sheets coarse-teapot'
          ' tori').split()


def swapped(truth, shown):
    """Swaps, in a picture, the two faces that show most: the pixels that the judge then finds wrong, and how many right
    ones were swapped."""
    number, count = np.unique(shown[truth.covered], return_counts=True)
    a, b = number[np.argsort(count)[-2:]]
    right = truth.covered & (shown == truth.nearest) & ((shown == a) | (shown == b))
    wrong, alone = truth.wrong(np.where(shown == a, b, np.where(shown == b, a, shown)))
    return int(wrong[right].sum()) + alone, int(right.sum())


def main(output, program, scenes):
    results, failed = {}, []
    made = versions(output, program)
    for scene in scenes or SCENES:
        faces = faces_of(scene, program)
        began = time.monotonic()
        truth = Truth([corners for _, corners in faces])
        covered = int(truth.covered.sum())
        if not covered:
            failed.append(f'{scene}: no pixel is far from all edges')
            continue
        row = results[scene] = {'faces': len(faces), 'judged': covered, 'programs': {}}
        differ = truth.by_fractions(100)
        if differ:
            failed.append(f'{scene}: fractions differ at {differ} pixels')
        print(f'{scene}: {len(faces)} faces, {covered} pixels judged, {time.monotonic() - began:.1f} s', flush=True)
        listed = [(group, corners.tolist()) for group, corners in faces]
        (output / f'{scene}.faces.json').write_text(json.dumps(listed))
        np.save(output / f'{scene}.npy', np.where(truth.judged, truth.nearest, -3).astype(np.int16))
        np.save(output / f'{scene}.truth.npy', truth.nearest.astype(np.int16))
        for name, draw in PROGRAMS.items():
            folder = output / 'work' / folder_of(scene, name)
            folder.mkdir(parents=True, exist_ok=True)
            try:
                seconds = draw(folder, faces, program)
            except NoPicture as why:
                row['programs'][name] = {'none': str(why)}
                print(f'    {name:34} {why}', flush=True)
                continue
            shown = numbers_in(folder / 'shown.png', len(faces))
            np.save(folder / 'shown.npy', shown.astype(np.int16))
            wrong, alone = truth.wrong(shown)
            share = 100 * wrong.sum() / covered
            row['programs'][name] = {'wrong': share, 'pixels': int(wrong.sum()), 'alone': alone, 'seconds': seconds,
                                     'no_face': int((wrong & (shown < 0)).sum())}
            print(f'    {name:34} {share:7.3f} % wrong, {wrong.sum()} pixels ({(wrong & (shown < 0)).sum()} without a'
                  f' face), and {alone} alone; {seconds:.2f} s', flush=True)
            if truth.outside(shown) > 0.001:
                failed.append(f'{scene}, {name}: {100 * truth.outside(shown):.2f} % of the paper is painted')
            if name == 'xnewell':
                found, expected = row['swap'] = swapped(truth, shown)
                print(f'    with two faces swapped: {found} wrong of {expected}, {100 * found / covered:.1f} %')
                if not found >= expected > 0:
                    failed.append(f'{scene}: two faces were swapped, and the judge did not see it')
    (output / 'results.json').write_text(json.dumps({'versions': made, 'scenes': results}, indent=1))
    print('\n'.join(failed))
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main(Path(sys.argv[1]), sys.argv[2], sys.argv[3:]))
