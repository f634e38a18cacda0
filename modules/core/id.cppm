// SPDX-License-Identifier: Apache-2.0
// Ids instead of pointers: a slot and the generation that lived in it.
export module abut.core.id;
import abut.core.standard;

export namespace abut {

template <class Tag>
struct Id {
  std::uint32_t slot = 0;  // one-based; 0 is null
  std::uint32_t generation = 0;

  friend constexpr bool operator==(const Id&, const Id&) = default;
  friend constexpr auto operator<=>(const Id&, const Id&) = default;
  [[nodiscard]] constexpr bool is_null() const { return slot == 0; }
};

}  // namespace abut
