// SPDX-License-Identifier: Apache-2.0
module abut.proximity.crossings;
import abut.core.standard;
import abut.core;
import abut.deforming;
import abut.math;
import abut.proximity.body;
import abut.proximity.stencil;
import abut.trees.elements.element_pairs;

namespace abut {
namespace {

// An edge passes a face where a vertex that runs along the edge meets it.
[[nodiscard]] std::optional<Crossing> crossing_of(const ElementBody& own, std::uint32_t edge, const ElementBody& other,
                                                  std::uint32_t face, bool is_edge_of_b) {
  const std::array<Vec3, 2> ends = ends_at(own.start(), own.ends_of(edge));
  const std::array<Vec3, 3> corners = corners_at(other.start(), other.corners_of(face));
  const MovingTouch touch = first_touch_of_vertex_and_face(
      {ends[0], ends[1]}, {{{corners[0], corners[0]}, {corners[1], corners[1]}, {corners[2], corners[2]}}}, {});
  if (!touch.touches) {
    return std::nullopt;
  }
  const Real share = 0.5 * (touch.lower + touch.upper);
  return Crossing{edge, face, is_edge_of_b, share, (1 - share) * ends[0] + share * ends[1]};
}

}  // namespace

void Crossings::find(ElementBody& a, ElementBody& b, const Workers& workers, std::vector<Crossing>& out) {
  search_.begin(a, b, 0, workers);
  found_.resize(std::max(found_.size(), search_.tasks()));
  for (std::vector<Crossing>& found : found_) {
    found.clear();
  }
  search_.for_each_crossing_candidates(a, b, workers, [&](std::size_t task, const CrossingCandidates& candidates) {
    const auto add = [&](const std::optional<Crossing>& crossing) {
      if (crossing) {
        found_[task].push_back(*crossing);
      }
    };
    for (const auto& [edge, face] : candidates.edges_and_faces.list()) {
      add(crossing_of(a, edge, b, face, false));
    }
    for (const auto& [edge, face] : candidates.faces_and_edges.list()) {
      add(crossing_of(b, edge, a, face, true));
    }
  });
  out.clear();
  for (const std::vector<Crossing>& found : found_) {
    out.insert(out.end(), found.begin(), found.end());
  }
  std::ranges::sort(out, [](const Crossing& x, const Crossing& y) {
    return std::tie(x.is_edge_of_b, x.edge, x.face) < std::tie(y.is_edge_of_b, y.edge, y.face);
  });
}

}  // namespace abut
