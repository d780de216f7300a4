#include "x11/views/terms_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shading/picture/picture_cache.h"
#include "x11/views/views.h"

namespace xnewell::THIS_FILE {

namespace {

Picture made(Shading method, Form form = Form::Textbook, ColorPlan plan = ColorPlan::OneHue,
             const char* scene = "teapot") {
  PictureCache pictures{readScene(scene, 4)};
  PictureSettings s = pictures.scene().settings;
  s.camera = pictures.scene().camera;
  s.width = 240, s.height = 180;
  s.shading = method, s.light.form = form, s.colors = plan;
  return pictures.make(s, CellPlan{}[Cell::Well]);
}

}  // namespace

// The colour of each sample tells its value: gray from 0 to 1, blue below 0. Only the steps of the scene's
// cells are lost.
TEST(TermsView, ColoursTellTheValues) {
  for (const ColorPlan plan : {ColorPlan::OneHue, ColorPlan::Chosen})
    for (const TermValueRow& row : kTerms) {
      SCOPED_TRACE(std::string{row.name});
      const Picture picture = made(Shading::Phong, Form::Textbook, plan);
      const TermValues found = termValuesOf(picture, row.id);
      const ColoredImage image = termImage(found, picture, CellPlan{}, picture.palette(CellPlan{}));
      const double step = 255.0 / (row.isCosine ? 119 : 239);
      int compared = 0, negative = 0;
      for (std::size_t k = std::size_t{240} * 40; k < found.values.size(); ++k) {  // below the legend
        const Rgb16 color = image.palette[image.image.pixels[k]];
        if (std::isnan(found.values[k])) {
          ASSERT_EQ(image.image.pixels[k], CellPlan{}[Cell::Well]);
        } else if (found.values[k] >= 0.0) {
          ASSERT_NEAR(color.r >> 8, 255.0 * found.values[k], step) << k;
          ASSERT_EQ(color.r, color.b);
        } else {
          ASSERT_EQ(color.r, 0) << k;
          ASSERT_GE(color.b >> 8, 79);
          ++negative;
        }
        compared += !std::isnan(found.values[k]);
      }
      EXPECT_GT(compared, 5'000);
      EXPECT_EQ(negative > 100, row.isCosine);
    }
}

// The finding names the number as the form of the equation does, with its range. Where the method computes
// no light it says so, and nothing is shown.
TEST(TermsView, FindingsAreOfTheNumbers) {
  const auto bold = [](const Picture& picture, Term term) {
    return findingOf(termValuesOf(picture, term), picture).bold;
  };
  EXPECT_EQ(bold(made(Shading::Flat), Term::Ambient), "ambient is 0.1800 everywhere.");
  EXPECT_TRUE(bold(made(Shading::Flat), Term::Cosine).starts_with("R.V: -"));
  EXPECT_TRUE(bold(made(Shading::Phong, Form::HalfVector), Term::Cosine).starts_with("N.H: -"));
  EXPECT_EQ(bold(made(Shading::Depth), Term::Diffuse), "depth computes no light: there is no diffuse.");
  EXPECT_EQ(bold(made(Shading::Environment), Term::NdotL), "env looks up sums: there is no N.L.");
  const Picture lights = made(Shading::Gouraud, Form::Textbook, ColorPlan::OneHue, "colored-lights");
  EXPECT_NE(findingOf(termValuesOf(lights, Term::NdotL), lights).why.find("the first of "),
            std::string::npos);
  const Picture depth = made(Shading::Depth);
  for (const double value : termValuesOf(depth, Term::Diffuse).values) ASSERT_TRUE(std::isnan(value));
}

// Every number has a view of its own, by the same name, and each row stands where its view's number says.
TEST(TermsView, AreViews) {
  for (const TermValueRow& row : kTerms) {
    const auto* const view = std::ranges::find(kViews, row.name, &ViewRow::name);
    ASSERT_NE(view, kViews.end());
    EXPECT_EQ(view->term, row.id);
  }
  for (std::size_t k = 0; k < kViews.size(); ++k) EXPECT_EQ(static_cast<std::size_t>(kViews[k].id), k);
}

}  // namespace xnewell::THIS_FILE
