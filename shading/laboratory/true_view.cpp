#include "shading/laboratory/true_view.h"

#include "depthsort/oracle.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/settings.h"

namespace xnewell {

PictureSettings trueSettings(const PictureSettings& settings) {
  PictureSettings unpainted = withoutShortCuts(settings);
  unpainted.shading = Shading::Full;
  unpainted.colors = ColorPlan::OneHue;
  return unpainted;
}

TrueView::TrueView(const Picture& of)
    : picture_{PictureCache{of}.make(trueSettings(of.settings()))},
      faces_{picture_.seen(0, picture_.settings().height).faces},
      surface_{picture_.scene(), picture_.camera().view, picture_.settings().width,
               picture_.settings().height} {}

void TrueView::keepShownOnly() {
  picture_ = picture_.onlyShown();
  faces_ = picture_.seen(0, picture_.settings().height).faces;
}

SurfacePlace TrueView::place(std::size_t sample) const {
  const auto width = static_cast<std::size_t>(picture_.settings().width);
  return surface_.at(picture_.snapped().faces[faces_[sample]].part, static_cast<int>(sample % width),
                     static_cast<int>(sample / width));
}

}  // namespace xnewell
