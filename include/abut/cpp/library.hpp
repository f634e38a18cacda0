// SPDX-License-Identifier: Apache-2.0
// The library that was loaded: its version, its features, the layout of its structs.
#ifndef ABUT_CPP_LIBRARY_HPP
#define ABUT_CPP_LIBRARY_HPP

#include <abut/abut.h>
#include <abut/cpp/answer.hpp>
#include <abut/cpp/values.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace abut {
inline namespace ABUT_ANSWERS {

// Such as "0.2.0".
[[nodiscard]] inline std::string version() { return abut_version_string(); }

// Whether the loaded library understands the header that this was compiled with.
inline Answer<void> check_version() {
  return detail::answer(abut_check_version(ABUT_VERSION_MAJOR, ABUT_VERSION_MINOR));
}

[[nodiscard]] inline bool has_feature(const std::string& name) { return abut_has_feature(name.c_str()) != 0; }

// Hears of failures in the whole process; null for nothing. It may be called by several threads at once.
inline Answer<void> set_log(abut_log log, void* context = nullptr, abut_log_level most = ABUT_LOG_WARNING) {
  return detail::answer(abut_set_log(log, context, most));
}

// Offsets and sizes of all structs, for bindings that check their own.
[[nodiscard]] inline Answer<std::vector<LayoutEntry>> layout() {
  std::vector<LayoutEntry> entries(abut_layout_count());
  abut_status status = ABUT_OK;
  for (std::size_t i = 0; i < entries.size() && status == ABUT_OK; ++i) status = abut_layout_at(i, &entries[i]);
  return detail::answer(status, entries);
}

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
