// SPDX-License-Identifier: Apache-2.0
// Defaults that builds without motion tell as well.
#ifndef ABUT_CAPI_IMPACT_OPTIONS_HPP
#define ABUT_CAPI_IMPACT_OPTIONS_HPP

#include "options.hpp"

namespace abut::capi {

inline constexpr abut_impact_options default_impact_options{sizeof(abut_impact_options), 1024, 0, 0, 0, 0};

}  // namespace abut::capi

#endif
