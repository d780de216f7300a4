#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "geometry/files/output_file.h"
#include "shading/figure/figure_errors.h"
#include "shading/figure/make_figure.h"
#include "shading/figure/write_figure.h"
#include "shading/laboratory/ground_truth.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/shared.h"
#include "shading/scene/settings.h"
#include "x11/command/commands.h"
#include "x11/command/report.h"
#include "x11/options/setup_command.h"
#include "x11/terminal/terminal.h"

namespace xnewell {

namespace {

/// The errors of a figure, beside those of the picture that `draw` makes.
FigureErrors errorsOf(const VectorFigure& figure, const Options& options, const Scene& scene) {
  const Doing measuring{"measuring the errors"};
  const PictureSettings settings = settingsOf(options);
  const CellPlan plan{settings.table.kind};
  const Picture picture = makePicture(scene, settings, plan[Cell::Well]);
  const Palette palette = picture.palette(plan);
  return errorsOf(figure, Comparison{picture, GroundTruth{picture}, palette}, palette);
}

}  // namespace

void drawFigure(const Options& options, const Scene& scene) {
  std::optional<Doing> doing{"sorting"};
  const Stopwatch watch;
  const FigureStages stages{scene, settingsOf(options), options.tolerance, options.smooth};
  const double msSorted = watch.ms();
  doing.reset();
  doing.emplace("joining areas");
  const auto made = [&](FigureColors colors) {
    VectorFigure figure = stages.figure(colors);
    if (options.paper) figure.paper = {figureColorOf(*options.paper)};
    figure.note = noteOf(options, stages.picture);
    return figure;
  };
  const VectorFigure figure = made(FigureColors::Shades);
  const double msJoined = watch.ms();
  doing.reset();
  doing.emplace("writing");
  const std::string bytes = figureFormatOf(options.output)->write(figure);
  const double msWritten = watch.ms();
  std::optional<FigureErrors> errors;
  if (options.errors) {
    doing.reset();
    errors = errorsOf(figure, options, scene);
  }
  std::vector<OutputFile> files{{options.output, bytes}};
  std::string ids;
  if (!options.ids.empty()) {
    ids = figureFormatOf(options.ids)->write(made(FigureColors::Ids));
    files.push_back({options.ids, ids});
  }
  writeFiles(files);
  doing.reset();
  const FigureStatistics& s = figure.statistics;
  if (options.smooth &&
      std::ranges::all_of(figure.paths, &std::vector<FigureTriangle>::empty, &FigurePath::triangles))
    std::cerr
        << "xnewell: --smooth changed nothing: no face has Gouraud shading of one hue over its triangles\n";
  if (stages.samples || s.off > 0)
    std::cerr << "xnewell: note: " << options.output << ": colours are at most " << s.off << " of 255 off"
              << (stages.samples ? ", from the picture's pixels" : "") << "; " << s.loops << " areas, "
              << bytes.size() / 1000 << " kB\n";
  if (!options.stats) return;
  page::Object stats{{"scene", options.scene},
                     {"size", page::List{figure.width, figure.height}},
                     {"faces", stages.picture.scene().mesh.faceCount()},
                     {"fragments", s.fragments},
                     {"outside", s.outside},
                     {"hidden", s.hidden},
                     {"levels", s.levels},
                     {"off", s.off},
                     {"paths", figure.paths.size()},
                     {"loops", s.loops},
                     {"corners", s.corners},
                     {"bytes", bytes.size()},
                     {"ms", page::Object{{"picture and sort", msSorted},
                                         {"join", msJoined - msSorted},
                                         {"write", msWritten - msJoined}}}};
  if (errors)
    stats.emplace_back("errors", page::Object{{"samples", errors->samples},
                                              {"differ", errors->differ},
                                              {"largest", errors->largest},
                                              {"ciede2000", spreadAsData(errors->figure)},
                                              {"ciede2000_of_the_picture", spreadAsData(errors->picture)}});
  std::cout << page::asJson(stats);
}

}  // namespace xnewell
