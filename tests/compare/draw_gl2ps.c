/* draw_gl2ps FACES FILE.svg simple|bsp: draws polygons with OpenGL into a feedback buffer, and gl2ps sorts
   them. FACES has a line for each polygon: red green blue n x y z ..., colours from 0 to 255. */
#include <GL/osmesa.h>
#include <gl2ps.h>
#include <stdio.h>
#include <string.h>

enum { kSize = 600 };
static unsigned char pixels[kSize * kSize * 4];

static void drawAll(FILE* faces) {
  int red, green, blue, n;
  rewind(faces);
  while (fscanf(faces, "%d %d %d %d", &red, &green, &blue, &n) == 4) {
    glBegin(GL_POLYGON);
    glColor3ub((GLubyte)red, (GLubyte)green, (GLubyte)blue);
    for (double x, y, z; n > 0 && fscanf(faces, "%lf %lf %lf", &x, &y, &z) == 3; --n) glVertex3d(x, y, z);
    glEnd();
  }
}

int main(int count, char** argument) {
  FILE *faces, *svg;
  GLint viewport[4] = {0, 0, kSize, kSize}, size = 1 << 20;
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
  if (count == 2 && !strcmp(argument[1], "version"))
    return printf("%d.%d.%d\n", GL2PS_MAJOR_VERSION, GL2PS_MINOR_VERSION, GL2PS_PATCH_VERSION) < 0;
  if (count != 4 || !context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, kSize, kSize)) return 2;
  if (!(faces = fopen(argument[1], "r")) || !(svg = fopen(argument[2], "w"))) return 2;
  glOrtho(-1, 1, -1, 1, -1, 1);
  for (int state = GL2PS_OVERFLOW; state == GL2PS_OVERFLOW; size *= 2) {
    rewind(svg);
    gl2psBeginPage("faces", "compare", viewport, GL2PS_SVG,
                   strcmp(argument[3], "bsp") ? GL2PS_SIMPLE_SORT : GL2PS_BSP_SORT, GL2PS_NONE, GL_RGBA, 0,
                   NULL, 0, 0, 0, size, svg, argument[2]);
    drawAll(faces);
    state = gl2psEndPage();
  }
  return fclose(svg) != 0;
}
