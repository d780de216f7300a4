"""draw_matplotlib.py FACES.json FILE.svg one|each: all faces in one Poly3DCollection, or a collection for each object.
It prints where the corners (-1, -1) and (1, 1) of the picture are in the file."""
import json
import sys

import matplotlib
matplotlib.use('svg')
import matplotlib.pyplot as plt
from mpl_toolkits.mplot3d import proj3d
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

faces_file, svg, how = sys.argv[1:]
figure = plt.figure(figsize=(10, 10), dpi=72)
axes = figure.add_axes([0, 0, 1, 1], projection='3d', proj_type='ortho')
axes.set_axis_off()
axes.view_init(90, -90)
axes.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))
axes.set_box_aspect((1, 1, 1))
with open(faces_file) as file:
    faces = json.load(file)
for group in sorted({face['object'] for face in faces}) if how == 'each' else [None]:
    mine = [face for face in faces if group in (None, face['object'])]
    axes.add_collection3d(Poly3DCollection([face['corners'] for face in mine], linewidths=0, edgecolors='none',
                                           facecolors=[face['colour'] for face in mine]))
figure.savefig(svg)
for corner in (-1, 1):
    x, y, _ = proj3d.proj_transform(corner, corner, 0, axes.get_proj())
    x, y = axes.transData.transform((x, y))
    print(x, 720 - y)
