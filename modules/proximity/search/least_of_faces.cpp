// SPDX-License-Identifier: Apache-2.0
module abut.proximity.search.least_of_faces;
import abut.core.standard;
import abut.math;
import abut.proximity.body;

namespace abut {
namespace {

[[nodiscard]] bool share_vertex(const ElementBody& body, std::uint32_t face, std::uint32_t other) {
  const auto corners = body.corners_of(other);
  return std::ranges::any_of(body.corners_of(face), [&](std::uint32_t corner) {
    return corner == corners[0] || corner == corners[1] || corner == corners[2];
  });
}

}  // namespace

void LeastOfFaces::add(const ElementBody& a, const ElementBody& b, std::uint32_t of_a, std::uint32_t of_b,
                       Real square) {
  if (&a == &b && share_vertex(a, of_a, of_b)) {
    return;
  }
  const bool is_turned = &a == &b && of_b < of_a;
  const std::uint32_t first = is_turned ? of_b : of_a, second = is_turned ? of_a : of_b;
  entries_.push_back({std::uint64_t{first} << 32 | second, square, count_});
}

void LeastOfFaces::add_vertex(const ElementBody& a, const ElementBody& b, std::uint32_t vertex, std::uint32_t face,
                              bool is_of_b, Real square) {
  for (const std::uint32_t around : (is_of_b ? b : a).faces_around_vertices().of(vertex)) {
    if (is_of_b) {
      add(a, b, face, around, square);
    } else {
      add(a, b, around, face, square);
    }
  }
  ++count_;
}

void LeastOfFaces::add_edges(const ElementBody& a, const ElementBody& b, std::uint32_t of_a, std::uint32_t of_b,
                             Real square) {
  for (const std::uint32_t first : a.faces_around_edges().of(of_a)) {
    for (const std::uint32_t second : b.faces_around_edges().of(of_b)) {
      add(a, b, first, second, square);
    }
  }
  ++count_;
}

const std::vector<bool>& LeastOfFaces::result() {
  constexpr Real tie = 1 + 2e-9;  // of squares
  std::ranges::sort(entries_, [](const Entry& x, const Entry& y) {
    return std::tie(x.faces, x.square, x.number) < std::tie(y.faces, y.square, y.number);
  });
  is_least_.assign(count_, false);
  Real least = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (i == 0 || entries_[i].faces != entries_[i - 1].faces) {
      least = entries_[i].square;
    }
    if (entries_[i].square <= tie * least) {
      is_least_[entries_[i].number] = true;
    }
  }
  return is_least_;
}

}  // namespace abut
