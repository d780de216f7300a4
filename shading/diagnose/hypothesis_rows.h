#pragma once

#include <string_view>
#include <vector>

#include "shading/diagnose/hypothesis.h"

namespace xnewell::rows {

/// What the files that list the rows of hypotheses() share.

using W = Approach;
using S = PictureSettings;

[[nodiscard]] inline bool isLinear(const S& s) { return s.table.kind == TableKind::Linear; }
[[nodiscard]] inline bool isEvenTable(const S& s) { return isEven(s.table.kind); }
[[nodiscard]] inline bool isCorrected(const S& s) { return s.table.kind == TableKind::Corrected; }
[[nodiscard]] inline bool isFlat(const S& s) { return s.shading == Shading::Flat; }
[[nodiscard]] inline bool isGouraud(const S& s) { return s.shading == Shading::Gouraud; }
[[nodiscard]] inline bool isPhong(const S& s) { return s.shading == Shading::Phong; }
[[nodiscard]] inline bool hasVertices(const S& s) { return rowOf(s.shading).interpolates; }
[[nodiscard]] inline bool isTwoSided(const S& s) { return s.light.twoSided; }

/// A mistake of the editable equation: its words are there.
[[nodiscard]] inline Hypothesis shared(Mistake mistake, std::string_view term, void (*change)(W&)) {
  const MistakeRow& row = rowOf(mistake);
  return {row.name, row.is, term, Meaning::Wrong, change, nullptr};
}

/// `applies` may be left out.
[[nodiscard]] inline Hypothesis wrong(std::string_view key, std::string_view term, std::string_view sentence,
                                      bool (*applies)(const S&), void (*change)(W&)) {
  return {key, sentence, term, Meaning::Wrong, change, applies};
}
[[nodiscard]] inline Hypothesis wrong(std::string_view key, std::string_view term, std::string_view sentence,
                                      void (*change)(W&)) {
  return wrong(key, term, sentence, nullptr, change);
}

[[nodiscard]] inline Hypothesis allowed(std::string_view key, std::string_view term,
                                        std::string_view sentence, bool (*applies)(const S&),
                                        void (*change)(W&)) {
  return {key, sentence, term, Meaning::Allowed, change, applies};
}
[[nodiscard]] inline Hypothesis allowed(std::string_view key, std::string_view term,
                                        std::string_view sentence, void (*change)(W&)) {
  return allowed(key, term, sentence, nullptr, change);
}

[[nodiscard]] inline Hypothesis numbers(std::string_view key, std::string_view term,
                                        std::string_view sentence, void (*change)(W&)) {
  return {key, sentence, term, Meaning::Numbers, change, nullptr};
}

void addTables(std::vector<Hypothesis>& all);
void addPainting(std::vector<Hypothesis>& all);
void addViews(std::vector<Hypothesis>& all);
void addNumbers(std::vector<Hypothesis>& all);

}  // namespace xnewell::rows
