#include "x11/options/shell_words.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace xnewell {

std::string quoted(const std::string& word) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view{"-_./,:=+"}.find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, plain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string{"'\\''"} : std::string{c};
  return text + '\'';
}

std::optional<std::vector<std::string>> wordsOf(std::string_view command) {
  std::vector<std::string> words;
  bool inWord = false, quoting = false;
  for (std::size_t k = 0; k < command.size(); ++k) {
    char c = command[k];
    if (c == ' ' && !quoting) {
      inWord = false;
      continue;
    }
    if (!std::exchange(inWord, true)) words.emplace_back();
    if (c == '\'') {
      quoting = !quoting;
      continue;
    }
    if (c == '\\' && !quoting) {
      if (++k == command.size()) return std::nullopt;
      c = command[k];
    }
    words.back() += c;
  }
  if (quoting) return std::nullopt;
  return words;
}

}  // namespace xnewell
