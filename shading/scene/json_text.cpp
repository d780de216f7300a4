#include "shading/scene/json_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

namespace xnewell {

void Node::fail(const std::string& what) const {
  throw ParseError{file_, 0, path_.empty() ? what : path_ + ": " + what};
}

void Node::expectKeys(const std::vector<std::string_view>& keys) const {
  for (const std::string& key : this->keys())
    if (std::ranges::find(keys, key) == keys.end()) {
      std::string all;
      for (const std::string_view k : keys) all += (all.empty() ? "" : ", ") + std::string{k};
      fail("unknown key " + inQuotes(key) + "; the keys are " + all);
    }
}

void Node::expectKeys(std::initializer_list<std::string_view> keys,
                      std::initializer_list<std::string_view> more) const {
  std::vector<std::string_view> all{keys};
  all.insert(all.end(), more);
  expectKeys(all);
}

bool Node::has(std::string_view key) const { return value_.is_object() && value_.contains(key); }

Node Node::at(std::string_view key) const {
  return {value_.at(key), file_, path_.empty() ? std::string{key} : path_ + "." + std::string{key}};
}

std::vector<std::string> Node::keys() const {
  if (!value_.is_object()) fail("an object { } is needed");
  std::vector<std::string> all;
  for (const auto& [key, unused] : value_.items()) all.push_back(key);
  return all;
}

bool Node::isList() const { return value_.is_array(); }

bool Node::isObject() const { return value_.is_object(); }

bool Node::isNumber() const { return value_.is_number(); }

int Node::size() const {
  if (!value_.is_array()) fail("a list [ ] is needed");
  return static_cast<int>(value_.size());
}

Node Node::item(int i) const {
  return {value_[static_cast<std::size_t>(i)], file_, path_ + "[" + std::to_string(i) + "]"};
}

double Node::number() const {
  if (!value_.is_number()) fail("a number is needed");
  const double v = value_.get<double>();
  if (!std::isfinite(v)) fail("the number is too large");
  return v;
}

double Node::numberAbove(double low) const {
  const double v = number();
  if (!(v > low)) fail("a number above " + std::to_string(static_cast<int>(low)) + " is needed");
  return v;
}

double Node::numberFrom(int low, int high) const {
  const double v = number();
  if (v < low || v > high)
    fail("a number from " + std::to_string(low) + " to " + std::to_string(high) + " is needed");
  return v;
}

int Node::whole(int low, int high) const {
  if (!value_.is_number_integer() || value_.get<std::int64_t>() < low || value_.get<std::int64_t>() > high)
    fail("a whole number from " + std::to_string(low) + " to " + std::to_string(high) + " is needed");
  return value_.get<int>();
}

bool Node::isTrue() const { return value_.is_boolean() && value_.get<bool>(); }

bool Node::truth() const {
  if (!value_.is_boolean()) fail("true or false is needed");
  return value_.get<bool>();
}

std::string Node::text() const {
  if (!value_.is_string()) fail("a string is needed");
  return value_.get<std::string>();
}

glm::dvec3 Node::direction() const {
  const glm::dvec3 v = point();
  if (v == glm::dvec3{0.0}) fail("0, 0, 0 is not a direction");
  return v;
}

glm::dvec3 Node::color() const {
  const glm::dvec3 c = point();
  if (std::min({c.r, c.g, c.b}) < 0.0 || std::max({c.r, c.g, c.b}) > 1.0)
    fail("r, g, b from 0 to 1 are needed");
  return c;
}

namespace {

/// How far a text has been read. The parser does not give the place of a key, nor of a number that is too
/// large.
struct Progress {
  std::string_view text;
  const std::string& file;
  int line = 1;  ///< on which the text begins
  std::ptrdiff_t read = 0;

  /// Names the line of the last character read. If that character ends a line, it does not count: it may be
  /// what ended a number.
  template <class Error = ParseError>
  [[noreturn]] void fail(const std::string& what) const {
    const auto end = text.begin() + std::max(read - 1, std::ptrdiff_t{0});
    throw Error{file, line + static_cast<int>(std::count(text.begin(), end, '\n')), what};
  }
  /// Fails where the text is no JSON: at the bracket that is not closed, if the text ends within it or closes
  /// another one.
  [[noreturn]] void failAsText() const {
    std::vector<std::size_t> open;
    bool quoted = false;
    const auto last = static_cast<std::size_t>(std::max(read - 1, std::ptrdiff_t{0}));
    const bool ends = last + 1 >= text.size();
    for (std::size_t k = 0; k < (ends ? text.size() : last); ++k) {
      const char c = text[k];
      if (quoted && c == '\\')
        ++k;
      else if (c == '"')
        quoted = !quoted;
      else if (!quoted && (c == '{' || c == '['))
        open.push_back(k);
      else if (!quoted && (c == '}' || c == ']') && !open.empty())
        open.pop_back();
    }
    if (!quoted && !open.empty()) {
      const char opener = text[open.back()], at = ends ? ' ' : text[last];
      if (ends || at == (opener == '{' ? ']' : '}') || (opener == '{' && at == '{'))
        Progress{text, file, line, static_cast<std::ptrdiff_t>(open.back()) + 1}.fail<NotJson>(
            std::string{"this "} + opener + " is not closed");
    }
    fail<NotJson>("not valid JSON here");
  }
};

/// An iterator over the text that records how far it came.
class Walk {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Walk(const char* at, Progress& progress) : at_{at}, progress_{&progress} {}
  reference operator*() const { return *at_; }
  Walk& operator++() {
    ++at_, ++progress_->read;
    return *this;
  }
  bool operator==(const Walk& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  Progress* progress_;
};

/// Refuses an object that has the same key twice. A parser keeps the last value, but nobody should have to
/// guess which one counts.
class KeysOnce {
 public:
  explicit KeysOnce(const Progress& progress) : progress_{progress} {}
  bool operator()(int, Node::Json::parse_event_t event, const Node::Json& parsed) {
    using Event = Node::Json::parse_event_t;
    if (event == Event::object_start) open_.emplace_back();
    if (event == Event::object_end) open_.pop_back();
    if (event == Event::key && !open_.back().insert(parsed.get<std::string>()).second)
      progress_.fail("the key " + inQuotes(parsed.get<std::string>()) + " appears twice in an object");
    return true;
  }

