/* SPDX-License-Identifier: Apache-2.0 */
/*
 * response.h - what contacts do to bodies: impulses and velocities whose error is told.
 *
 * A library of its own (libabut_response.so) on top of the public interface of libabut.so: a program that only detects
 * loads none of it. The conventions of abut.h hold; docs/response.md tells more.
 *
 * Kilograms, metres, seconds and newtons, or any other consistent units. All vectors are in the world frame.
 */
#ifndef ABUT_RESPONSE_H
#define ABUT_RESPONSE_H

#include "abut.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------
 * The contact problem on arrays
 * --------------------------------------------------------------------------------------------- */

/** In the place of a body: ground, a wall, or anything else that no impulse moves. */
#define ABUT_NO_BODY 0xFFFFFFFFu

/**
 * Bodies and the contacts between them, at one moment. The relative velocity of a contact is
 *   u = (velocity of b - velocity of a) at the point + surface velocity.
 * An impulse pushes b, and a the other way. It satisfies, within the residuals that are told:
 *   impulse_n >= 0, u_n + compliance * impulse_n + offset >= 0, and one of the two is 0;
 *   |(impulse_t / friction_t, impulse_s / friction_s)| <= impulse_n, with equality where the surfaces slide.
 * A sliding impulse dissipates as much as it can. Numbers are at most 1e30 in size. Arrays are borrowed for the call.
 */
typedef struct abut_contact_problem {
  uint32_t struct_size;
  uint32_t body_count;              /**< default 0 */
  uint32_t contact_count;           /**< default 0 */
  uint32_t reserved;                /**< zero */
  const double *masses;             /**< one a body, 1e-30 to 1e30 */
  const double *inertias;           /**< nine a body: symmetric positive definite, about the centre of mass */
  const double *centres;            /**< three a body: centre of mass */
  const double *free_velocities;    /**< six a body: linear and angular, as they would be without contacts */
  const uint32_t *bodies;           /**< two a contact: a and b, which differ; one of them may be ABUT_NO_BODY */
  const double *points;             /**< three a contact */
  const double *normals;            /**< three a contact: of any length but zero, from a to b */
  const double *tangents;           /**< three a contact: the direction t, less its part along the normal. Null where
                                         both frictions of each contact are equal */
  const double *frictions;          /**< two a contact: along t, and along s at right angles to it; 0 to 1e6. Null for
                                         0 */
  const double *compliances;        /**< one a contact: velocity per impulse, at least 0; null for rigid contacts */
  const double *offsets;            /**< one a contact: velocity; a gap over the step lets bodies come as near as they
                                         are apart. Null for 0 */
  const double *surface_velocities; /**< three a contact: of b less a, beyond that of the bodies, such as that of a
                                         belt. Null for 0 */
  const double *first_velocities;   /**< six a body, where the search begins; null for free_velocities */
  const double *first_impulses;     /**< three a contact, where the search begins; null for 0 */
} abut_contact_problem;

/** Fills in an empty problem. */
ABUT_API void abut_contact_problem_init(abut_contact_problem *problem, uint32_t struct_size);

/** When the solver ends. */
typedef struct abut_solver_options {
  uint32_t struct_size;
  uint32_t most_rounds; /**< default 200, at least 1 */
  double tolerance;     /**< largest residual, as a part of `speed`; default 1e-9, at least 0 */
  double speed;         /**< velocity; 0, the default, for the largest of bodies and contacts in the free motion */
} abut_solver_options;

/** Fills in the defaults. */
ABUT_API void abut_solver_options_init(abut_solver_options *options, uint32_t struct_size);

/** How far velocities and impulses are from the law. All are 0 for an exact solution. */
typedef struct abut_residuals {
  double contact;        /**< velocity: by how much the worst contact misses its law; see docs/response.md */
  double motion;         /**< velocity: by how much the worst body misses its equation of motion */
  double dissipation;    /**< energy: impulse times shifted velocity, which is 0 for each contact, summed in size */
  double speed;          /**< velocity that the tolerance is a part of */
  uint32_t rounds;       /**< updates of impulses */
  uint32_t newton_steps; /**< factorisations of the matrix of the convex problem */
  uint32_t is_converged; /**< 1 where contact and motion are within the tolerance and what rounding leaves; 0 where the
                              rounds ended before */
  uint32_t reserved;     /**< zero */
} abut_residuals;

/**
 * Velocities and impulses of a contact problem; the same bits each time.
 * A problem that the rounds did not solve is no failure: the best velocities and impulses that were found come with
 * their residuals. Dense heaps with friction above 0.3 are such problems (docs/response.md).
 * @param options     may be null for the defaults
 * @param velocities  six a body: linear and angular; may be null where there are no bodies
 * @param impulses    three a contact: on b, at the point; may be null where there are no contacts
 * Complexity: each Newton step factors a sparse matrix of six rows a body, O(bodies) for stacks and rows.
 * ABUT_NOT_CONVERGED where numbers are so far apart that a result is not finite. [any]
 */
ABUT_API abut_status abut_contact_problem_solve(const abut_contact_problem *problem, const abut_solver_options *options,
                                                double *velocities, double *impulses, abut_residuals *out);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif /* ABUT_RESPONSE_H */
