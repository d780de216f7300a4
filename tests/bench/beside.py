"""beside.py OUTPUT_FOLDER [PROGRAM [SHADING_BENCH]] [--only ROW,ROW]: how fast whole programs are; see beside.sh."""
import argparse
import json
import math
import os
import re
import sys
from pathlib import Path

from beside_runs import Command, apart, median_of, output_of, processor, say, summary, take_turns

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# The program keeps freed memory (x11/terminal/memory.h). llvmpipe is four times as slow without it.
TUNABLES = 'glibc.malloc.mmap_threshold=33554432:glibc.malloc.trim_threshold=268435456:glibc.malloc.hugetlb=1'


class WindowView:
    """The programs, and a folder for what they read and write."""

    def __init__(self, arguments):
        self.program, self.shading_bench = arguments.program.resolve(), arguments.shading_bench.resolve()
        self.work = arguments.folder.resolve() / 'work'
        self.work.mkdir(parents=True, exist_ok=True)

    def scene(self, name, make, *numbers, for_sketch=False):
        """Writes a scene, made by a function of beside_scenes.py. Returns the file, and the options that put xnewell's
        eye where Sketch has its own."""
        stem = stem_of(name)

        def write():
            import beside_scenes as scenes  # here, because this process must stay small
            eye = scenes.write(getattr(scenes, make)(*numbers), self.work, stem, for_sketch)
            (self.work / f'{stem}.eye').write_text('%.9f,%.9f,%.9f' % eye)
        apart(write)
        eye = (self.work / f'{stem}.eye').read_text()
        return [f'{stem}.obj', f'--eye={eye}', '--look-at=0,0,0', '--up=0,1,0', '--size', '800x600']

    def draw(self, name, options, label='xnewell'):
        """To a PNG file. A further run, which is not timed, counts the pieces."""
        def pieces(_):
            said = output_of([self.program, 'draw', *options, '-o', 'stats.png', '--stats'], self.work)
            return f'{json.loads(said)["fragments"]:,} pieces' if said else ''
        return Command(f'{label}, {name}', [self.program, 'draw', *options, '-o', f'{stem_of(name)}.png'], made=pieces)

    def sketch(self, name, *options):
        """To a TikZ file, which has a line for each piece."""
        def pieces(_):
            with open(self.work / f'{stem_of(name)}.tex', encoding='ascii', errors='replace') as tikz:
                return f'{sum(line.startswith(chr(92) + "filldraw") for line in tikz):,} pieces'
        return Command(' '.join(['Sketch', *options]) + f', {name}',
                       ['sketch', *options, f'{stem_of(name)}.sk', '-o', f'{stem_of(name)}.tex'], made=pieces)

    def both(self, name, make, *numbers, options=('-b',)):
        """A scene drawn by xnewell and by Sketch."""
        drawn = self.scene(name, make, *numbers, for_sketch=True)
        return self.run([self.draw(name, drawn), self.sketch(name, *options)])

    def run(self, commands):
        take_turns(commands, self.work)
        return [summary(command) for command in commands]


def stem_of(name):
    return re.sub(r'\W+', '-', name)


def frame(bench):
    def printed(text):
        return [float(word) / 1e3 for word in text.split()[:3]]

    def repeated(text):
        runs = [run for run in json.loads(text)['benchmarks'] if run['run_type'] == 'iteration']
        times = [run['real_time'] / 1e3 for run in runs]
        return min(times), median_of(times), sum(run['cpu_time'] / 1e3 for run in runs) / len(runs)
    bench.run([Command('gcc', ['gcc', '-O2', HERE / 'llvmpipe_frame.c', '-o', 'llvmpipe_frame', '-lOSMesa', '-lGL',
                               '-lm'], most_runs=1)])
    commands = []
    if os.access(bench.shading_bench, os.X_OK):
        for order in ('Newell', 'ZBuffer24'):
            commands.append(Command(f'xnewell, frame, {order}', [
                bench.shading_bench, f'--benchmark_filter=^BM_Frame64k<Shading::Gouraud, Order::{order}>$',
                '--benchmark_repetitions=60', '--benchmark_min_time=0.001', '--benchmark_format=json'],
                frames=repeated, most_runs=3, env={'GLIBC_TUNABLES': TUNABLES}))
    else:
        say(f'there is no {bench.shading_bench}, so the frames of xnewell are left out: build it with'
            ' `cmake --preset bench && cmake --build --preset bench --target shading_bench`')
    one = Command('llvmpipe, frame, one thread', ['./llvmpipe_frame', 'llvmpipe.ppm'], frames=printed, most_runs=3,
                  env={'LP_NUM_THREADS': '0', 'GLIBC_TUNABLES': TUNABLES})
    its_own = Command(f'llvmpipe, frame, threads of its own on {len(os.sched_getaffinity(0))} processors',
                      ['./llvmpipe_frame'], frames=printed, most_runs=3, env={'GLIBC_TUNABLES': TUNABLES})
    return bench.run(commands + [one, its_own])


