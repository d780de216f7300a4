#include "x11/options/shell_words.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

#include "geometry/files/visible.h"

namespace xnewell {

std::string quoted(const std::string& word) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view{"-_./,:=+"}.find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, plain)) return word;
  const bool control = visible(word) != word;
  std::string text;
  for (const char c : word)
    if (control && (c == '\'' || c == '\\'))
      text += std::string{'\\', c};
    else
      text += c == '\'' ? std::string{"'\\''"} : std::string{c};
  return (control ? "$'" : "'") + visible(text) + '\'';
}

std::optional<std::vector<std::string>> wordsOf(std::string_view command) {
  std::vector<std::string> words;
  enum class Quoting { No, Plain, Escapes } quoting = Quoting::No;
  bool inWord = false;
  for (std::size_t k = 0; k < command.size(); ++k) {
    char c = command[k];
    if (c == ' ' && quoting == Quoting::No) {
      inWord = false;
      continue;
    }
    if (!std::exchange(inWord, true)) words.emplace_back();
    if (quoting == Quoting::No && command.substr(k).starts_with("$'")) {
      quoting = Quoting::Escapes;
      ++k;
      continue;
    }
    if (c == '\'') {
      quoting = quoting == Quoting::No ? Quoting::Plain : Quoting::No;
      continue;
    }
    if (c == '\\' && quoting != Quoting::Plain) {
      if (++k == command.size()) return std::nullopt;
      c = command[k];
      if (quoting == Quoting::Escapes && (c == 'n' || c == 't')) c = c == 'n' ? '\n' : '\t';
      if (quoting == Quoting::Escapes && c == 'x') {
        unsigned byte = 0;
        const std::string_view digits = command.substr(k + 1, 2);
        const char* const end = digits.data() + digits.size();
        if (std::from_chars(digits.data(), end, byte, 16).ptr != end || byte == 0) return std::nullopt;
        c = static_cast<char>(byte);
        k += 2;
      }
    }
    words.back() += c;
  }
  if (quoting != Quoting::No) return std::nullopt;
  return words;
}

}  // namespace xnewell
