// SPDX-License-Identifier: Apache-2.0
// How a body turns without torque.
module;

#include <abut/abut.h>

export module abut.response:motion;
import :vector;

export namespace abut::response {

struct Turning {
  abut_quat orientation;
  abut_vec3 angular;  // velocity, world frame
};

// Angular momentum and energy stay what they are, but for rounding. `inertia` stands in the frame of the body.
[[nodiscard]] Turning turned_freely(const Matrix& inertia, const Turning& start, double dt);

}  // namespace abut::response
