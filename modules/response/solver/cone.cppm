// SPDX-License-Identifier: Apache-2.0
// The cone of friction: impulses (t, s, n) with |(t, s)| <= friction * n.
module;

#include <array>

export module abut.response:cone;

export namespace abut::response {

using Triple = std::array<double, 3>;  // along the two tangents and the normal
using Triple2 = std::array<Triple, 3>;

struct ConePoint {
  Triple point;
  Triple2 derivative;  // of the point by what was projected: row i has the change of component i
};

// The point of the cone nearest to another one, where squares of tangents count `tangent` and those of the normal
// `normal`. Without friction only the normal is left.
[[nodiscard]] Triple project(const Triple& given, double friction, double tangent, double normal);
[[nodiscard]] ConePoint project_with_derivative(const Triple& given, double friction, double tangent, double normal);

}  // namespace abut::response
