#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <system_error>
#include <vector>

#include "geometry/files/output_file.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "tests/support/reader_fixture.h"
#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Numbers

double numberIn(const std::string& word) {
  Words words{word, "n.obj"};
  words.nextLine();
  return toNumber(words, words.next());
}

// Seventeen significant digits identify every double, so numbers printed with them are read back bit for bit:
// all exponents, subnormals and the sign of 0 included.
TEST(ToNumber, ReturnsEveryDoubleFromSeventeenDigits) {
  std::mt19937_64 rng{17};
  for (int i = 0; i < 100'000; ++i) {
    const auto x =
        std::bit_cast<double>(i % 4 ? rng() : rng() & 0x800f'ffff'ffff'ffff);  // a quarter subnormal
    if (!(std::abs(x) <= DBL_MAX)) continue;
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", x);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(numberIn(text)), std::bit_cast<std::uint64_t>(x)) << text;
  }
}

// Decimal texts longer than any double are rounded to the nearest double, as the C library does.
TEST(ToNumber, RoundsLongDecimalsToNearest) {
  std::mt19937 rng{40};
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    for (auto digits = 1 + rng() % 40; digits > 0; --digits) text += static_cast<char>('0' + rng() % 10);
    text.insert(text.begin() + static_cast<int>(rng() % text.size()), '.');
    text += 'e';
    text += std::to_string(static_cast<int>(rng() % 720) - 380);
    const double expected = std::strtod(text.c_str(), nullptr);
    if (expected > DBL_MAX) {
      EXPECT_EQ(complaint([&] { return numberIn(text); }),
                "n.obj:1: number " + inQuotes(text) + " is too large");
    } else {
      ASSERT_EQ(numberIn(text), expected) << text;
    }
  }
}

// The spellings that modellers use. from_chars alone does not accept them all.
TEST(ToNumber, TakesTheUsualSpellings) {
  for (const auto& [word, number] : {std::pair{"+2", 2.0},
                                     {"1.", 1.0},
                                     {".5", 0.5},
                                     {"-.5", -0.5},
                                     {"+.5E+1", 5.0},
                                     {"1e3", 1000.0},
                                     {"007", 7.0}})
    EXPECT_EQ(numberIn(word), number) << word;
  EXPECT_TRUE(std::signbit(numberIn("-0")));
}

// The smallest subnormal is 2^-1074 = 4.94...e-324. Numbers below half of it are read as 0, with their sign.
TEST(ToNumber, UnderflowsGradually) {
  const std::string zeros(400, '0');
  for (const auto& [word, number] : {std::pair<std::string, double>{"5e-324", DBL_TRUE_MIN},
                                     {"2.4703282292062328e-324", DBL_TRUE_MIN},
                                     {"2.4703282292062327e-324", 0.0},
                                     {"1e-320", 1e-320},
                                     {"1e-99999999999999999999999", 0.0},
                                     {"0." + zeros + "1", 0.0},
                                     {"0." + zeros + "1e10", 0.0},
                                     {"1" + zeros + "e-800", 0.0},
                                     {"0e99999999999999999999999", 0.0},
                                     {"1" + zeros + "e-400", 1.0}})
    EXPECT_EQ(numberIn(word), number) << word;
  EXPECT_TRUE(std::signbit(numberIn("-1e-400")));
}

// The first decimal that would round beyond the largest double, 2^1024 - 2^970, is an error, and so are all
// above it.
TEST(ToNumber, RefusesOverflow) {
  EXPECT_EQ(numberIn("1.7976931348623158e308"), DBL_MAX);
  const std::string small = "0." + std::string(400, '0') + "1e800";  // a small mantissa, but too large
  for (const std::string& word :
       {std::string{"1.7976931348623159e308"}, std::string{"-1e309"}, std::string{"+1e400"},
        std::string{"1e99999999999999999999"}, "1" + std::string(309, '0'), small,
        "1." + std::string(800, '0') + "e400"}) {
    EXPECT_EQ(complaint([&] { return numberIn(word); }),
              "n.obj:1: number " + inQuotes(word) + " is too large");
  }
}

// Decimals are counted in the text, trailing zeros included. The exponent moves the decimal point.
TEST(Decimals, AreThoseOfTheText) {
  for (const auto& [text, count] : {std::pair{"-1.250", 3},
                                    {"1.5e-3", 4},
                                    {"1.5E+0", 1},
                                    {"1.25e1", 1},
                                    {"1.25e7", -5},
                                    {"1e3", -3},
                                    {"1000", 0},
                                    {"1e-3", 3},
                                    {"+.5", 1},
                                    {"7.", 0},
                                    {"7", 0},
                                    {"1e-99999999999999999999", kMaxDecimals},
                                    {"1e99999999999999999999", -kMaxDecimals}})
    EXPECT_EQ(decimals(text), count) << text;
}

