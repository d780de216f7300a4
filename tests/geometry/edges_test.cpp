#include "geometry/model/edges.h"

#include <gtest/gtest.h>

#include "geometry/files/obj.h"

namespace xnewell::THIS_FILE {

namespace {

EdgeCounts edgesOf(const std::string& faces) {
  return countEdges(
      parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 -0\nv 3 0 0\n" + faces, "a.obj", "."));
}
void expectEdges(const EdgeCounts& counts, int open, int turned, int crowded) {
  EXPECT_EQ(counts.open, open);
  EXPECT_EQ(counts.turned, turned);
  EXPECT_EQ(counts.crowded, crowded);
}

}  // namespace

// A tetrahedron is closed. Without a face it is open, with one face turned its neighbours disagree, and with
// one face twice three edges are crowded. A vertex that is written twice is one place.
TEST(Edges, AreCountedByWhatMeetsThere) {
  const std::string low = "f 1 3 2\n", front = "f 1 2 4\n", left = "f 1 4 3\n", slope = "f 2 3 4\n";
  expectEdges(edgesOf(low + front + left + slope), 0, 0, 0);
  expectEdges(edgesOf(low + front + left + "f 5 3 4\n"), 0, 0, 0);
  expectEdges(edgesOf(low + front + left), 3, 0, 0);
  expectEdges(edgesOf(low + front + left + "f 4 3 2\n"), 0, 3, 0);
  expectEdges(edgesOf(low + front + left + slope + slope), 0, 0, 3);
  expectEdges(edgesOf("f 1 1 1\n"), 0, 0, 0);
  expectEdges(edgesOf("f 1 2 5 3\n"), 3, 0, 0);
}

}  // namespace xnewell::THIS_FILE
