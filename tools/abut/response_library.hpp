// SPDX-License-Identifier: Apache-2.0
// The response library, loaded by the first scene with bodies that forces move.
#pragma once

#include "abut/response.h"

namespace cli {

struct ResponseFunctions {
  decltype(&abut_response_options_init) options_init;
  decltype(&abut_response_create) create;
  decltype(&abut_response_destroy) destroy;
  decltype(&abut_body_options_init) body_options_init;
  decltype(&abut_response_add_bodies) add_bodies;
  decltype(&abut_response_remove_body) remove_body;
  decltype(&abut_response_body) body;
  decltype(&abut_response_step) step;
  decltype(&abut_response_energy) energy;
  decltype(&abut_response_contacts) contacts;
  decltype(&abut_response_islands) islands;
};

/// Throws BadInput when the library is not installed.
[[nodiscard]] ResponseFunctions load_response();

}  // namespace cli
