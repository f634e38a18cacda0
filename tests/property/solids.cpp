// SPDX-License-Identifier: Apache-2.0
#include "solids.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <variant>

namespace property {

namespace {

using oracle::Point;
using Numbers = std::vector<double>;

// A shape by the generic door of the C interface.
ShapePtr shape_of(const std::string& kind, const std::string& name, const Numbers& parameters, const Numbers& reals) {
  abut_shape_desc desc;
  abut_shape_desc_init(&desc, sizeof desc);
  desc.kind = abut_shape_kind_by_name(kind.c_str());
  desc.parameters = parameters.data();
  desc.parameter_count = parameters.size();
  desc.reals = reals.data();
  desc.real_count = reals.size();
  abut_shape* shape = nullptr;
  const abut_status status = abut_shape_create(&desc, &shape);
  if (status != ABUT_OK) {
    throw std::runtime_error("cannot create " + name + ": " + abut_status_name(status) + ": " +
                             abut_last_error_message());
  }
  return ShapePtr(shape);
}

double smallest_positive(const Numbers& lengths) {
  double best = 0;
  for (const double length : lengths) {
    if (length > 0 && (best == 0 || length < best)) best = length;
  }
  return best > 0 ? best : 1;
}

std::vector<Point> points_of(const Numbers& numbers) {
  std::vector<Point> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  return points;
}

oracle::Solid solid_of(const std::string& kind, const Numbers& p) {
  if (kind == "point") return oracle::solid_of(oracle::make_hull({{0, 0, 0}}));
  if (kind == "segment") return oracle::solid_of(oracle::make_hull({{0, 0, -p[0]}, {0, 0, p[0]}}));
  if (kind == "triangle" || kind == "hull") return oracle::solid_of(oracle::make_hull(points_of(p)));
  if (kind == "sphere") return oracle::solid_of(oracle::make_sphere(p[0]));
  if (kind == "box") return oracle::solid_of(oracle::Box{{p[0], p[1], p[2]}});
  if (kind == "capsule") return oracle::solid_of(oracle::make_capsule(p[0], p[1]));
  if (kind == "cylinder") return oracle::solid_of(oracle::Cylinder{p[0], p[1]});
  if (kind == "cone") return oracle::solid_of(oracle::Cone{p[0], p[1]});
  return oracle::solid_of(oracle::Ellipsoid{{p[0], p[1], p[2]}});
}

oracle::Measured measured_of(const oracle::Solid& solid) {
  if (const auto* rounded = std::get_if<oracle::Rounded>(&solid.form)) {
    oracle::Measured measured = rounded->measured;
    measured.radius = rounded->body.radius;
    return measured;
  }
  if (const auto* box = std::get_if<oracle::Box>(&solid.form)) {
    return oracle::measured(oracle::make_box(box->half[0], box->half[1], box->half[2]));
  }
  return {};
}

// The smallest that is not zero of the parameters, or of the half sides where these are points.
double small_length(const std::string& kind, const Numbers& numbers) {
  if (kind != "triangle" && kind != "hull") return smallest_positive(numbers);
  Numbers sides;
  const std::vector<Point> points = points_of(numbers);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [axis](const auto& p, const auto& q) { return p[axis] < q[axis]; });
    sides.push_back(((*high)[axis] - (*low)[axis]) / 2);
  }
  return smallest_positive(sides);
}

}  // namespace

SolidSubject make_solid(const std::string& kind, const std::string& name, const Numbers& numbers) {
  const bool has_points = kind == "hull";
  SolidSubject result;
  result.subject.kind = kind;
  result.subject.name = name;
  result.subject.shape = shape_of(kind, name, has_points ? Numbers{} : numbers, has_points ? numbers : Numbers{});
  result.solid = solid_of(kind, numbers);
  result.subject.measured = measured_of(result.solid);
  result.subject.size = result.solid.size;
  result.subject.small = small_length(kind, numbers);
  result.is_curved = kind == "cylinder" || kind == "cone" || kind == "ellipsoid";
  return result;
}

