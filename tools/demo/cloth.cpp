// SPDX-License-Identifier: Apache-2.0
#include "cloth.hpp"

#include <algorithm>
#include <cmath>

namespace demo {
namespace {

constexpr std::uint32_t side = 100;  // vertices
constexpr double spacing = 3.7;      // metres
constexpr double thickness = 0.9;    // that features keep
constexpr double reach = 2 * thickness;
// Features that are no contact cannot come within the thickness: both of them move by this at most.
constexpr double longest_move = 0.5 * thickness;
constexpr double substep = 0.05;  // seconds
constexpr double gravity = 9.81;
constexpr int iterations = 12;
constexpr double bending_share = 0.02;
constexpr double friction_share = 0.5;

Triangles level_sheet(const Vec3& middle, Random& random) {
  Triangles out;
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const Vec3 place{(i - 0.5 * (side - 1)) * spacing, (j - 0.5 * (side - 1)) * spacing, random.uniform(0.0, 0.1)};
      out.vertices.push_back(middle + place);
      if (i + 1 < side && j + 1 < side) {
        const std::uint32_t a = i * side + j, b = a + side;
        out.indices.insert(out.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
      }
    }
  }
  return out;
}

Vec3 above(const std::vector<Vec3>& vertices) {
  Vec3 low = vertices.front(), high = low;
  for (const Vec3& v : vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  return {0.5 * (low.x + high.x), 0.5 * (low.y + high.y), high.z + 2 * thickness};
}

}  // namespace

ShapeOwner make_mesh(const Triangles& triangles) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  abut_shape* shape = nullptr;
  check(abut_mesh_create(&triangles.vertices.front().x, triangles.vertices.size(), triangles.indices.data(),
                         triangles.indices.size() / 3, nullptr, &shape),
        "cannot make a mesh");
  return ShapeOwner(shape);
}

Cloth::Cloth(const Triangles& bunny, Random random, std::uint32_t threads)
    : sheet_(level_sheet(above(bunny.vertices), random)), bunny_(bunny.vertices), velocities_(sheet_.vertices.size()) {
  add_springs();
  place(bunny, threads);
}

// Along edges and diagonals, and weak ones over two cells, which resist bending.
void Cloth::add_springs() {
  const auto add = [&](std::uint32_t i, std::uint32_t j, std::uint32_t to_i, std::uint32_t to_j, double share) {
    if (to_i < side && to_j < side) {
      const std::uint32_t a = i * side + j, b = to_i * side + to_j;
      springs_.push_back({a, b, length(sheet_.vertices[b] - sheet_.vertices[a]), share});
    }
  };
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      add(i, j, i + 1, j, 1.0);
      add(i, j, i, j + 1, 1.0);
      add(i, j, i + 1, j + 1, 0.3);
      add(i, j, i + 1, j - 1, 0.3);  // beyond the border where j is 0
      add(i, j, i + 2, j, bending_share);
      add(i, j, i, j + 2, bending_share);
    }
  }
}

// A universe of its own, which steps more often than that of the bodies.
void Cloth::place(const Triangles& bunny, std::uint32_t threads) {
  abut_universe_options options;
  abut_universe_options_init(&options, sizeof options);
  options.tolerance_mode = ABUT_TOLERANCE_MARGIN;
  options.threads = threads;
  abut_universe* universe = nullptr;
  check(abut_universe_create(&options, &universe), "cannot create the universe of the cloth");
  universe_.reset(universe);
  abut_policy policy;
  abut_policy_init(&policy, sizeof policy);
  policy.detail = ABUT_DETAIL_ELEMENTS;
  policy.tolerance = reach;
  policy.contact_distance = thickness;
  policy.rest_distance = 1.3 * reach;
  check(abut_policy_set(universe, 0, 0, &policy), "cannot set the policy of the cloth");
  const auto add = [&](const Triangles& its, abut_motion motion, abut_geometry_flags flags) {
    abut_part_options part_options;
    abut_part_options_init(&part_options, sizeof part_options);
    part_options.motion = motion;
    abut_part_id part;
    check(abut_part_create(universe, &part_options, &part), "cannot create a part for the cloth");
    abut_geometry_options geometry_options;
    abut_geometry_options_init(&geometry_options, sizeof geometry_options);
    geometry_options.flags = flags;
    abut_geometry_id geometry;
    check(abut_geometry_create(universe, part, make_mesh(its).get(), &geometry_options, &geometry),
          "cannot place a mesh of the cloth");
    return geometry;
  };
  add(bunny, ABUT_MOTION_STATIC, 0);
  cloth_ = add(sheet_, ABUT_MOTION_DYNAMIC, ABUT_GEOMETRY_SELF_PAIRS);
}

