// Triangles prepared for rays: neighbours joined in pairs, each with its plane in double.
//
// Embree traverses quads a third faster than the triangles that they consist of. Single precision
// would leave cracks between neighbours, so the outlines that Embree sees are a little larger than
// the triangles (surface.cpp, `grown`); the hit itself is computed on the plane of the true triangle.
module;

#include <abut/abut.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

module abut.picking:surface;
import :source;
import :vector;

namespace abut::picking {

/// Points p with dot(normal, p) == offset; the normal has unit length.
struct Plane {
  abut_vec3 normal;
  double offset;
};

/// Planes of the two triangles of a pair; both are the same when a triangle stays alone. One cache line.
struct alignas(64) Patch {
  std::array<Plane, 2> planes;
};
static_assert(sizeof(Patch) == 64);

/// Corners of a pair, as indices into the vertices of its list: the triangles are 0 1 3 and 2 3 1.
/// A triangle alone has its last corner twice.
using Corners = std::array<std::uint32_t, 4>;

struct Surface {
  std::vector<Patch> patches;
  std::vector<std::array<std::uint32_t, 2>> triangles;  // numbers in the list, for each patch
  std::vector<Corners> corners;                         // empty once Embree has them
};

/// Joins triangles to pairs. Triangles without area are left out: no ray meets them.
[[nodiscard]] Surface make_surface(const TriangleList& list);

/// Outlines of the patches in single precision relative to the space, three numbers for each of the
/// four corners of each patch.
void write_outlines(const Surface& surface, const TriangleList& list, const Space& space, std::span<float> out);

/// Box around the vertices.
[[nodiscard]] abut_aabb box_of(const TriangleList& list);

/// A space that fits around a box.
[[nodiscard]] Space space_around(const abut_aabb& box);

}  // namespace abut::picking
