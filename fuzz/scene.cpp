// SPDX-License-Identifier: Apache-2.0
module;
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>
module abut.fuzz;

namespace abut::fuzz {
namespace {

using Numbers = std::array<Real, 8>;

Real size_or_one(Real value) { return value == 0 ? 1 : std::fabs(value); }

// Everything that is not a length, from the bits of the numbers that are not used as one.
Random random_of(const Numbers& numbers) {
  std::uint64_t seed = 0;
  for (std::size_t i = 3; i < 8; ++i) {
    seed = scrambled(seed + std::bit_cast<std::uint64_t>(numbers[i]));
  }
  return Random(seed);
}

// Between -1 and 1; on a lattice, where points fall on common lines and planes, in steps of a half.
Real coordinate(Random& random, bool on_lattice) {
  return on_lattice ? 0.5 * (static_cast<Real>(random.below(5)) - 2) : random.between(-1, 1);
}

ShapeInput hull_input(const Numbers& numbers, bool flat, bool doubled, bool on_lattice) {
  Random random = random_of(numbers);
  const std::size_t count = 4 + random.below(21);
  ShapeInput input;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Real place = coordinate(random, on_lattice);
      const bool repeats = doubled && i % 3 == 2;
      input.reals.push_back(repeats             ? input.reals[3 * (i - 2) + axis]
                            : flat && axis == 2 ? 0
                                                : size_or_one(numbers[axis]) * place);
    }
  }
  return input;
}

ShapeInput tetrahedron_input(const Numbers& numbers, bool flat) {
  const Real x = size_or_one(numbers[0]), y = size_or_one(numbers[1]), z = flat ? 0 : size_or_one(numbers[2]);
  return {{0}, {0, 0, 0, x, 0, 0, 0, y, 0, 0, 0, z}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}};
}

ShapeInput sheet_input(const Numbers& numbers, bool flat, bool on_lattice) {
  Random random = random_of(numbers);
  const std::uint32_t columns = 2 + static_cast<std::uint32_t>(random.below(4)),
                      rows = 2 + static_cast<std::uint32_t>(random.below(4));
  ShapeInput input{{0}, {}, {}};
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const Real height = flat ? 0 : coordinate(random, on_lattice);
      input.reals.push_back(size_or_one(numbers[0]) * (2 * static_cast<Real>(i) / (columns - 1) - 1));
      input.reals.push_back(size_or_one(numbers[1]) * (2 * static_cast<Real>(j) / (rows - 1) - 1));
      input.reals.push_back(numbers[2] * height);
      if (i + 1 < columns && j + 1 < rows) {
        const std::uint32_t corner = j * columns + i;
        input.indices.insert(input.indices.end(), {corner, corner + 1, corner + columns + 1, corner,
                                                   corner + columns + 1, corner + columns});
      }
    }
  }
  return input;
}

bool takes_lengths_alone(std::size_t place) {
  if (kind_parameter_count(place) == 0) {
    return false;
  }
  for (std::size_t i = 0; i < kind_parameter_count(place); ++i) {
    const std::string_view name = kind_parameter_name(place, i);
    if (!name.starts_with("half") && !name.starts_with("radius")) {
      return false;
    }
  }
  return kind_name(place) != "particles";
}

// The kind of a child: the first one from a place on that is made of lengths, and of the first child no hole.
std::size_t kind_of_child(std::size_t from, bool is_first) {
  for (std::size_t step = 0; step < shape_kind_count; ++step) {
    const std::size_t kind = (from + step) % shape_kind_count;
    if (takes_lengths_alone(kind) && !(is_first && kind_name(kind).ends_with("hole"))) {
      return kind;
    }
  }
  std::fputs("finding: no kind of this build can be a child of a composite; add \"sphere\" to ABUT_SHAPES.\n", stderr);
  std::abort();
}

// As the generic door takes the children of a composite.
void append_child(ShapeInput& input, std::uint32_t kind, const std::array<Real, 7>& pose, const ShapeInput& child) {
  input.indices.insert(input.indices.end(), {kind, static_cast<std::uint32_t>(child.parameters.size()),
                                             static_cast<std::uint32_t>(child.reals.size()),
                                             static_cast<std::uint32_t>(child.indices.size())});
  input.indices.insert(input.indices.end(), child.indices.begin(), child.indices.end());
  input.reals.insert(input.reals.end(), pose.begin(), pose.end());
  input.reals.insert(input.reals.end(), child.parameters.begin(), child.parameters.end());
  input.reals.insert(input.reals.end(), child.reals.begin(), child.reals.end());
}

