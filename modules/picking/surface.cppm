// SPDX-License-Identifier: Apache-2.0
// Triangles prepared for rays: outlines for Embree in single precision, planes for us in double.
//
// Single precision leaves cracks between neighbouring triangles; Embree's robust mode has fewer, at a
// quarter of its speed. So the outlines that Embree sees are grown a little beyond the triangles,
// which costs nothing; the hit itself is computed on the plane of the true triangle. A ray that runs nearly
// along both triangles of an edge sees little of that growth: there cracks may stay.
//
// Grids become quads of two triangles each: half as many boxes and a smaller scene, which pays for the
// robust mode. It is needed there, since the halves of a quad cannot be grown apart from each other.
// Where halves are folded, growing would turn them away from the edges. So triangles of steep grids are
// there twice: once as they are, which leaves no crack along edges in the robust mode, and once grown,
// which leaves none at corners.
module;

#include <abut/abut.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

module abut.picking:surface;
import :source;
import :vector;

namespace abut::picking {

// Points p with dot(normal, p) == offset. The normal has unit length, or none for a triangle without area.
struct alignas(32) Facet {
  abut_vec3 normal;
  double offset;
};
static_assert(sizeof(Facet) == 32);

// In one register.
[[nodiscard]] inline Four numbers_of(const Facet& facet) {
  return {facet.normal.x, facet.normal.y, facet.normal.z, facet.offset};
}

// Largest difference between a hit found in single precision and the one on the plane of the
// triangle, in parts of the extent. Beyond it the ray runs along the plane and single precision
// knows better.
inline constexpr double largest_correction = 1e-3;

// Distance along a ray to a plane near which a hit was found; of the vectors, only the first three
// numbers are looked at.
[[nodiscard]] [[gnu::always_inline]] inline double distance_to(const Four& plane, const Four& origin,
                                                               const Four& direction, double found, double extent) {
  const double exact = (plane[3] - dot_of_three(plane, origin)) / dot_of_three(plane, direction);
  const bool is_close = std::fabs(exact - found) <= largest_correction * extent;
  return std::max(is_close ? exact : found, 0.0);
}

// The plane of each triangle.
using Surface = std::vector<Facet>;

// Adds the planes of a list.
void add_planes(const TriangleList& list, Surface& out);

// Outlines in single precision relative to the space, nine numbers for each triangle, or eighteen: as it is and
// grown. Those of triangles without area have none either: no ray meets them.
enum class Outlines : unsigned char { grown, both };
void write_outlines(const TriangleList& list, const Space& space, Outlines outlines, std::span<float> out);

// Whether the triangles come in pairs that share an edge, as those of grids and height fields do,
// and all have an area.
[[nodiscard]] bool is_paired(const TriangleList& list);

// Whether two triangles of a pair are folded too much for a quad.
[[nodiscard]] bool is_steep(const TriangleList& list);

// As write_outlines, for quads of two triangles each: twelve numbers for each pair. The first half
// of a quad, its corners 0, 1 and 3, is the first triangle of the pair.
void write_quads(const TriangleList& list, const Space& space, std::span<float> out);

// Box around the vertices.
[[nodiscard]] abut_aabb box_of(const TriangleList& list);

// A space that fits around a box.
[[nodiscard]] Space space_around(const abut_aabb& box);

}  // namespace abut::picking
