// SPDX-License-Identifier: Apache-2.0
// Lets oneTBB run eight threads in this process, whatever the machine has. Otherwise tests of several threads would
// run two on a machine of two cores. For programs of tests; it takes effect before main.
#include <oneapi/tbb/global_control.h>

namespace {

const tbb::global_control eight_threads(tbb::global_control::max_allowed_parallelism, 8);

}  // namespace