// Doubled: with a hole, and diagonals of any kind.
ShapeInput height_field_input(const Numbers& numbers, bool flat, bool doubled, bool on_lattice) {
  Random random = random_of(numbers);
  const std::size_t columns = 3 + random.below(4), rows = 3 + random.below(3);
  ShapeInput input{
      {static_cast<Real>(columns), static_cast<Real>(rows), size_or_one(numbers[0]), size_or_one(numbers[1]), 0},
      {},
      {}};
  for (std::size_t i = 0; i < columns * rows; ++i) {
    input.reals.push_back(flat ? 0 : numbers[2] * coordinate(random, on_lattice));
  }
  if (doubled) {
    input.parameters[4] = static_cast<Real>(random.below(3));
    const std::size_t missing = random.below(columns * rows);
    // All triangles of two by two cells may have the vertex in the middle.
    input.reals[columns * rows == 9 && missing == 4 ? 0 : missing] = std::numeric_limits<Real>::quiet_NaN();
  }
  return input;
}

// Any two axes and few cells, as meshes have few triangles.
void put_in_cells(const Numbers& numbers, ShapeInput& mesh) {
  Random random = random_of(numbers);
  const std::size_t axis = random.below(3), other = (axis + 1 + random.below(2)) % 3;
  for (const std::size_t number : {axis, other, random.below(5), random.below(5)}) {
    mesh.parameters.push_back(static_cast<Real>(number));
  }
}

ShapeInput particles_input(const Numbers& numbers, bool various, bool on_lattice) {
  Random random = random_of(numbers);
  const std::size_t count = 1 + random.below(24);
  const Real radius = size_or_one(numbers[3]);
  ShapeInput input{{various ? 0 : radius}, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      input.reals.push_back(size_or_one(numbers[axis]) * coordinate(random, on_lattice));
    }
    if (various) {
      input.reals.push_back(radius * static_cast<Real>(random.below(3)));
    }
  }
  return input;
}

// A ball, a box or what two balls have together, by their distances.
ShapeInput distance_field_input(const Numbers& numbers, bool flat, bool doubled, std::uint8_t flags) {
  Random random = random_of(numbers);
  const Real cell = size_or_one(numbers[0]);
  ShapeInput input;
  for (int axis = 0; axis < 3; ++axis) {
    input.parameters.push_back(static_cast<Real>(5 + random.below(8)));
  }
  for (int axis = 0; axis < 3; ++axis) {
    input.parameters.push_back(cell * (flat && axis == 2 ? 0.25 : random.between(0.5, 1)));
  }
  std::array<Real, 3> half{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    half[axis] = 0.5 * (input.parameters[axis] - 1) * input.parameters[axis + 3];
    input.parameters.push_back((flags & lattice) != 0 ? 0 : -half[axis]);
  }
  input.parameters.push_back((flags & one_sided) != 0 ? 1 : 0);
  const Real radius = 0.7 * std::min({half[0], half[1], half[2]});
  const Real x = half[0] * random.between(-0.3, 0.3), y = half[1] * random.between(-0.3, 0.3);
  for (Real k = 0; k < input.parameters[2]; ++k) {
    for (Real j = 0; j < input.parameters[1]; ++j) {
      for (Real i = 0; i < input.parameters[0]; ++i) {
        const Vec3 p{i * input.parameters[3] - half[0], j * input.parameters[4] - half[1],
                     k * input.parameters[5] - half[2]};
        const Vec3 out = absolute(p) - Vec3{radius, 0.8 * radius, 0.6 * radius};
        const Real of_box = norm(maximum(out, Vec3{0, 0, 0})) + std::min(std::max({out.x, out.y, out.z}), Real{0});
        const Real of_balls = std::min(norm(p) - radius, norm(p - Vec3{x, y, 0}) - radius);
        input.reals.push_back((flags & parallel) != 0 ? of_box : doubled ? of_balls : norm(p) - radius);
      }
    }
  }
  // What no sample is inside of would be no solid.
  Real& least = *std::ranges::min_element(input.reals);
  least = std::min(least, -0.1 * radius);
  return input;
}

