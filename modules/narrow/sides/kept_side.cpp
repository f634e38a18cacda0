// SPDX-License-Identifier: Apache-2.0
module abut.narrow.sides.kept_side;
import abut.capability;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

std::array<Real, 6> ends_of(const Vec3& low, const Vec3& high) { return {low.x, low.y, low.z, high.x, high.y, high.z}; }

bool is_lower(const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

}  // namespace

SidesOfParts::SidesOfParts(std::span<const TriangleCorners> corners)
    : states_(corners.size(), State::unknown), edge_of_part_(3 * corners.size()) {
  for (std::size_t part = 0; part < corners.size(); ++part) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &from = corners[part][i], &to = corners[part][(i + 1) % 3];
      const bool is_forward = is_lower(from, to);
      edges_.push_back(
          {is_forward ? ends_of(from, to) : ends_of(to, from), static_cast<std::uint32_t>(part), is_forward});
    }
  }
  std::ranges::sort(edges_, {}, [](const Edge& edge) { return std::tie(edge.ends, edge.part, edge.is_forward); });
  std::vector<std::uint32_t> filled(corners.size(), 0);
  for (std::uint32_t at = 0; at < edges_.size(); ++at) {
    if (at == 0 || edges_[at].ends != edges_[at - 1].ends) {
      group_starts_.push_back(at);
    }
    edges_[at].group = static_cast<std::uint32_t>(group_starts_.size() - 1);
    const std::uint32_t part = edges_[at].part;
    edge_of_part_[3 * part + filled[part]++] = at;
  }
  group_starts_.push_back(static_cast<std::uint32_t>(edges_.size()));
}

void SidesOfParts::spread(std::vector<std::uint32_t> open, std::vector<State>& states) const {
  for (std::size_t next = 0; next < open.size(); ++next) {
    const std::uint32_t part = open[next];
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge& own = edges_[edge_of_part_[3 * part + i]];
      for (std::uint32_t at = group_starts_[own.group]; at < group_starts_[own.group + 1]; ++at) {
        const Edge& other = edges_[at];
        if (states[other.part] == State::unknown) {
          // Neighbours that are wound alike run along their edge in opposite directions.
          const bool is_alike = other.is_forward != own.is_forward;
          states[other.part] = (states[part] == State::front) == is_alike ? State::front : State::back;
          open.push_back(other.part);
        }
      }
    }
  }
}

void SidesOfParts::spread() {
  std::vector<std::uint32_t> open;
  for (std::uint32_t at = 0; at < states_.size(); ++at) {
    if (is_known(at)) {
      open.push_back(at);
    }
  }
  spread(std::move(open), states_);
}

void SidesOfParts::spread_from(std::size_t at, bool is_front) {
  std::vector<State> states(states_.size(), State::unknown);
  states[at] = is_front ? State::front : State::back;
  spread({static_cast<std::uint32_t>(at)}, states);
  for (std::size_t part = 0; part < states.size(); ++part) {
    states_[part] = states[part] == State::unknown ? states_[part] : states[part];
  }
}

std::vector<SideOfPart> sides_around(std::span<const Triangle> triangles, std::span<const SideOfPart> known) {
  std::vector<TriangleCorners> corners;
  corners.reserve(triangles.size());
  for (const Triangle& triangle : triangles) {
    corners.push_back(triangle.corners());
  }
  SidesOfParts sides(corners);
  for (std::size_t at = 0, next = 0; at < triangles.size() && next < known.size(); ++at) {
    if (triangles[at].index() == known[next].part) {
      sides.set(at, known[next++].is_front);
    }
  }
  sides.spread();
  std::vector<SideOfPart> all;
  for (std::size_t at = 0; at < triangles.size(); ++at) {
    if (sides.is_known(at)) {
      all.push_back({triangles[at].index(), sides.is_front(at)});
    }
  }
  return all;
}

std::optional<std::size_t> find_part(std::span<const TouchedPart> touched, std::uint32_t part) {
  const auto at =
      std::lower_bound(touched.begin(), touched.end(), part,
                       [](const TouchedPart& its, std::uint32_t number) { return its.triangle.index() < number; });
  return at != touched.end() && at->triangle.index() == part
             ? std::optional(static_cast<std::size_t>(at - touched.begin()))
             : std::nullopt;
}

}  // namespace abut
