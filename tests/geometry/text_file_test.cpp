#include "geometry/files/text_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <vector>

#include "geometry/files/visible.h"
#include "tests/support/reader_fixture.h"

namespace xnewell::THIS_FILE {

using testing::ElementsAre;

namespace {

/// Every word of a text with its line number: "1:v".
std::vector<std::string> wordsOf(std::string_view text) {
  std::vector<std::string> all;
  Words words{text, "text"};
  while (words.nextLine()) {
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      all.push_back(std::to_string(words.line()).append(":").append(word));
    }
  }
  return all;
}

}  // namespace

// Any mixture of line ends and blanks, with or without the last line end, gives the same words on the same
// lines.
TEST(Words, DoNotDependOnBlanksAndLineEnds) {
  const auto expected = ElementsAre("1:v", "1:1", "3:f", "3:2");
  EXPECT_THAT(wordsOf("v 1\n\nf 2\n"), expected);
  EXPECT_THAT(wordsOf("v 1\r\n\r\nf 2\r\n"), expected);
  EXPECT_THAT(wordsOf("v 1\r\rf 2 # x\r"), expected);
  EXPECT_THAT(wordsOf(" \tv\t\t1 \n \nf\v2\f"), expected);
  EXPECT_THAT(wordsOf("\xEF\xBB\xBFv 1\n\nf 2"), expected);
}

// A backslash at the end of a line joins the next line to it and separates words. Line numbers still count.
TEST(Words, JoinContinuedLines) {
  EXPECT_THAT(wordsOf("f 1\\\n2 \\\r\n 3\nf"), ElementsAre("1:f", "1:1", "2:2", "3:3", "4:f"));
  EXPECT_THAT(wordsOf("f 1\\\r2\rf"), ElementsAre("1:f", "1:1", "2:2", "3:f"));
  EXPECT_THAT(wordsOf("a\\b \\ \\"), ElementsAre("1:a\\b", "1:\\", "1:\\")) << "only at a line's end";
  Words words{"f 1 \\\n 2\ng", "text"};
  ASSERT_TRUE(words.nextLine());
  ASSERT_TRUE(words.nextLine()) << "words not asked for are skipped, the continued line's too";
  EXPECT_EQ(words.next(), "g");
}

// A comment begins with a '#' that begins a word, and it ends with its line. A backslash does not continue
// it.
TEST(Words, LeaveOutComments) {
  EXPECT_THAT(wordsOf("# a\nv # b\nm#1 1.#INF\n#c\\\nv"), ElementsAre("2:v", "3:m#1", "3:1.#INF", "5:v"));
}

// The line after the last word is the last line, with or without its own line end.
TEST(Words, StayOnTheLastLineAtTheEnd) {
  for (const std::string_view text : {"a\nb\nc", "a\nb\nc\n", "a\nb\nc\r\n", "a\rb\rc\r"}) {
    Words words{text, "text"};
    while (words.nextLine()) {
    }
    EXPECT_EQ(words.line(), 3) << text;
    EXPECT_FALSE(words.nextLine());
  }
}

// A text without words gives none, however short it is.
TEST(Words, OfTextsWithoutAny) {
  for (const std::string_view text : {"", "\n", " ", "#", "\\\n", "\r\n", "\xEF\xBB\xBF"}) {
    EXPECT_TRUE(wordsOf(text).empty());
  }
  EXPECT_TRUE(wordsOf({}).empty());
}

// rest() returns the remaining words with single blanks between them.
TEST(Words, RestOfALine) {
  Words words{"g  left \t front # x\n", "text"};
  words.nextLine();
  EXPECT_EQ(words.next(), "g");
  EXPECT_EQ(words.rest(), "left front");
  EXPECT_EQ(words.rest(), "");
}

// A text whose lines might not be countable in an int is refused before a byte of it is read.
TEST(Words, RefuseTextsBeyond31Bits) {
  const std::size_t size = kMaxTextBytes + 1;
  void* const map = ::mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  ASSERT_NE(map, MAP_FAILED);
  const std::string_view text{static_cast<const char*>(map), size};
  EXPECT_EQ(complaint([&] { return Words{text, "a.obj"}; }), "a.obj: longer than 2147483647 bytes");
  ::munmap(map, size);
}

