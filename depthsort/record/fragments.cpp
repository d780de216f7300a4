#include "depthsort/record/fragments.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace xnewell {

namespace {

/// A name of bounded length. It is cut at a character's boundary.
std::string shortened(const std::string& name) {
  constexpr std::size_t kMost = 48;  // bytes
  if (name.size() <= kMost) return name;
  std::size_t end = kMost;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;
  return name.substr(0, end) + "...";
}

}  // namespace

Fragments::Fragments(const Mesh& mesh, const SnappedScene& scene, const SortedScene& sorted)
    : mesh_{&mesh},
      scene_{&scene},
      sorted_{&sorted},
      faces_{static_cast<int>(scene.faces.size())},
      regions_{scene} {
  for (const Event& e : sorted.events)
    if (e.kind == Event::Kind::Split) splitter_.push_back(face(e.Q).plane);
  for (const int group : mesh.group) ++facesNamed_[mesh.groupNames[group]];
}

Region Fragments::region(int id) const {
  Region region;
  if (!isPiece(id)) {
    regions_.outline(scene_->faces[id], region);
    return region;
  }
  region = this->region(parent(id));
  const int k = (id - faces_) / 2;
  const Line nearer = regions_.cut(face(id).plane, splitter_[k]);
  regions_.clip(region, id == pieceOf(k) ? Regions::flipped(nearer) : nearer);
  return region;
}

Extents Fragments::extents(int id) const {
  if (!isPiece(id)) return extentsOf(*scene_, face(id));
  return extentsOf(*scene_, face(id), region(id), extents(parent(id)));
}

std::string Fragments::path(int id) const {
  std::string splits;
  while (isPiece(id)) {
    splits += (id - faces_) % 2 == 0 ? 'a' : 'b';
    id = parent(id);
  }
  std::ranges::reverse(splits);

  const int number = face(id).number;
  const auto numberOf = [&](int i) { return scene_->faces[i].number; };
  int part = 1;
  while (id - part >= 0 && numberOf(id - part) == number) ++part;
  if (part > 1 || (id + 1 < faces_ && numberOf(id + 1) == number)) return "." + std::to_string(part) + splits;
  return splits;
}

const std::string& Fragments::group(int id) const { return mesh_->groupNames[mesh_->group[face(id).number]]; }

bool Fragments::hasName(int id) const {
  // Sentences use these for the two polygons of a pair.
  constexpr std::array<std::string_view, 4> kRoles{"P", "Q", "p", "q"};
  const std::string& name = group(id);
  return !name.empty() && std::ranges::find(kRoles, name) == kRoles.end() && facesNamed_.at(name) == 1;
}

std::string Fragments::name(int id) const {
  const std::string name = hasName(id) ? shortened(group(id)) : "face " + std::to_string(face(id).number);
  const std::string path = this->path(id);
  const bool joins =
      path.empty() || path.front() == '.' || std::isdigit(static_cast<unsigned char>(name.back())) != 0;
  return name + (joins ? "" : ".") + path;
}

std::string Fragments::number(int id) const { return std::to_string(face(id).number) + path(id); }

std::string Fragments::part(int id) const { return hasName(id) ? name(id) : shortened(group(id)); }

}  // namespace xnewell