// A file that is written with more decimals than it holds is told, in the three ways in which it can be seen.
TEST(RoundingOfNumbers, TellsOfDecimalsThatHoldNothing) {
  const auto told = [](const char* format, const auto& value) {
    RoundingOfNumbers r;
    std::mt19937 rng{1};
    for (int k = 0; k < 60; ++k) {
      const double v = value(static_cast<double>(rng()) * 0x1p-32 + 1);
      char text[64];
      std::snprintf(text, sizeof text, format, v);
      r.add(text, std::strtod(text, nullptr));
    }
    return r.doubtful();
  };
  const auto as = [](double v) { return v; };
  const auto single = [](double v) { return static_cast<double>(static_cast<float>(v)); };
  const auto sixDecimals = [](double v) { return std::round(1e6 * v) / 1e6; };
  const auto far = [&](double v) { return single(1e7 + v); };
  const auto quarters = [](double v) { return std::round(4 * v) / 4; };
  EXPECT_NE(told("%.12f", single).find("written with 12 decimals but are numbers of single precision"),
            std::string::npos);
  EXPECT_NE(told("%.9f", sixDecimals).find("9 decimals but have no more than 6 that are not 0"),
            std::string::npos);
  EXPECT_NE(told("%.6f", far), "");
  const auto moved = [](double v) { return 1e7 + v; };
  for (const char* honest : {"%.3f", "%.8f", "%.15f", "%.17g"}) EXPECT_EQ(told(honest, moved), "") << honest;
  for (const char* honest : {"%.3f", "%.6f", "%.12f", "%.17g"}) EXPECT_EQ(told(honest, as), "") << honest;
  for (const char* honest : {"%.4f", "%.6f"}) EXPECT_EQ(told(honest, single), "") << honest;
  EXPECT_EQ(told("%.6f", quarters), "");  // a model of round numbers
}

// The most decimals give the rounding, for any exponent. A few numbers with more decimals, zeros and integers
// do not count.
TEST(RoundingOfNumbers, IsThatOfMost) {
  const auto rounding = [](const std::vector<std::string>& numbers) {
    RoundingOfNumbers r;
    for (const std::string& n : numbers) r.add(n, std::stod(n));
    return r.rounding();
  };
  EXPECT_EQ(rounding({}), 0.5);
  EXPECT_EQ(rounding({"1", "0.0000", "250"}), 0.5);
  EXPECT_EQ(rounding({"1.5", "0.25", "7"}), 0.005);
  EXPECT_EQ(rounding({"1.234567e200", "1e0", "0"}), 0.5);
  EXPECT_EQ(rounding({"1.234567e9", "-2.5e8", "0.000"}), 500.0);
  std::vector<std::string> many(18, "0.125");
  many.insert(many.end(), {"1", "0", "2.3123456789012345", "0.12345678901234567"});
  EXPECT_EQ(rounding(many), 0.0005);  // two of twenty
  many.push_back("0.34567890123456784");
  EXPECT_LT(rounding(many), 1e-15);
  EXPECT_EQ(rounding({"446522.05700000003", "0.10000000000000001", "5.0000000000000000001"}), 0.0005);
  EXPECT_EQ(rounding({"0.30000000000000004", "12.000000000000002"}), 0.05);
}

/// ---- Lines and files that are read

using testing::ElementsAre;

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
  EXPECT_EQ(complaint([] { return readTextFile(""); }), ": No such file or directory");
  const TemporaryFolder folder;
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

/// ---- Files that are written

std::string contents(const std::string& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// The errno of the failure. The test fails if there is no failure.
int failure(const std::string& file, std::string_view bytes) {
  try {
    writeFile(file, bytes);
  } catch (const std::system_error& e) {
    return e.code().value();
  }
  ADD_FAILURE() << file << ": written";
  return 0;
}

/// During its lifetime no file grows beyond `bytes`. To write() this looks like a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const ::rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  ::rlimit before_{};
  void (*handler_)(int);
};

