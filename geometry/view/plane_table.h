#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

#include "geometry/view/screen_plane.h"

namespace xnewell {

/// A bound for the error of a plane's z, in z steps, linear in z: rounding in the model moves points near the
/// eye further (plane_record.h). Neither coefficient is negative. If both are 0, the plane counts as exact.
struct Doubt {
  float atBack = 0, byZ = 0;
  [[nodiscard]] double at(double z) const { return atBack + z * byZ; }
};

/// A difference of depths, in z steps, linear over the screen.
struct Ahead {
  double x = 0, y = 0, c = 0;
  [[nodiscard]] double at(std::int64_t px, std::int64_t py) const {
    return x * static_cast<double>(px) + y * static_cast<double>(py) + c;
  }
};

/// Memory that is 0. A page of it costs nothing until something is written there.
template <class T>
struct ZeroPages {
  using value_type = T;
  ZeroPages() = default;
  template <class U>
  explicit(false) ZeroPages(const ZeroPages<U>&) {}
  [[nodiscard]] T* allocate(std::size_t count) {
    if (void* const memory = std::calloc(count, sizeof(T))) return static_cast<T*>(memory);
    throw std::bad_alloc{};
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }
  void construct(T*) const {}  // an element that is given no value stays 0
  bool operator==(const ZeroPages&) const = default;
};

/// The planes of a scene, by SnappedFace::plane, and how far they may be off. They define the depth; the z of
/// a vertex may be off by a step or more. Most planes are never asked for, so they are made one by one
/// (scene_planes.h). Nobody can read one that is not made.
class PlaneTable {
 public:
  /// True if the scene has no planes at all, as after snap().
  [[nodiscard]] bool empty() const { return planes_.empty(); }
  [[nodiscard]] std::size_t size() const { return planes_.size(); }
  [[nodiscard]] int made() const { return made_; }
  [[nodiscard]] bool has(int plane) const {
    return static_cast<std::size_t>(plane) < planes_.size() && planes_[plane].C != 0;
  }
  /// @throws std::logic_error if the plane is not made
  [[nodiscard]] const ScreenPlane& operator[](int plane) const {
    if (!has(plane)) [[unlikely]]
      notMade();
    return planes_[plane];
  }
  /// The error bound of the plane of a face's own corners within the face, from the rounding of the snap and
  /// of the model. `face` is its place in SnappedScene::faces. @throws std::logic_error as above
  [[nodiscard]] Doubt doubtOf(std::ptrdiff_t face, int plane) const {
    if (!has(plane)) [[unlikely]]
      notMade();
    return static_cast<std::size_t>(face) < doubts_.size() ? doubts_[face] : Doubt{};
  }
  /// By SnappedFace::part: how much nearer the plane of the part's own corners (ConvexParts::own) is than its
  /// record.
  [[nodiscard]] Ahead ahead(int part) const {
    return static_cast<std::size_t>(part) < ahead_.size() ? ahead_[part] : Ahead{};
  }

  void makeRoom(std::size_t planes) { planes_.resize(planes); }
  void set(int plane, const ScreenPlane& record) {
    made_ += !has(plane);
    planes_[plane] = record;
  }
  void add(const ScreenPlane& record) { planes_.push_back(record), ++made_; }
  /// `room` is the number of faces, or of parts.
  void setDoubt(int face, const Doubt& doubt, std::size_t room) { roomIn(doubts_, face, room) = doubt; }
  void setAhead(int part, const Ahead& ahead, std::size_t room) { roomIn(ahead_, part, room) = ahead; }

 private:
  [[noreturn]] static void notMade();
  /// A vector of a trivial type. The elements that its first resize() adds are 0.
  template <class T>
  using SparseVector = std::vector<T, ZeroPages<T>>;
  template <class T>
  [[nodiscard]] static T& roomIn(SparseVector<T>& values, int at, std::size_t room) {
    if (values.size() < room) values.resize(room);
    return values[at];
  }

  SparseVector<ScreenPlane> planes_;  ///< C = 0 where none is made
  SparseVector<Doubt> doubts_;
  SparseVector<Ahead> ahead_;
  int made_ = 0;
};

}  // namespace xnewell
