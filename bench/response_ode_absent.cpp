// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "response.hpp"

namespace bench {

std::unique_ptr<Mover> make_ode_mover(const MovingWorld&, const Effort&) { return nullptr; }
bool has_ode() { return false; }

}  // namespace bench