std::span<const abut_element_contact> Cloth::contacts() const {
  const abut_element_contact* first = nullptr;
  std::size_t count = 0;
  check(abut_universe_element_contacts(universe_.get(), &first, &count), "cannot read element contacts");
  return {first, count};
}

Vec3 Cloth::middle_of(const abut_element_contact& contact) const {
  const abut_stencil& its = contact.stencil;
  Vec3 out{0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_vertex_of_a = i < its.of_a;
    const std::vector<Vec3>& places = is_vertex_of_a && is_on_bunny(contact) ? bunny_ : before_;
    out = out + places[its.vertices[i]] * (is_vertex_of_a ? -0.5 * its.weights[i] : 0.5 * its.weights[i]);
  }
  return out;
}

void Cloth::advance(double seconds) {
  for (int left = static_cast<int>(std::round(seconds / substep)); left > 0; --left) {
    find_barriers();
    fall();
    for (int i = 0; i < iterations; ++i) {
      solve();
    }
    rub();
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
      const Vec3 move = sheet_.vertices[i] - before_[i];
      const double far = length(move);
      sheet_.vertices[i] = before_[i] + move * (far > longest_move ? longest_move / far : 1.0);
      velocities_[i] = (sheet_.vertices[i] - before_[i]) * (1.0 / substep);
    }
  }
}

void Cloth::fall() {
  before_ = sheet_.vertices;
  for (std::size_t i = 0; i < velocities_.size(); ++i) {
    Vec3 move = (velocities_[i] - Vec3{0.0, 0.0, gravity * substep}) * substep;
    const double far = length(move);
    move = move * (far > longest_move ? longest_move / far : 1.0);
    sheet_.vertices[i] = sheet_.vertices[i] + move;
  }
}

void Cloth::find_barriers() {
  check(abut_geometry_set_vertices(universe_.get(), cloth_, 0, &sheet_.vertices.front().x, sheet_.vertices.size()),
        "cannot move the cloth");
  check(abut_universe_step(universe_.get(), substep), "cannot run a step of the cloth");
  barriers_.clear();
  for (const abut_element_contact& contact : contacts()) {
    const abut_stencil& its = contact.stencil;
    Barrier barrier{{}, {}, its.normal, 0.0, 0.0, is_on_bunny(contact)};
    for (std::size_t i = 0; i < 4; ++i) {
      if (barrier.is_on_bunny && i < its.of_a) {
        barrier.offset += its.weights[i] * dot(its.normal, bunny_[its.vertices[i]]);
        continue;
      }
      barrier.vertices.at(i) = its.vertices[i];
      barrier.weights.at(i) = its.weights[i];
      barrier.mobility += its.weights[i] * its.weights[i];
    }
    barriers_.push_back(barrier);
  }
}

double Cloth::distance_at(const Barrier& barrier) const {
  double sum = barrier.offset;
  for (std::size_t i = 0; i < 4; ++i) {
    sum += barrier.weights.at(i) * dot(barrier.normal, sheet_.vertices[barrier.vertices.at(i)]);
  }
  return sum;
}

void Cloth::push(const Barrier& barrier, const Vec3& by) {
  for (std::size_t i = 0; i < 4; ++i) {
    Vec3& vertex = sheet_.vertices[barrier.vertices.at(i)];
    vertex = vertex + by * (barrier.weights.at(i) / barrier.mobility);
  }
}

void Cloth::solve() {
  for (const Spring& spring : springs_) {
    Vec3 &a = sheet_.vertices[spring.a], &b = sheet_.vertices[spring.b];
    const Vec3 way = b - a;
    const double now = length(way);
    const Vec3 half = way * (0.5 * spring.share * (now - spring.length) / now);
    a = a + half;
    b = b - half;
  }
  for (const Barrier& barrier : barriers_) {
    const double missing = thickness - distance_at(barrier);
    if (missing > 0.0) {
      push(barrier, barrier.normal * missing);
    }
  }
}

// Takes a part of the motion along the bunny away where the cloth lies on it.
void Cloth::rub() {
  for (const Barrier& barrier : barriers_) {
    if (!barrier.is_on_bunny || distance_at(barrier) > 1.05 * thickness) {
      continue;
    }
    Vec3 slid{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t vertex = barrier.vertices.at(i);
      slid = slid + (sheet_.vertices[vertex] - before_[vertex]) * barrier.weights.at(i);
    }
    slid = slid - barrier.normal * dot(barrier.normal, slid);
    push(barrier, slid * -friction_share);
  }
}

}  // namespace demo