// Some fields are tri-quadratic, and some are bent by a lattice whose points have moved by less than their spacing.
void form_field(ShapeInput& input, Real form) {
  Random random(std::bit_cast<std::uint64_t>(form));
  const bool is_smooth = random.below(2) == 0, is_bent = random.below(2) == 0;
  input.parameters.push_back(is_smooth ? 1 : 0);
  if (!is_bent) {
    return;
  }
  std::array<std::size_t, 3> points{};
  std::array<Real, 3> spacings{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    points.at(axis) = 2 + random.below(2);
    spacings.at(axis) =
        (input.parameters[axis] - 1) * input.parameters[axis + 3] / static_cast<Real>(points.at(axis) - 1);
  }
  for (const std::size_t count : points) {
    input.parameters.push_back(static_cast<Real>(count));
  }
  const Real reach = random.between(0, 0.2) * std::min({spacings[0], spacings[1], spacings[2]});
  const auto place = [&](std::size_t axis, std::size_t at) {
    return input.parameters[axis + 6] + spacings.at(axis) * static_cast<Real>(at) + random.between(-reach, reach);
  };
  for (std::size_t k = 0; k < points[2]; ++k) {
    for (std::size_t j = 0; j < points[1]; ++j) {
      for (std::size_t i = 0; i < points[0]; ++i) {
        input.reals.push_back(place(0, i));
        input.reals.push_back(place(1, j));
        input.reals.push_back(place(2, k));
      }
    }
  }
}

// Kinds that came later are no children, so that records keep the scenes that they stand for.
constexpr std::size_t kinds_of_children = 18;

// Children of the kinds that take lengths alone, some of them in a composite of their own.
ShapeInput composite_input(std::size_t place, const Numbers& numbers, bool nests, bool on_lattice) {
  Random random = random_of(numbers);
  ShapeInput input;
  const std::size_t count = 1 + random.below(12);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t kind = kind_of_child(random.below(std::min(shape_kind_count, kinds_of_children)), i == 0);
    ShapeInput child;
    for (std::size_t k = 0; k < kind_parameter_count(kind); ++k) {
      child.parameters.push_back(size_or_one(numbers[k % 3]) * random.between(0.1, 1));
    }
    std::array<Real, 7> pose{0, 0, 0, 1, 0, 0, 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      pose[axis] = 2 * size_or_one(numbers[axis]) * coordinate(random, on_lattice);
      pose[4 + axis] = on_lattice ? 0 : random.between(-1, 1);
    }
    append_child(input, Shapes::kinds[kind], pose, child);
  }
  if (nests) {
    ShapeInput outer;
    append_child(outer, Shapes::kinds[place], {0, 0, 0, 1, 0, 0, 0}, input);
    append_child(outer, Shapes::kinds[place], {numbers[0], 0, 0, 1, 0, 1, 0}, input);
    return outer;
  }
  return input;
}

// Parameters of this kind that are no lengths stay as they are.
void scale(std::string_view kind, ShapeInput& input, Real by) {
  const std::size_t first = kind == "plane"            ? 3
                            : kind == "height_field"   ? 2
                            : kind == "mesh"           ? 1
                            : kind == "distance_field" ? 3
                                                       : 0;
  const std::size_t end = kind == "cylinder_hole"    ? 2
                          : kind == "box_hole"       ? 3
                          : kind == "height_field"   ? 4
                          : kind == "distance_field" ? 9
                                                     : input.parameters.size();
  for (std::size_t i = first; i < end; ++i) {
    input.parameters[i] *= by;
  }
  for (Real& value : input.reals) {
    value *= by;
  }
}

Real reach(const AnyShape& shape) {
  const Aabb box = aabb_of(shape, Pose::identity());
  if (box.is_bounded()) {
    return largest_magnitude(maximum(absolute(box.low), absolute(box.high)));
  }
  return std::visit(
      []<class S>(const S& s) -> Real {
        if constexpr (HalfSpace<S>) {
          return std::fabs(s.offset());
        } else if constexpr (SampledSolid<S>) {
          return largest_magnitude(maximum(absolute(s.solid_box().low), absolute(s.solid_box().high)));
        } else {
          return 0;
        }
      },
      shape);
}

}  // namespace

