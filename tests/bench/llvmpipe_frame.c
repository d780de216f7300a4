/* llvmpipe_frame [FILE.ppm]: the torus of 64,800 triangles of frame_bench.cpp, drawn by Mesa's OpenGL without
   a graphics card, from buffer objects, with a z-buffer of 24 bits. The eye moves a degree a frame. It prints
   milliseconds: the least and the median of 60 frames, and the processor's time a frame. With
   LP_NUM_THREADS=0 Mesa rasterizes in the calling thread. FILE.ppm gets the last frame. */
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>

#include <GL/glext.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { kWidth = 800, kHeight = 600, kSide = 180, kWarm = 10, kFrames = 60, kTriangles = 2 * kSide * kSide };
struct Corner {
  float at[3], N[3];
};
static unsigned char pixels[4 * kWidth * kHeight];
static struct Corner corners[kSide * kSide];
static GLuint triangles[kTriangles][3];

static double milliseconds(clockid_t clock) {
  struct timespec now;
  clock_gettime(clock, &now);
  return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

static int byValue(const void* a, const void* b) {
  const double x = *(const double*)a, y = *(const double*)b;
  return (x > y) - (x < y);
}

/* As torus() in geometry/model/solids.cpp; each quadrilateral is cut from its first corner. */
static void makeTorus(void) {
  GLuint buffers[2];
  const double step = 2 * acos(-1.0) / kSide;
  int count = 0;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const double x = cos(i * step), y = sin(i * step), out = cos(j * step), up = sin(j * step),
                   r = 1 + 0.4 * out;
      const GLuint a = (GLuint)(i * kSide + j), b = (GLuint)((i + 1) % kSide * kSide + j);
      const GLuint c = (GLuint)((i + 1) % kSide * kSide + (j + 1) % kSide),
                   d = (GLuint)(i * kSide + (j + 1) % kSide);
      const GLuint two[2][3] = {{a, b, c}, {a, c, d}};
      corners[a] = (struct Corner){{(float)(r * x), (float)(r * y), (float)(0.4 * up)},
                                   {(float)(out * x), (float)(out * y), (float)up}};
      for (int half = 0; half < 2; ++half, ++count)
        for (int k = 0; k < 3; ++k) triangles[count][k] = two[half][k];
    }
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof triangles, triangles, GL_STATIC_DRAW);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glVertexPointer(3, GL_FLOAT, sizeof(struct Corner), (void*)0);
  glNormalPointer(GL_FLOAT, sizeof(struct Corner), (void*)sizeof corners[0].at);
}

/* The light and the surface are xnewell's defaults (shading/light/illumination.h). The table's hue is red. */
static void setUp(void) {
  const GLfloat ambient[] = {0.2f, 0, 0, 1}, light[] = {0.7f, 0, 0, 1}, none[] = {0, 0, 0, 1};
  const GLfloat ka[] = {0.9f, 0, 0, 1}, kd[] = {0.9f, 0, 0, 1}, ks[] = {0.4f, 0, 0, 1};
  const double nearest = 2.2, farthest = 6.5, top = nearest * tan(acos(-1.0) / 12),
               right = top * kWidth / kHeight;
  glViewport(0, 0, kWidth, kHeight);
  glMatrixMode(GL_PROJECTION);
  glFrustum(-right, right, -top, top, nearest, farthest);
  glMatrixMode(GL_MODELVIEW);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glShadeModel(GL_SMOOTH);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, none);
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  glLightfv(GL_LIGHT0, GL_AMBIENT, ambient);
  glLightfv(GL_LIGHT0, GL_DIFFUSE, light);
  glLightfv(GL_LIGHT0, GL_SPECULAR, light);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, ka);
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, kd);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, ks);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
}

/* The camera that placeCamera() gives this torus, turned about the z axis. */
static void draw(int degrees) {
  const GLfloat towards[] = {-0.54f, -0.64f, 0.55f, 0};
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glLoadIdentity();
  glTranslated(0, 0.1758, -4.3645);
  glRotated(-63.075, 1, 0, 0);
  glRotated(-12.407 - degrees, 0, 0, 1);
  glLightfv(GL_LIGHT0, GL_POSITION, towards);
  glDrawElements(GL_TRIANGLES, 3 * kTriangles, GL_UNSIGNED_INT, (void*)0);
  glFinish();
}

static int writePpm(const char* name) {
  FILE* const file = fopen(name, "wb");
  if (!file) return 1;
  fprintf(file, "P6 %d %d 255\n", kWidth, kHeight);
  for (int row = kHeight - 1; row >= 0; --row)
    for (int column = 0; column < kWidth; ++column) fwrite(pixels + 4 * (row * kWidth + column), 1, 3, file);
  return fclose(file) != 0;
}

int main(int count, char** argument) {
  double frames[kFrames], began = 0;
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
  if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, kWidth, kHeight)) return 2;
  setUp();
  makeTorus();
  for (int k = -kWarm; k < kFrames; ++k) {
    if (k == 0) began = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    const double start = milliseconds(CLOCK_MONOTONIC);
    draw(k);
    if (k >= 0) frames[k] = milliseconds(CLOCK_MONOTONIC) - start;
  }
  const double processor = (milliseconds(CLOCK_PROCESS_CPUTIME_ID) - began) / kFrames;
  qsort(frames, kFrames, sizeof frames[0], byValue);
  if (glGetError() != GL_NO_ERROR) return 1;
  printf("%.3f %.3f %.3f %s\n", frames[0], frames[kFrames / 2], processor,
         (const char*)glGetString(GL_RENDERER));
  return count > 1 ? writePpm(argument[1]) : 0;
}
