// A start for the assignment: polygons of an .obj file, projected, shaded flat, sorted by their farthest
// corner and painted in a window. It needs libX11, GLM and a header of ours, `xnewell run-header >
// xnewell_run.h`: c++ -std=c++20 -O2 student.cpp -o student -lX11
//   student MODEL.obj              opens a window; any key ends it
//   student MODEL.obj picture.ppm  also writes what the window shows, for `xnewell diagnose`
//   student MODEL.obj picture.ppm order.jsonl   and the painting order, for `xnewell judge`
//   student MODEL.obj picture.ppm order.jsonl run.jsonl   and its steps, for `xnewell judge --run`
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iostream>
#include <sstream>
#include <vector>

#include "xnewell_run.h"

namespace {

using glm::dvec3;

constexpr int kWidth = 640, kHeight = 480;
constexpr double kFov = 30;  // degrees, of the picture's height
const dvec3 kEye{4, 3, 6}, kLookAt{0, 0.4, 0}, kUp{0, 1, 0};
const dvec3 kLight{-0.5, 0.6, -0.4};  // the direction to the light
constexpr double Ia = 0.2, Ip = 0.7, ka = 0.9, kd = 0.9, ks = 0.4;
constexpr int n = 4;

struct Polygon {
  std::vector<dvec3> corners;  // in the world
  std::vector<XPoint> points;  // on the screen
  double farthest = 0;         // distance along the viewing direction
  int number = 0, cell = 0;
};

std::vector<Polygon> readObj(const char* file) {
  std::vector<dvec3> places;
  std::vector<Polygon> polygons;
  std::ifstream in{file};
  for (std::string line; std::getline(in, line);) {
    std::istringstream words{line};
    std::string what;
    words >> what;
    if (what == "v") {
      dvec3 p;
      words >> p.x >> p.y >> p.z;
      places.push_back(p);
    } else if (what == "f") {
      Polygon polygon;
      for (std::string word; words >> word;) polygon.corners.push_back(places.at(std::stoul(word) - 1));
      polygon.number = static_cast<int>(polygons.size());
      polygons.push_back(polygon);
    }
  }
  return polygons;
}

/// The illumination equation.
double intensity(const dvec3& N, const dvec3& L, const dvec3& V) {
  const double NL = glm::dot(N, L);
  double I = ka * Ia;
  if (NL > 0) {
    const dvec3 R = 2.0 * NL * N - L;
    I += Ip * (kd * NL + ks * std::pow(std::max(0.0, glm::dot(R, V)), n));
  }
  return std::min(1.0, I);
}

int cellOf(double I) { return static_cast<int>(std::lround(11 + 239 * I)); }
void shade(Polygon& polygon) {
  dvec3 N{0}, centroid{0};
  double area = 0;
  const std::vector<dvec3>& p = polygon.corners;
  for (std::size_t k = 1; k + 1 < p.size(); ++k) N += glm::cross(p[k] - p[0], p[k + 1] - p[0]);
  N = glm::normalize(N);
  for (std::size_t k = 1; k + 1 < p.size(); ++k) {  // the centroid of the area
    const double one = glm::dot(glm::cross(p[k] - p[0], p[k + 1] - p[0]), N);
    centroid += one * (p[0] + p[k] + p[k + 1]) / 3.0, area += one;
  }
  centroid /= area;
  const dvec3 V = glm::normalize(kEye - centroid);
  if (glm::dot(N, V) < 0) N = -N;  // both sides of a polygon are lit
  polygon.cell = cellOf(intensity(N, glm::normalize(kLight), V));
}

void project(Polygon& polygon) {
  const glm::dmat4 view = glm::lookAt(kEye, kLookAt, kUp);
  const double scale = kHeight / 2.0 / std::tan(glm::radians(kFov) / 2);
  for (const dvec3& corner : polygon.corners) {
    const dvec3 p{view * glm::dvec4{corner, 1}};  // the eye looks along -z
    polygon.points.push_back({static_cast<short>(std::lround(kWidth / 2.0 + scale * p.x / -p.z - 0.5)),
                              static_cast<short>(std::lround(kHeight / 2.0 - scale * p.y / -p.z - 0.5))});
    polygon.farthest = std::max(polygon.farthest, -p.z);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::cerr << "usage: student MODEL.obj [picture.ppm [order.jsonl [run.jsonl]]]\n", 2;
  Display* const display = XOpenDisplay(nullptr);
  if (!display) return std::cerr << "student: no X server\n", 1;
  std::vector<Polygon> polygons = readObj(argv[1]);
  for (Polygon& polygon : polygons) shade(polygon), project(polygon);
  std::ranges::stable_sort(polygons, std::greater{}, &Polygon::farthest);

  const int screen = DefaultScreen(display);
  const Window window =
      XCreateSimpleWindow(display, RootWindow(display, screen), 0, 0, kWidth, kHeight, 0, 0, 0);
  XSelectInput(display, window, ExposureMask | KeyPressMask);
  XMapWindow(display, window);
  std::array<unsigned long, 256> pixel{};
  for (int i = 11; i <= 250; ++i) {  // the table: cell i holds (i - 10)/255 of red
    XColor color{};
    color.red = static_cast<unsigned short>(65535 * (i - 10) / 255);
    if (XAllocColor(display, DefaultColormap(display, screen), &color)) pixel[i] = color.pixel;
  }
  XColor gray{0, 0x4000, 0x4000, 0x4000, DoRed | DoGreen | DoBlue, 0};
  XAllocColor(display, DefaultColormap(display, screen), &gray);
  const Pixmap picture = XCreatePixmap(display, window, kWidth, kHeight, DefaultDepth(display, screen));
  const GC gc = XCreateGC(display, picture, 0, nullptr);
  XSetForeground(display, gc, gray.pixel);
  XFillRectangle(display, picture, gc, 0, 0, kWidth, kHeight);
  for (Polygon& polygon : polygons) {
    XSetForeground(display, gc, pixel[polygon.cell]);
    XFillPolygon(display, picture, gc, polygon.points.data(), static_cast<int>(polygon.points.size()), Convex,
                 CoordModeOrigin);
  }
  if (argc > 2) {
    XImage* const image = XGetImage(display, picture, 0, 0, kWidth, kHeight, AllPlanes, ZPixmap);
    std::ofstream out{argv[2], std::ios::binary};
    out << "P6\n" << kWidth << ' ' << kHeight << "\n255\n";
    for (int j = 0; j < kHeight; ++j)
      for (int i = 0; i < kWidth; ++i)  // on a TrueColor visual a pixel is red, green and blue
        for (const int shift : {16, 8, 0}) out.put(static_cast<char>(XGetPixel(image, i, j) >> shift & 255));
    XDestroyImage(image);
  }
  if (argc > 3) {
    std::ofstream out{argv[3]};
    for (const Polygon& polygon : polygons) out << "{\"face\": " << polygon.number << "}\n";
  }
  if (argc > 4) {
    xnewell_run::Run run(argv[4], kWidth, kHeight);
    for (const Polygon& polygon : polygons) run.take(polygon.number), run.paint(polygon.number, polygon.cell);
  }
  for (XEvent event; argc == 2;) {
    XNextEvent(display, &event);
    if (event.type == KeyPress) break;
    XCopyArea(display, picture, window, gc, 0, 0, kWidth, kHeight, 0, 0);
  }
  XCloseDisplay(display);
}
