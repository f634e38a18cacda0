/* SPDX-License-Identifier: Apache-2.0 */
/* A C program that knows abut_response by pkg-config: a body flies to a floor 2 m below it in a step of 0.5 s. */
#include <abut/response.h>
#include <stdio.h>

int main(void) {
  const double mass = 3, inertia[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, centre[3] = {0, 0, 0}, normal[3] = {0, 0, 1};
  const double free_velocity[6] = {0, 0, -8, 0, 0, 0}, step = 0.5, offset = 2 / 0.5;
  const uint32_t bodies[2] = {ABUT_NO_BODY, 0};
  double velocity[6], impulse[3];
  abut_residuals residuals;
  abut_contact_problem problem;
  abut_contact_problem_init(&problem, sizeof problem);
  problem.body_count = problem.contact_count = 1;
  problem.masses = &mass;
  problem.inertias = inertia;
  problem.centres = problem.points = centre;
  problem.free_velocities = free_velocity;
  problem.bodies = bodies;
  problem.normals = normal;
  problem.offsets = &offset;
  if (abut_contact_problem_solve(&problem, NULL, velocity, impulse, &residuals) != ABUT_OK) {
    fprintf(stderr, "%s\n", abut_last_error_message());
    return 1;
  }
  printf("distance %.6g\n", -velocity[2] * step);
  return 0;
}
