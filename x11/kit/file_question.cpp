#include "x11/kit/file_question.h"

#include <exception>
#include <filesystem>
#include <utility>

#include "x11/kit/one_line.h"

namespace xnewell {

Question fileQuestion(std::string asks, std::string text,
                      std::function<std::string(const std::string& file)> complaint,
                      std::function<void(const std::string& file)> write) {
  return {.asks = std::move(asks),
          .text = std::move(text),
          .take = [complaint = std::move(complaint), write = std::move(write),
                   replaced = std::string{}](const std::string& file) mutable -> std::string {
            if (std::string wrong = complaint(file); !wrong.empty()) return wrong;
            if (std::filesystem::is_directory(file)) return "That is a folder.";
            if (file != replaced && std::filesystem::exists(file)) {
              replaced = file;
              return "The file exists. Press Return again to replace it.";
            }
            try {
              write(file);
            } catch (const std::exception& e) {
              return oneLine(e.what());
            }
            return {};
          }};
}

}  // namespace xnewell
