// SPDX-License-Identifier: Apache-2.0
module abut.triangles.alike_triangles;
import abut.core.joined_sets;
import abut.core.standard;
import abut.math;
import abut.triangles.edges;

namespace abut {

// Edges that more than two triangles share, or that two of them run along the same way, part sets.
AlikeTriangles::AlikeTriangles(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices)
    : order_(indices.size() / 3), groups_(order_.size()) {
  JoinedSets sets(order_.size());
  visit_edges(indices, [&](std::span<const EdgeOfTriangle> sharing) {
    if (sharing.size() == 2 && sharing[0].is_forward != sharing[1].is_forward) {
      sets.join(sharing[0].triangle, sharing[1].triangle);
    }
  });
  // The least triangle of a set stands for it. Sorted by counting: where each set begins, then its triangles.
  std::vector<std::uint32_t> places(order_.size(), 0);
  const auto count = static_cast<std::uint32_t>(order_.size());
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
    ++places[sets.of(triangle)];
  }
  for (std::uint32_t triangle = 0, before = 0; triangle < count; ++triangle) {
    before += std::exchange(places[triangle], before);
  }
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
    order_[places[sets.of(triangle)]++] = triangle;
  }
  for (std::uint32_t place = 0; place < count; ++place) {
    const std::uint32_t triangle = order_[place];
    const bool is_new_set = sets.of(triangle) == triangle;
    if (is_new_set) {
      first_groups_.push_back(static_cast<std::uint32_t>(begins_.size()));
    }
    if (is_new_set || place - begins_.back() == most_in_group) {
      begins_.push_back(place);
    }
    groups_[triangle] = static_cast<std::uint32_t>(begins_.size() - 1);
  }
  first_groups_.push_back(static_cast<std::uint32_t>(begins_.size()));
  begins_.push_back(static_cast<std::uint32_t>(order_.size()));
  const std::uint32_t groups = first_groups_.back();
  summaries_.resize(2 * std::size_t{groups});
  for (std::uint32_t group = 0; group < groups; ++group) {
    summaries_[std::size_t{groups} + group] = of_group(group, vertices, indices);
  }
  for (std::size_t node = groups; node-- > 1;) {
    summaries_[node] = both(summaries_[2 * node], summaries_[2 * node + 1]);
  }
}

AlikeTriangles::Summary AlikeTriangles::both(const Summary& a, const Summary& b) {
  const bool is_a = std::pair(-a.area_of_largest, a.largest) < std::pair(-b.area_of_largest, b.largest);
  const Summary& larger = is_a ? a : b;
  return {a.area + b.area, larger.area_of_largest, larger.largest};
}

AlikeTriangles::Summary AlikeTriangles::of_group(std::uint32_t group, std::span<const Vec3> vertices,
                                                 std::span<const std::uint32_t> indices) const {
  Summary out;
  for (const std::uint32_t triangle : between(group, group + 1)) {
    const auto its = indices.subspan(3 * std::size_t{triangle}, 3);
    const Vec3 a = vertices[its[0]], b = vertices[its[1]], c = vertices[its[2]];
    const Real area = 0.5 * norm(cross(b - a, c - a));
    out = both(out, {area, area, triangle});
  }
  return out;
}

AlikeTriangles::Summary AlikeTriangles::summary(std::uint32_t set) const {
  Summary out;
  std::size_t begin = first_groups_.back() + std::size_t{first_groups_[set]},
              end = first_groups_.back() + std::size_t{first_groups_[set + 1]};
  for (; begin < end; begin /= 2, end /= 2) {
    if (begin % 2 == 1) {
      out = both(out, summaries_[begin++]);
    }
    if (end % 2 == 1) {
      out = both(out, summaries_[--end]);
    }
  }
  return out;
}

void AlikeTriangles::move(std::uint32_t triangle, std::span<const Vec3> vertices,
                          std::span<const std::uint32_t> indices) {
  const std::uint32_t group = groups_[triangle];
  std::size_t node = first_groups_.back() + std::size_t{group};
  summaries_[node] = of_group(group, vertices, indices);
  for (node /= 2; node > 0; node /= 2) {
    summaries_[node] = both(summaries_[2 * node], summaries_[2 * node + 1]);
  }
}

}  // namespace abut
