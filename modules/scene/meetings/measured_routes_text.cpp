// SPDX-License-Identifier: Apache-2.0
// What `abut tune` wrote; scripts/routes renews it.
module abut.scene.meetings.measured_routes;
import abut.core.standard;

namespace abut {

std::string_view committed_routes() {
  return R"routes(# abut routes 1
)routes";
}

}  // namespace abut
