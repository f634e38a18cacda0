// SPDX-License-Identifier: Apache-2.0
module abut.triangles.elements;
import abut.core.standard;

namespace abut {
namespace {

constexpr std::size_t first_edge_bit = 3, first_border_bit = 6, face_bit = 9;

[[nodiscard]] inline std::uint16_t bit(std::size_t place) { return static_cast<std::uint16_t>(1u << place); }

// An edge as one number in the order of the ends, and where it lies: three times its triangle, plus its place there.
struct PlacedEdge {
  std::uint64_t ends;
  std::size_t place;
};

}  // namespace

ElementTable::ElementTable(std::size_t vertex_count, std::span<const std::uint32_t> triangles)
    : edges_of_(triangles.size() / 3, {none, none, none}), flags_(triangles.size() / 3) {
  std::vector<bool> is_owned(vertex_count);
  for (std::size_t triangle = 0; triangle < edges_of_.size(); ++triangle) {
    const auto corners = triangles.subspan(3 * triangle).first<3>();
    if (corners[0] == corners[1] && corners[1] == corners[2]) {
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_owned[corners[i]]) {
        is_owned[corners[i]] = true;
        flags_[triangle] |= bit(i);
      }
    }
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) {
      flags_[triangle] |= bit(face_bit);
      ++face_count_;
    }
  }
  number_edges(triangles);
  list_edges_around(vertex_count);
}

void ElementTable::list_edges_around(std::size_t vertex_count) {
  first_around_vertex_.assign(vertex_count + 1, 0);
  for (const EdgeEnds& ends : edges_) {
    ++first_around_vertex_[ends[0]];
    ++first_around_vertex_[ends[1]];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& first : first_around_vertex_) {
    first = sum += first;
  }
  edges_around_.resize(sum);
  // From the back, so that each list is in order and each end becomes a beginning.
  for (std::size_t edge = edges_.size(); edge-- > 0;) {
    for (const std::uint32_t end : edges_[edge]) {
      edges_around_[--first_around_vertex_[end]] = static_cast<std::uint32_t>(edge);
    }
  }
}

void ElementTable::number_edges(std::span<const std::uint32_t> triangles) {
  std::vector<PlacedEdge> placed;
  placed.reserve(triangles.size());
  for (std::size_t place = 0; place < triangles.size(); ++place) {
    const std::uint32_t start = triangles[place], end = triangles[place - place % 3 + (place + 1) % 3];
    if (start != end) {
      placed.push_back({std::uint64_t{std::min(start, end)} << 32 | std::max(start, end), place});
    }
  }
  std::ranges::sort(placed, [](const PlacedEdge& a, const PlacedEdge& b) {
    return std::tuple(a.ends, a.place) < std::tuple(b.ends, b.place);
  });
  for (std::size_t begin = 0, end = 0; begin < placed.size(); begin = end) {
    const std::uint64_t ends = placed[begin].ends;
    std::size_t faces = 0;
    for (; end < placed.size() && placed[end].ends == ends; ++end) {
      const std::size_t triangle = placed[end].place / 3;
      edges_of_[triangle][placed[end].place % 3] = static_cast<std::uint32_t>(edges_.size());
      if (is_face(static_cast<std::uint32_t>(triangle))) {
        ++faces;
        corners_across_.push_back(triangles[3 * triangle + (placed[end].place + 2) % 3]);
      }
    }
    first_across_edge_.push_back(static_cast<std::uint32_t>(corners_across_.size()));
    flags_[placed[begin].place / 3] |= bit(first_edge_bit + placed[begin].place % 3);
    for (std::size_t i = begin; i < end && faces < 2; ++i) {
      flags_[placed[i].place / 3] |= bit(first_border_bit + placed[i].place % 3);
    }
    edges_.push_back({static_cast<std::uint32_t>(ends >> 32), static_cast<std::uint32_t>(ends)});
  }
}

std::uint32_t ElementTable::edge_between(std::uint32_t a, std::uint32_t b) const {
  const EdgeEnds ends{std::min(a, b), std::max(a, b)};
  const auto found = std::lower_bound(edges_.begin(), edges_.end(), ends);
  return found == edges_.end() || *found != ends ? none : static_cast<std::uint32_t>(found - edges_.begin());
}

}  // namespace abut
