/* SPDX-License-Identifier: Apache-2.0 */
/* The header alone, first in its file: it brings abut.h along. */
#include <abut/response.h>

abut_status abut_header_test(const abut_contact_problem* problem, double* velocities, abut_residuals* out);
abut_status abut_header_test(const abut_contact_problem* problem, double* velocities, abut_residuals* out) {
  return abut_contact_problem_solve(problem, NULL, velocities, NULL, out);
}
