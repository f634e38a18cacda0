// SPDX-License-Identifier: Apache-2.0
// Everything textual that the C border includes: each header here starts with it, so that includes come before imports
// in every translation unit. The standard library comes as a module: merging it with what is included would take longer
// than all the rest of compiling.
#ifndef ABUT_CAPI_PRELUDE_HPP
#define ABUT_CAPI_PRELUDE_HPP

#include <abut/abut.h>

#include "core/check.hpp"

#endif
