// SPDX-License-Identifier: Apache-2.0
// The memory layout of every public struct: fixed here, and reported to bindings.
#include "border.hpp"
#include "guard.hpp"
#include "layout_table.h"

import abut.core;

using namespace abut::capi;

static_assert(sizeof(void*) == 8 && sizeof(std::size_t) == 8, "the sizes below are those of 64-bit platforms");

namespace {

// Plain data of a size that never changes.
template <class Struct>
constexpr bool is_plain(std::size_t size) {
  return std::is_standard_layout_v<Struct> && std::is_trivially_copyable_v<Struct> && sizeof(Struct) == size &&
         alignof(Struct) <= 8;
}

#define ABUT_ASSERT_STRUCT(type, size) static_assert(is_plain<type>(size));
#define ABUT_ASSERT_FIELD(type, field, offset, size) \
  static_assert(offsetof(type, field) == (offset) && sizeof(type::field) == (size));
ABUT_LAYOUT(ABUT_ASSERT_STRUCT, ABUT_ASSERT_FIELD)

#define ABUT_STRUCT(type, size) abut_layout_entry{#type, "", 0, sizeof(type)},
#define ABUT_FIELD(type, field, offset, size) \
  abut_layout_entry{#type, #field, offsetof(type, field), sizeof(type::field)},
constexpr auto layout = std::to_array<abut_layout_entry>({ABUT_LAYOUT(ABUT_STRUCT, ABUT_FIELD)});

}  // namespace

size_t abut_layout_count(void) { return layout.size(); }

abut_status abut_layout_at(size_t index, abut_layout_entry* out) {
  return guard([&]() -> abut_status {
    if (const abut_status status = check_not_null("out", out); status != ABUT_OK) {
      return status;
    }
    if (index >= layout.size()) {
      return refuse(abut::error_about(abut::Errc::index_out_of_range, "index", std::uint64_t{index},
                                      "below " + std::to_string(layout.size())));
    }
    *out = layout[index];
    return ABUT_OK;
  });
}
