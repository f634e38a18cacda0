// SPDX-License-Identifier: Apache-2.0
// The names of the standard library that modules/ uses. Were the headers included instead, each module would hold a
// copy of their declarations, and every importer would compare and merge all copies: most of the time of compiling.
module;
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>
export module abut.core.standard;

export namespace std {
using std::FILE;
using std::abs;
using std::any_of;
using std::array;
using std::as_bytes;
using std::as_const;
using std::atomic;
using std::atomic_thread_fence;
using std::bad_alloc;
using std::binary_search;
using std::bit_cast;
using std::bit_ceil;
using std::bit_width;
using std::byte;
using std::cbrt;
using std::ceil;
using std::clamp;
using std::convertible_to;
using std::copy;
using std::copy_n;
using std::copyable;
using std::copysign;
using std::cos;
using std::countr_zero;
using std::default_delete;
using std::default_initializable;
using std::equal_to;
using std::erase;
using std::erase_if;
using std::exception;
using std::exchange;
using std::fabs;
using std::fclose;
using std::fill;
using std::floor;
using std::fmax;
using std::fmin;
using std::fopen;
using std::forward;
using std::function;

using std::get;
using std::get_if;
using std::hash;
using std::hypot;
using std::ilogb;
using std::index_sequence;
using std::initializer_list;
using std::int32_t;
using std::int64_t;
using std::integral_constant;
using std::invoke_result_t;
using std::iota;
using std::is_enum_v;
using std::is_same_v;
using std::is_standard_layout_v;
using std::is_trivially_copyable_v;
using std::is_trivially_default_constructible_v;
using std::isfinite;
using std::isinf;
using std::isnan;
using std::iter_swap;
using std::ldexp;
using std::length_error;
using std::less;
using std::logic_error;
using std::lower_bound;
using std::lround;
using std::make_index_sequence;
using std::make_shared;
using std::make_unique;
using std::map;
using std::max;
using std::max_element;
using std::memcpy;
using std::memmove;
using std::memory_order_acq_rel;
using std::memory_order_acquire;
using std::memory_order_relaxed;
using std::memory_order_release;
using std::micro;
using std::min;
using std::minmax;
using std::minmax_element;
using std::movable;
using std::move;
using std::move_backward;
using std::mutex;
using std::nextafter;
using std::none_of;
using std::nth_element;
using std::nullopt;
using std::numeric_limits;
using std::optional;
using std::pair;
using std::partition;
using std::ptrdiff_t;
using std::ref;
using std::remove_const_t;
using std::remove_if;
using std::remove_reference_t;
using std::reverse;
using std::round;
using std::same_as;
using std::scoped_lock;
using std::shared_ptr;
using std::signbit;
using std::sin;
using std::size_t;
using std::sort;
using std::span;
using std::sqrt;
using std::ssize;
using std::string;
using std::string_view;
using std::swap;
using std::swap_ranges;
using std::tie;
using std::to_array;
using std::to_chars;
using std::to_string;
using std::transform;
using std::tuple;
using std::tuple_element;
using std::tuple_size;
using std::tuple_size_v;
using std::uint16_t;
using std::uint32_t;
using std::uint64_t;
using std::uint8_t;
using std::underlying_type_t;
using std::uintptr_t;
using std::unique;
using std::unique_ptr;
using std::variant;
using std::variant_alternative_t;
using std::variant_size_v;
using std::vector;
using std::visit;
// Found by the types of their operands.
using std::operator==;
using std::operator<=>;
using std::operator<;
using std::operator+;
using std::operator-;
}  // namespace std

export namespace std::chrono {
using std::chrono::duration;
using std::chrono::steady_clock;
using std::chrono::operator-;
}  // namespace std::chrono

export namespace std::numbers {
using std::numbers::pi;
}  // namespace std::numbers

export namespace std::ranges {
using std::ranges::all_of;
using std::ranges::any_of;
using std::ranges::binary_search;
using std::ranges::copy;
using std::ranges::count_if;
using std::ranges::find;
using std::ranges::for_each;
using std::ranges::is_sorted;
using std::ranges::min_element;
using std::ranges::none_of;
using std::ranges::sort;
}  // namespace std::ranges

// Operators of the iterators of libstdc++.
export namespace __gnu_cxx {
using __gnu_cxx::operator==;
using __gnu_cxx::operator<=>;
using __gnu_cxx::operator-;
using __gnu_cxx::operator+;
}  // namespace __gnu_cxx
