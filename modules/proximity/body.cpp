// SPDX-License-Identifier: Apache-2.0
module abut.proximity.body;
import abut.core.standard;
import abut.core;
import abut.elements.nearest;
import abut.math;

namespace abut {
namespace {

void place(std::span<const Real> numbers, std::vector<Vec3>& out) {
  out.resize(numbers.size() / 3);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  }
}

[[nodiscard]] Real squared_distance_to_edge(const Vec3& point, const std::array<Vec3, 2>& edge) {
  return nearest_on_face(point, {edge[0], edge[1], edge[1]}).square;
}

}  // namespace

ElementBody::ElementBody(std::vector<Vec3> rest, std::vector<std::uint32_t> triangles, const Workers& workers)
    : rest_(std::move(rest)),
      start_(rest_),
      triangles_(std::move(triangles)),
      table_(rest_.size(), triangles_),
      tree_(table_, triangles_, rest_, workers),
      box_(box_of_vertices()) {
  const auto face_count = static_cast<std::uint32_t>(table_.triangle_count());
  const auto visit_faces = [&](const auto& visit) {
    for (std::uint32_t face = 0; face < face_count; ++face) {
      if (table_.is_face(face)) {
        visit(face);
      }
    }
  };
  around_vertices_.make(rest_.size(), [&](const auto& add) {
    visit_faces([&](std::uint32_t face) {
      for (const std::uint32_t corner : corners_of(face)) {
        add(corner, face);
      }
    });
  });
  around_edges_.make(table_.edges().size(), [&](const auto& add) {
    visit_faces([&](std::uint32_t face) {
      for (const std::uint32_t edge : table_.edges_of(face)) {
        add(edge, face);
      }
    });
  });
}

Aabb ElementBody::box_of_vertices() const {
  Aabb box = Aabb::empty();
  for (const std::vector<Vec3>* places : {&start_, &end_}) {
    for (const Vec3& vertex : *places) {
      box.include(vertex);
    }
  }
  return box;
}

void ElementBody::move(std::span<const Real> start, std::span<const Real> end) {
  fitted_reach_ = -1;
  place(start, start_);
  place(end, end_);
  box_ = box_of_vertices();
}

void ElementBody::move(std::span<const Vec3> start, std::span<const Vec3> end) {
  fitted_reach_ = -1;
  start_.assign(start.begin(), start.end());
  end_.assign(end.begin(), end.end());
  box_ = box_of_vertices();
}

void ElementBody::fit(const Vec3& origin, Real reach, const Workers& workers) {
  if (fitted_reach_ == reach && tree_.origin() == origin) {
    return;
  }
  tree_.set_origin(origin);
  tree_.fit(start(), end(), reach, workers);
  fitted_reach_ = reach;
}

std::size_t ElementBody::bytes() const {
  return sizeof(ElementBody) + (rest_.capacity() + start_.capacity() + end_.capacity()) * sizeof(Vec3) +
         triangles_.capacity() * sizeof(std::uint32_t) + table_.bytes() + tree_.bytes() + around_vertices_.bytes() +
         around_edges_.bytes();
}

bool are_near_at_rest(const ElementBody& body, std::uint32_t vertex, std::uint32_t face, Real distance) {
  const Real square = nearest_on_face(body.rest()[vertex], corners_at(body.rest(), body.corners_of(face))).square;
  return square < distance * distance;
}

bool are_edges_near_at_rest(const ElementBody& body, std::uint32_t a, std::uint32_t b, Real distance) {
  const std::array<Vec3, 2> of_a = ends_at(body.rest(), body.ends_of(a)), of_b = ends_at(body.rest(), body.ends_of(b));
  Real square = infinity;
  if (const auto inside = nearest_of_edges(of_a, of_b)) {
    square = inside->square;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    square = std::min({square, squared_distance_to_edge(of_a.at(i), of_b), squared_distance_to_edge(of_b.at(i), of_a)});
  }
  return square < distance * distance;
}

}  // namespace abut
