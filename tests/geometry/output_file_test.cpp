#include "geometry/files/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <iterator>
#include <system_error>

#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

namespace {

std::string contents(const std::string& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// The message and the errno of the failure. The test fails if there is no failure.
std::pair<std::string, int> failure(const std::string& file, std::string_view bytes) {
  try {
    writeFile(file, bytes);
  } catch (const std::system_error& e) {
    return {e.what(), e.code().value()};
  }
  ADD_FAILURE() << file << ": written";
  return {};
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

}  // namespace

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
    EXPECT_EQ(failure(old, std::string(5000, 'x')).second, EFBIG);
    EXPECT_EQ(failure(fresh, std::string(5000, 'x')).second, EFBIG);
  }
  EXPECT_EQ(contents(old), "before");
  EXPECT_FALSE(std::filesystem::exists(fresh));
  EXPECT_EQ(folder.entries(), 1);
}

// The message has the file's name as the user gave it, and the reason in the system's words.
TEST(OutputFile, FailureNamesFileAndReason) {
  const TemporaryFolder folder;
  const std::string nowhere = folder.file("no/such/folder");
  EXPECT_EQ(failure(nowhere, "x").first, nowhere + ": No such file or directory");
  EXPECT_EQ(failure("/dev/full", "x").first, "/dev/full: No space left on device");
  std::filesystem::create_directory(folder.file("folder"));
  EXPECT_EQ(failure(folder.file("folder"), "x").second, EISDIR);
  EXPECT_EQ(folder.entries(), 1);
}

// A name that is too long, and a file in the place of a folder, are told in the system's words, too.
TEST(OutputFile, StrangeNamesAreTold) {
  const TemporaryFolder folder;
  writeFile(folder.file("file"), "x");
  const std::string inside = folder.file("file") + "/a", endless = folder.file(std::string(300, 'n'));
  EXPECT_EQ(failure(inside, "x").first, inside + ": Not a directory");
  EXPECT_EQ(failure(endless, "x").first, endless + ": File name too long");
}

// A folder, or a file without write permission, is not written.
TEST(OutputFile, RespectsPermissions) {
  const TemporaryFolder folder;
  const std::string place = folder.file("place"), file = place + "/kept";
  std::filesystem::create_directory(place);
  writeFile(file, "before");
  std::filesystem::permissions(file, std::filesystem::perms{0444});
  std::filesystem::permissions(folder.file("."), std::filesystem::perms{0755});
  std::filesystem::permissions(place, std::filesystem::perms{0777});
  // Root may write everywhere, so the test becomes another user for a while.
  const uid_t user = ::geteuid(), nobody = 65534;
  if (user == 0 && ::seteuid(nobody) != 0) GTEST_SKIP() << "root cannot be anybody else here";
  const int readOnlyFile = failure(file, "x").second;
  EXPECT_EQ(::seteuid(user), 0);
  std::filesystem::permissions(place, std::filesystem::perms{0555});
  EXPECT_EQ(::seteuid(user == 0 ? nobody : user), 0);
  const int readOnlyFolder = failure(place + "/new", "x").second;
  EXPECT_EQ(::seteuid(user), 0);
  std::filesystem::permissions(place, std::filesystem::perms{0755});
  EXPECT_EQ(readOnlyFile, EACCES);
  EXPECT_EQ(readOnlyFolder, EACCES);
  EXPECT_EQ(contents(file), "before");
}

// A symbolic link stays a link. The file at its end changes.
TEST(OutputFile, FollowsALink) {
  const TemporaryFolder folder;
  writeFile(folder.file("real"), "before");
  std::filesystem::create_symlink("real", folder.file("link"));
  writeFile(folder.file("link"), "after");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_EQ(contents(folder.file("real")), "after");
  EXPECT_EQ(folder.entries(), 2);
}

// A link may lead to a file that does not exist yet, through other links and folders. It makes that file.
TEST(OutputFile, MakesWhatALinkLeadsTo) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("far"));
  std::filesystem::create_symlink("far/second", folder.file("first"));
  std::filesystem::create_symlink("file", folder.file("far/second"));
  writeFile(folder.file("first"), "made");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("first")));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("far/second")));
  EXPECT_EQ(contents(folder.file("far/file")), "made");
  std::filesystem::create_symlink("round", folder.file("round"));
  EXPECT_EQ(failure(folder.file("round"), "x").second, ELOOP);
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

}  // namespace xnewell::THIS_FILE
