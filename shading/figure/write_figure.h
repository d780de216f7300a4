#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "shading/figure/figure.h"

namespace xnewell {

/// The bytes of a figure's file. They depend on the figure alone: they hold no time and no version. A pixel
/// of the picture is a pixel of SVG, and a point (1/72 inch) of PDF and EPS.
/// Precondition of SVG and EPS: no path has triangles.
[[nodiscard]] std::string svgOf(const VectorFigure& figure);
[[nodiscard]] std::string pdfOf(const VectorFigure& figure);
[[nodiscard]] std::string epsOf(const VectorFigure& figure);

struct FigureFormat {
  std::string_view ending, name;
  std::string (*write)(const VectorFigure&);
};
inline constexpr std::array kFigureFormats{FigureFormat{".svg", "SVG", svgOf},
                                           FigureFormat{".pdf", "PDF", pdfOf},
                                           FigureFormat{".eps", "EPS", epsOf}};
/// The format of a file by the end of its name, in capitals or not; null if there is none.
[[nodiscard]] const FigureFormat* figureFormatOf(std::string_view file);

/// The note that one of these files carries, byte for byte; nothing if there is none near its beginning.
/// Nobody promises that it is a note of ours, or UTF-8. @throws std::system_error
[[nodiscard]] std::optional<std::string> noteInFigure(const std::string& file);

}  // namespace xnewell
