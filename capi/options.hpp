// Structs that begin with struct_size: what a caller with an older or a newer header hands over.
#ifndef ABUT_CAPI_OPTIONS_HPP
#define ABUT_CAPI_OPTIONS_HPP

#include "prelude.hpp"

#include "border.hpp"

namespace abut::capi {

// No struct will ever be larger; a number beyond is not a size.
inline constexpr std::uint32_t largest_struct_size = 4096;

// Size of the first version of a struct, which callers with the oldest header have. All structs are
// still in their first version; a field that is added later is read only if struct_size covers all of it.
template <class Struct>
inline constexpr std::uint32_t first_size = sizeof(Struct);

// Checks the size that a struct says it has. What an unknown newer header has appended must be zero:
// those wishes cannot be met.
template <class Struct>
[[nodiscard]] abut_status check_struct_size(const Where& where, const Struct& given) {
  const std::uint32_t size = given.struct_size;
  if (size < first_size<Struct> || size > largest_struct_size) {
    return refuse(error_about(Errc::wrong_struct_size, where.with(".struct_size"), std::uint64_t{size},
                              std::to_string(sizeof(Struct)) + ", which the _init function sets"));
  }
  if (size > sizeof(Struct)) {
    const auto tail = bytes_of(reinterpret_cast<const unsigned char*>(&given), size).subspan(sizeof(Struct));
    if (std::any_of(tail.begin(), tail.end(), [](unsigned char byte) { return byte != 0; })) {
      return refuse(ABUT_WRONG_STRUCT_SIZE,
                    where.with(".struct_size is ") + std::to_string(size) + " and fields past the known " +
                        std::to_string(sizeof(Struct)) + " bytes are set; this version of abut does not have them");
    }
  }
  return ABUT_OK;
}

[[nodiscard]] inline abut_status check_reserved(const Where& where, std::uint32_t reserved) {
  if (reserved != 0) [[unlikely]] {
    return refuse(error_about(Errc::invalid_argument, where.with(".reserved"), std::uint64_t{reserved}, "zero"));
  }
  return ABUT_OK;
}

// Enumerations whose values are 0 ... last.
[[nodiscard]] inline abut_status check_value(const Where& where, std::string_view field, std::uint32_t value, std::uint32_t last) {
  if (value > last) [[unlikely]] {
    return refuse(error_about(Errc::unknown_value, where.with(field), std::uint64_t{value}, "at most " + std::to_string(last)));
  }
  return ABUT_OK;
}

// Fills a struct that the caller may know in an older version.
template <class Struct>
void write_struct(const Struct& from, Struct* out) {
  const std::uint32_t size = std::min<std::uint32_t>(out->struct_size, sizeof(Struct));
  Struct answer = from;
  answer.struct_size = out->struct_size;
  std::memcpy(out, &answer, size);
}

}  // namespace abut::capi

#endif
