#include "x11/command/commands.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include "geometry/files/data_folder.h"
#include "geometry/files/input_file.h"
#include "geometry/files/output_file.h"
#include "geometry/files/text_file.h"
#include "x11/homework/html.h"
#include "x11/options/shell_words.h"

namespace xnewell {

namespace {

namespace fs = std::filesystem;

/// The line of page.html that says how the page begins.
constexpr std::string_view kBegin = R"(const begin = {"address": "", "files": {}};)";

/// Where `cmake --install` puts the page, or build.sh.
std::string emptyPage() {
  const fs::path data = fs::canonical(dataFolder());
  for (const fs::path& file : {data / "xnewell.html", data.parent_path() / "build/browser/xnewell.html"})
    if (fs::exists(file)) return readTextFile(file);
  throw std::runtime_error{"the page for browsers is missing; x11/browser/build.sh makes it"};
}

bool isIn(const fs::path& folder, const fs::path& file) {
  return std::ranges::mismatch(folder, file).in1 == folder.end();
}

/// The smallest folder that has them all.
fs::path folderOf(const std::set<fs::path>& files) {
  if (files.empty()) return {};
  fs::path folder = files.begin()->parent_path();
  while (!std::ranges::all_of(files, [&](const fs::path& file) { return isIn(folder, file); }))
    folder = folder.parent_path();
  return folder;
}

}  // namespace

std::string pageThatBeginsWith(const Options& options, const std::set<std::string>& read, std::string page) {
  const fs::path data = fs::canonical(dataFolder());
  std::set<fs::path> files;
  for (const std::string& file : read)
    if (!isIn(data, file)) files.insert(file);
  const fs::path folder = folderOf(files), own = placeOf(options.scene);
  std::string command = "xnewell " + std::string{rowOf(options.command).name} + ' ' +
                        quoted(files.contains(own) ? own.lexically_relative(folder).string() : options.scene);
  for (std::size_t k = 0; k < options.given.size(); ++k)
    if (const std::string& option = options.given[k]; option.starts_with("--") && option != "--page")
      command += ' ' + option + '=' + quoted(options.values[k]);
  nlohmann::ordered_json begin{{"address", addressOf(command)}, {"files", nlohmann::ordered_json::object()}};
  for (const fs::path& file : files)
    begin["files"][file.lexically_relative(folder).string()] = base64(readTextFile(file));
  std::string text = begin.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != text.npos;) text.replace(at, 1, "\\u003c");
  const std::size_t at = page.find(kBegin);
  if (at == page.npos) throw std::runtime_error{"the page for browsers is of another version"};
  return page.replace(at, kBegin.size(), "const begin = " + text + ';');
}

void writePage(const Options& options) {
  const std::set<std::string> read = inputs();  // without the page
  writeFile(options.page, pageThatBeginsWith(options, read, emptyPage()));
}

}  // namespace xnewell
