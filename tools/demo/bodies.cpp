// SPDX-License-Identifier: Apache-2.0
#include "bodies.hpp"

#include <algorithm>
#include <numbers>

namespace demo {
namespace {

constexpr double half_sqrt2 = 0.5 * std::numbers::sqrt2;
// Turn the axis of a capsule, local Z, into local X or Y.
constexpr abut_quat z_to_x{half_sqrt2, 0.0, half_sqrt2, 0.0};
constexpr abut_quat z_to_y{half_sqrt2, -half_sqrt2, 0.0, 0.0};

constexpr abut_pose lifted(double z) { return {{0.0, 0.0, z}, no_rotation}; }

// Sizes in metres: the terrain is 30 km wide, so that smaller bodies could not be seen from where its ridges can.
constexpr double smallest = 16.0;
constexpr double largest = 37.0;

double any_size(Random& random) {
  const double t = random.uniform(0.0, 1.0);
  return smallest + (largest - smallest) * t * t;  // more small ones than large ones
}

std::vector<double> flat(const std::vector<Vec3>& points) {
  std::vector<double> xyz;
  xyz.reserve(3 * points.size());
  for (const Vec3& p : points) {
    xyz.insert(xyz.end(), {p.x, p.y, p.z});
  }
  return xyz;
}

// A boulder: points around an ellipsoid, cut flat below so that it has a face to rest on.
std::vector<Vec3> boulder(Random& random, double size) {
  const Vec3 axes{size * random.uniform(0.9, 1.4), size * random.uniform(0.8, 1.2), size * random.uniform(0.7, 1.1)};
  const double floor = -0.55 * axes.z;
  std::vector<Vec3> points(14 + random.below(14));
  for (Vec3& p : points) {
    const Vec3 d = random.direction();
    p = {axes.x * d.x, axes.y * d.y, std::max(axes.z * d.z, floor) - floor};
  }
  for (const double x : {-0.6, 0.6}) {
    for (const double y : {-0.5, 0.5}) {
      points.push_back({axes.x * x, axes.y * y, 0.0});
    }
  }
  return points;
}

}  // namespace

Catalogue::Catalogue(const Triangles& bunny, Random random) {
  add_spheres(random);
  add_boxes(random);
  add_capsules(random);
  add_hulls(random);
  for (int i = 0; i < 4; ++i) {
    add_snowmen(random);
    add_houses(random);
    add_dumbbells(random);
    add_crosses(random);
    add_pyramids(random);
  }
  add_bunnies(bunny);
}

std::size_t Catalogue::choose(Random& random) const {
  struct Share {
    Kind kind;
    std::uint32_t percent;
  };
  constexpr std::array<Share, 7> shares{{{Kind::sphere, 17},
                                         {Kind::box, 18},
                                         {Kind::capsule, 15},
                                         {Kind::hull, 17},
                                         {Kind::compound, 23},
                                         {Kind::bunny_mesh, 5},
                                         {Kind::bunny_hull, 5}}};
  std::size_t ticket = random.below(100);
  std::size_t chosen = 0;
  while (ticket >= shares[chosen].percent) {
    ticket -= shares[chosen].percent;
    ++chosen;
  }
  const std::vector<std::size_t>& of_kind = designs_of_kind_[static_cast<std::size_t>(shares[chosen].kind)];
  return of_kind[random.below(of_kind.size())];
}

void Catalogue::add(Kind kind, std::vector<Piece> pieces, double radius) {
  designs_of_kind_[static_cast<std::size_t>(kind)].push_back(designs_.size());
  designs_.push_back({kind, std::move(pieces), radius});
}

std::size_t Catalogue::keep(abut_shape* shape) {
  shapes_.emplace_back(shape);
  return shapes_.size() - 1;
}

std::size_t Catalogue::sphere(double radius) {
  abut_shape* shape = nullptr;
  check(abut_sphere_create(radius, &shape), "cannot create a sphere");
  return keep(shape);
}

std::size_t Catalogue::box(double half_x, double half_y, double half_z) {
  abut_shape* shape = nullptr;
  check(abut_box_create(half_x, half_y, half_z, &shape), "cannot create a box");
  return keep(shape);
}

std::size_t Catalogue::capsule(double radius, double half_height) {
  abut_shape* shape = nullptr;
  check(abut_capsule_create(radius, half_height, &shape), "cannot create a capsule");
  return keep(shape);
}

std::size_t Catalogue::hull(const std::vector<Vec3>& points) {
  abut_shape* shape = nullptr;
  const std::vector<double> xyz = flat(points);
  check(abut_hull_create(xyz.data(), points.size(), &shape), "cannot create a convex hull");
  return keep(shape);
}

std::size_t Catalogue::mesh(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& indices) {
  abut_shape* shape = nullptr;
  const std::vector<double> xyz = flat(points);
  check(abut_mesh_create(xyz.data(), points.size(), indices.data(), indices.size() / 3, nullptr, &shape),
        "cannot create a triangle mesh");
  return keep(shape);
}

void Catalogue::add_spheres(Random& random) {
  for (int i = 0; i < 16; ++i) {
    const double radius = any_size(random);
    add(Kind::sphere, {{sphere(radius), lifted(radius)}}, radius);
  }
}

void Catalogue::add_boxes(Random& random) {
  for (int i = 0; i < 24; ++i) {
    const double size = any_size(random);
    const double x = size * random.uniform(0.8, 1.5);
    const double y = size * random.uniform(0.7, 1.1);
    const double z = size * random.uniform(0.5, 1.1);
    add(Kind::box, {{box(x, y, z), lifted(z)}}, std::max(x, y));
  }
}

void Catalogue::add_capsules(Random& random) {
  for (int i = 0; i < 16; ++i) {
    const double radius = 0.6 * any_size(random);
    const double half_height = radius * random.uniform(1.0, 2.4);
    add(Kind::capsule, {{capsule(radius, half_height), {{0.0, 0.0, radius}, z_to_x}}}, half_height);
  }
}

void Catalogue::add_hulls(Random& random) {
  for (int i = 0; i < 32; ++i) {
    const double size = any_size(random);
    add(Kind::hull, {{hull(boulder(random, size)), lifted(0.0)}}, 1.1 * size);
  }
}

void Catalogue::add_snowmen(Random& random) {
  const double size = any_size(random);
  add(Kind::compound,
      {{sphere(size), lifted(size)},
       {sphere(0.7 * size), lifted(2.4 * size)},
       {sphere(0.45 * size), lifted(3.3 * size)}},
      size);
}

void Catalogue::add_houses(Random& random) {
  const double size = any_size(random);
  const double x = 1.2 * size;
  const double y = 0.85 * size;
  const double eaves = 1.1 * size;
  const double ridge = 2.0 * size;
  const std::vector<Vec3> roof{{-1.1 * x, -1.2 * y, eaves}, {1.1 * x, -1.2 * y, eaves}, {-1.1 * x, 1.2 * y, eaves},
                               {1.1 * x, 1.2 * y, eaves},   {-1.1 * x, 0.0, ridge},     {1.1 * x, 0.0, ridge}};
  add(Kind::compound, {{box(x, y, 0.5 * eaves), lifted(0.5 * eaves)}, {hull(roof), lifted(0.0)}}, x);
}

void Catalogue::add_dumbbells(Random& random) {
  const double size = 0.8 * any_size(random);
  const double half = 1.5 * size;
  add(Kind::compound,
      {{capsule(0.4 * size, half), {{0.0, 0.0, size}, z_to_x}},
       {sphere(size), {{-half, 0.0, size}, no_rotation}},
       {sphere(size), {{half, 0.0, size}, no_rotation}}},
      half + 0.5 * size);
}

void Catalogue::add_crosses(Random& random) {
  const double size = any_size(random);
  const double radius = 0.4 * size;
  const double half = 1.1 * size;
  const double centre = half + radius;
  const std::size_t beam = capsule(radius, half);
  add(Kind::compound,
      {{beam, {{0.0, 0.0, centre}, no_rotation}},
       {beam, {{0.0, 0.0, centre}, z_to_x}},
       {beam, {{0.0, 0.0, centre}, z_to_y}}},
      size);
}

void Catalogue::add_pyramids(Random& random) {
  const double size = any_size(random);
  std::vector<Piece> pieces;
  double top = 0.0;
  for (const double part : {1.2, 0.8, 0.4}) {
    const double half = 0.3 * size;
    pieces.push_back({box(part * size, part * size, half), lifted(top + half)});
    top += 2.0 * half;
  }
  add(Kind::compound, std::move(pieces), 1.2 * size);
}

void Catalogue::add_bunnies(const Triangles& bunny) {
  for (const double tall : {52.0, 70.0, 95.0}) {
    std::vector<Vec3> points(bunny.vertices.size());
    std::transform(bunny.vertices.begin(), bunny.vertices.end(), points.begin(),
                   [&](const Vec3& v) { return v * tall; });
    add(Kind::bunny_mesh, {{mesh(points, bunny.indices), lifted(0.0)}}, 0.5 * tall);
    add(Kind::bunny_hull, {{hull(points), lifted(0.0)}}, 0.5 * tall);
  }
}

}  // namespace demo