// Every byte of a file is returned unchanged.
TEST(ReadTextFile, GivesEveryByteBack) {
  const TemporaryFolder folder;
  for (const std::size_t size : {0u, 1u, 65'535u, 65'536u, 65'537u, 300'001u}) {
    SCOPED_TRACE(size);
    std::mt19937 rng{1975};
    std::string bytes(size, '\0');
    for (char& c : bytes) c = static_cast<char>(rng());
    EXPECT_EQ(readTextFile(folder.write("bytes", bytes)), bytes);
  }
}

// Failures of the system are reported in its words, with the name as the user gave it.
TEST(ReadTextFile, SaysWhatTheSystemSays) {
  const TemporaryFolder folder;
  EXPECT_EQ(complaint([] { return readTextFile("no/such/../teapot.obj"); }),
            "no/such/../teapot.obj: No such file or directory");
  EXPECT_EQ(complaint([] { return readTextFile(""); }), ": No such file or directory");
  EXPECT_EQ(complaint([&] { return readTextFile(folder.path()); }),
            folder.path().string() + ": Is a directory");
  const std::filesystem::path secret = folder.write("secret.obj", "v 0 0 0");
  std::filesystem::permissions(secret, std::filesystem::perms::none);
  const std::string refusal =
      ::geteuid() == 0 ? "" : secret.string() + ": Permission denied";  // root may read everything
  EXPECT_EQ(complaint([&] { return readTextFile(secret); }), refusal);
}

// A pipe, to which nobody may write, and a device, which may have no end, are refused at once.
TEST(ReadTextFile, ReadsRegularFilesOnly) {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("a.obj"), zero = folder.file("b.obj");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", zero);
  for (const std::string& file : {pipe, zero})
    EXPECT_EQ(complaint([&] { return readTextFile(file); }), file + ": not a regular file");
}

// UTF-16 has a name instead of words that no reader knows.
TEST(ReadTextFile, NamesUtf16) {
  const TemporaryFolder folder;
  for (const std::string_view begin : {"\xFF\xFEv", "\xFE\xFF"}) {
    const std::string file = folder.write("a.obj", std::string{begin} + '\0');
    EXPECT_EQ(complaint([&] { return readTextFile(file); }), file + ": a text in UTF-16; save it as UTF-8");
  }
}

// A file that is too long is refused by its size. This one takes no room on the disk.
TEST(ReadTextFile, RefusesFilesBeyond31Bits) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("long.obj", "");
  std::filesystem::resize_file(file, kMaxTextBytes + 1);
  EXPECT_EQ(complaint([&] { return readTextFile(file); }), file.string() + ": longer than 2147483647 bytes");
}

// A quoted word shows at most 40 bytes and no control characters for the terminal.
TEST(InQuotes, IsShortAndPrintable) {
  EXPECT_EQ(inQuotes("1.2.3"), "'1.2.3'");
  const std::string longest(40, 'x');
  EXPECT_EQ(inQuotes(longest), "'" + longest + "'");
  EXPECT_EQ(inQuotes(longest + "x"), "'" + longest + "...'");
  EXPECT_EQ(inQuotes(std::string(39, 'x') + "\xc3\xa9"), "'" + std::string(39, 'x') + "...'");
}

// Only control characters change, those of Latin-1 too. A byte of another character is not one of them.
TEST(Visible, KeepsAllButControlCharacters) {
  EXPECT_EQ(visible(std::string_view{"\x1b[J\0z\x7f~\n\t", 9}), "\\x1b[J\\x00z\\x7f~\\n\\t");
  const std::string letters = "\u00c9mile \u00d6 \u015b \u201c\u20ac\u201d \U0001FAD6 \xc9mile\xff";
  EXPECT_EQ(visible(letters), letters);
  EXPECT_EQ(visible("\u009b2J \x9b \xe0\x80\x9b"), "\\xc2\\x9b2J \\x9b \xe0\\x80\\x9b");
  EXPECT_EQ(visible("\xe2\x82\xc2"), "\xe2\\x82\xc2");
}

}  // namespace xnewell::THIS_FILE
