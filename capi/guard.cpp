// SPDX-License-Identifier: Apache-2.0
#include "guard.hpp"

namespace abut::capi {

abut_status refuse_exception() noexcept {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return refuse(ABUT_OUT_OF_MEMORY, "there is not enough memory");
  } catch (const std::length_error&) {
    return refuse(ABUT_OUT_OF_MEMORY, "an array would be larger than the address space");
  } catch (const std::exception& error) {
    return refuse(ABUT_INTERNAL, error.what());
  } catch (...) {
    return refuse(ABUT_INTERNAL, "an exception of unknown type");
  }
}

}  // namespace abut::capi
