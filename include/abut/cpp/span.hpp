// SPDX-License-Identifier: Apache-2.0
// Views of arguments and of results that the library lends. One type for all versions of C++: std::span converts to it
// and, from C++20 on, it to std::span.
#ifndef ABUT_CPP_SPAN_HPP
#define ABUT_CPP_SPAN_HPP

#include <abut/abut.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <type_traits>
#if __cplusplus >= 202002L
#include <ranges>
#endif

namespace abut {

// Values that lie side by side and belong to somebody else.
template <class T>
class Span {
  // Options of this library add nothing to the C structs that they are derived from, so arrays of them are arrays of
  // those.
  template <class U>
  static constexpr bool fits = std::is_convertible_v<U*, T*> && sizeof(U) == sizeof(T);
  template <class Container>
  using ElementOf = std::remove_pointer_t<decltype(std::data(std::declval<Container&>()))>;

 public:
  using element_type = T;
  using value_type = std::remove_cv_t<T>;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using pointer = T*;
  using reference = T&;
  using iterator = T*;

  constexpr Span() noexcept = default;
  constexpr Span(T* data, std::size_t size) noexcept : data_(data), size_(size) {}

  // std::vector, std::array, std::span, an array, another Span.
  template <class Container, class = std::enable_if_t<fits<ElementOf<Container>>>>
  constexpr Span(Container&& container) noexcept : data_(std::data(container)), size_(std::size(container)) {}

  // A list in braces lives to the end of the call that it is an argument of.
  template <class U = T, class = std::enable_if_t<std::is_const_v<U>>>
  constexpr Span(std::initializer_list<value_type> values) noexcept : Span(std::data(values), values.size()) {}

  [[nodiscard]] constexpr T* data() const noexcept { return data_; }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
  [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] constexpr T* begin() const noexcept { return data_; }
  [[nodiscard]] constexpr T* end() const noexcept { return data_ + size_; }
  [[nodiscard]] constexpr T& front() const { return (*this)[0]; }
  [[nodiscard]] constexpr T& operator[](std::size_t index) const {
    assert(index < size_);
    return data_[index];
  }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

// An argument that may be left out. It refers to what it was made from, which lives to the end of the call.
template <class T>
class OptionalRef {
 public:
  constexpr OptionalRef() noexcept = default;
  constexpr OptionalRef(std::nullopt_t) noexcept {}
  constexpr OptionalRef(const T& value) noexcept : value_(&value) {}

  [[nodiscard]] constexpr const T* get() const noexcept { return value_; }

 private:
  const T* value_ = nullptr;
};

// Numbers that belong together three by three, in any of their usual forms: plain numbers, std::array of three,
// abut_vec3.
template <class Number>
class Triples {
  using Triple = std::conditional_t<std::is_same_v<Number, double>, abut_vec3, std::array<Number, 3>>;
  static_assert(sizeof(Triple) == 3 * sizeof(Number));

  static Span<const Number> numbers(const Number* data, std::size_t size) { return {data, size}; }
  static Span<const Number> numbers(const std::array<Number, 3>* data, std::size_t size) {
    return {size == 0 ? nullptr : data->data(), 3 * size};
  }
  static Span<const double> numbers(const abut_vec3* data, std::size_t size) {
    return {size == 0 ? nullptr : &data->x, 3 * size};
  }

 public:
  Triples() noexcept = default;
  Triples(std::initializer_list<Triple> values) : numbers_(numbers(std::data(values), values.size())) {}

  template <class Container,
            class = std::enable_if_t<std::is_convertible_v<
                decltype(numbers(std::data(std::declval<const Container&>()), std::size_t())), Span<const Number>>>>
  Triples(const Container& container) : numbers_(numbers(std::data(container), std::size(container))) {}

  [[nodiscard]] const Number* data() const noexcept { return numbers_.data(); }
  // Of triples; numbers that are left over count for nothing here.
  [[nodiscard]] std::size_t size() const noexcept { return numbers_.size() / 3; }
  [[nodiscard]] std::size_t number_count() const noexcept { return numbers_.size(); }

 private:
  Span<const Number> numbers_;
};

using Points = Triples<double>;
using Triangles = Triples<std::uint32_t>;

}  // namespace abut

#if __cplusplus >= 202002L
template <class T>
inline constexpr bool std::ranges::enable_borrowed_range<abut::Span<T>> = true;
template <class T>
inline constexpr bool std::ranges::enable_view<abut::Span<T>> = true;
#endif

#endif
