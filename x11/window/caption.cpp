#include "x11/window/caption.h"

#include <algorithm>

namespace xnewell {

namespace {

std::string_view chosen(char key, const Setup& setup) {
  const ChoiceRow& row = *choiceOf(key);
  return row.options[row.get(setup)];
}

}  // namespace

std::string orderInWords(Order order) {
  switch (order) {
    case Order::Unsorted:
      return "not sorted";
    case Order::ZMean:
      return "sorted by mean z";
    case Order::ZSort:
      return "sorted by farthest z";
    case Order::Newell:
      return "sorted by depth, Newell's way";
    case Order::Oracle:
      return "each sample decided by itself";
  }
  return {};
}

std::string captionOf(const Setup& setup) {
  std::string shading{chosen('S', setup)};
  if (setup.picture.shading == Shading::Full) shading = "full intensity";
  if (setup.picture.shading == Shading::Environment) shading = "environment map";
  return shading + "; " + orderInWords(setup.picture.order) + "; " +
         (setup.fill == Fill::Scanline ? "own scanline" : "XFillPolygon") + "; " +
         std::string{chosen('P', setup)};
}

}  // namespace xnewell
