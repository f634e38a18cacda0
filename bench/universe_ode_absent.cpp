// SPDX-License-Identifier: Apache-2.0
// In the place of ODE where it is not installed.
#include <memory>

#include "universe.hpp"

namespace bench {

std::unique_ptr<Detector> make_ode_world(const World&) { return nullptr; }

}  // namespace bench
