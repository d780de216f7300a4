#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace xnewell::THIS_FILE {

namespace {

namespace fs = std::filesystem;

/// Turns of phrase that nobody says to a class, and what to write instead.
struct Phrase {
  std::string_view words, instead;
};
constexpr std::array kPhrases{
    Phrase{"is that of", "name the thing again, or say who has it"},
    Phrase{"are those of", "name the things again, or say who has them"},
    Phrase{"is told", "say who says it to whom"},
    Phrase{"are told", "say who says it to whom"},
    Phrase{"the one that", "name it"},
    Phrase{", of which", "begin a new sentence"},
    Phrase{"by it go", "begin with what goes"},
    Phrase{"thereby", "so"},
    Phrase{"in order to", "to"},
    Phrase{"so as to", "to"},
};

/// The text with a blank for each line break, and for each mark that a line of a table or a list begins with.
std::string flowing(const fs::path& file) {
  std::ifstream in{file};
  std::string text{std::istreambuf_iterator<char>{in}, {}}, flat;
  for (const char c : text) {
    const bool blank = c == '\n' || c == ' ';
    if (!blank || (!flat.empty() && flat.back() != ' ')) flat += blank ? ' ' : c;
  }
  return flat;
}

/// Where a phrase stands as words of its own; npos if nowhere.
std::size_t placeOf(std::string_view phrase, const std::string& text) {
  for (std::size_t at = text.find(phrase); at != std::string::npos; at = text.find(phrase, at + 1)) {
    const std::size_t end = at + phrase.size();
    const auto isLetter = [&](std::size_t k) {
      return k < text.size() && std::isalnum(static_cast<unsigned char>(text[k])) != 0;
    };
    if (!(at > 0 && isLetter(at - 1)) && !isLetter(end)) return at;
  }
  return std::string::npos;
}

}  // namespace

// What people read is plain: the documents, and the words of scenes and lessons.
TEST(PlainWords, InDocumentsAndLessons) {
  const fs::path project = fs::path{XNEWELL_DATA_DIR}.parent_path();
  int documents = 0;
  for (auto at = fs::recursive_directory_iterator{project}; at != fs::recursive_directory_iterator{}; ++at) {
    const std::string name = at->path().filename().string();
    if (at->is_directory() && (name == "build" || name.starts_with('.'))) at.disable_recursion_pending();
    const bool lesson = at->path().extension() == ".json" &&
                        at->path().string().find("/data/") != std::string::npos &&
                        at->path().string().find("/tests/") == std::string::npos;
    if (at->path().extension() != ".md" && !lesson) continue;
    ++documents;
    const std::string text = flowing(at->path());
    for (const Phrase& phrase : kPhrases) {
      const std::size_t place = placeOf(phrase.words, text);
      if (place == std::string::npos) continue;
      ADD_FAILURE() << at->path().lexically_relative(project).string() << " has \"" << phrase.words << "\" ("
                    << phrase.instead << "): ..." << text.substr(place < 40 ? 0 : place - 40, 100) << "...";
    }
  }
  EXPECT_GT(documents, 40);
}

}  // namespace xnewell::THIS_FILE
