#include "geometry/files/model_file.h"

#include <algorithm>

namespace xnewell {

std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

const ModelFileRow* modelFile(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  const auto* const row = std::ranges::find(kModelFiles, extension, &ModelFileRow::extension);
  return row == kModelFiles.end() ? nullptr : row;
}

std::string modelExtensions() {
  std::string all;
  for (const ModelFileRow& row : kModelFiles) all += (all.empty() ? "" : ", ") + std::string{row.extension};
  return all;
}

}  // namespace xnewell
