/* SPDX-License-Identifier: Apache-2.0 */
/* All headers twice, in either order. */
#include <abut/picking.h>
#include <abut/response.h>
#include <abut/abut.h>
#include <abut/response.h>
#include <abut/picking.h>
#include <abut/abut.h>

abut_status abut_header_test(abut_universe* universe);
abut_status abut_header_test(abut_universe* universe) { return abut_universe_step(universe, 0.0); }
