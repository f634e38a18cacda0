// SPDX-License-Identifier: Apache-2.0
// Questions about meshes that deform, and who answers them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "deforming_scenes.hpp"

namespace bench {

// candidates: pairs of elements whose boxes, from start to end, come within reach. closest: of each vertex within
// reach of a face its least distance, at the start. impact: pairs of elements that touch on the way, and when. overlap:
// edges that pass faces, at the start. distance: that of two meshes, at the start.
enum class Asked : std::uint8_t { candidates, closest, impact, overlap, distance };

inline constexpr std::array all_asked{Asked::candidates, Asked::closest, Asked::impact, Asked::overlap,
                                      Asked::distance};

[[nodiscard]] constexpr std::string_view asked_name(Asked asked) {
  constexpr std::array<std::string_view, 5> names{"candidates", "closest", "impact", "overlap", "distance"};
  return names[static_cast<std::size_t>(asked)];
}

// In a mesh with itself, features that share a vertex are no pair, and each pair counts once.
enum class PairKind : std::uint8_t {
  vertex_face,  // of a and of b
  edge_edge,    // of one mesh the lower number first
  face_vertex,  // of a and of b, of two meshes alone
  edge_face,    // of overlaps: the edge is of a
  face_edge     // likewise: the edge is of b
};

struct ElementPair {
  PairKind kind = PairKind::vertex_face;
  std::uint32_t a = 0, b = 0;
  double value = 0;  // of impacts the time, from 0 to 1

  [[nodiscard]] std::array<std::uint32_t, 3> key() const { return {static_cast<std::uint32_t>(kind), a, b}; }
};

struct Found {
  std::vector<ElementPair> pairs;  // in any order; each once
  std::vector<double> distances;  // of closest: of the vertices of a, then of b, infinite beyond reach; or the only one
  bool is_yes = false;            // of overlap, where `has_pairs` is false
  bool has_pairs = true;          // false of a contender that tells no more than whether there are any
};

// Ready for the first step of a scene. The timed part takes the vertices of a step, and answers.
class DeformingWay {
 public:
  DeformingWay() = default;
  DeformingWay(const DeformingWay&) = delete;
  DeformingWay& operator=(const DeformingWay&) = delete;
  virtual ~DeformingWay() = default;

  virtual void answer(const DeformingCase& step, Found& found) = 0;
};

struct NamedWay {
  std::string name;
  std::unique_ptr<DeformingWay> way;
};

// The list is empty where a library has no such question.
[[nodiscard]] std::vector<NamedWay> abut_ways(Asked asked, const DeformingCase& first);
// Candidates alone, in double precision: a loop over all pairs, and a sweep along one axis.
[[nodiscard]] std::vector<NamedWay> plain_ways(Asked asked);
[[nodiscard]] [[gnu::visibility("default")]] std::vector<NamedWay> bullet_ways(Asked asked, const DeformingCase& first);
[[nodiscard]] [[gnu::visibility("default")]] std::vector<NamedWay> fcl_ways(Asked asked, const DeformingCase& first);

}  // namespace bench
