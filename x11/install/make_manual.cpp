/// make_manual man VERSION DATE|bash|zsh|fish FILE: writes the man page or the completion of a shell.

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "x11/install/manual.h"

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  std::string text;
  if (words.size() == 4 && words[0] == "man") text = xnewell::manPage(words[1], words[2]);
  if (words.size() == 2 && words[0] == "bash") text = xnewell::bashCompletion();
  if (words.size() == 2 && words[0] == "zsh") text = xnewell::zshCompletion();
  if (words.size() == 2 && words[0] == "fish") text = xnewell::fishCompletion();
  if (text.empty()) {
    std::cerr << "usage: make_manual man VERSION DATE FILE, or bash|zsh|fish FILE\n";
    return 2;
  }
  std::ofstream file{words.back()};
  file << text;
  file.close();
  if (!file) std::cerr << words.back() << ": cannot be written\n";
  return file ? 0 : 1;
}
