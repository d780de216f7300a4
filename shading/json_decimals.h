#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geometry/number.h"
#include "shading/json_node.h"

/// Reads nothing but the decimals that numbers below a key "polygons" carry in their text.
class DecimalsOfPolygons : public nlohmann::json_sax<Node::Json> {
 public:
  /// Of the k-th `polygons` of the file.
  [[nodiscard]] double rounding(std::size_t k) const {
    return k < numbers_.size() ? numbers_[k].rounding() : 0.0;
  }

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
