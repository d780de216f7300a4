#include "shading/scene/json_text.h"

#include <gtest/gtest.h>

#include "geometry/files/parse_error.h"

namespace xnewell::THIS_FILE {

// A list of scenes reads one sentence of each file. What stands below in another object does not count, and
// what stands behind is not read.
TEST(JsonText, ReadsSomeKeysAlone) {
  const JsonText one{
      R"({"other": {"shows": "deep"}, "list": [1, {"shows": 2}], "shows": "a card", "then": nonsense)",
      "a.json",
      {"shows"}};
  EXPECT_EQ(one.root().keys(), std::vector<std::string>{"shows"});
  EXPECT_EQ(one.root().at("shows").text(), "a card");

  const JsonText two{
      R"({"title": "t", "steps": [{"title": "s"}], "number": 3})", "a.json", {"number", "title"}};
  EXPECT_EQ(two.root().at("title").text(), "t");
  EXPECT_EQ(two.root().at("number").whole(1, 9), 3);
  EXPECT_EQ(two.root().keys().size(), 2u);

  EXPECT_FALSE((JsonText{R"({"number": 3})", "a.json", {"shows"}}.root().has("shows")));
  EXPECT_THROW((JsonText{R"({"number": 3, nonsense)", "a.json", {"shows"}}), ParseError);
}

}  // namespace xnewell::THIS_FILE
