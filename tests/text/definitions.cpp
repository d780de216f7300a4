#include "tests/text/definitions.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace xnewell {

namespace {

using Tokens = std::vector<std::string>;

bool inName(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool isName(const std::string& token) { return inName(token.front()); }

/// Splits a source into names, numbers, `::` and single characters. Comments and preprocessor lines are left
/// out; a string or a character becomes `""`.
class Splitter {
 public:
  explicit Splitter(std::string_view source) : rest_{source} {}

  Tokens split() {
    bool lineStarts = true;
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (c == '\n') lineStarts = true;
      if (std::isspace(static_cast<unsigned char>(c))) {
        rest_.remove_prefix(1);
      } else if (rest_.starts_with("//")) {
        skipTo("\n", 0);
      } else if (rest_.starts_with("/*")) {
        skipTo("*/", 2);
      } else if (c == '#' && lineStarts) {
        skipDirective();
      } else {
        lineStarts = false;
        takeToken();
      }
    }
    return std::move(tokens_);
  }

 private:
  void skipTo(std::string_view end, std::size_t andPast) {
    const std::size_t at = rest_.find(end);
    rest_.remove_prefix(at == std::string_view::npos ? rest_.size() : at + andPast);
  }
  void skipDirective() {
    while (true) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      const bool goesOn = end > 0 && rest_[end - 1] == '\\';
      rest_.remove_prefix(end);
      if (!goesOn || rest_.empty()) return;
      rest_.remove_prefix(1);
    }
  }
  void skipQuoted(char quote) {
    std::size_t at = 1;
    while (at < rest_.size() && rest_[at] != quote) at += rest_[at] == '\\' ? 2 : 1;
    rest_.remove_prefix(std::min(at + 1, rest_.size()));
    tokens_.emplace_back("\"\"");
  }
  void takeToken() {
    const char c = rest_.front();
    if (c == '"' || c == '\'') return skipQuoted(c);
    if (rest_.starts_with("::")) return take(2);
    if (!inName(c)) return take(1);
    const bool number = std::isdigit(static_cast<unsigned char>(c));
    std::size_t n = 1;
    while (n < rest_.size() && (inName(rest_[n]) || (number && (rest_[n] == '.' || rest_[n] == '\'')))) ++n;
    if (rest_.substr(0, n).ends_with('R') && rest_.substr(n).starts_with('"')) {
      const std::size_t open = rest_.find('(');
      const std::string end = ")" + std::string{rest_.substr(n + 1, open - n - 1)} + "\"";
      skipTo(end, end.size());
      tokens_.emplace_back("\"\"");
      return;
    }
    take(n);
  }
  void take(std::size_t n) {
    tokens_.emplace_back(rest_.substr(0, n));
    rest_.remove_prefix(n);
  }

  std::string_view rest_;
  Tokens tokens_;
};

/// The index behind the bracket that closes the one at `open`.
std::size_t behind(const Tokens& tokens, std::size_t open, const std::string& opens,
                   const std::string& closes) {
  int depth = 0;
  for (std::size_t k = open; k < tokens.size(); ++k) {
    if (tokens[k] == opens) ++depth;
    if (tokens[k] == closes && --depth == 0) return k + 1;
  }
  return tokens.size();
}

/// A declaration without its template parameters, attributes and alignment.
Tokens plain(const Tokens& head) {
  Tokens rest;
  for (std::size_t k = 0; k < head.size();) {
    const bool bracket = k + 1 < head.size() && head[k] == "[" && head[k + 1] == "[";
    if (head[k] == "template")
      k = k + 1 < head.size() && head[k + 1] == "<" ? behind(head, k + 1, "<", ">") : k + 1;
    else if (bracket)
      k = behind(head, k, "[", "]");
    else if (head[k] == "alignas")
      k = behind(head, k + 1, "(", ")");
    else
      rest.push_back(head[k++]);
  }
  return rest;
}

std::string joined(const Tokens& tokens, std::size_t from, std::size_t to) {
  std::string text;
  for (std::size_t k = from; k < to; ++k) {
    if (k > from && isName(tokens[k - 1]) && isName(tokens[k])) text += ' ';
    text += tokens[k];
  }
  return text;
}

bool holds(const Tokens& tokens, const std::string& token) {
  return std::ranges::find(tokens, token) != tokens.end();
}

/// The first of these tokens that is not inside < >.
std::size_t firstOf(const Tokens& head, const Tokens& wanted) {
  for (std::size_t k = 0; k < head.size(); ++k) {
    if (holds(wanted, head[k])) return k;
    if (head[k] == "operator") {  // operator<, operator()
      ++k;
      while (k + 1 < head.size() && head[k + 1] != "(") ++k;
    } else if (head[k] == "<" && k > 0 && isName(head[k - 1])) {
      k = behind(head, k, "<", ">") - 1;
    }
  }
  return head.size();
}

/// "(const Foo&,int)" for "(const Foo& foo, int n = 3)".
std::string parameterTypes(const Tokens& head, std::size_t open) {
  const std::size_t end = behind(head, open, "(", ")");
  std::string types = "(";
  Tokens one;
  int depth = 0;
  const auto add = [&] {
    one.resize(static_cast<std::size_t>(std::ranges::find(one, "=") - one.begin()));
    const std::size_t n = one.size();
    if (n > 1 && isName(one[n - 1]) && one[n - 2] != "::" && one[n - 2] != "const") one.pop_back();
    types += joined(one, 0, one.size());
    one.clear();
  };
  for (std::size_t k = open + 1; k + 1 < end; ++k) {
    if (head[k] == "(" || head[k] == "<" || head[k] == "{") ++depth;
    if (head[k] == ")" || head[k] == ">" || head[k] == "}") --depth;
    if (head[k] == "," && depth == 0) {
      add();
      types += ",";
    } else {
      one.push_back(head[k]);
    }
  }
  add();
  return types + ")";
}

