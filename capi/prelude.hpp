// SPDX-License-Identifier: Apache-2.0
// Everything textual that the C border includes: each header here starts with it, so that includes
// come before imports in every translation unit.
#ifndef ABUT_CAPI_PRELUDE_HPP
#define ABUT_CAPI_PRELUDE_HPP

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/check.hpp"

#endif
