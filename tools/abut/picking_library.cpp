// SPDX-License-Identifier: Apache-2.0
#include "picking_library.hpp"

#include <bit>
#include <string>

#include <dlfcn.h>

#include "failures.hpp"

namespace cli {
namespace {

template <class Function>
void find(void* library, const char* name, Function*& out) {
  void* const symbol = dlsym(library, name);
  if (symbol == nullptr) {
    throw BadInput("the picking library has no " + std::string(name) + "; expected that of abut " +
                   abut_version_string());
  }
  out = std::bit_cast<Function*>(symbol);
}

}  // namespace

tools::PickingFunctions load_picking() {
  // It stays for good: threads of what it stands on may outlive its last use.
  void* const library = dlopen(ABUT_PICKING_LIBRARY, RTLD_NOW | RTLD_NODELETE);
  if (library == nullptr) {
    throw BadInput("pictures need the picking library of abut, which cannot be loaded: " + std::string(dlerror()));
  }
  tools::PickingFunctions its{};
  find(library, "abut_picker_create", its.create);
  find(library, "abut_picker_destroy", its.destroy);
  find(library, "abut_picker_render", its.render);
  find(library, "abut_picker_cast_rays", its.cast_rays);
  find(library, "abut_camera_init", its.camera_init);
  find(library, "abut_camera_look_at", its.camera_look_at);
  find(library, "abut_camera_ray", its.camera_ray);
  return its;
}

}  // namespace cli
