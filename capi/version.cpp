// SPDX-License-Identifier: Apache-2.0
// Version and contents of the library that was loaded.
#include "guard.hpp"

using namespace abut::capi;

#define ABUT_STRINGIZE(x) #x
#define ABUT_DOTTED(major, minor, patch) ABUT_STRINGIZE(major) "." ABUT_STRINGIZE(minor) "." ABUT_STRINGIZE(patch)

namespace {

constexpr std::string_view version = ABUT_DOTTED(ABUT_VERSION_MAJOR, ABUT_VERSION_MINOR, ABUT_VERSION_PATCH);
static_assert(version == ABUT_PROJECT_VERSION, "the version in abut.h is not the one in CMakeLists.txt");

// Commas on both sides of each name.
constexpr std::string_view features = "," ABUT_PROJECT_FEATURES ",";

}  // namespace

const char* abut_version_string(void) { return version.data(); }

abut_status abut_check_version(uint32_t major, uint32_t minor) {
  return guard([&]() -> abut_status {
    // Before 1.0 each minor version has an ABI of its own.
    const bool is_known = major == 0 ? minor == ABUT_VERSION_MINOR : minor <= ABUT_VERSION_MINOR;
    if (major == ABUT_VERSION_MAJOR && is_known) {
      return ABUT_OK;
    }
    return refuse(ABUT_UNSUPPORTED, "the caller was compiled for version " + std::to_string(major) + "." +
                                        std::to_string(minor) + ", the library is " + std::string(version));
  });
}

uint32_t abut_has_feature(const char* name) {
  const std::string_view wanted(name == nullptr ? "" : name);
  if (wanted.empty() || wanted.find(',') != std::string_view::npos) {
    return 0;
  }
  for (std::size_t at = features.find(wanted); at != std::string_view::npos; at = features.find(wanted, at + 1)) {
    if (features[at - 1] == ',' && features[at + wanted.size()] == ',') {
      return 1;
    }
  }
  return 0;
}
