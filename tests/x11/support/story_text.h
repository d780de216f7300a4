#pragma once

#include <map>
#include <string>

namespace xnewell {

/// The texts of tests/stories, which README.md there describes.

inline std::string unescaped(const std::string& text) {
  std::string plain;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '\\' || k + 1 == text.size()) {
      plain += text[k];
    } else if (text[++k] == 'x') {
      plain += static_cast<char>(std::stoi(text.substr(k + 1, 2), nullptr, 16));
      k += 2;
    } else {
      plain += text[k] == 'n' ? '\n' : text[k] == 'r' ? '\r' : text[k] == 't' ? '\t' : text[k];
    }
  }
  return plain;
}

/// The line with each <NAME> replaced by what it stands for.
inline std::string withNames(std::string line, const std::map<std::string, std::string>& names) {
  for (const auto& [name, text] : names)
    for (std::size_t at = 0; (at = line.find(name, at)) != line.npos; at += text.size())
      line.replace(at, name.size(), text);
  return line;
}

}  // namespace xnewell