// Afterwards the file holds the bytes, whatever it held before, and nothing else is in the folder.
TEST(OutputFile, IsReplacedWhole) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.bin"), bytes("\0abc\n", 5);
  writeFile(file, std::string(100'000, 'x'));
  writeFile(file, bytes);
  EXPECT_EQ(contents(file), bytes);
  EXPECT_EQ(folder.entries(), 1);
}

// A new file gets the permissions that the umask gives to any new file.
TEST(OutputFile, ObeysTheUmask) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  writeFile(folder.file("a"), "x");
  ::umask(before);
  EXPECT_EQ(static_cast<int>(std::filesystem::status(folder.file("a")).permissions()), 0640);
}

// If the disk fills up after 1000 bytes, the old file stays and no temporary file does.
TEST(OutputFile, OfAFullDiskIsAsItWas) {
  const TemporaryFolder folder;
  const std::string old = folder.file("old"), fresh = folder.file("fresh");
  writeFile(old, "before");
  {
    const SmallDisk disk{1000};
    EXPECT_EQ(failure(old, std::string(5000, 'x')), EFBIG);
    EXPECT_EQ(failure(fresh, std::string(5000, 'x')), EFBIG);
  }
  EXPECT_EQ(contents(old), "before");
  EXPECT_FALSE(std::filesystem::exists(fresh));
  EXPECT_EQ(folder.entries(), 1);
}

// A file without write permission is not replaced, though its folder would allow it.
TEST(OutputFile, RespectsPermissions) {
  const TemporaryFolder folder;
  const std::string file = folder.write("kept", "before");
  std::filesystem::permissions(file, std::filesystem::perms{0444});
  std::filesystem::permissions(folder.path(), std::filesystem::perms{0777});
  // Root may write everywhere, so the test becomes another user for a while.
  const uid_t user = ::geteuid(), nobody = 65534;
  if (user == 0 && ::seteuid(nobody) != 0) GTEST_SKIP() << "root cannot be anybody else here";
  const int refusal = failure(file, "x");
  EXPECT_EQ(::seteuid(user), 0);
  EXPECT_EQ(refusal, EACCES);
  EXPECT_EQ(contents(file), "before");
}

// A symbolic link stays a link, and the file at its end changes. A link may also lead to a file that does not
// exist yet, through other links and folders. It makes that file.
TEST(OutputFile, MakesWhatALinkLeadsTo) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("far"));
  std::filesystem::create_symlink("far/second", folder.file("first"));
  std::filesystem::create_symlink("file", folder.file("far/second"));
  writeFile(folder.file("first"), "made");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("first")));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("far/second")));
  EXPECT_EQ(contents(folder.file("far/file")), "made");
  writeFile(folder.file("first"), "after");
  EXPECT_EQ(contents(folder.file("far/file")), "after");
  std::filesystem::create_symlink("round", folder.file("round"));
  EXPECT_EQ(failure(folder.file("round"), "x"), ELOOP);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("round")));
}

// A file that is replaced keeps its mode, its owner and its group.
TEST(OutputFile, KeepsModeAndOwner) {
  const TemporaryFolder folder;
  const std::string file = folder.file("private");
  writeFile(file, "before");
  constexpr uid_t kOther = 65534;
  const bool root = ::geteuid() == 0;
  if (root) {
    ASSERT_EQ(::chown(file.c_str(), kOther, kOther), 0);
  }
  for (const mode_t mode : {0600, 0755, 0640}) {
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    writeFile(file, "after");
    struct ::stat now {};
    ASSERT_EQ(::stat(file.c_str(), &now), 0);
    EXPECT_EQ(now.st_mode & 07777, mode);
    EXPECT_EQ(now.st_uid, root ? kOther : ::geteuid());
    EXPECT_EQ(now.st_gid, root ? kOther : ::getegid());
  }
  EXPECT_EQ(folder.entries(), 1);
}

// A pipe and a file descriptor are written to, not replaced.
TEST(OutputFile, GoesStraightIntoAPipeOrADescriptor) {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe"), held = folder.file("held");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDWR);
  writeFile(pipe, "through");
  std::array<char, 16> read{};
  EXPECT_EQ(::read(reader, read.data(), read.size()), 7);
  EXPECT_STREQ(read.data(), "through");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  ::close(reader);

  const int holder = ::open(held.c_str(), O_RDWR | O_CREAT, 0600);
  writeFile("/dev/fd/" + std::to_string(holder), "seen");
  EXPECT_EQ(::pread(holder, read.data(), read.size(), 0), 4);
  ::close(holder);
  EXPECT_EQ(folder.entries(), 2);
  writeFile("/dev/null", "nothing");
}

}  // namespace

}  // namespace xnewell::THIS_FILE
