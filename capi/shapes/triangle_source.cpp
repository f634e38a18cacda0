// SPDX-License-Identifier: Apache-2.0
#include "shapes/triangle_source.hpp"

#include "border.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.triangles.buffers;

namespace abut::capi {
namespace {

abut_status check_options(const FaceOptions& options) {
  if (options.corners != 3 && options.corners != 4) {
    return refuse(error_about(Errc::unknown_value, "options.corners", std::uint64_t{options.corners}, "3 or 4"));
  }
  if (options.merges_vertices > 1) {
    return refuse(
        error_about(Errc::unknown_value, "options.merges_vertices", std::uint64_t{options.merges_vertices}, "0 or 1"));
  }
  const Fault fault = check_not_negative("options.merge_distance", options.merge_distance);
  return fault ? refuse(*fault) : static_cast<abut_status>(ABUT_OK);
}

}  // namespace

abut_status TriangleSource::read(const Faces& faces, const FaceOptions& options, TriangleSource& out) {
  abut_status status = check_options(options);
  status = status != ABUT_OK ? status : read_span<3>("xyz", faces.xyz, "vertex_count", faces.vertex_count, out.xyz_);
  if (status != ABUT_OK) {
    return status;
  }
  if (options.corners == 4) {
    status = read_span<4>("triangles", faces.corners, "triangle_count", faces.face_count, out.given_);
    status = status != ABUT_OK ? status : out.split_quads();
  } else {
    status = read_span<3>("triangles", faces.corners, "triangle_count", faces.face_count, out.given_);
  }
  return status != ABUT_OK || options.merges_vertices == 0 ? status : out.merge(options.merge_distance);
}

// Both halves have the first corner and the third.
abut_status TriangleSource::split_quads() {
  if (const Fault fault = check_indices(xyz_.size() / 3, given_)) {
    return refuse(*fault);
  }
  halves_.reserve(given_.size() / 4 * 6);
  for (std::size_t i = 0; i < given_.size(); i += 4) {
    const std::uint32_t a = given_[i], b = given_[i + 1], c = given_[i + 2], d = given_[i + 3];
    halves_.insert(halves_.end(), {a, b, c, a, c == d ? a : c, c == d ? a : d});
  }
  given_ = halves_;
  return ABUT_OK;
}

abut_status TriangleSource::merge(double distance) {
  if (const Fault fault = check_triangles("a mesh", xyz_, given_)) {
    return refuse(*fault);
  }
  merged_ = merge_vertices(xyz_, given_, distance);
  for (std::uint32_t triangle = 0; triangle < given_.size() / 3; ++triangle) {
    if (!is_removed(merged_.triangles, triangle)) {
      return ABUT_OK;
    }
  }
  return refuse(error_about(Errc::empty, "options.merge_distance", distance,
                            "less, as merging leaves no triangle; a mesh needs at least one"));
}

}  // namespace abut::capi
