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

/** How a contact problem is solved. */
typedef uint32_t abut_solver;
enum abut_solver_value ABUT_ENUM(uint32_t) {
  ABUT_SOLVER_NEWTON = 0, /**< multipliers around Newton's method; converges for any ratio of masses */
  ABUT_SOLVER_SWEEPS = 1  /**< projected Gauss-Seidel: each round takes one contact after the other. Fast for many light
                               contacts of like masses, and slow to converge. Where masses differ by more than 1,000
                               and the residual stays above 1e-2 of the speed, Newton's method takes over */
};

/** How the solver works, and when it ends. */
typedef struct abut_solver_options {
  uint32_t struct_size;
  uint32_t most_rounds; /**< default 200, at least 1 */
  double tolerance;     /**< largest residual, as a part of `speed`; default 1e-9, at least 0 */
  double speed;         /**< velocity; 0, the default, for the largest of bodies and contacts in the free motion */
  abut_solver solver;   /**< default ABUT_SOLVER_NEWTON */
  uint32_t reserved;    /**< zero */
} abut_solver_options;

/** Fills in the defaults. */
ABUT_API void abut_solver_options_init(abut_solver_options *options, uint32_t struct_size);

/** How far velocities and impulses are from the law. All are 0 for an exact solution. */
typedef struct abut_residuals {
  double contact;        /**< velocity: by how much the worst contact misses its law; see docs/response.md */
  double motion;         /**< velocity: by how much the worst body misses its equation of motion */
  double dissipation;    /**< energy: impulse times shifted velocity, which is 0 for each contact, summed in size */
  double speed;          /**< velocity that the tolerance is a part of */
  uint32_t rounds;       /**< updates of impulses, or sweeps */
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

/* ------------------------------------------------------------------------------------------------
 * Rigid bodies of a universe
 * --------------------------------------------------------------------------------------------- */

/** Mass of a solid, in the frame that is named where it is used. */
typedef struct abut_mass_properties {
  double mass;       /**< 1e-30 to 1e30 */
  abut_vec3 centre;  /**< centre of mass */
  double inertia[9]; /**< symmetric positive definite matrix about the centre of mass, row by row */
} abut_mass_properties;

/**
 * Mass of a shape, in its own frame. Balls, boxes, capsules, cylinders, cones and ellipsoids have closed forms. Hulls,
 * meshes and distance fields have what their triangles enclose. Composites are the sum of their solids, also where
 * these overlap, less what their holes take out of each.
 * A hole must lie within a solid or beside it, but for a rounding of 1e-9 of its size. Or both are boxes or cylinders
 * with parallel axes, such as a bore through a plate; then the hole may leave by the ends of the solid.
 * ABUT_UNSUPPORTED for shapes without a volume, and surfaces that are not closed. So it is for composites of such
 * shapes, holes that cross surfaces otherwise, and holes that overlap in a solid: there the mass is to be given.
 * @param density  mass per volume, 1e-30 to 1e30
 * Complexity O(triangles log triangles), of composites for each hole and solid. [any]
 */
ABUT_API abut_status abut_shape_mass_properties(const abut_shape *shape, double density, abut_mass_properties *out);

/** Bodies of a universe. Owned by its creator. */
typedef struct abut_response abut_response;

/** Bits of the flags of a response. */
typedef uint32_t abut_response_flags;
enum abut_response_flags_value ABUT_ENUM(uint32_t) {
  ABUT_RESPONSE_IMPACTS = 1 /**< steps stop at each touch of geometries with ABUT_GEOMETRY_FAST, where bodies bounce by
                                 the restitution of their materials. ABUT_UNSUPPORTED without the feature motion */
};

/** How bodies move. */
typedef struct abut_response_options {
  uint32_t struct_size;
  uint32_t most_rounds;      /**< of the solver, for each island; default 100, at least 1 */
  abut_vec3 gravity;         /**< acceleration; default (0, 0, -9.81) */
  double tolerance;          /**< of the solver, as in abut_solver_options; default 1e-9 */
  double slop;               /**< depth that rigid contacts keep; default 1e-5, at least 0. Deeper ones are moved
                                  apart */
  abut_response_flags flags; /**< default 0 */
  abut_solver solver;        /**< default ABUT_SOLVER_NEWTON */
  uint32_t threads;          /**< that share the islands of a step; the same bits for any number. Default 1, at most
                                  256; more than 1 is ABUT_UNSUPPORTED in a build without the feature threads */
  uint32_t reserved;         /**< zero */
} abut_response_options;

/** Fills in the defaults. */
ABUT_API void abut_response_options_init(abut_response_options *options, uint32_t struct_size);

/**
 * Creates a response without bodies. It keeps the universe, as a picker does. Calls on a response count as calls on its
 * universe: [exclusive] ones as exclusive, [const] ones as const.
 * @param options  may be null for the defaults
 * [const] on the universe.
 */
ABUT_API abut_status abut_response_create(abut_universe *universe, const abut_response_options *options,
                                          abut_response **out);

/** Destroys a response; parts stay as they are. Null is allowed. [exclusive] */
ABUT_API void abut_response_destroy(abut_response *response);

/** Options from the next step on. [exclusive] */
ABUT_API abut_status abut_response_set_options(abut_response *response, const abut_response_options *options);

/** How a body goes from one step to the next. Of bodies that touch or are linked, the greatest counts for all. */
typedef uint32_t abut_integrator;
enum abut_integrator_value ABUT_ENUM(uint32_t) {
  ABUT_INTEGRATOR_STATIC = 0,   /**< held where it is; joins nobody */
  ABUT_INTEGRATOR_EULER = 1,    /**< forces and springs of contacts at the start of the step, and the new velocity all
                                     along (symplectic). Springs diverge where dt is above 2 sqrt(m / k) */
  ABUT_INTEGRATOR_RK4 = 2,      /**< Runge-Kutta of order 4 for the force callback; springs as above */
  ABUT_INTEGRATOR_MIDPOINT = 3, /**< the force callback and springs at the middle of the step: order 2, no damping */
  ABUT_INTEGRATOR_IMPLICIT = 4  /**< the force callback at the start, springs at the end: order 1, any stiffness */
};

/** What a body weighs, and how it moves. */
typedef struct abut_body_options {
  uint32_t struct_size;
  abut_integrator integrator; /**< default ABUT_INTEGRATOR_IMPLICIT */
  double density;            /**< of all geometries of the part but sensors; default 1000. Not read where a mass is
                                  given */
  abut_mass_properties mass; /**< in the frame of the part; its mass is 0 by default, which asks for the density */
} abut_body_options;

/** Fills in the defaults. */
ABUT_API void abut_body_options_init(abut_body_options *options, uint32_t struct_size);

/**
 * Makes bodies of dynamic parts, all or none. A part that is a body already gets the new mass. Velocities are those of
 * abut_part_set_velocity. While a part is asleep, or not dynamic, its body stands still and pushes like a wall.
 * ABUT_INVALID_ARGUMENT for a part that is not dynamic, and ABUT_EMPTY for one without geometries whose mass is not
 * given. ABUT_UNSUPPORTED where a geometry has no volume.
 * @param parts    count parts
 * @param options  of all of them; may be null for the defaults
 * [exclusive]
 */
ABUT_API abut_status abut_response_add_bodies(abut_response *response, const abut_part_id *parts, size_t count,
                                              const abut_body_options *options);

/** Ends a body; its part stays where it is. ABUT_STALE_ID where the part is none. [exclusive] */
ABUT_API abut_status abut_response_remove_body(abut_response *response, abut_part_id part);

/** Mass of a body, in the frame of its part; ABUT_STALE_ID where the part is none. [const] */
ABUT_API abut_status abut_response_body(const abut_response *response, abut_part_id part, abut_mass_properties *out);

/**
 * Pushes a body in the next step, in addition to what pushes it already. Wakes the part.
 * @param force  in newtons, world frame; at most 1e30
 * @param at     point of the world; may be null for the centre of mass
 * ABUT_STALE_ID where the part is no body. [exclusive]
 */
ABUT_API abut_status abut_response_apply_force(abut_response *response, abut_part_id part, const abut_vec3 *force,
                                               const abut_vec3 *at);

/** The same with a torque in newton metres. [exclusive] */
ABUT_API abut_status abut_response_apply_torque(abut_response *response, abut_part_id part, const abut_vec3 *torque);

/**
 * A field of forces: adds to the force through the centre of mass, and to the torque. The position of `pose` is the
 * centre of mass, its orientation that of the part, and `velocity` that of the centre of mass. `time` counts from the
 * creation of the response. It runs on the thread that steps, up to four times a body and step, as integrators ask. It
 * may make [const] calls; it must not throw.
 */
typedef void (*abut_force_callback)(void *context, abut_part_id part, const abut_pose *pose,
                                    const abut_velocity *velocity, double time, abut_vec3 *force, abut_vec3 *torque);

/** Sets the field of forces; null for none. `context` is kept and handed to it. A number that is not finite makes the
 * step answer ABUT_NOT_FINITE. [exclusive] */
ABUT_API abut_status abut_response_set_force_callback(abut_response *response, abut_force_callback callback,
                                                      void *context);

/**
 * Makes bodies that do not turn of all particles of a geometry, whose part must be no body. They go by the integrator
 * ABUT_INTEGRATOR_IMPLICIT, and by gravity alone. Particles that were bodies already get the new numbers. They end with
 * their geometry. The vertices of a mesh are its particles, too: a cloth. Contacts push them by their weights; see
 * docs/response.md. ABUT_UNSUPPORTED for a geometry that has neither, and for steps with ABUT_RESPONSE_IMPACTS.
 * @param masses      count numbers, 1e-30 to 1e30; 0 for a particle that is held
 * @param xyz         count * 3 numbers, centres in the world; the geometry takes them
 * @param velocities  count * 3 numbers; may be null for 0
 * @param count       of the geometry; particles beyond are walls
 * [exclusive]
 */
ABUT_API abut_status abut_response_add_particles(abut_response *response, abut_geometry_id geometry,
                                                 const double *masses, const double *xyz, const double *velocities,
                                                 size_t count);

/**
 * Springs between particles that are bodies, behind those that there are. By implicit Euler: forces are those of the
 * places at the end of the step, for any stiffness and step, so that no energy is gained. Particles that springs or
 * tetrahedra join are one island, and are solved by Newton's method. A particle of mass 0 holds what is tied to it.
 * abut_response_add_particles takes all springs and tetrahedra of the geometry away.
 * ABUT_STALE_ID where the geometry has no particles that are bodies, ABUT_INDEX_OUT_OF_RANGE for a particle that is
 * none, ABUT_INVALID_ARGUMENT for one with itself. Then nothing is added.
 * @param pairs         count * 2 numbers of particles
 * @param stiffnesses   count numbers in N/m, 0 to 1e30
 * @param dampings      count numbers in N s/m along the spring, 0 to 1e30; may be null for 0
 * @param rest_lengths  count numbers in m, 0 to 1e30; may be null for the present lengths
 * [exclusive]
 */
ABUT_API abut_status abut_response_add_springs(abut_response *response, abut_geometry_id geometry,
                                               const uint32_t *pairs, const double *stiffnesses,
                                               const double *dampings, const double *rest_lengths, size_t count);

/** The material of tetrahedra. */
typedef struct abut_elastic_options {
  uint32_t struct_size;
  uint32_t reserved; /**< zero */
  double young;      /**< N/m^2; default 1e6, from 0 to 1e30 */
  double poisson;    /**< default 0.3, from 0 to 0.499 */
  double damping;    /**< seconds; default 0, at least 0. Viscous forces are those of a move through that time */
} abut_elastic_options;

/** Fills in the defaults. */
ABUT_API void abut_elastic_options_init(abut_elastic_options *options, uint32_t struct_size);

/**
 * Tetrahedra of four particles each, at rest as these lie now, in either order of corners. Their material is linear
 * in a frame that turns with each of them (corotational), so that turns cost no force. All else is as for
 * abut_response_add_springs. The mass is that of the particles.
 * ABUT_INVALID_ARGUMENT for a tetrahedron without volume.
 * @param tetrahedra  count * 4 numbers of particles
 * @param options     may be null for the defaults
 * [exclusive]
 */
ABUT_API abut_status abut_response_add_tetrahedra(abut_response *response, abut_geometry_id geometry,
                                                  const uint32_t *tetrahedra, size_t count,
                                                  const abut_elastic_options *options);

/**
 * Lets the vertices of a mesh follow particles that are bodies: a fine surface on a coarse body. Each is the mean of
 * four by their weights, now and after each step, such as barycentric coordinates in a tetrahedron. Contacts push the
 * particles by the same weights. A surface that followed others already follows these. It follows until a geometry of
 * the two is destroyed, or abut_response_add_particles or abut_response_remove_particles is called for one.
 * ABUT_STALE_ID where `carrier` has no particles that are bodies, ABUT_INDEX_OUT_OF_RANGE for a particle that is none.
 * ABUT_INVALID_ARGUMENT for vertices that are bodies themselves, or of a part that is one. ABUT_OUT_OF_RANGE where four
 * weights have a sum that is off 1 by more than 1e-6; they are divided by that sum. Then nothing changes.
 * @param surface  ABUT_UNSUPPORTED for a geometry without vertices
 * @param carrier  the geometry with the particles; on the part of the surface, the two do not meet
 * @param numbers  count * 4 numbers of particles
 * @param weights  count * 4 numbers, -1000 to 1000
 * @param count    of vertices; vertices beyond are walls
 * [exclusive]
 */
ABUT_API abut_status abut_response_map_vertices(abut_response *response, abut_geometry_id surface,
                                                abut_geometry_id carrier, const uint32_t *numbers,
                                                const double *weights, size_t count);

/** Ends particles, or a surface on some; they stay. ABUT_STALE_ID where the geometry has none. [exclusive] */
ABUT_API abut_status abut_response_remove_particles(abut_response *response, abut_geometry_id geometry);

/**
 * Where particles are in the world, and how they move: count * 3 numbers each. Borrowed until the next [exclusive]
 * call.
 * ABUT_STALE_ID where the geometry has none. [const]
 */
ABUT_API abut_status abut_response_particles(const abut_response *response, abut_geometry_id geometry,
                                             const double **xyz, const double **velocities, size_t *count);

/* ------------------------------------------------------------------------------------------------
 * What contacts do: kinds, rules and links
 * --------------------------------------------------------------------------------------------- */

/**
 * Edits a contact before a step responds to it. `material` holds what the materials of its sides say, and afterwards
 * what counts. 0 leaves the contact out. It runs on the thread that steps, in the order of contacts, once for each of
 * them, and again after each impact. It may make [const] calls; it must not throw.
 */
typedef uint32_t (*abut_contact_callback)(void *context, const abut_contact *contact,
                                          abut_contact_material *material);

/** Sets what edits contacts; null for nothing. `context` is kept and handed to it. [exclusive] */
ABUT_API abut_status abut_response_set_contact_callback(abut_response *response, abut_contact_callback callback,
                                                        void *context);

/** A contact between two geometries, as a kind of your own makes it. Velocities and impulses of b less a. */
typedef struct abut_contact_law {
  double friction_primary;    /**< along the tangent of the contact; 0 to 1e6 */
  double friction_secondary;  /**< at right angles to it */
  double compliance;          /**< velocity per impulse, at least 0 */
  double offset;              /**< velocity: impulse_n >= 0, u_n + compliance * impulse_n + offset >= 0, one is 0 */
  double pull;                /**< impulse that draws the two together in this step, at least 0 */
  abut_vec3 surface_velocity; /**< of b less a, beyond that of the bodies */
} abut_contact_law;

/**
 * The law of a contact of your own kind, for one step. `law` holds what the kind "friction" would do. A force f(gap),
 * such as that of Hertz, has the slope k = -df/dgap. By implicit Euler, linear within the step, it becomes
 *   compliance = 1 / (dt * dt * k), offset = -f / (dt * k).
 * `velocity` is that of b less a at the contact, before the step. 0 leaves the contact without an
 * impulse. It runs on the thread that steps, in the order of contacts, and again after each impact. It may make [const]
 * calls; it must not throw.
 */
typedef uint32_t (*abut_contact_law_callback)(void *context, const abut_contact *contact, const abut_vec3 *velocity,
                                              double dt, abut_contact_law *law);

/**
 * Adds a kind of your own, under a name that is not taken. These are there from the start:
 *  - friction: the default. Signorini and Coulomb, with springs where there is a compliance.
 *  - penalty: a spring and a damper along the normal, without friction.
 *  - augmented: friction whose normal impulse follows over steps, with the compliance epsilon times the mobility.
 *  - stick: bonds the two where they touch, until a point bears more than `break`, or abut_response_release.
 *  - slide: friction whose sticking points remember how far they crept, and go back.
 *  - none: no impulse; contacts are told all the same.
 * ABUT_INVALID_ARGUMENT for a name that is taken, empty, or longer than 63 bytes. [exclusive]
 */
ABUT_API abut_status abut_response_add_kind(abut_response *response, const char *name, abut_contact_law_callback law,
                                            void *context);

/** Names of all kinds, yours last, by count-then-fill; they stay while the response does. [const] */
ABUT_API abut_status abut_response_kinds(const abut_response *response, const char **names, size_t capacity,
                                         size_t *count);

/** What a side of a rule speaks of. */
typedef uint32_t abut_response_side_kind;
enum abut_response_side_kind_value ABUT_ENUM(uint32_t) {
  ABUT_RESPONSE_SIDE_ANY = 0,
  ABUT_RESPONSE_SIDE_GEOMETRY = 1,
  ABUT_RESPONSE_SIDE_PART = 2,    /**< all geometries of a part */
  ABUT_RESPONSE_SIDE_LABEL = 3,   /**< all geometries with a label */
  ABUT_RESPONSE_SIDE_TAG = 4,     /**< all geometries with a tag */
  ABUT_RESPONSE_SIDE_MATERIAL = 5 /**< contacts of that material, which children of composites may have */
};

typedef struct abut_response_side {
  abut_response_side_kind kind;
  uint32_t slot;       /**< of the geometry or the part; the label, tag or material; 0 for any */
  uint32_t generation; /**< of the geometry or the part; else 0 */
} abut_response_side;

/**
 * Appends a rule: contacts of the two sides, in either order, have that kind and these parameters. The first rule that
 * fits counts; where none does, contacts have the kind "friction". Numbers that are not given are those of the
 * materials.
 * @param a           a side; may be null for any
 * @param b           the other side; may be null for any
 * @param kind        name of a kind
 * @param parameters  such as "mu=0.5&k=1e4"; may be null for none. `$name$` stands for a variable. There are:
 *                    mu (both frictions), mu1, mu2, static (static_scale), k (N/m; the compliance is 1/k), compliance,
 *                    d (damping), e (restitution), threshold (restitution_threshold), adhesion (adhesive_force), all as
 *                    in abut_contact_material; break (N, 0: never; of stick), epsilon (1e-8 to 1, default 0.01; of
 *                    augmented)
 * @param out         receives the number of the rule, from 0; may be null
 * ABUT_INVALID_ARGUMENT for an unknown kind, parameter or variable, which the message names. ABUT_OUT_OF_RANGE for a
 * number. [exclusive]
 */
ABUT_API abut_status abut_response_add_rule(abut_response *response, const abut_response_side *a,
                                            const abut_response_side *b, const char *kind, const char *parameters,
                                            uint32_t *out);

/**
 * Gives a rule other parameters, from the next step on; `parameters` may be null for none. ABUT_INDEX_OUT_OF_RANGE
 * beyond the last rule. [exclusive]
 */
ABUT_API abut_status abut_response_set_rule_parameters(abut_response *response, uint32_t rule, const char *parameters);

/** Takes all rules away. Those of single geometries and variables stay. [exclusive] */
ABUT_API abut_status abut_response_clear_rules(abut_response *response);

/** What `$name$` stands for in parameters that are set from now on. [exclusive] */
ABUT_API abut_status abut_response_set_variable(abut_response *response, const char *name, const char *value);

/**
 * What all contacts of a geometry do, before any rule. Of two geometries that both have one, that of the lower slot
 * counts. `kind` may be null, which takes it away, and `parameters` may be null for none. ABUT_STALE_ID for a geometry
 * that is none. [exclusive]
 */
ABUT_API abut_status abut_response_set_geometry_kind(abut_response *response, abut_geometry_id geometry,
                                                     const char *kind, const char *parameters);

/**
 * Which rule counts for two geometries, its kind and all numbers, in words. Materials are those of the geometries.
 * @param text      capacity bytes, always terminated when capacity > 0; null with capacity 0 asks for the size
 * @param needed    bytes of the whole text with its terminator
 * [const]
 */
ABUT_API abut_status abut_response_rule_between(const abut_response *response, abut_geometry_id a, abut_geometry_id b,
                                                char *text, size_t capacity, size_t *needed);

/** A spring, a bond or a mouse between points of two parts, or of a part and the world. */
typedef struct abut_link_options {
  uint32_t struct_size;
  uint32_t reserved;  /**< zero */
  abut_part_id a;     /**< null id, the default, for the world */
  abut_part_id b;
  abut_vec3 point_a;  /**< in the world, now: the points that are drawn together */
  abut_vec3 point_b;
  double stiffness;   /**< N/m; 0, the default, for rigid */
  double damping;     /**< N s/m; default 0; of springs */
  double most_force;  /**< N; 0, the default, for any. A force that would be larger has that size */
  double break_force; /**< N; 0, the default, for never. A link that bears more ends after the step */
} abut_link_options;

/** Fills in the defaults. */
ABUT_API void abut_link_options_init(abut_link_options *options, uint32_t struct_size);

/**
 * Draws two points together from the next step on, along all three axes. Springs are implicit, as contacts are. Wakes
 * both parts; a link ends with a part. Linked bodies are solved as one island.
 * ABUT_INVALID_ARGUMENT where neither part is a body, or both are one.
 * @param out  receives the number of the link, from 1, never used again
 * [exclusive]
 */
ABUT_API abut_status abut_response_add_link(abut_response *response, const abut_link_options *options, uint64_t *out);

/** Moves the point of a link that is held in the world, such as where a mouse points. ABUT_STALE_ID where the link has
 * ended, ABUT_INVALID_ARGUMENT where point a is one of a part. [exclusive] */
ABUT_API abut_status abut_response_move_link(abut_response *response, uint64_t link, const abut_vec3 *point_a);

/** Force on b in the last step. ABUT_STALE_ID where the link has ended. [const] */
ABUT_API abut_status abut_response_link_force(const abut_response *response, uint64_t link, abut_vec3 *out);

/** Ends a link. ABUT_STALE_ID where it has ended. [exclusive] */
ABUT_API abut_status abut_response_remove_link(abut_response *response, uint64_t link);

/** Ends the bonds of two geometries. They bond again once they have been apart. ABUT_STALE_ID where they have none.
 * [exclusive] */
ABUT_API abut_status abut_response_release(abut_response *response, abut_geometry_id a, abut_geometry_id b);

/* ------------------------------------------------------------------------------------------------
 * Steps, and what they did
 * --------------------------------------------------------------------------------------------- */

/**
 * Moves all bodies by a time. The order:
 *  1. abut_universe_step(universe, dt) finds contacts at the present poses, and events;
 *  2. gravity and forces change velocities; each island of bodies that touch is solved (abut_contact_problem_solve);
 *  3. bodies move, and rigid ones that overlap are moved apart, which changes no velocity;
 *  4. poses and velocities are set.
 * Friction, static_scale, compliance and damping are those of abut_material_pair_get for each contact, per point.
 * There coefficients are at most 1e6, and other numbers at most 1e30: ABUT_OUT_OF_RANGE, or ABUT_NOT_FINITE.
 * Sensors push nothing. A part that is no body is a wall that moves by its velocity. Bodies whose part was destroyed
 * end. When a step fails, bodies are where they were; contacts and islands may be those of the step that failed.
 *
 * With ABUT_RESPONSE_IMPACTS a step stops at each impact of fast geometries, at most 64 times. There the rigid contacts
 * of an island bounce together: surfaces that approach by more than restitution_threshold leave by restitution times
 * that speed (Newton's law). All that is said of a step then holds from impact to impact: abut_universe_step, so that
 * ages and sleep count each part of it. Parts that are no bodies move by their velocities, too. A step that fails may
 * have moved bodies up to an impact.
 *
 * Complexity: the steps of the universe, and each island as abut_contact_problem_solve.
 * @param dt  above 0, at most 1e30
 * ABUT_NOT_CONVERGED where a velocity would not be finite. [exclusive]
 */
ABUT_API abut_status abut_response_step(abut_response *response, double dt);

/** What a contact does. */
typedef uint32_t abut_contact_state;
enum abut_contact_state_value ABUT_ENUM(uint32_t) {
  ABUT_CONTACT_STATE_OPEN = 0,     /**< no impulse */
  ABUT_CONTACT_STATE_STICKING = 1, /**< friction is less than it may be */
  ABUT_CONTACT_STATE_SLIDING = 2,  /**< friction is as large as it may be, or there is none */
  ABUT_CONTACT_STATE_BONDED = 3    /**< held by a bond of the kind stick */
};

/** A contact of the last step. World frame. */
typedef struct abut_response_contact {
  abut_geometry_id geometry_a;
  abut_geometry_id geometry_b;
  uint64_t id;              /**< of the contact of the universe; of a bond, that of the contact that made it */
  abut_vec3 point;          /**< between the two surfaces, at the start of the step */
  abut_vec3 normal;         /**< unit, from a to b */
  abut_vec3 impulse;        /**< on b; a received the opposite */
  abut_vec3 force;          /**< impulse over dt */
  double distance;          /**< at the start of the step; negative: overlapping */
  double normal_velocity;   /**< of b less a at the end of the step */
  abut_contact_state state;
  uint32_t island;          /**< index into abut_response_islands */
  uint32_t kind;            /**< index into abut_response_kinds */
  uint32_t reserved;        /**< zero */
} abut_response_contact;

/** Contacts of the last step that have an awake body, in the order of the universe. Borrowed until the next
 * [exclusive] call. [const] */
ABUT_API abut_status abut_response_contacts(const abut_response *response, const abut_response_contact **contacts,
                                            size_t *count);

/** What became of an object in the last step. */
typedef uint32_t abut_response_event;
enum abut_response_event_value ABUT_ENUM(uint32_t) {
  ABUT_RESPONSE_EVENT_BEGIN = 0,
  ABUT_RESPONSE_EVENT_PERSIST = 1,
  ABUT_RESPONSE_EVENT_END = 2 /**< is told once, without contacts */
};

/** Two geometries that have contacts or bonds. */
typedef struct abut_response_object {
  abut_geometry_id geometry_a;
  abut_geometry_id geometry_b;
  uint32_t kind;          /**< index into abut_response_kinds, of the first contact */
  abut_response_event event;
  uint32_t contact_count; /**< of abut_response_contacts, bonds too; 0 where both bodies are asleep */
  uint32_t bond_count;
  uint32_t age;           /**< steps before the last one that had it */
  uint32_t reserved;      /**< zero */
  abut_vec3 impulse;      /**< on b, of all contacts of the step */
  abut_vec3 force;        /**< impulse over dt */
} abut_response_object;

/** Objects after the last step, by geometries, and those that ended in it. Borrowed until the next [exclusive] call.
 * [const] */
ABUT_API abut_status abut_response_objects(const abut_response *response, const abut_response_object **objects,
                                           size_t *count);

/** Is told of each object after a step that succeeded, in their order. It may make [const] calls; it must not throw. */
typedef void (*abut_response_listener)(void *context, const abut_response_object *object);

/** Sets what listens; null for nothing. `context` is kept and handed to it. [exclusive] */
ABUT_API abut_status abut_response_set_listener(abut_response *response, abut_response_listener listener,
                                                void *context);

/** Bodies that touch each other, and how well they were solved. */
typedef struct abut_response_island {
  uint32_t body_count;
  uint32_t contact_count;
  abut_integrator integrator; /**< that its bodies go by */
  uint32_t reserved;          /**< zero */
  abut_residuals residuals;
} abut_response_island;

/**
 * Islands of the last step that have contacts, springs or tetrahedra, each time that they were solved. Borrowed until
 * the next [exclusive] call. [const]
 */
ABUT_API abut_status abut_response_islands(const abut_response *response, const abut_response_island **islands,
                                           size_t *count);

/** Sums over all bodies, as they are now. */
typedef struct abut_energy {
  double kinetic;
  double potential;           /**< of gravity, 0 at the origin, and of springs and tetrahedra */
  abut_vec3 linear_momentum;
  abut_vec3 angular_momentum; /**< about the origin */
} abut_energy;

/** Energy and momentum of all bodies. O(bodies). [const] */
ABUT_API abut_status abut_response_energy(const abut_response *response, abut_energy *out);

/* ------------------------------------------------------------------------------------------------
 * Telling, and bytes
 * --------------------------------------------------------------------------------------------- */

/** What will surprise whoever built a response. */
typedef uint32_t abut_response_finding_code;
enum abut_response_finding_code_value ABUT_ENUM(uint32_t) {
  ABUT_RESPONSE_FINDING_DEAD_BAND = 0,       /**< the universe has ABUT_TOLERANCE_DEAD_BAND: what rests trembles */
  ABUT_RESPONSE_FINDING_NO_TOLERANCE = 1,    /**< a geometry of a body has the tolerance 0: contacts come too late */
  ABUT_RESPONSE_FINDING_NOT_DYNAMIC = 2,     /**< the part of a body is not dynamic: it stands still */
  ABUT_RESPONSE_FINDING_ASLEEP = 3,          /**< a part has a velocity, and sleeps: no velocity wakes it */
  ABUT_RESPONSE_FINDING_NOT_FAST = 4,        /**< ABUT_RESPONSE_IMPACTS, and a geometry of a body is not fast */
  ABUT_RESPONSE_FINDING_SPECULATIVE = 5,     /**< ABUT_RESPONSE_IMPACTS, and a geometry of a body is speculative */
  ABUT_RESPONSE_FINDING_NO_IMPACTS = 6,      /**< a rule has a restitution that no step uses */
  ABUT_RESPONSE_FINDING_NO_STIFFNESS = 7,    /**< a rule has the kind penalty without k: it is rigid unless materials
                                                  are not */
  ABUT_RESPONSE_FINDING_UNUSED = 8,          /**< a rule gives a parameter that its kind does not read */
  ABUT_RESPONSE_FINDING_UNREACHABLE = 9,     /**< a rule comes after one that fits everything */
  ABUT_RESPONSE_FINDING_GONE = 10,           /**< a rule names a geometry or a part that has been destroyed */
  ABUT_RESPONSE_FINDING_SLOW_SWEEPS = 11,    /**< sweeps, and masses that differ by more than 1,000 */
  ABUT_RESPONSE_FINDING_NO_FUNCTION = 12     /**< a kind of yours came from bytes, and has no function yet */
};

typedef struct abut_response_finding {
  abut_response_finding_code code;
  uint32_t rule;             /**< where one is meant */
  abut_part_id part;         /**< null where none is meant */
  abut_geometry_id geometry; /**< null where none is meant */
  char message[168];         /**< for people; terminated, cut to what fits */
} abut_response_finding;

/**
 * Looks for what is odd, by count-then-fill; ordered by code, rule and slots. An empty answer means that nothing was
 * found. The first call makes the universe measure times, as abut_universe_explain does.
 * Complexity O(geometries of bodies + rules). [const]
 */
ABUT_API abut_status abut_response_validate(const abut_response *response, abut_response_finding *findings,
                                            size_t capacity, size_t *count);

/**
 * What steps do and how well the last one was solved, in words: options, bodies by integrator, rules, links, and each
 * island with rounds and residuals.
 * @param text      capacity bytes, always terminated when capacity > 0; null with capacity 0 asks for the size
 * @param needed    bytes of the whole text with its terminator
 * [const]
 */
ABUT_API abut_status abut_response_explain(const abut_response *response, char *text, size_t capacity, size_t *needed);

/** The same as JSON; docs/response.md lists the fields. [const] */
ABUT_API abut_status abut_response_explain_json(const abut_response *response, char *text, size_t capacity,
                                                size_t *needed);

/**
 * A response as bytes, by count-then-fill: options, bodies, particles, rules, variables, kinds by name, links, and what
 * the next step begins with. Callbacks are not in them; contacts and islands of the last step neither. The bytes begin
 * with a mark, a version and a checksum, and are the same on every machine.
 * @param bytes     capacity bytes; null with capacity 0 asks for the size
 * @param size      receives the number of bytes; nothing is written when they do not all fit
 * [const]
 */
ABUT_API abut_status abut_response_save(const abut_response *response, void *bytes, size_t capacity, size_t *size);

/**
 * Makes a response of bytes on a universe with the same ids, such as one of abut_universe_load. Steps then give the
 * same bits. Kinds of the caller get their functions by abut_response_add_kind, under their names; until then steps are
 * refused. ABUT_INVALID_ARGUMENT for bytes that are no response, or damaged. [const] on the universe.
 */
ABUT_API abut_status abut_response_load(abut_universe *universe, const void *bytes, size_t size, abut_response **out);

/** Hash of the bytes of abut_response_save: with abut_universe_hash, equal runs have equal hashes. [const] */
ABUT_API abut_status abut_response_hash(const abut_response *response, uint64_t *out);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif /* ABUT_RESPONSE_H */
