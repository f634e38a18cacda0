// SPDX-License-Identifier: Apache-2.0
// Making a shape of a kind. No class of a shape is named here: kinds are found by name.
#ifndef ABUT_CAPI_SHAPE_MAKE_HPP
#define ABUT_CAPI_SHAPE_MAKE_HPP

#include "prelude.hpp"

import abut.core.standard;

namespace abut::capi {

struct [[gsl::Pointer]] Numbers {
  std::span<const double> parameters;
  std::span<const double> reals;
  std::span<const std::uint32_t> indices;
};

// Shapes name their buffers as the named functions do; the generic door calls them reals and indices.
enum class Door : unsigned char { named, generic };

// `place`: of the kind, in the registry.
[[nodiscard]] abut_status create(std::size_t place, const Numbers& numbers, abut_shape** out, Door door = Door::named);

// ABUT_UNSUPPORTED where this build has no such kind.
[[nodiscard]] abut_status create_named(std::string_view name, const Numbers& numbers, abut_shape** out);

}  // namespace abut::capi

#endif
