/* SPDX-License-Identifier: Apache-2.0 */
/* The header alone, first in its file. */
#include <abut/abut.h>

abut_status abut_header_test(abut_universe* universe, abut_part_id part);
abut_status abut_header_test(abut_universe* universe, abut_part_id part) {
  const abut_pose pose = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
  const abut_status status = abut_part_set_pose(universe, part, &pose);
  return status == ABUT_OK ? (abut_status)ABUT_OK : status;
}
