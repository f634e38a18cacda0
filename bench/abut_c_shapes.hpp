// SPDX-License-Identifier: Apache-2.0
// Solids and placements as the C interface of abut wants them.
#pragma once
#include <abut/abut.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "abut_inputs.hpp"
#include "scene.hpp"

namespace bench {

struct ReleaseShape {
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
using AbutCShape = std::unique_ptr<abut_shape, ReleaseShape>;

inline void expect_ok(abut_status status) {
  if (status != ABUT_OK) {
    throw std::runtime_error(abut_last_error_message());
  }
}

[[nodiscard]] inline abut_pose abut_c_pose(const Placement& placement) {
  const auto& [position, q] = placement;
  return {{position[0], position[1], position[2]}, {q[0], q[1], q[2], q[3]}};
}

[[nodiscard]] inline AbutCShape abut_c_composite(const Solid& solid) {
  abut_shape* box = nullptr;
  expect_ok(abut_box_create(solid.sizes[0], solid.sizes[1], solid.sizes[2], &box));
  const AbutCShape child(box);
  const std::vector<const abut_shape*> children(solid.points.size(), box);
  std::vector<abut_pose> poses;
  for (const Point& p : solid.points) {
    poses.push_back(abut_c_pose({p, {1, 0, 0, 0}}));
  }
  abut_shape* shape = nullptr;
  expect_ok(abut_composite_create(children.data(), poses.data(), poses.size(), &shape));
  return AbutCShape(shape);
}

[[nodiscard]] inline AbutCShape abut_c_shape(const Solid& solid) {
  if (solid.kind == Kind::composite) {
    return abut_c_composite(solid);
  }
  const std::vector<double> parameters = abut_parameters(solid), reals = abut_reals(solid);
  const std::vector<std::uint32_t> indices = abut_indices(solid);
  abut_shape_desc desc;
  abut_shape_desc_init(&desc, sizeof desc);
  desc.kind = abut_shape_kind_by_name(std::string(abut_kind_name(solid)).c_str());
  desc.parameters = parameters.data();
  desc.parameter_count = parameters.size();
  desc.reals = reals.data();
  desc.real_count = reals.size();
  desc.indices = indices.data();
  desc.index_count = indices.size();
  abut_shape* shape = nullptr;
  expect_ok(abut_shape_create(&desc, &shape));
  return AbutCShape(shape);
}

}  // namespace bench
