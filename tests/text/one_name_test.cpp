#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/text/definitions.h"

namespace xnewell::THIS_FILE {

namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

struct SourceFile {
  std::string path;  ///< in the project
  Definitions definitions;
};

/// All sources of the program and its tests.
const std::vector<SourceFile>& sources() {
  static const std::vector<SourceFile> all = [] {
    const fs::path project = fs::path{XNEWELL_DATA_DIR}.parent_path();
    std::vector<SourceFile> files;
    for (const char* floor : {"geometry", "depthsort", "shading", "x11", "tests"})
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator{project / floor}) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        std::ifstream in{entry.path()};
        const std::string text{std::istreambuf_iterator<char>{in}, {}};
        files.push_back({fs::relative(entry.path(), project).string(), definitionsIn(text)});
      }
    return files;
  }();
  return all;
}

std::vector<std::string> namesIn(std::string_view source) {
  const Definitions found = definitionsIn(source);
  EXPECT_TRUE(found.balanced) << source;
  std::vector<std::string> names;
  for (const Definition& one : found.all) names.push_back(one.name);
  return names;
}

}  // namespace

// A name means one thing in the whole program. If two files define it, the linker silently takes one of the
// two, and the other file goes on with the wrong one (the one-definition rule, [basic.def.odr]). No compiler
// sees that, because no file includes both.
TEST(OneName, HasOneDefinition) {
  std::map<std::string, std::set<std::string>> files;
  int types = 0;
  for (const SourceFile& source : sources()) {
    EXPECT_TRUE(source.definitions.balanced) << source.path << ": the braces do not match";
    for (const Definition& one : source.definitions.all) {
      files[one.name].insert(source.path);
      types += one.kind == Definition::Kind::Type;
    }
  }
  EXPECT_GT(types, 500);
  EXPECT_GT(files.size(), 1'500u);
  EXPECT_GT(files.erase("main(int,char**)"), 0u) << "each program has its own";
  // So may these be: [replacement.functions].
  std::erase_if(files, [](const auto& entry) {
    return entry.first.starts_with("operator new(") || entry.first.starts_with("operator delete(");
  });
  for (const auto& [name, places] : files)
    EXPECT_EQ(places.size(), 1u) << name << " is defined in " << testing::PrintToString(places)
                                 << ": rename it, or put it into an anonymous namespace";
}

// A type of the program that only its own source file knows is in an anonymous namespace, so that it meets no
// other. Fixtures of tests are not: GoogleTest prints their names.
TEST(OneName, OfASourceFileAloneIsHidden) {
  std::set<std::string> declared;
  for (const SourceFile& source : sources())
    if (source.path.ends_with(".h")) declared.merge(std::set{source.definitions.declared});
  for (const SourceFile& source : sources()) {
    if (source.path.ends_with(".h") || source.path.starts_with("tests/")) continue;
    for (const Definition& one : source.definitions.all) {
      const bool nested = one.name.rfind("::") > one.name.find("::");
      EXPECT_TRUE(one.kind != Definition::Kind::Type || nested || declared.contains(one.name))
          << source.path << ": " << one.name << " belongs into an anonymous namespace";
    }
  }
}

// The reader knows definitions from declarations, members, and what an anonymous namespace hides.
TEST(DefinitionsIn, FindsTypes) {
  EXPECT_THAT(
      namesIn("namespace n { struct A { struct B {}; int f() { return 1; } }; enum class C : int { D };"
              " template <class T> class E final : public A {}; union F { int i; }; }"),
      ElementsAre("n::A", "n::C", "n::E", "n::F"));
  EXPECT_THAT(
      namesIn("namespace n::m { struct alignas(16) A {}; class [[nodiscard]] B {}; struct A::C {}; }"),
      ElementsAre("n::m::A", "n::m::B", "n::m::A::C"));
  EXPECT_THAT(namesIn("template <> struct hash<n::A> { };"), ElementsAre("hash<n::A>"));
  EXPECT_THAT(namesIn("struct A; class B; enum class C : int; friend struct D; using E = struct F;"),
              IsEmpty());
  EXPECT_THAT(definitionsIn("namespace n { struct A; class B; }").declared, ElementsAre("n::A", "n::B"));
  EXPECT_THAT(namesIn("namespace { struct A {}; namespace m { struct B {}; } } struct C {};"),
              ElementsAre("C"));
  EXPECT_THAT(namesIn("void f() { struct A {}; if (true) { struct B {}; } }"), ElementsAre("f()"));
}

TEST(DefinitionsIn, FindsFunctions) {
  EXPECT_THAT(namesIn("int f(int a, const B& b = {}) { return 1; } int f(int) { return 2; }"),
              ElementsAre("f(int,const B&)", "f(int)"));
  EXPECT_THAT(namesIn("std::map<int, A> f(std::function<int(int)> g) noexcept(true) { }"),
              ElementsAre("f(std::function<int(int)>)"));
  EXPECT_THAT(
      namesIn("bool operator<(A a, A b) { return true; } int A::operator()(int i) const { return i; }"),
      ElementsAre("operator<(A,A)", "A::operator()(int)"));
  EXPECT_THAT(namesIn("A::A(int i) : B{i}, c_(i), d_{i} { f(); } A::~A() { }"),
              ElementsAre("A::A(int)", "A::~A()"));
  EXPECT_THAT(
      namesIn("template <class T> requires true auto f(T t) -> int { } int g(int); static int h() {}"),
      ElementsAre("f(T)"));
  EXPECT_THAT(namesIn("TEST(A, B) { int i; }"), IsEmpty());
}

TEST(DefinitionsIn, FindsInlineVariables) {
  EXPECT_THAT(
      namesIn("inline constexpr std::array kA{1, 2}; inline int b = 3, c; inline const auto kD = [](int) "
              "{ return 1; }; inline constexpr int kE[] = {1};"),
      ElementsAre("kA", "b", "kD", "kE"));
  EXPECT_THAT(namesIn("constexpr int kA = 1; const B kB{1}; extern int c;"), IsEmpty());
}

TEST(DefinitionsIn, SkipsWhatIsNoCode) {
  EXPECT_THAT(namesIn("// struct A {\n/* struct B { */ #define C struct D { \\\n struct E {\nstruct F {};"),
              ElementsAre("F"));
  EXPECT_THAT(namesIn("const char* a = \"struct A {\\\"{\"; char b = '{', c = '\\''; int d = 1'000;"),
              IsEmpty());
  EXPECT_THAT(namesIn("const char* a = R\"x(struct A { )\" )x\"; struct B {};"), ElementsAre("B"));
  EXPECT_FALSE(definitionsIn("struct A {").balanced);
  EXPECT_FALSE(definitionsIn("namespace n { } }").balanced);
}

}  // namespace xnewell::THIS_FILE