def knot(bench):
    return bench.both('knot', 'knot', options=())


def torus(bench):
    side = 708
    rows = bench.run([bench.draw('torus', bench.scene('torus', 'torus', side))])
    rows[0]['note'] += f'; {rows[0]["bytes"] / (2 * side * side):,.0f} bytes a face'
    return rows


def soup(bench):
    return [row for count in (10_000, 3_000)
            for row in bench.both(f'dense soup of {count:,}', 'dense_soup', count)]


def quads(bench):
    return [row for count in (100, 200, 400)
            for row in bench.both(f'{count} quads through a point', 'quads_through_a_point', count)]


def planes(bench):
    return bench.both('40 + 40 planes', 'planes', 40)


def ball(bench):
    return bench.both('ball of 3,000', 'ball', 3_000)


def teapot(bench):
    return bench.run([
        Command(f'xnewell draw teapot{stats}, {size}', [bench.program, 'draw', 'teapot', '-o', 'teapot.png', '--size',
                                                       size, *stats.split()])
        for size in ('800x600', '8192x8192') for stats in ('', ' --stats')])


def start(bench):
    return bench.run([Command('true', ['/usr/bin/true']),
                      Command('xnewell scenes', [bench.program, 'scenes']),
                      Command('xnewell --version', [bench.program, '--version']),
                      Command('xnewell draw teapot', [bench.program, 'draw', 'teapot', '-o', 'start.png'])])


def face(bench):
    kinds = ('convex', 'star', 'comb')
    drawn = [bench.scene(kind, 'outline', kind) for kind in kinds]
    return bench.run([bench.draw(kind, options, 'one face') for kind, options in zip(kinds, drawn)])


def trace(bench):
    def printed(out):
        return f'{out.stat().st_size / 1e6:,.1f} MB are printed'
    return [row for count in (100, 400)
            for options in [bench.scene(f'large-{count}', 'large_triangles', count)]
            for row in bench.run([Command(f'xnewell trace{quick}, {count} large triangles',
                                          [bench.program, 'trace', *options, *quick.split()], made=printed)
                                  for quick in ('', ' --quick')])]


GROWTH = {  # numbers of faces, and the function that makes them of a number
    'large triangles': ({n: n for n in (100, 200, 400, 800, 1_600, 3_200)}, 'large_triangles'),
    'quads through a point': ({n: n for n in (50, 100, 200, 400, 800)}, 'quads_through_a_point'),
    'triangles of a torus': ({2 * n * n: n for n in (71, 224, 708)}, 'torus'),
}


def growth(bench):
    rows = []
    for family, (counts, make) in GROWTH.items():
        commands = []
        for count, number in counts.items():
            options = bench.scene(f'{family} {count}', make, number)
            command = Command(f'{count:,} {family}', [bench.program, 'draw', *options, '-o', 'growth.png', '--stats'],
                              frames=lambda text: (json.loads(text)['ms']['sort'] / 1e3,) * 3,
                              made=lambda out: json.loads(out.read_text())['fragments'])
            commands.append(command)
        for count, command, row in zip(counts, commands, bench.run(commands)):
            rows.append(row | {'family': family, 'count': count, 'sort': row['least'],
                               'least': min(run['seconds'] for run in command.runs)})
    return rows


ROWS = {'frame': frame, 'knot': knot, 'torus': torus, 'soup': soup, 'quads': quads, 'planes': planes, 'ball': ball,
        'teapot': teapot, 'start': start, 'face': face, 'trace': trace, 'growth': growth}


