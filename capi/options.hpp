// SPDX-License-Identifier: Apache-2.0
// Structs that begin with struct_size: what a caller with an older or a newer header hands over.
#ifndef ABUT_CAPI_OPTIONS_HPP
#define ABUT_CAPI_OPTIONS_HPP

#include "prelude.hpp"

#include "border.hpp"
#include "defaults.hpp"

namespace abut::capi {

// Size of the first version of a struct, which callers with the oldest header have. All structs are
// still in their first version; a field that is added later is read only if struct_size covers all of it.
template <class Struct>
inline constexpr std::uint32_t first_size = sizeof(Struct);

// What an unknown newer header has appended must be zero: those wishes cannot be met.
[[nodiscard]] inline abut_status check_tail(const Where& where, std::uint32_t size,
                                            std::span<const unsigned char> tail) {
  if (std::any_of(tail.begin(), tail.end(), [](unsigned char byte) { return byte != 0; })) {
    return refuse(ABUT_WRONG_STRUCT_SIZE, where.with(".struct_size is ") + std::to_string(size) +
                                              " and some of its last " + std::to_string(tail.size()) +
                                              " bytes are set; this version of abut does not know them");
  }
  return ABUT_OK;
}

// Checks the size that a struct says it has.
template <class Struct>
[[nodiscard]] abut_status check_struct_size(const Where& where, const Struct& given) {
  const std::uint32_t size = given.struct_size;
  if (size < first_size<Struct> || size > largest_struct_size) {
    return refuse(error_about(Errc::wrong_struct_size, where.with(".struct_size"), std::uint64_t{size},
                              std::to_string(sizeof(Struct)) + ", which the _init function sets"));
  }
  return size > sizeof(Struct) ? check_tail(where, size, bytes_of(&given, size).subspan(sizeof(Struct)))
                               : static_cast<abut_status>(ABUT_OK);
}

[[nodiscard]] inline abut_status check_reserved(const Where& where, std::uint32_t reserved) {
  if (reserved != 0) [[unlikely]] {
    return refuse(error_about(Errc::invalid_argument, where.with(".reserved"), std::uint64_t{reserved}, "zero"));
  }
  return ABUT_OK;
}

// Enumerations whose values are 0 ... last.
[[nodiscard]] inline abut_status check_value(const Where& where, std::string_view field, std::uint32_t value,
                                             std::uint32_t last) {
  if (value > last) [[unlikely]] {
    return refuse(
        error_about(Errc::unknown_value, where.with(field), std::uint64_t{value}, "at most " + std::to_string(last)));
  }
  return ABUT_OK;
}

// The number of threads that a call asks for. No machine runs more at once; a number beyond is a mistake.
[[nodiscard]] inline abut_status check_threads(std::uint32_t threads, std::string_view name = "options.threads") {
  constexpr std::uint32_t most_threads = 1024;
  if (threads > most_threads) [[unlikely]] {
    return refuse(
        error_about(Errc::out_of_range, name, std::uint64_t{threads}, "at most " + std::to_string(most_threads)));
  }
  if (threads > 1 && abut_has_feature("threads") == 0) [[unlikely]] {
    return refuse(ABUT_UNSUPPORTED, std::string(name) + " is " + std::to_string(threads) +
                                        "; this build of abut is without the feature \"threads\", so 0 and 1 are left");
  }
  return ABUT_OK;
}

// What follows paths, in builds that do not.
[[nodiscard]] inline abut_status refuse_motion() {
  return refuse(ABUT_UNSUPPORTED, "this build of abut is without the feature \"motion\"");
}

// Tags of geometries, to which policies apply.
[[nodiscard]] inline abut_status check_tag(const Where& where, std::string_view field, std::uint32_t tag) {
  constexpr std::uint32_t tag_count = 64;
  if (tag >= tag_count) [[unlikely]] {
    return refuse(
        error_about(Errc::out_of_range, where.with(field), std::uint64_t{tag}, "below " + std::to_string(tag_count)));
  }
  return ABUT_OK;
}

// Sets of flags.
[[nodiscard]] inline abut_status check_bits(const Where& where, std::string_view field, std::uint32_t bits,
                                            std::uint32_t known) {
  if ((bits & ~known) != 0) [[unlikely]] {
    return refuse(error_about(Errc::unknown_value, where.with(field), std::uint64_t{bits},
                              "made of the bits of " + std::to_string(known)));
  }
  return ABUT_OK;
}

// An array of structs as a caller with another header lays it out: one struct_size after the other.
template <class Struct>
class StructArray {
 public:
  // An argument that may be null, for which the answer is an empty array.
  [[nodiscard]] static abut_status read(std::string_view name, const Struct* structs, std::size_t count,
                                        StructArray& out) {
    if (const abut_status status = check_size(name, "count", count, sizeof(Struct));
        status != ABUT_OK || structs == nullptr || count == 0) {
      return status;
    }
    if (const abut_status status = check_struct_size({name, 0}, *structs); status != ABUT_OK) {
      return status;
    }
    const std::uint32_t stride = structs->struct_size;
    if (count > 1 && stride % alignof(Struct) != 0) {
      return refuse(error_about(Errc::wrong_struct_size, Where{name, 0}.with(".struct_size"), std::uint64_t{stride},
                                "a multiple of " + std::to_string(alignof(Struct))));
    }
    if (const abut_status status = check_size(name, "count", count, stride); status != ABUT_OK) {
      return status;
    }
    out.structs_.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      Struct& next = out.structs_.emplace_back();
      std::memcpy(&next, bytes_of(structs, count * stride).subspan(i * stride).data(), sizeof(Struct));
      if (const abut_status status = check_element(name, i, stride, next.struct_size, structs); status != ABUT_OK) {
        return status;
      }
    }
    return ABUT_OK;
  }

  [[nodiscard]] std::span<const Struct> span() const [[clang::lifetimebound]] { return structs_; }

 private:
  [[nodiscard]] static abut_status check_element(std::string_view name, std::size_t index, std::uint32_t stride,
                                                 std::uint32_t size, const Struct* structs) {
    if (size != stride) {
      return refuse(error_about(Errc::wrong_struct_size, Where{name, index}.with(".struct_size"), std::uint64_t{size},
                                std::to_string(stride) + " as in the first element"));
    }
    const auto tail = bytes_of(structs, (index + 1) * stride).subspan(index * stride + sizeof(Struct));
    return check_tail({name, index}, size, tail);
  }

  std::vector<Struct> structs_;
};

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
