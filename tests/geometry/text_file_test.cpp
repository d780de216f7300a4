#include "geometry/files/text_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <thread>
#include <vector>

#include "tests/support/reader_fixture.h"

namespace xnewell {

using testing::ElementsAre;

namespace {

/// Every word of a text with the line it is said to stand on: "1:v".
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

// Any mixture of line ends, blanks and a missing last line end gives the same words on the same lines.
TEST(Words, DoNotDependOnBlanksAndLineEnds) {
  const auto expected = ElementsAre("1:v", "1:1", "3:f", "3:2");
  EXPECT_THAT(wordsOf("v 1\n\nf 2\n"), expected);
  EXPECT_THAT(wordsOf("v 1\r\n\r\nf 2\r\n"), expected);
  EXPECT_THAT(wordsOf(" \tv\t\t1 \n \nf\v2\f"), expected);
  EXPECT_THAT(wordsOf("\xEF\xBB\xBFv 1\n\nf 2"), expected);
}

// A backslash that ends a line joins the next one to it, separates words, and keeps the lines' numbers.
TEST(Words, JoinContinuedLines) {
  EXPECT_THAT(wordsOf("f 1\\\n2 \\\r\n 3\nf"), ElementsAre("1:f", "1:1", "2:2", "3:3", "4:f"));
  EXPECT_THAT(wordsOf("a\\b \\ \\"), ElementsAre("1:a\\b", "1:\\", "1:\\")) << "only at a line's end";
  Words words{"f 1 \\\n 2\ng", "text"};
  ASSERT_TRUE(words.nextLine());
  ASSERT_TRUE(words.nextLine()) << "words not asked for are skipped, the continued line's too";
  EXPECT_EQ(words.next(), "g");
}

// A comment begins with a word's '#', ends with its line, and no backslash makes it longer.
TEST(Words, LeaveOutComments) {
  EXPECT_THAT(wordsOf("# a\nv # b\nm#1 1.#INF\n#c\\\nv"), ElementsAre("2:v", "3:m#1", "3:1.#INF", "5:v"));
}

// The line after the last word is the last line, with or without its own line end.
TEST(Words, StayOnTheLastLineAtTheEnd) {
  for (const std::string_view text : {"a\nb\nc", "a\nb\nc\n", "a\nb\nc\r\n"}) {
    Words words{text, "text"};
    while (words.nextLine()) {
    }
    EXPECT_EQ(words.line(), 3) << text;
    EXPECT_FALSE(words.nextLine());
  }
}

// No text, however short, has a word it should not have.
TEST(Words, OfTextsWithoutAny) {
  for (const std::string_view text : {"", "\n", " ", "#", "\\\n", "\r\n", "\xEF\xBB\xBF"}) {
    EXPECT_TRUE(wordsOf(text).empty());
  }
  EXPECT_TRUE(wordsOf({}).empty());
}

// The rest of a line is its words with single blanks between them.
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

// A file's bytes come back unchanged, whatever they are, from a file and from a pipe of unknown length.
TEST(ReadTextFile, GivesEveryByteBack) {
  const TemporaryFolder folder;
  for (const std::size_t size : {0u, 1u, 65'535u, 65'536u, 65'537u, 300'001u}) {
    SCOPED_TRACE(size);
    std::mt19937 rng{1975};
    std::string bytes(size, '\0');
    for (char& c : bytes) c = static_cast<char>(rng());
    EXPECT_EQ(readTextFile(folder.write("bytes", bytes)), bytes);

    const std::filesystem::path pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::jthread writer{[&] { std::ofstream{pipe, std::ios::binary} << bytes; }};
    EXPECT_EQ(readTextFile(pipe), bytes);
    std::filesystem::remove(pipe);
  }
}

// What the system refuses is said in its words, with the name as the user gave it.
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
      ::geteuid() == 0 ? "" : secret.string() + ": Permission denied";  // root reads all
  EXPECT_EQ(complaint([&] { return readTextFile(secret); }), refusal);
}

// A file too long to be read is refused by its size; this one takes no room on the disk.
TEST(ReadTextFile, RefusesFilesBeyond31Bits) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("long.obj", "");
  std::filesystem::resize_file(file, kMaxTextBytes + 1);
  EXPECT_EQ(complaint([&] { return readTextFile(file); }), file.string() + ": longer than 2147483647 bytes");
}

// A quoted word shows 40 bytes at most and nothing that a terminal would obey.
TEST(InQuotes, IsShortAndPrintable) {
  EXPECT_EQ(inQuotes("1.2.3"), "'1.2.3'");
  const std::string longest(40, 'x');
  EXPECT_EQ(inQuotes(longest), "'" + longest + "'");
  EXPECT_EQ(inQuotes(longest + "x"), "'" + longest + "...'");
  EXPECT_EQ(inQuotes(std::string_view{"\x1b[J\0z\x7f~\xc3\xa9", 9}),
            "'?[J?z?~?"
            "?'");
}

}  // namespace xnewell
