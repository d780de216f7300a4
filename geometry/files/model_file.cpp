#include "geometry/files/model_file.h"

#include <algorithm>
#include <stdexcept>
#include <system_error>

namespace xnewell {

namespace {

namespace fs = std::filesystem;

fs::path findData() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none), installed{XNEWELL_DATA_INSTALLED};
  const fs::path beside = (program.parent_path() / XNEWELL_DATA_FROM_PROGRAM).lexically_normal();
  for (const fs::path& folder : {beside, installed})
    if (fs::is_directory(folder, none)) return folder;
  std::string places = beside.string();
  if (installed != beside) places += " or " + installed.string();
  throw std::runtime_error{"the scenes and lessons of the program are missing; they belong in " + places};
}

}  // namespace

const fs::path& dataFolder() {
  static const fs::path folder = findData();
  return folder;
}

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
