"""What renderers make of the figures in a folder; see figures.sh."""
import subprocess
import sys

import numpy as np
from PIL import Image

PAPER = (255, 0, 255)
Image.MAX_IMAGE_PIXELS = None
QUIET = subprocess.DEVNULL  # mutool of Debian says for each file that it has no ICC
WAYS = [('svg', 'rsvg-convert {i} -o {o}.png'),
        ('pdf', 'pdftoppm -r 72 -png -singlefile {i} {o}'),
        ('pdf', 'pdftocairo -r 72 -png -singlefile {i} {o}'),
        ('pdf', 'gs -q -dNOPAUSE -dBATCH -dSAFER -sDEVICE=png16m -r72 -dGraphicsAlphaBits=4 -sOutputFile={o}.png {i}'),
        ('pdf', 'mutool draw -q -r 72 -o {o}.png {i}'),
        ('eps', 'gs -q -dNOPAUSE -dBATCH -dSAFER -dEPSCrop -sDEVICE=png16m -r72 -dGraphicsAlphaBits=4'
                ' -sOutputFile={o}.png {i}')]


def image(file, kind=np.int32):
    return np.asarray(Image.open(file).convert('RGB')).astype(kind)


def numbers(ids):
    """The numbers of the faces, + 1, in their colours; 0 where none lies."""
    return ids[..., 0] << 16 | ids[..., 1] << 8 | ids[..., 2]


def around(values, radius, combine):
    """Combines the values of all pixels within the radius."""
    result = values
    for y in range(-radius, radius + 1):
        for x in range(-radius, radius + 1):
            result = combine(result, np.roll(np.roll(values, y, 0), x, 1))
    return result


def main(folder, scenes):
    wrong_of_all = compared = most_leak = leaks = 0
    for scene in scenes:
        base = f'{folder}/{scene}'
        true, ids = image(base + '.png'), image(base + '.ids.png')
        bare = numbers(ids) == 0
        true[bare] = ids[bare] = PAPER
        # What is thinner than a pixel may pass between its samples: the picture of four times the size shows it.
        fine = numbers(image(base + '.fine.ids.png', np.uint32))
        times = len(fine) // len(ids)
        fine = fine.reshape(len(ids), times, -1, times)
        least, most = fine.min((1, 3)).astype(np.int32), fine.max((1, 3)).astype(np.int32)
        away = around(least, 1, np.minimum) == around(most, 1, np.maximum)
        inside = around(least, 2, np.minimum) > 0
        blue = around(true[..., 2], 1, np.maximum)
        for ending, command in WAYS:
            wrong = []
            for kind, expected in (('', true), ('.ids', ids)):
                made = f'{base}{kind}.made'
                subprocess.check_call(command.format(i=f'{base}{kind}.{ending}', o=made).split(), stderr=QUIET)
                shown = image(made + '.png')
                wrong.append(int(((abs(shown - expected).max(2) > 1) & away).sum()))
                if not kind:
                    leak = np.where(inside, shown[..., 2] - blue, 0)
            wrong_of_all += sum(wrong)
            compared += int(away.sum())
            most_leak, leaks = max(most_leak, int(leak.max())), leaks + int((leak > 4).sum())
            print(f'{scene:16} {ending} {command.split()[0]:12} away from edges {away.sum()}: wrong colour {wrong[0]},'
                  f' wrong face {wrong[1]}; paper inside: at most {max(0, leak.max())} of 255,'
                  f' {(leak > 4).sum()} pixels above 4')
    print(f'of {compared} pixels away from edges, {wrong_of_all} have a wrong colour or face; paper inside: at most'
          f' {most_leak} of 255, {leaks} pixels above 4')
    return 1 if wrong_of_all else 0


sys.exit(main(sys.argv[1], sys.argv[2:]))