const Tokens kClassKeys{"class", "struct", "union", "enum"};

/// The name of the type that a declaration begins with; "" if there is none.
std::string typeNamed(const Tokens& head) {
  std::size_t k = !head.empty() && head[0] == "typedef" ? 1 : 0;
  if (k >= head.size() || !holds(kClassKeys, head[k])) return "";
  while (k < head.size() && holds(kClassKeys, head[k])) ++k;
  std::size_t end = k;
  while (end < head.size() && head[end] != ":" && head[end] != "final") ++end;
  return joined(head, k, end);
}

/// Where the name that ends before `end` begins: it may have classes before it, as `Mesh::size` has.
std::size_t nameBegins(const Tokens& head, std::size_t end) {
  for (std::size_t k = 0; k < end; ++k)
    if (head[k] == "operator") {
      end = k + 1;
      break;
    }
  std::size_t begin = end > 0 ? end - 1 : 0;
  if (begin > 0 && head[begin - 1] == "~") --begin;
  while (begin >= 2 && head[begin - 1] == "::" && isName(head[begin - 2])) begin -= 2;
  return begin;
}

class Reader {
 public:
  Definitions read(const Tokens& tokens) {
    Tokens head;
    int parentheses = 0;
    for (std::size_t k = 0; k < tokens.size(); ++k) {
      const std::string& token = tokens[k];
      if (token == "{" && parentheses == 0) {
        if (!opens(plain(head))) k = skipBody(tokens, k);
        head.clear();
      } else if (token == "}" && parentheses == 0) {
        if (scopes_.empty())
          found_.balanced = false;
        else
          scopes_.pop_back();
        head.clear();
      } else if (token == ";" && parentheses == 0) {
        ends(plain(head));
        head.clear();
      } else {
        parentheses += token == "(" ? 1 : token == ")" ? -1 : 0;
        head.push_back(token);
      }
    }
    found_.balanced &= scopes_.empty() && parentheses == 0;
    return std::move(found_);
  }

 private:
  /// An open namespace; no name: what is in it cannot be seen from other files.
  using Scope = std::optional<std::string>;

  /// At a brace. True if it opens a namespace.
  bool opens(const Tokens& head) {
    const auto space = std::ranges::find(head, "namespace");
    if (space != head.end() && space - head.begin() <= 1) {
      const auto at = static_cast<std::size_t>(space - head.begin()) + 1;
      scopes_.push_back(at == head.size() ? Scope{} : Scope{joined(head, at, head.size()) + "::"});
      return true;
    }
    if (head == Tokens{"extern", "\"\""}) {
      scopes_.emplace_back("");
      return true;
    }
    if (const std::string type = typeNamed(head); !type.empty()) {
      add(Definition::Kind::Type, type);
      return false;
    }
    const std::size_t at = firstOf(head, {"(", "="});
    if (at == head.size() || head[at] == "=")
      variable(head, at);
    else if (!head.empty() && head[0] != ",")
      function(head, at);
    return false;
  }

  /// At the end of a declaration without braces.
  void ends(const Tokens& head) {
    if (const std::string type = typeNamed(head); !type.empty() && head.size() <= 3)
      found_.declared.insert(qualified(type));
    else if (const std::size_t at = firstOf(head, {"(", "="}); at < head.size() && head[at] == "=")
      variable(head, at);
  }

  void variable(const Tokens& head, std::size_t end) {
    if (!holds(head, "inline") || holds(head, "using") || end == 0) return;
    if (const std::size_t bracket = firstOf(head, {"["}); bracket < end) end = bracket;
    const std::size_t begin = nameBegins(head, end);
    add(Definition::Kind::Variable, joined(head, begin, end));
  }

  void function(const Tokens& head, std::size_t open) {
    const std::size_t begin = nameBegins(head, open);
    // TEST(A, B) is not a function, and a static one is for its own file alone.
    const bool member = holds(head, "::");
    if ((begin == 0 && !member) || holds(head, "static")) return;
    add(Definition::Kind::Function, joined(head, begin, open) + parameterTypes(head, open));
  }

  std::size_t skipBody(const Tokens& tokens, std::size_t open) {
    const std::size_t end = behind(tokens, open, "{", "}");
    if (end == tokens.size() && tokens.back() != "}") found_.balanced = false;
    return end - 1;
  }

  [[nodiscard]] std::string qualified(const std::string& name) const {
    std::string full;
    for (const Scope& scope : scopes_) full += scope.value_or("(anonymous)::");
    return full + name;
  }
  void add(Definition::Kind kind, const std::string& name) {
    const bool hidden = std::ranges::any_of(scopes_, [](const Scope& s) { return !s; });
    if (!hidden && !name.empty()) found_.all.push_back({kind, qualified(name)});
  }

  std::vector<Scope> scopes_;
  Definitions found_;
};

}  // namespace

Definitions definitionsIn(std::string_view source) { return Reader{}.read(Splitter{source}.split()); }

}  // namespace xnewell
