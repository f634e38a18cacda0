// SPDX-License-Identifier: Apache-2.0
// Cones of directions in which the distance of a vertex, an edge or a face can have a local minimum.
export module abut.proximity.search.cones;
import abut.core.standard;
import abut.math;
import abut.proximity.body;

export namespace abut {

struct ConeOptions {
  Real angle = 0;     // a cosine by which cones are wider
  Real factor = 0.5;  // how much of the cosine between the normal and a side is added
  bool is_front_only = false;
};

// `way`: the unit vector from the feature to what is near it. The distance grows along a feature that begins here where
// the way leads against it, as then that feature is nearer. Without faces an edge takes ways at right angles.
[[nodiscard]] bool is_minimum_of_vertex(const ElementBody& body, std::uint32_t vertex, const Vec3& way,
                                        const ConeOptions& options);
[[nodiscard]] bool is_minimum_of_edge(const ElementBody& body, std::uint32_t edge, const Vec3& way,
                                      const ConeOptions& options);
[[nodiscard]] bool is_minimum_of_face(const ElementBody& body, std::uint32_t face, const Vec3& way,
                                      const ConeOptions& options);
// Whether the faces of an edge fold there, and not just go on.
[[nodiscard]] bool is_ridge(const ElementBody& body, std::uint32_t edge);

}  // namespace abut
