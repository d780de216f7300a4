#include "shading/scene/json_node.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

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

}  // namespace xnewell
