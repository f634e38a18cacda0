// SPDX-License-Identifier: Apache-2.0
#include "subject.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace property {

namespace {

ShapePtr owned(abut_status status, abut_shape* shape, const std::string& name) {
  if (status != ABUT_OK) {
    throw std::runtime_error("cannot create " + name + ": " + abut_status_name(status) + ": " +
                             abut_last_error_message());
  }
  return ShapePtr(shape);
}

double smallest_positive(std::vector<double> lengths) {
  double best = 0;
  for (const double length : lengths) {
    if (length > 0 && (best == 0 || length < best)) best = length;
  }
  return best > 0 ? best : 1;
}

Subject subject(const std::string& kind, const std::string& name, const std::function<ShapePtr(double)>& build,
                oracle::Measured shape, double size, double small) {
  return {kind, name, build(1), build(2), std::move(shape), size, small};
}

}  // namespace

Subject make_sphere(const std::string& name, double radius) {
  const auto build = [&](double scale) {
    abut_shape* shape = nullptr;
    const abut_status status = abut_sphere_create(radius * scale, &shape);
    return owned(status, shape, name);
  };
  return subject("sphere", name, build, oracle::measured(oracle::make_sphere(radius)), radius, radius);
}

Subject make_box(const std::string& name, double x, double y, double z) {
  const auto build = [&](double scale) {
    abut_shape* shape = nullptr;
    const abut_status status = abut_box_create(x * scale, y * scale, z * scale, &shape);
    return owned(status, shape, name);
  };
  const oracle::Body body = oracle::make_box(x, y, z);
  return subject("box", name, build, oracle::measured(body), oracle::size_of(body), smallest_positive({x, y, z}));
}

Subject make_capsule(const std::string& name, double radius, double half_height) {
  const auto build = [&](double scale) {
    abut_shape* shape = nullptr;
    const abut_status status = abut_capsule_create(radius * scale, half_height * scale, &shape);
    return owned(status, shape, name);
  };
  const oracle::Body body = oracle::make_capsule(radius, half_height);
  return subject("capsule", name, build, oracle::measured(body), oracle::size_of(body), radius);
}

Subject make_plane(const std::string& name, const oracle::Point& normal, double offset) {
  const auto build = [&](double scale) {
    abut_shape* shape = nullptr;
    const abut_vec3 direction{normal[0], normal[1], normal[2]};
    const abut_status status = abut_plane_create(&direction, offset * scale, &shape);
    return owned(status, shape, name);
  };
  return subject("plane", name, build, oracle::measured(oracle::HalfSpace{normal, offset}), std::abs(offset), 1e300);
}

namespace {

std::vector<double> flat(const std::vector<oracle::Point>& points, double scale) {
  std::vector<double> numbers;
  for (const oracle::Point& p : points) {
    for (const double coordinate : p) numbers.push_back(coordinate * scale);
  }
  return numbers;
}

// The smallest side of the box around the points that is not zero.
double smallest_side(const std::vector<oracle::Point>& points) {
  std::vector<double> sides;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [axis](const auto& p, const auto& q) { return p[axis] < q[axis]; });
    sides.push_back(((*high)[axis] - (*low)[axis]) / 2);
  }
  return smallest_positive(sides);
}

}  // namespace

Subject make_hull(const std::string& name, const std::vector<oracle::Point>& points) {
  const auto build = [&](double scale) {
    const std::vector<double> numbers = flat(points, scale);
    abut_shape* shape = nullptr;
    const abut_status status = abut_hull_create(numbers.data(), points.size(), &shape);
    return owned(status, shape, name);
  };
  const oracle::Body body = oracle::make_hull(points);
  return subject("hull", name, build, oracle::measured(body), oracle::size_of(body), smallest_side(points));
}

Subject make_mesh(const std::string& name, const oracle::Soup& soup) {
  const auto build = [&](double scale) {
    const std::vector<double> numbers = flat(soup.points, scale);
    std::vector<std::uint32_t> indices;
    for (const auto& triangle : soup.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
    abut_shape* shape = nullptr;
    const abut_status status =
        abut_mesh_create(numbers.data(), soup.points.size(), indices.data(), soup.triangles.size(), nullptr, &shape);
    return owned(status, shape, name);
  };
  return subject("mesh", name, build, oracle::measured(soup), oracle::size_of(soup), smallest_side(soup.points));
}

namespace {

oracle::Soup triangles_of(const Grid& grid) {
  oracle::Soup soup;
  for (std::uint32_t j = 0; j < grid.rows; ++j) {
    for (std::uint32_t i = 0; i < grid.columns; ++i) {
      soup.points.push_back({i * grid.spacing_x, j * grid.spacing_y, grid.heights[j * grid.columns + i]});
    }
  }
  for (std::uint32_t j = 0; j + 1 < grid.rows; ++j) {
    for (std::uint32_t i = 0; i + 1 < grid.columns; ++i) {
      const std::uint32_t corner = j * grid.columns + i;
      const std::uint32_t opposite = corner + grid.columns + 1;
      soup.triangles.push_back({corner, corner + 1, opposite});
      soup.triangles.push_back({corner, opposite, corner + grid.columns});
    }
  }
  return soup;
}

}  // namespace

Subject make_height_field(const std::string& name, const Grid& grid) {
  const auto build = [&](double scale) {
    std::vector<double> heights = grid.heights;
    for (double& height : heights) height *= scale;
    abut_height_field_desc desc;
    abut_height_field_desc_init(&desc, sizeof desc);
    desc.columns = grid.columns;
    desc.rows = grid.rows;
    desc.spacing_x = grid.spacing_x * scale;
    desc.spacing_y = grid.spacing_y * scale;
    desc.heights = heights.data();
    abut_shape* shape = nullptr;
    const abut_status status = abut_height_field_create(&desc, &shape);
    return owned(status, shape, name);
  };
  const oracle::Soup soup = triangles_of(grid);
  return subject("height_field", name, build, oracle::measured(soup), oracle::size_of(soup),
                 std::min(grid.spacing_x, grid.spacing_y));
}

oracle::Pose pose_of(const abut_pose& pose) {
  const abut_quat& q = pose.orientation;
  return oracle::Pose::from({pose.position.x, pose.position.y, pose.position.z}, {q.w, q.x, q.y, q.z});
}

oracle::Vec vec_of(const abut_vec3& v) { return {oracle::quad(v.x), oracle::quad(v.y), oracle::quad(v.z)}; }

namespace {

std::string hexadecimal(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%a", value);
  return text.data();
}

}  // namespace

std::string text_of(const abut_vec3& v) {
  return "{" + hexadecimal(v.x) + ", " + hexadecimal(v.y) + ", " + hexadecimal(v.z) + "}";
}

std::string text_of(const abut_pose& pose) {
  const abut_quat& q = pose.orientation;
  return "{" + text_of(pose.position) + ", {" + hexadecimal(q.w) + ", " + hexadecimal(q.x) + ", " + hexadecimal(q.y) +
         ", " + hexadecimal(q.z) + "}}";
}

}  // namespace property
