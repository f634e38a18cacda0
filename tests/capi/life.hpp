// SPDX-License-Identifier: Apache-2.0
// A program on the C interface from its first call to its last, which itself asks for no memory.
#pragma once

namespace abut_test {

// Shapes of many kinds, a universe that steps, queries, plans in words, bytes of a universe and refused calls. Gives
// everything back, also where a call fails; answers the first status that was not to be expected.
int live_once(bool with_hull, unsigned threads);

}  // namespace abut_test
