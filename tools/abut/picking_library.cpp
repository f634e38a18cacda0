// SPDX-License-Identifier: Apache-2.0
#include "picking_library.hpp"

#include "loaded_library.hpp"

namespace cli {

tools::PickingFunctions load_picking() {
  const LoadedLibrary library(ABUT_PICKING_LIBRARY, "pictures", "picking");
  tools::PickingFunctions its{};
  library.find("abut_picker_create", its.create);
  library.find("abut_picker_destroy", its.destroy);
  library.find("abut_picker_render", its.render);
  library.find("abut_picker_cast_rays", its.cast_rays);
  library.find("abut_camera_init", its.camera_init);
  library.find("abut_camera_look_at", its.camera_look_at);
  library.find("abut_camera_ray", its.camera_ray);
  return its;
}

}  // namespace cli