def of_seconds(seconds):
    """Three digits, as milliseconds below a second."""
    value, unit = (seconds * 1e3, 'ms') if seconds < 1 else (seconds, 's')
    return f'{value:.{max(0, 2 - math.floor(math.log10(max(value, 0.01))))}f} {unit}'


def of_bytes(row):
    """Megabytes. A program that starts has the peak of this script as its own: no less can be seen."""
    if row['bytes'] <= 1.02 * row['least_seen']:
        return f'under {math.ceil(row["bytes"] / 1e6)} MB'
    return f'{row["bytes"] / 1e6:,.0f} MB'


def exponent(rows, key):
    first, last = rows[0], rows[-1]
    if any(row['failed'] or not row[key] for row in (first, last)):
        return '-'
    return f'{math.log(last[key] / first[key]) / math.log(last["count"] / first["count"]):.2f}'


def growth_table(rows):
    lines = ['| scene | whole program | exponent | depth sort | exponent | pieces | exponent |',
             '| --- | ---: | ---: | ---: | ---: | ---: | ---: |']
    keys = ('least', 'sort', 'note')
    for family in GROWTH:
        own = [row for row in rows if row['family'] == family]
        for k, row in enumerate(own):
            said = [row['failed'] or of_seconds(row['least']), of_seconds(row['sort']), f'{row["note"] or 0:,}']
            since = ['' if k == 0 else exponent(own[k - 1:k + 1], key) for key in keys]
            lines.append(f'| {row["label"]} | ' + ' | '.join(f'{a} | {b}' for a, b in zip(said, since)) + ' |')
        whole = ' | '.join(f'| {exponent(own, key)}' for key in keys)
        lines.append(f'| {family}, over the whole range | {whole} |')
    return lines


def table(results):
    lines = [f'{results["processor"]}; {results["xnewell"]}; Sketch {results["sketch"]}.', '',
             '| what | least | median | processor | memory | what came of it |',
             '| --- | ---: | ---: | ---: | ---: | --- |']
    for name, rows in results['rows'].items():
        for row in rows if name != 'growth' else []:
            times = [of_seconds(row[key]) for key in ('least', 'median', 'processor')]
            if row['failed']:
                times[:2] = ['-', '-']
            lines.append(f'| {row["label"]} | ' + ' | '.join(times) + f' | {of_bytes(row)} |'
                         f' {row["failed"] or row["note"]} |')
    if 'growth' in results['rows']:
        lines += ['', *growth_table(results['rows']['growth'])]
    return '\n'.join(lines) + '\n'


def main():
    parser = argparse.ArgumentParser(prog='tests/bench/beside.sh')
    parser.add_argument('folder', type=Path, metavar='OUTPUT_FOLDER')
    parser.add_argument('program', type=Path, nargs='?', metavar='PROGRAM',
                        default=ROOT / 'build/release/x11/xnewell')
    parser.add_argument('shading_bench', type=Path, nargs='?', metavar='SHADING_BENCH',
                        default=ROOT / 'build/bench/tests/bench/shading_bench')
    parser.add_argument('--only', metavar='ROW,ROW', type=lambda text: text.split(','), default=list(ROWS),
                        help='only these rows: ' + ', '.join(ROWS))
    arguments = parser.parse_args()
    if unknown := [name for name in arguments.only if name not in ROWS]:
        parser.error(f'there is no row {unknown[0]}; the rows are {", ".join(ROWS)}')
    if not os.access(arguments.program, os.X_OK):
        parser.error(f'build xnewell first, there is no {arguments.program}')
    bench = WindowView(arguments)
    sketch = re.search(r'\d+\.\d+ \(build \w+', output_of(['sketch', '-v'], bench.work))
    results = {'processor': processor(), 'xnewell': output_of([bench.program, '--version'], bench.work).strip(),
               'sketch': sketch[0].replace(' (', ' ') if sketch else '?', 'rows': {}}
    for name in ROWS:
        if name in arguments.only:
            say(f'{name} ...')
            results['rows'][name] = ROWS[name](bench)
            (arguments.folder / 'results.json').write_text(json.dumps(results, indent=1))
            (arguments.folder / 'table.md').write_text(table(results))
    print((arguments.folder / 'table.md').read_text(), end='')


if __name__ == '__main__':
    sys.exit(main())