 private:
  const Progress& progress_;
  std::vector<std::set<std::string>> open_;  ///< for each object being read, its keys so far
};

/// Parses the text. `keep` says of each event whether its value is kept. A value is copied and destroyed by
/// recursion, so one that is nested without end would end the stack.
template <class Keep>
Node::Json parsed(Progress& progress, Keep keep) {
  constexpr int kDeepest = 100;
  const std::string_view text = progress.text;
  const Walk begin{text.data(), progress}, end{text.data() + text.size(), progress};
  try {
    return Node::Json::parse(
        begin, end, [&](int depth, Node::Json::parse_event_t event, const Node::Json& parsed) {
          if (depth > kDeepest)
            progress.fail("lists and objects are nested more than " + std::to_string(kDeepest) + " deep");
          return keep(depth, event, parsed);
        });
  } catch (const Node::Json::parse_error&) {
    progress.failAsText();
  } catch (const Node::Json::out_of_range&) {
    progress.fail("a number is too large");
  }
}

/// Some members of the top-level object.
Node::Json head(std::string_view text, const std::string& name,
                std::initializer_list<std::string_view> keys) {
  struct Enough {};
  Node::Json found = Node::Json::object();
  std::string key;
  const auto keep = [&](int depth, Node::Json::parse_event_t event, const Node::Json& parsed) {
    if (depth != 1) return depth == 0;
    if (event == Node::Json::parse_event_t::key) key = parsed.get<std::string>();
    if (event != Node::Json::parse_event_t::value || std::ranges::find(keys, key) == keys.end()) return true;
    found[key] = parsed;
    if (found.size() == keys.size()) throw Enough{};
    return true;
  };
  Progress progress{text, name};
  try {
    [[maybe_unused]] const Node::Json rest = parsed(progress, keep);
  } catch (const Enough&) {
  }
  return found;
}

/// Reads only the decimals with which the numbers below a key "polygons" are written.
class DecimalsOfPolygons : public nlohmann::json_sax<Node::Json> {
 public:
  [[nodiscard]] std::vector<RoundingOfNumbers> numbers() && { return std::move(numbers_); }

  bool number_float(double value, const std::string& text) override {
    if (inside_ > 0) numbers_.back().add(text, value);
    return true;
  }
  bool key(std::string& name) override {
    polygonsNext_ = name == "polygons";
    return true;
  }
  bool start_array(std::size_t) override {
    if (inside_ == 0 && polygonsNext_) numbers_.emplace_back();
    if (inside_ > 0 || polygonsNext_) ++inside_;
    polygonsNext_ = false;
    return true;
  }
  bool end_array() override {
    if (inside_ > 0) --inside_;
    return true;
  }
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(std::int64_t) override { return true; }
  bool number_unsigned(std::uint64_t) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(Node::Json::binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool end_object() override { return true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  std::vector<RoundingOfNumbers> numbers_;
  int inside_ = 0;
  bool polygonsNext_ = false;
};

}  // namespace

Node::Json parsedJson(std::string_view text, const std::string& file, int line) {
  Progress progress{text, file, line};
  return parsed(progress, KeysOnce{progress});
}

void forEachJsonLine(std::string_view text, const std::string& file, std::string_view example,
                     const std::function<void(const Node::Json&, int line)>& use) {
  int number = 0;
  for (std::size_t from = 0, end = 0; from < text.size(); from = end + 1) {
    ++number;
    end = std::min(text.find('\n', from), text.size());
    const std::string_view line = text.substr(from, end - from);
    if (line.find_first_not_of(" \t\r") == line.npos) continue;
    Node::Json json;
    try {
      json = parsedJson(line, file, number);
    } catch (const NotJson&) {
      for (const char* word : {"nan", "NaN", "inf", "Inf"})
        if (line.find(word) != line.npos)
          throw ParseError{file, number, std::string{"JSON has no "} + word + ": places are numbers"};
    }
    if (!json.is_object())
      throw ParseError{file, number, "not a JSON object such as " + std::string{example}};
    try {
      use(json, number);
    } catch (const ParseError&) {
      throw;
    } catch (const std::runtime_error& e) {
      throw ParseError{file, number, e.what()};
    }
  }
}

JsonText::JsonText(std::string_view text, std::string name)
    : name_{std::move(name)}, value_{std::make_unique<const Node::Json>(parsedJson(text, name_))} {}

JsonText::JsonText(std::string_view text, std::string name, std::initializer_list<std::string_view> keys)
    : name_{std::move(name)}, value_{std::make_unique<const Node::Json>(head(text, name_, keys))} {}

JsonText::~JsonText() = default;

Node JsonText::root() const { return {*value_, name_, ""}; }

std::vector<RoundingOfNumbers> roundingOfPolygons(std::string_view text) {
  DecimalsOfPolygons decimals;
  Node::Json::sax_parse(text, &decimals);
  return std::move(decimals).numbers();
}

}  // namespace xnewell