Real tamed(Real value) {
  if (!std::isfinite(value) || value == 0) {
    return 0;
  }
  return std::copysign(std::clamp(std::fabs(value), 0x1p-20, 0x1p20), value);
}

ShapeInput shape_input(std::size_t place, const std::array<Real, 8>& raw, bool flat, bool doubled, std::uint8_t flags) {
  Numbers numbers = raw;
  std::ranges::transform(numbers, numbers.begin(), tamed);
  const bool on_lattice = (flags & lattice) != 0;
  const std::string_view kind = kind_name(place);
  if (kind == "hull") {
    return hull_input(numbers, flat, doubled, on_lattice);
  }
  if (kind == "mesh") {
    ShapeInput input = doubled ? tetrahedron_input(numbers, flat) : sheet_input(numbers, flat, on_lattice);
    input.parameters[0] = (flags & one_sided) != 0 ? 1 : 0;
    return input;
  }
  if (kind == "height_field") {
    return height_field_input(numbers, flat, doubled, on_lattice);
  }
  if (kind == "particles") {
    return particles_input(numbers, doubled, on_lattice);
  }
  if (kind == "distance_field") {
    return distance_field_input(numbers, flat, doubled, flags);
  }
  if (kind == "composite") {
    return composite_input(place, numbers, doubled, on_lattice);
  }
  ShapeInput input;
  if (kind == "plane") {
    const auto normal = UnitVec3::make({numbers[0], numbers[1], numbers[2]}).value_or(UnitVec3::axis_z()).vec();
    input.parameters = {normal.x, normal.y, normal.z, numbers[3]};
    return input;
  }
  for (std::size_t i = 0; i < kind_parameter_count(place); ++i) {
    const Real value = i < numbers.size() ? numbers[i] : 0;
    if (kind_parameter_name(place, i).starts_with("open")) {
      // Sums of faces along Z, which for a cylinder are its ends.
      const Real unit = kind_parameter_name(place, i) == "open_ends" ? 1 : 16;
      input.parameters.push_back(unit * static_cast<Real>(random_of(numbers).below(4)));
      continue;
    }
    // A half extent may be zero; a radius may not.
    input.parameters.push_back(kind_parameter_name(place, i).starts_with("half") ? std::fabs(value)
                                                                                 : size_or_one(value));
  }
  return input;
}

Result<Scene> make_scene(std::size_t place_a, std::size_t place_b, const Record& record, Real by) {
  const auto has = [&](std::uint8_t flag) { return (record.flags & flag) != 0; };
  const auto shape = [&](std::size_t place, const Numbers& raw, bool flat, bool doubled) {
    ShapeInput input = shape_input(place, raw, flat, doubled, record.flags);
    if (kind_name(place) == "distance_field" && record.extra[1] != 0) {
      form_field(input, record.extra[1]);
    }
    scale(kind_name(place), input, by);
    if (kind_name(place) == "mesh" && has(of_cells)) {
      put_in_cells(raw, input);
      place = find_kind("uv_grid").value();
    }
    return make_shape(place, input.parameters, input.reals, input.indices);
  };
  Result<ShapeHandle> a = shape(place_a, record.a, has(flat_a), has(doubled_a));
  if (!a) {
    return a.error();
  }
  Result<ShapeHandle> b = shape(place_b, record.b, has(flat_b), has(doubled_b));
  if (!b) {
    return b.error();
  }
  const std::array<Real, 4>& q = record.rotation;
  const Quat upright{1, 0, 0, 0};
  const Quat rotation =
      has(parallel) ? upright : normalized(Quat{tamed(q[0]), tamed(q[1]), tamed(q[2]), tamed(q[3])}).value_or(upright);
  const Vec3 position = by * Vec3{tamed(record.position[0]), tamed(record.position[1]), tamed(record.position[2])};
  Scene scene{std::move(a).value(), std::move(b).value(), {Rotation::from(rotation), position}, 0, 0};
  scene.size = std::max({reach(scene.a), reach(scene.b), largest_magnitude(position)});
  scene.margin = std::min(std::fabs(by * tamed(record.extra[0])), scene.size);
  return scene;
}

Scene swapped(const Scene& scene) { return {scene.b, scene.a, scene.ab.inverse(), scene.margin, scene.size}; }

}  // namespace abut::fuzz
