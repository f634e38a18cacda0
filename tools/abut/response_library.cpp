// SPDX-License-Identifier: Apache-2.0
#include "response_library.hpp"

#include "loaded_library.hpp"

namespace cli {

ResponseFunctions load_response() {
  const LoadedLibrary library(ABUT_RESPONSE_LIBRARY, "scenes with a response", "response");
  ResponseFunctions its{};
  library.find("abut_response_options_init", its.options_init);
  library.find("abut_response_create", its.create);
  library.find("abut_response_destroy", its.destroy);
  library.find("abut_body_options_init", its.body_options_init);
  library.find("abut_response_add_bodies", its.add_bodies);
  library.find("abut_response_remove_body", its.remove_body);
  library.find("abut_response_body", its.body);
  library.find("abut_response_step", its.step);
  library.find("abut_response_energy", its.energy);
  library.find("abut_response_contacts", its.contacts);
  library.find("abut_response_islands", its.islands);
  return its;
}

}  // namespace cli
