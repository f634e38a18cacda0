// SPDX-License-Identifier: Apache-2.0
// The children of composites.
#include "convert.hpp"
#include "guard.hpp"
#include "shapes/shape_handle.hpp"

import abut.core;
import abut.core.standard;
import abut.math;
import abut.math.turn;
import abut.pairs.any_shape;
import abut.pairs.any_shape.child_list;

using namespace abut::capi;

namespace {

abut_composite_child from_child(const abut::ChildDescription& child) {
  return {{from_vec3(child.placed.pose.position), from_quat(abut::quaternion_of(child.placed.pose.rotation))},
          child.placed.material,
          child.is_hole ? 1U : 0U,
          child.cut_begin,
          child.cut_end};
}

// At least one; a shape without children is no composite.
abut_status read_children(const abut_shape* shape, std::vector<abut::ChildDescription>& out) {
  out = abut::children_of(shape_of(shape));
  if (!out.empty()) {
    return ABUT_OK;
  }
  return refuse(ABUT_UNSUPPORTED, "shape is a " + std::string(abut::kind_name(abut::kind_of(shape_of(shape)))) +
                                      "; only a composite has children");
}

abut_status write_children(const abut_shape* shape, abut_composite_child* children, std::size_t capacity,
                           std::size_t* count) {
  std::span<abut_composite_child> out;
  std::vector<abut::ChildDescription> found;
  abut_status status = read_span("children", children, "capacity", capacity, out);
  status = status != ABUT_OK ? status : read_children(shape, found);
  if (status == ABUT_OK) {
    fill(std::span<const abut::ChildDescription>(found), out, from_child);
    *count = found.size();
  }
  return status;
}

abut_status make_child(const abut_shape* shape, std::uint32_t child, abut_shape** out) {
  std::vector<abut::ChildDescription> found;
  if (const abut_status status = read_children(shape, found); status != ABUT_OK) {
    return status;
  }
  if (child >= found.size()) {
    return refuse(abut::error_about(abut::Errc::index_out_of_range, "child", std::uint64_t{child},
                                    "below " + std::to_string(found.size()) + ", the number of children"));
  }
  *out = std::make_unique<abut_shape>(found[child].placed.shape).release();
  return ABUT_OK;
}

}  // namespace

abut_status abut_composite_children(const abut_shape* shape, abut_composite_child* children, size_t capacity,
                                    size_t* count) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"shape", shape}, {"count", count}}});
    return status != ABUT_OK ? status : write_children(shape, children, capacity, count);
  });
}

abut_status abut_composite_child_shape(const abut_shape* shape, uint32_t child, abut_shape** out) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"shape", shape}, {"out", out}}});
    return status != ABUT_OK ? status : make_child(shape, child, out);
  });
}
