// SPDX-License-Identifier: Apache-2.0
// Triangles from the faces that callers hand over: quads are split, vertices merged.
#ifndef ABUT_CAPI_TRIANGLE_SOURCE_HPP
#define ABUT_CAPI_TRIANGLE_SOURCE_HPP

#include "prelude.hpp"

import abut.core.standard;
import abut.triangles.merged_vertices;

namespace abut::capi {

// As callers hand them over.
struct [[gsl::Pointer]] Faces {
  const double* xyz;
  std::size_t vertex_count;
  const std::uint32_t* corners;
  std::size_t face_count;
};

struct FaceOptions {
  std::uint32_t corners;
  std::uint32_t merges_vertices;
  double merge_distance;
};

class [[gsl::Pointer]] TriangleSource {
 public:
  // Checks the options and, where quads are split or vertices merged, the numbers as well. What is handed on as it is
  // will be checked by what is made of it.
  [[nodiscard]] static abut_status read(const Faces& faces, const FaceOptions& options, TriangleSource& out);

  [[nodiscard]] std::span<const double> xyz() const { return xyz_; }
  [[nodiscard]] std::span<const std::uint32_t> triangles() const {
    return merged_.triangles.empty() ? given_ : std::span<const std::uint32_t>(merged_.triangles);
  }
  [[nodiscard]] const MergedVertices& merged() const { return merged_; }

 private:
  [[nodiscard]] abut_status split_quads();
  [[nodiscard]] abut_status merge(double distance);

  std::span<const double> xyz_;
  std::span<const std::uint32_t> given_;
  std::vector<std::uint32_t> halves_;  // of quads
  MergedVertices merged_{{}, 0, 0, 0};
};

}  // namespace abut::capi

#endif
