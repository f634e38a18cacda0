// SPDX-License-Identifier: Apache-2.0
// Defaults that builds without the feature `deforming` tell as well.
#ifndef ABUT_CAPI_ELEMENTS_OPTIONS_HPP
#define ABUT_CAPI_ELEMENTS_OPTIONS_HPP

#include "options.hpp"

namespace abut::capi {

inline constexpr abut_elements_options default_elements_options{
    sizeof(abut_elements_options), ABUT_CLOSEST_FEATURES, 0, 0, 0, 0, 0, 1e-9, 0, 0, 0.5};

}  // namespace abut::capi

#endif