namespace {

struct Size {
  std::string name;
  Numbers numbers;
};

Numbers ball_of_points(std::uint64_t seed, int count, const Point& radii, const Point& centre) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Numbers numbers;
  for (int made = 0; made < count;) {
    const Point p{uniform(random), uniform(random), uniform(random)};
    const double length = std::hypot(p[0], p[1], p[2]);
    if (length > 1 || length < 0.1) continue;
    for (std::size_t i = 0; i < 3; ++i) numbers.push_back(centre[i] + radii[i] * p[i] / length);
    ++made;
  }
  return numbers;
}

std::vector<Size> sizes_of_points(const std::string& kind) {
  if (kind == "triangle") {
    return {{"plain", {0, 0, 0, 1, 0.25, 0.5, -0.25, 1, 0.75}},
            {"needle", {-1, 0, 0, 1, 1e-6, 0, 0.5, 0, 1e-6}},
            {"tiny", {1e-3, 0, 0, 0, 1e-3, 0, 0, 0, 1e-3}},
            {"huge", {-900, -800, 0, 1000, 0, 0, 0, 700, 100}},
            {"straight", {0, 0, 0, 1, 1, 1, 0.5, 0.5, 0.5}},
            {"shrunk", {0.25, 0.5, 0.75, 0.25, 0.5, 0.75, 0.25, 0.5, 0.75}}};
  }
  return {{"plain", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}},
          {"round", ball_of_points(41, 12, {1, 0.8, 0.6}, {0, 0, 0})},
          {"needle", ball_of_points(42, 8, {1e-6, 1e-6, 1}, {0, 0, 0})},
          {"plate", ball_of_points(43, 8, {1, 1, 1e-6}, {0, 0, 0})},
          {"tiny", ball_of_points(44, 8, {1e-3, 1e-3, 1e-3}, {0, 0, 0})},
          {"huge", ball_of_points(45, 8, {1e3, 800, 900}, {100, 0, 0})},
          {"flat", {-0.5, 0, 0, 0.5, 0, 0, 0, 0.75, 0, 0, -0.25, 0}}};
}

std::vector<Size> sizes_of(const std::string& kind) {
  if (kind == "point") return {{"plain", {}}};
  if (kind == "segment") return {{"plain", {1}}, {"tiny", {1e-3}}, {"huge", {1e3}}, {"shrunk", {0}}};
  if (kind == "sphere") return {{"plain", {0.5}}, {"tiny", {1e-3}}, {"huge", {1e3}}};
  if (kind == "capsule") {
    return {
        {"plain", {0.3, 1}}, {"needle", {1e-6, 1}}, {"tiny", {1e-3, 1e-3}}, {"huge", {800, 1000}}, {"round", {0.5, 0}}};
  }
  if (kind == "box") {
    return {{"plain", {1, 0.7, 0.4}},      {"needle", {1e-6, 1e-6, 1}}, {"plate", {1, 1, 1e-6}},
            {"tiny", {1e-3, 15e-4, 2e-3}}, {"huge", {1000, 800, 900}},  {"flat", {1, 0.5, 0}}};
  }
  if (kind == "ellipsoid") {
    return {{"plain", {1, 0.7, 0.4}}, {"round", {0.5, 0.5, 0.5}},    {"needle", {1e-6, 1e-6, 1}},
            {"plate", {1, 1, 1e-6}},  {"tiny", {1e-3, 15e-4, 2e-3}}, {"huge", {1000, 800, 900}},
            {"flat", {1, 0.5, 0}},    {"straight", {0, 0, 1}},       {"shrunk", {0, 0, 0}}};
  }
  if (kind == "cylinder" || kind == "cone") {
    return {{"plain", {0.5, 1}},   {"needle", {1e-6, 1}}, {"plate", {1, 1e-6}}, {"tiny", {1e-3, 2e-3}},
            {"huge", {800, 1000}}, {"flat", {1, 0}},      {"straight", {0, 1}}, {"shrunk", {0, 0}}};
  }
  return sizes_of_points(kind);
}

}  // namespace

std::vector<SolidSubject> solid_subjects(const std::string& kind) {
  std::vector<SolidSubject> list;
  if (abut_shape_kind_by_name(kind.c_str()) == 0) return list;
  for (const Size& size : sizes_of(kind)) list.push_back(make_solid(kind, size.name + " " + kind, size.numbers));
  return list;
}

}  // namespace property
