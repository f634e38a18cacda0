// SPDX-License-Identifier: Apache-2.0
// The only raw memory of abut.
export module abut.core.raw;
import abut.core.standard;

export namespace abut {

// The elements of an array from `first` on, as many as fit into To, as one vector register. The caller
// knows that they are there: first * sizeof(From) + sizeof(To) <= sizeof(from).
template <class To, class From, std::size_t Count>
[[nodiscard]] inline To loaded(const std::array<From, Count>& from, std::size_t first) {
  static_assert(std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From> && sizeof(To) <= sizeof(from));
  To values;
  std::memcpy(&values, &from[first], sizeof values);
  return values;
}

}  // namespace abut
