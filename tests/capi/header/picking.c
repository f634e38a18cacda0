/* SPDX-License-Identifier: Apache-2.0 */
/* The header alone, first in its file: it brings abut.h along. */
#include <abut/picking.h>

abut_status abut_header_test(abut_universe* universe, abut_picker** out);
abut_status abut_header_test(abut_universe* universe, abut_picker** out) { return abut_picker_create(universe, out); }
