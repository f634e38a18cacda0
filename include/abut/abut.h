/* SPDX-License-Identifier: Apache-2.0 */
/*
 * abut.h - C interface of abut, a 3D collision-detection library.
 *
 * Conventions, which hold for every function unless its comment says otherwise:
 *
 *  - A function that can fail returns abut_status. It writes its out-parameters, which come last,
 *    only when it returns ABUT_OK. When it fails, nothing has changed.
 *  - Ids are plain values. A zeroed id is null. A stale id, or one of another universe, is answered
 *    with ABUT_STALE_ID and never read through.
 *  - Inputs are borrowed for the call; nothing is kept unless the comment says so.
 *  - No function throws, aborts or exits.
 *  - Right-handed frames. Metres, radians and seconds, or any other consistent units.
 *  - Coordinates and lengths of inputs are at most 1e70 in magnitude, so that nothing overflows;
 *    beyond that the answer is ABUT_OUT_OF_RANGE. Where "infinite" is allowed, infinities are.
 *  - Arrays of unknown length are filled by count-then-fill: `capacity` elements fit into the array,
 *    `count` receives how many there are; nothing past `capacity` is written. A null array with
 *    capacity 0 asks for the count only.
 *  - A batch that sets something may name an id more than once; the last value wins.
 *  - Thread rule of each function: [any] any thread at any time; [const] together with other [const]
 *    calls on the same universe, not during an [exclusive] one; [exclusive] alone on its universe, and
 *    ABUT_BUSY from a callback of it.
 *    A shape never changes while the caller holds a reference to it, so calls that only read shapes are [any].
 *  - Structs that begin with struct_size grow over time. Fill them with their _init function, which
 *    is told sizeof of the struct as the caller knows it, then change fields. A caller compiled against
 *    an older header stays valid.
 *
 * Contents, each with the name to search for:
 *
 *  - Version, status, messages: abut_status, abut_last_error_message, abut_set_log, abut_check_version
 *  - Memory: abut_set_allocator, abut_memory_in_use
 *  - Values: abut_vec3, abut_quat, abut_pose, abut_aabb, abut_part_id, abut_geometry_id, abut_feature
 *  - Shapes: abut_sphere_create to abut_box_hole_create, abut_shape_create by name, abut_shape_retain,
 *    abut_shape_release, abut_shape_cast_ray
 *  - Pairs of shapes: abut_query_options, abut_pair_distance, abut_contact, abut_pair_contacts, abut_pair_memory,
 *    abut_pair_overlaps, abut_pair_routes
 *  - Vertices on straight lines: abut_vertices_touch_faces, abut_edges_touch_edges
 *  - Elements: abut_elements_create, abut_elements_closest, abut_elements_first_touches, abut_elements_crossings
 *  - Bodies that move and turn: abut_movement, abut_pair_time_of_impact
 *  - Universe:
 *      - itself: abut_universe_create, abut_universe_destroy, abut_universe_save, abut_universe_load
 *      - parts: abut_part_create, abut_part_set_pose, abut_part_set_motion, abut_part_set_sleep
 *      - geometries: abut_geometry_create, abut_geometry_set_options, abut_geometry_park
 *      - shapes that change: abut_geometry_set_shape, abut_geometry_set_parameters, abut_geometry_set_vertices,
 *        abut_geometry_next_vertices, abut_geometry_advance
 *      - who meets whom: abut_rule_set, abut_universe_set_filter
 *      - how: abut_policy_set, abut_universe_set_focus, abut_material_pair_set
 *      - detectors of your own: abut_backend_set, abut_backend_answer
 *      - steps: abut_universe_step, abut_universe_detect_all, abut_universe_refresh
 *      - answers: abut_universe_events, abut_universe_contacts, abut_universe_stats, abut_universe_hash
 *      - explanations: abut_universe_explain, abut_universe_why_apart, abut_universe_validate
 *  - Welds: ABUT_UNIVERSE_WELDS, ABUT_QUERY_WELDS
 *  - Islands: abut_universe_follow_islands, abut_universe_islands, abut_part_island
 *  - Velocities of parts: abut_part_set_velocity, abut_part_measure_velocity, abut_part_set_acceleration
 *  - Fast geometries: ABUT_GEOMETRY_FAST, abut_universe_impacts, abut_universe_advance_to_first_impact
 *  - Self pairs: ABUT_GEOMETRY_SELF_PAIRS
 *  - Element contacts: ABUT_DETAIL_ELEMENTS, abut_universe_element_contacts
 *  - Extension libraries of a universe: abut_universe_attach, abut_universe_detach
 *  - Queries on a universe: abut_universe_cast_ray, abut_universe_cast_shape, abut_universe_overlaps,
 *    abut_universe_at_point, abut_universe_closest; abut_pair_cast
 *  - Layout report: abut_layout_at
 */
#ifndef ABUT_ABUT_H
#define ABUT_ABUT_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define ABUT_API __attribute__((visibility("default")))
#else
#define ABUT_API
#endif

/* Enumerators are names for values of the integer typedef beside them, which is the ABI type. */
#if (defined(__cplusplus) && __cplusplus >= 201103L) || \
    (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 202311L)
#define ABUT_ENUM(type) : type
#else
#define ABUT_ENUM(type)
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------
 * Version, status, messages
 * --------------------------------------------------------------------------------------------- */

/** Version of the interface that this header describes. */
#define ABUT_VERSION_MAJOR 0
#define ABUT_VERSION_MINOR 2
#define ABUT_VERSION_PATCH 0

/** Status of a call. Values never change; new ones are appended. */
typedef int32_t abut_status;
enum abut_status_value ABUT_ENUM(int32_t) {
  ABUT_OK = 0,
  ABUT_INVALID_ARGUMENT = 1,      /**< a value outside its domain that has no status of its own */
  ABUT_NULL_ARGUMENT = 2,         /**< a pointer that must not be null */
  ABUT_NOT_FINITE = 3,            /**< a NaN or an infinity */
  ABUT_OUT_OF_RANGE = 4,          /**< a number that is negative, zero or too large where it must not be */
  ABUT_ZERO_VECTOR = 5,           /**< a normal, direction or quaternion without length */
  ABUT_NOT_UNIT = 6,              /**< a quaternion whose length is off 1 by more than 1e-3 */
  ABUT_INDEX_OUT_OF_RANGE = 7,    /**< an index past the end of what it points into */
  ABUT_SIZE_OVERFLOW = 8,         /**< count times stride does not fit into memory */
  ABUT_EMPTY = 9,                 /**< a mesh, hull or field with nothing in it */
  ABUT_STALE_ID = 10,             /**< an id that is null, destroyed, or of another universe */
  ABUT_WRONG_STRUCT_SIZE = 11,    /**< struct_size is zero, too small or has an unknown non-zero tail */
  ABUT_UNKNOWN_VALUE = 12,        /**< an enumeration value, kind, flag or name that does not exist */
  ABUT_UNSUPPORTED = 13,          /**< a shape, feature, pair or algorithm that is not available */
  ABUT_NOT_CONVERGED = 14,        /**< an algorithm of another library gave up or returned nonsense */
  ABUT_OUT_OF_MEMORY = 15,        /**< nothing has changed; but a universe in a step, detection or refresh answers
                                       ABUT_INTERNAL from now on */
  ABUT_INTERNAL = 16,             /**< a defect of abut; the universe answers only this from now on, as after a step
                                       without memory */
  ABUT_BUSY = 17                  /**< an [exclusive] call from a callback of the same universe; or abut_set_allocator
                                       while memory is in use */
};

/**
 * For extension libraries: sets this thread's message and returns `status`, so that their failures
 * read like those of abut itself. `message` may be null for an empty one; it is copied and cut to
 * what fits. [any]
 */
ABUT_API abut_status abut_set_last_error(abut_status status, const char *message);

/** Name of a status, such as "ABUT_OK"; "unknown" for a number that is none. Static. [any] */
ABUT_API const char *abut_status_name(abut_status status);

/**
 * Message of the last failing call on this thread: which argument, which value, what was expected.
 * Never null; empty before the first failure. A success leaves it as it is, so ask after a status other
 * than ABUT_OK. Valid until the next abut call on this thread. For people: programs look at the status.
 * [any]
 */
ABUT_API const char *abut_last_error_message(void);

/** What a log hears: everything up to a level. */
typedef uint32_t abut_log_level;
enum abut_log_level_value ABUT_ENUM(uint32_t) {
  ABUT_LOG_NONE = 0,
  ABUT_LOG_ERROR = 1,  /**< a defect of abut, or lack of memory */
  ABUT_LOG_WARNING = 2 /**< also calls that were refused for any other reason, and what abut_universe_validate finds at
                            the first step or detection of a universe from then on */
};

/**
 * Hears one sentence, which is there during the call. It runs on the thread that made the call, and on several at once
 * where several fail. It may make [any] and [const] calls, and does not hear of their failures. It must not throw.
 */
typedef void (*abut_log)(void *context, abut_log_level level, const char *message);

/**
 * Sets what hears of failures in the whole process; null for nothing, the default. `context` is kept and handed to it.
 * Another thread may still be in the log before when this returns. Calls that succeed cost nothing. [any]
 */
ABUT_API abut_status abut_set_log(abut_log log, void *context, abut_log_level most);

/** Version of the library that was loaded, such as "0.2.0". Static. [any] */
ABUT_API const char *abut_version_string(void);

/**
 * Checks that the loaded library understands the header that the caller was compiled with; pass
 * ABUT_VERSION_MAJOR and ABUT_VERSION_MINOR. ABUT_UNSUPPORTED when it does not: below 1.0 for any other minor
 * version, since each of them may change structs and functions; from 1.0 on for later ones. [any]
 */
ABUT_API abut_status abut_check_version(uint32_t major, uint32_t minor);

/** 1 when this build contains the feature ("universe", "hull"), otherwise 0. [any] */
ABUT_API uint32_t abut_has_feature(const char *name);

/* ------------------------------------------------------------------------------------------------
 * Memory: docs/memory.md
 * --------------------------------------------------------------------------------------------- */

/**
 * Gives memory, or null where there is none. `size` is at least 1, `alignment` a power of two of at least 16. It runs
 * on any thread, on several at once. It must not throw and must not call abut.
 */
typedef void *(*abut_allocate)(void *context, size_t size, size_t alignment);

/** Takes memory back, with the size and the alignment that it was asked for. The same rules hold. */
typedef void (*abut_release)(void *context, void *memory, size_t size, size_t alignment);

/**
 * Sets where the memory of abut and of its picking library comes from in the whole process; both null for operator new,
 * the default. `context` is kept and handed to both. ABUT_BUSY while any of the memory is in use: shapes, universes and
 * pickers have to be gone. No other function of abut runs meanwhile.
 * Where memory is refused, or not aligned as asked, calls answer ABUT_OUT_OF_MEMORY. [exclusive]
 */
ABUT_API abut_status abut_set_allocator(abut_allocate allocate, abut_release release, void *context);

/** How much memory abut has, in how many blocks; exact while no other function of abut runs. [any] */
ABUT_API abut_status abut_memory_in_use(uint64_t *bytes, uint64_t *blocks);

/**
 * For extension libraries: memory from where abut has its own, and counted with it. Null where there is none, or where
 * `alignment` is no power of two. [any]
 */
ABUT_API void *abut_memory_allocate(size_t size, size_t alignment);

/** Takes it back, with the size and the alignment that it was asked for; `memory` may be null. [any] */
ABUT_API void abut_memory_release(void *memory, size_t size, size_t alignment);

/* ------------------------------------------------------------------------------------------------
 * Values
 * --------------------------------------------------------------------------------------------- */

typedef struct abut_vec3 {
  double x;
  double y;
  double z;
} abut_vec3;

/** Unit quaternion, scalar first. Lengths within 1e-3 of 1 are accepted and normalised. */
typedef struct abut_quat {
  double w;
  double x;
  double y;
  double z;
} abut_quat;

/** Maps local points p to orientation * p + position. */
typedef struct abut_pose {
  abut_vec3 position;
  abut_quat orientation;
} abut_pose;

/** Axis-aligned box. Unbounded shapes have infinite sides. */
typedef struct abut_aabb {
  abut_vec3 minimum;
  abut_vec3 maximum;
} abut_aabb;

/** A part of a universe: a rigid body, or the frame of one. */
typedef struct abut_part_id {
  uint32_t slot;       /**< one-based; 0 means null */
  uint32_t generation; /**< differs for every use of the slot and from universe to universe */
} abut_part_id;

/** A collision geometry: a shape placed on a part. */
typedef struct abut_geometry_id {
  uint32_t slot;       /**< one-based; 0 means null */
  uint32_t generation; /**< differs for every use of the slot and from universe to universe */
} abut_geometry_id;

/** What of a shape takes part in a contact or is hit by a ray. */
typedef uint32_t abut_feature_kind;
enum abut_feature_kind_value ABUT_ENUM(uint32_t) {
  ABUT_FEATURE_WHOLE = 0,  /**< no corner, edge or face is told apart, as of planes; of spheres it is the centre,
                                vertex 0 */
  ABUT_FEATURE_VERTEX = 1,
  ABUT_FEATURE_EDGE = 2,
  ABUT_FEATURE_FACE = 3,   /**< of a mesh or a height field: the triangle */
  ABUT_FEATURE_CELL = 4,   /**< of a distance field: the cell in which the surface is met */
  ABUT_FEATURE_PARTICLE = 5 /**< one of many, by its number */
};

typedef struct abut_feature {
  abut_feature_kind kind;
  uint32_t index; /**< the numbering is the shape's own and stable for the life of the shape */
} abut_feature;

/* ------------------------------------------------------------------------------------------------
 * Shapes: immutable, shared, counted; independent of any universe
 * --------------------------------------------------------------------------------------------- */

/** A shape. Created with one reference, which belongs to the caller. */
typedef struct abut_shape abut_shape;

/** Number of a kind of shape. Numbers never change their meaning; find them by name. */
typedef uint32_t abut_shape_kind;

/** How many kinds of shape this build contains. [any] */
ABUT_API size_t abut_shape_kind_count(void);

/** The kind at an index below abut_shape_kind_count; 0 past the end. [any] */
ABUT_API abut_shape_kind abut_shape_kind_at(size_t index);

/**
 * Kind of that name: "sphere", "box", "capsule", "plane", "hull", "mesh", "height_field", "point", "segment",
 * "triangle", "cylinder", "cone", "ellipsoid", "particles", "composite", "sphere_hole",
 * "cylinder_hole", "box_hole", "distance_field", "uv_grid". 0 if none in this build. docs/shapes.md lists what they
 * take. [any]
 */
ABUT_API abut_shape_kind abut_shape_kind_by_name(const char *name);

/** Name of a kind; null for a number that is none in this build. Static. [any] */
ABUT_API const char *abut_shape_kind_name(abut_shape_kind kind);

/** How many scalar parameters a kind has. 0 for a number that is no kind. [any] */
ABUT_API size_t abut_shape_kind_parameter_count(abut_shape_kind kind);

/** Name of a parameter of a kind, such as "radius"; null past the end. Static. [any] */
ABUT_API const char *abut_shape_kind_parameter_name(abut_shape_kind kind, size_t index);

/** What two shapes can be asked. */
typedef uint32_t abut_query;
enum abut_query_value ABUT_ENUM(uint32_t) {
  ABUT_QUERY_DISTANCE = 0, /**< abut_pair_distance and abut_pairs_distance */
  ABUT_QUERY_CONTACTS = 1  /**< abut_pair_contacts, and contacts in a universe */
};

/**
 * Whether two kinds of shape answer a query, in either order; docs/pairs.md is the table of it. `out` becomes 1
 * or 0. ABUT_UNKNOWN_VALUE for a number that is no kind of this build, or no query. [any]
 */
ABUT_API abut_status abut_pair_support(abut_shape_kind kind_a, abut_shape_kind kind_b, abut_query query, uint32_t *out);

/** Solid ball, centred; radius > 0. [any] */
ABUT_API abut_status abut_sphere_create(double radius, abut_shape **out);

/** Solid box, centred; half_x >= 0, half_y >= 0, half_z >= 0, zero for a flat box. [any] */
ABUT_API abut_status abut_box_create(double half_x, double half_y, double half_z, abut_shape **out);

/**
 * Solid capsule along local Z: all points within a radius of the segment from (0, 0, -half_height) to
 * (0, 0, half_height); radius > 0, half_height >= 0. [any]
 */
ABUT_API abut_status abut_capsule_create(double radius, double half_height, abut_shape **out);

/** Solid cylinder along local Z with flat ends, centred; radius >= 0, half_height >= 0. [any] */
ABUT_API abut_status abut_cylinder_create(double radius, double half_height, abut_shape **out);

/** Solid cone along local Z: base at -half_height, apex at +half_height; radius >= 0, half_height >= 0. [any] */
ABUT_API abut_status abut_cone_create(double radius, double half_height, abut_shape **out);

/** Solid ellipsoid, centred; radii along the axes: radius_x >= 0, radius_y >= 0, radius_z >= 0. [any] */
ABUT_API abut_status abut_ellipsoid_create(double radius_x, double radius_y, double radius_z, abut_shape **out);

/** The origin of its frame. [any] */
ABUT_API abut_status abut_point_create(abut_shape **out);

/** Segment along local Z from -half_length to +half_length; half_length >= 0. [any] */
ABUT_API abut_status abut_segment_create(double half_length, abut_shape **out);

/** Triangle of any three points; both of its sides stop other shapes. [any] */
ABUT_API abut_status abut_triangle_create(const abut_vec3 *a, const abut_vec3 *b, const abut_vec3 *c,
                                          abut_shape **out);

/**
 * Half-space of the points p with dot(normal, p) <= offset. `normal` points out of the solid, is of any length but
 * zero, and is normalised; the offset is measured along the unit normal. [any]
 */
ABUT_API abut_status abut_plane_create(const abut_vec3 *normal, double offset, abut_shape **out);

/**
 * Convex hull of points.
 * @param xyz          point_count * 3 numbers, copied; any finite points, also coplanar, collinear,
 *                     coincident or a single one
 * @param point_count  at least 1
 * Complexity O(n log n). Source: Qhull. [any]
 */
ABUT_API abut_status abut_hull_create(const double *xyz, size_t point_count, abut_shape **out);

/** What a hull has left of its points. Set struct_size, or use the _init function, before asking. */
typedef struct abut_hull_report {
  uint32_t struct_size;
  uint32_t dimension;    /**< 0 a point, 1 a segment, 2 a polygon, 3 a solid */
  uint64_t point_count;  /**< as given */
  uint64_t vertex_count;
  uint64_t edge_count;
  uint64_t face_count;   /**< a polygon has two, one to either side */
  double error;          /**< the largest distance of a given point from the hull; 0 when it is below rounding */
} abut_hull_report;

ABUT_API void abut_hull_report_init(abut_hull_report *report, uint32_t struct_size);

/** How a hull was simplified and the error of that, found when it was made. ABUT_UNSUPPORTED for other kinds. [any] */
ABUT_API abut_status abut_hull_describe(const abut_shape *shape, abut_hull_report *out);

/** How a triangle mesh is read. */
typedef uint32_t abut_sides;
enum abut_sides_value ABUT_ENUM(uint32_t) {
  ABUT_SIDES_BOTH = 0,  /**< a sheet: pushed out on the side where the other shape lies */
  ABUT_SIDES_FRONT = 1, /**< only the counter-clockwise side stops other shapes */
  ABUT_SIDES_SOLID = 2  /**< a solid: what it encloses is inside, and is pushed out */
};

/** By what volumes the triangles of a mesh are found. Answers are the same but for rounding. */
typedef uint32_t abut_mesh_tree;
enum abut_mesh_tree_value ABUT_ENUM(uint32_t) {
  ABUT_MESH_TREE_AUTO = 0,  /**< what is the fastest: boxes along the axes */
  ABUT_MESH_TREE_AABB = 1,  /**< boxes along the axes of the shape, eight to a node */
  ABUT_MESH_TREE_OBB = 2,   /**< boxes with axes of their own, two to a node */
  ABUT_MESH_TREE_SPHERE = 3 /**< balls, two to a node */
};

typedef struct abut_mesh_options {
  uint32_t struct_size;
  abut_sides sides;         /**< default ABUT_SIDES_BOTH */
  uint32_t corners;         /**< of a face: 3 or 4; default 3. Face i of four is triangles 2 i and 2 i + 1: its
                                 corners 0, 1, 2 and 0, 2, 3. Where its last two are one vertex, the second counts as
                                 removed */
  uint32_t merges_vertices; /**< 1: triangles share vertices that are near each other; default 0 */
  double merge_distance;    /**< how near, not negative; default 0: in the same place */
  abut_mesh_tree tree;      /**< default ABUT_MESH_TREE_AUTO. Two surfaces go down trees of boxes in any case */
  uint32_t reserved;        /**< zero */
} abut_mesh_options;

ABUT_API void abut_mesh_options_init(abut_mesh_options *options, uint32_t struct_size);

/**
 * Triangle mesh: a surface without inside, or with ABUT_SIDES_SOLID a solid. Inside is where the winding number exceeds
 * one half, so that open, repeated and wrongly wound triangles do little harm.
 * @param xyz             vertex_count * 3 numbers, copied
 * @param triangles       triangle_count * 3 indices into the vertices (of faces with four corners, 4 each),
 *                        counter-clockwise seen from the front, copied; triangles without area are kept: they are met
 *                        as segments or points, but not by rays. One that names a vertex three times counts as
 *                        removed: see abut_geometry_remove_triangles
 * @param options         may be null.
 * ABUT_INVALID_ARGUMENT for a solid that is wound inside out, which has no inside: its volume is negative about every
 * point of its box. An edit may turn one inside out later: see ABUT_FINDING_INSIDE_OUT.
 * Vertices are merged in the order of their numbers: each stays, or gives way to the nearest within the distance that
 * stayed. All keep their numbers; those that gave way belong to no triangle. Triangles keep theirs. One of which two
 * corners are one vertex counts as removed. ABUT_EMPTY where none is left.
 * Complexity O(n); its tree is built when a query first needs it, in O(n log n). [any]
 */
ABUT_API abut_status abut_mesh_create(const double *xyz, size_t vertex_count, const uint32_t *triangles,
                                      size_t triangle_count, const abut_mesh_options *options, abut_shape **out);

/** What is unusual about triangles, in numbers. Set struct_size, or use the _init function, before asking. */
typedef struct abut_mesh_report {
  uint32_t struct_size;
  uint32_t reserved;
  uint64_t triangles;           /**< that count: not removed, and not collapsed */
  uint64_t vertices;            /**< that these have */
  uint64_t merged_vertices;     /**< that gave way to another one */
  uint64_t collapsed_triangles; /**< that merging has left with fewer than three corners */
  uint64_t duplicate_vertices;  /**< in the place of one with a lower number */
  uint64_t duplicate_triangles; /**< with the vertices of one with a lower number */
  uint64_t slivers;             /**< triangles whose least height is at most a thousandth of their longest side */
  uint64_t open_edges;          /**< of one triangle: a closed surface has none */
  uint64_t non_manifold_edges;  /**< of more than two triangles */
  uint64_t reversed_triangles;  /**< the least number to be turned so that neighbours are wound alike */
  uint64_t twisted_patches;     /**< that no turning makes alike, as a Moebius strip; edges of two connect a patch */
  uint64_t components;          /**< that have no vertex in common with each other */
  double merge_error;           /**< how far a corner of a triangle has moved at most */
  double volume;                /**< enclosed by the triangles; negative where they are wound inside out. That of an
                                     open surface is the one about the centre of its box */
} abut_mesh_report;

ABUT_API void abut_mesh_report_init(abut_mesh_report *report, uint32_t struct_size);

/**
 * What is unusual about a mesh before it is made, after vertices were merged as the options say. Parameters as those of
 * abut_mesh_create. Complexity O(n log n). [any]
 */
ABUT_API abut_status abut_mesh_describe(const double *xyz, size_t vertex_count, const uint32_t *triangles,
                                        size_t triangle_count, const abut_mesh_options *options,
                                        abut_mesh_report *out);

/** An axis of the frame of a shape. */
typedef uint32_t abut_axis;
enum abut_axis_value ABUT_ENUM(uint32_t) { ABUT_AXIS_X = 0, ABUT_AXIS_Y = 1, ABUT_AXIS_Z = 2 };

/** The sides of a mesh, and the grid of cells by which its tree is made. */
typedef struct abut_uv_grid_options {
  uint32_t struct_size;
  abut_sides sides; /**< default ABUT_SIDES_BOTH */
  abut_axis axis_u; /**< the first axis across which the grid lies; default ABUT_AXIS_X */
  abut_axis axis_v; /**< the second one, another than the first; default ABUT_AXIS_Y */
  uint32_t cells_u; /**< cells along the first axis, at most 65535; default 0: about four triangles in a cell */
  uint32_t cells_v; /**< cells along the second axis, at most 2^24 with the others; default 0 */
  uint32_t corners; /**< this and the next two as those of abut_mesh_options */
  uint32_t merges_vertices;
  double merge_distance;
} abut_uv_grid_options;

ABUT_API void abut_uv_grid_options_init(abut_uv_grid_options *options, uint32_t struct_size);

/**
 * A mesh whose tree is made by a grid of cells across two axes, in a fraction of the time: terrain with bridges, caves
 * and walls. Parameters as those of abut_mesh_create.
 * @param options  may be null
 * Complexity O(n); its tree is made when a query first needs it, in O(n log n) (Kamel and Faloutsos 1993). [any]
 */
ABUT_API abut_status abut_uv_grid_create(const double *xyz, size_t vertex_count, const uint32_t *triangles,
                                         size_t triangle_count, const abut_uv_grid_options *options, abut_shape **out);

/** How the cells of a height field are split into triangles: from sample (i, j) to (i + 1, j + 1), or the other way. */
typedef uint32_t abut_diagonal;
enum abut_diagonal_value ABUT_ENUM(uint32_t) {
  ABUT_DIAGONAL_RISING = 0,     /**< from (i, j) to (i + 1, j + 1) */
  ABUT_DIAGONAL_FALLING = 1,    /**< from (i + 1, j) to (i, j + 1) */
  ABUT_DIAGONAL_ALTERNATING = 2 /**< rising where i + j is even, falling where it is odd */
};

/** What lies below a height field. */
typedef uint32_t abut_below;
enum abut_below_value ABUT_ENUM(uint32_t) {
  ABUT_BELOW_OPEN = 0, /**< nothing: what has fallen through is apart */
  ABUT_BELOW_SOLID = 1 /**< ground: what has fallen through is pushed up. Ground is below the triangles, down to a
                            level floor as far below the lowest sample as the longer side of the field. It ends in
                            vertical walls at the border and around missing samples. Walls and floor are surface
                            like the triangles, for every query */
};

/**
 * Terrain over a regular grid. Sample (i, j) is the point (i * spacing_x, j * spacing_y,
 * heights[j * columns + i]) - each cell holds two triangles. One-sided: the front is +Z. A height that is NaN makes a
 * hole: triangles with this sample are missing. At least one triangle is there.
 */
typedef struct abut_height_field_desc {
  uint32_t struct_size;
  abut_diagonal diagonal; /**< default ABUT_DIAGONAL_RISING */
  uint32_t columns;       /**< samples along X, from 2 to 65535 */
  uint32_t rows;          /**< samples along Y, from 2 to 65535; columns * rows is at most 2^30, of a solid 2^29 */
  double spacing_x;       /**< positive */
  double spacing_y;       /**< positive */
  const double *heights;  /**< columns * rows numbers or NaN, X fastest, copied */
  abut_below below;       /**< default ABUT_BELOW_OPEN */
  uint32_t reserved;      /**< zero */
} abut_height_field_desc;

ABUT_API void abut_height_field_desc_init(abut_height_field_desc *desc, uint32_t struct_size);

/** Terrain. Complexity O(samples). Source: grid cells found by division. [any] */
ABUT_API abut_status abut_height_field_create(const abut_height_field_desc *desc, abut_shape **out);

/** How values of a distance field follow from its samples. */
typedef uint32_t abut_interpolation;
enum abut_interpolation_value ABUT_ENUM(uint32_t) {
  ABUT_INTERPOLATION_LINEAR = 0,   /**< tri-linear: through all samples; gradients jump from cell to cell */
  ABUT_INTERPOLATION_QUADRATIC = 1 /**< tri-quadratic B-splines: gradients are continuous, edges become round */
};

/**
 * A solid given by its signed distance on a regular grid, negative inside. Sample (i, j, k) lies at
 * origin + (i * spacing.x, j * spacing.y, k * spacing.z) and has values[(k * rows + j) * columns + i]. Values between
 * samples are interpolated, and the solid is where they are not positive. A solid that reaches the border of the grid
 * ends there: no sample is deeper than its distance from the border. With ABUT_INTERPOLATION_QUADRATIC a field that is
 * linear stays as it is. Of a distance, a value differs from its sample by at most a quarter of the sides of a cell,
 * added up. Samples take 1.8 times the memory.
 */
typedef struct abut_distance_field_desc {
  uint32_t struct_size;
  uint32_t is_inside_out; /**< 1: a container, all that is not in the solid; default 0 */
  uint32_t columns;       /**< samples along X, from 2 to 65535 */
  uint32_t rows;          /**< samples along Y, from 2 to 65535 */
  uint32_t layers;        /**< samples along Z, from 2 to 65535 */
  abut_interpolation interpolation; /**< default ABUT_INTERPOLATION_LINEAR */
  abut_vec3 spacing;      /**< positive; default 1 */
  abut_vec3 origin;       /**< where the first sample lies */
  const double *values;   /**< columns * rows * layers numbers, X fastest, then Y, copied as single numbers */
} abut_distance_field_desc;

ABUT_API void abut_distance_field_desc_init(abut_distance_field_desc *desc, uint32_t struct_size);

/** A solid from samples of its signed distance. Complexity O(samples). [any] */
ABUT_API abut_status abut_distance_field_create(const abut_distance_field_desc *desc, abut_shape **out);

typedef struct abut_distance_field_options {
  uint32_t struct_size;
  uint32_t is_inside_out; /**< 1: a container, all that is not in the solid; default 0 */
  double spacing;         /**< of samples; default 0: a sixty-fourth of the longest side of the triangles' box */
  double band;            /**< how many cells around the surface hold samples of their own; default 3 */
  abut_interpolation interpolation; /**< default ABUT_INTERPOLATION_LINEAR */
  uint32_t reserved;      /**< zero */
} abut_distance_field_options;

ABUT_API void abut_distance_field_options_init(abut_distance_field_options *options, uint32_t struct_size);

/**
 * The solid within a mesh, as a distance field in the frame of the mesh. Inside is where the triangles wind around a
 * point by more than one half, so gaps and flipped triangles do little harm. Near the surface samples are exact. Blocks
 * of 8 x 8 x 8 cells beyond the band are interpolated between their corners.
 * @param xyz        vertex_count * 3 numbers
 * @param triangles  triangle_count * 3 indices into the vertices, counter-clockwise seen from outside
 * @param options    may be null
 * ABUT_INVALID_ARGUMENT where the triangles enclose no sample. Runs on as many threads as a universe may.
 * Source: winding numbers of Barill et al. (2018). [any]
 */
ABUT_API abut_status abut_distance_field_from_mesh(const double *xyz, size_t vertex_count, const uint32_t *triangles,
                                                   size_t triangle_count, const abut_distance_field_options *options,
                                                   abut_shape **out);

/** What is known of a distance field as a whole. Set struct_size, or use the _init function, before asking. */
typedef struct abut_distance_field_report {
  uint32_t struct_size;
  abut_interpolation interpolation;
  uint64_t block_count;      /**< of 8 x 8 x 8 cells */
  uint64_t held_block_count; /**< of these, those that hold samples; others are interpolated between their corners */
  double error;              /**< where samples are held, true distances lie from value - error to value + error */
  double far_error;          /**< the same in other blocks; 0 where there are none */
  double least_stretch;      /**< by which a lattice makes ways longer, at least; 1 without a lattice */
  double most_stretch;       /**< the same, at most */
} abut_distance_field_report;

ABUT_API void abut_distance_field_report_init(abut_distance_field_report *report, uint32_t struct_size);

/**
 * How far values of a distance field may be from the true distance. Samples have to be distances, in the frame of the
 * field: those of abut_distance_field_from_mesh are, of closed meshes with their sign. Without a lattice that frame is
 * the one of the shape. With one, a way there becomes longer by a factor from least_stretch to most_stretch.
 * ABUT_UNSUPPORTED for other kinds. Complexity O(samples / 512). [any]
 */
ABUT_API abut_status abut_distance_field_describe(const abut_shape *shape, abut_distance_field_report *out);

/**
 * Many small balls in one shape; a hash grid of its own finds those near another shape.
 * @param xyz     count * 3 numbers, the centres, copied
 * @param count   at least 1
 * @param radius  of each, positive
 * Complexity O(n); the grid is built when a query first needs it, in O(n). [any]
 */
ABUT_API abut_status abut_particles_create(const double *xyz, size_t count, double radius, abut_shape **out);

/**
 * Small balls with radii of their own.
 * @param xyz    count * 3 numbers, the centres, copied
 * @param radii  count numbers, not negative, copied
 * @param count  at least 1
 * Complexity as abut_particles_create. [any]
 */
ABUT_API abut_status abut_particles_create_with_radii(const double *xyz, const double *radii, size_t count,
                                                      abut_shape **out);

/**
 * Shapes of any kind, each at a pose of its own, as one shape. They never meet each other. Composites may be
 * children, up to 32 deep; their children count as children of this one, in order, depth first, and contacts
 * name them by that number.
 * @param children  count shapes; each is kept alive by the composite
 * @param poses     count poses in the frame of the composite, copied
 * @param count     at least 1
 * Complexity O(n), above 8 children O(n log n) for a tree. [any]
 */
ABUT_API abut_status abut_composite_create(const abut_shape *const *children, const abut_pose *poses, size_t count,
                                           abut_shape **out);

/**
 * A composite whose children have materials of their own, which contacts of a universe report in place of that of the
 * geometry.
 * @param materials  count numbers, copied; 0: that of the geometry. Children of a composite that have one keep it
 * [any]
 */
ABUT_API abut_status abut_composite_create_with_materials(const abut_shape *const *children, const abut_pose *poses,
                                                          const uint32_t *materials, size_t count, abut_shape **out);

/** A child of a composite. Children of composites in it count as its own, depth first. */
typedef struct abut_composite_child {
  abut_pose pose;     /**< in the frame of the composite */
  uint32_t material;  /**< 0: that of the geometry */
  uint32_t is_hole;   /**< 1 for a hole, which cuts the solids from number `cut_begin` on, up to before `cut_end` */
  uint32_t cut_begin; /**< 0 for solids, as the next one */
  uint32_t cut_end;
} abut_composite_child;

/**
 * Children of a composite, in the order of their numbers, by count-then-fill. ABUT_UNSUPPORTED for all other shapes.
 * Complexity O(n). [any]
 */
ABUT_API abut_status abut_composite_children(const abut_shape *shape, abut_composite_child *children, size_t capacity,
                                             size_t *count);

/**
 * The shape of a child of a composite; never a composite itself. The caller releases it.
 * ABUT_UNSUPPORTED for shapes that are no composites, ABUT_INDEX_OUT_OF_RANGE beyond the last child.
 * @param child  its number, as contacts tell it
 * Complexity O(n). [any]
 */
ABUT_API abut_status abut_composite_child_shape(const abut_shape *shape, uint32_t child, abut_shape **out);

/**
 * Cavity of the shape of a ball, centred; radius >= 0. A hole takes material from the composite that it is a child of.
 * docs/shapes.md tells what a hole does. [any]
 */
ABUT_API abut_status abut_sphere_hole_create(double radius, abut_shape **out);

/** Ends of a cylinder hole that have no wall. */
typedef uint32_t abut_open_ends;
enum abut_open_ends_value ABUT_ENUM(uint32_t) {
  ABUT_OPEN_TOP = 1,   /**< at +half_height */
  ABUT_OPEN_BOTTOM = 2 /**< at -half_height */
};

/**
 * Cavity of the shape of a cylinder along local Z, centred; radius >= 0, half_height >= 0. The hole goes on without end
 * beyond an open end. [any]
 */
ABUT_API abut_status abut_cylinder_hole_create(double radius, double half_height, abut_open_ends open_ends,
                                               abut_shape **out);

/** Faces of a box hole that have no wall. */
typedef uint32_t abut_open_faces;
enum abut_open_faces_value ABUT_ENUM(uint32_t) {
  ABUT_OPEN_X_HIGH = 1,
  ABUT_OPEN_X_LOW = 2,
  ABUT_OPEN_Y_HIGH = 4,
  ABUT_OPEN_Y_LOW = 8,
  ABUT_OPEN_Z_HIGH = 16,
  ABUT_OPEN_Z_LOW = 32
};

/**
 * Cavity of the shape of a box, centred; half_x >= 0, half_y >= 0, half_z >= 0. Faces of one axis may be open: those of
 * two are ABUT_INVALID_ARGUMENT. The hole goes on without end beyond an open face. [any]
 */
ABUT_API abut_status abut_box_hole_create(double half_x, double half_y, double half_z, abut_open_faces open_faces,
                                          abut_shape **out);

/**
 * The generic door: any kind of shape from its parameters and buffers. What each kind takes is
 * listed in docs/shapes.md.
 */
typedef struct abut_shape_desc {
  uint32_t struct_size;
  abut_shape_kind kind;
  const double *parameters; /**< parameter_count numbers, in the order of abut_shape_kind_parameter_name */
  uint64_t parameter_count;
  const double *reals;      /**< vertices (x, y, z each), heights or values; null where the kind has none */
  uint64_t real_count;      /**< how many numbers, not how many points */
  const uint32_t *indices;  /**< triangles (three each); null where the kind has none */
  uint64_t index_count;
} abut_shape_desc;

ABUT_API void abut_shape_desc_init(abut_shape_desc *desc, uint32_t struct_size);

/** Creates a shape of any kind; the named functions above are shorthands for it. [any] */
ABUT_API abut_status abut_shape_create(const abut_shape_desc *desc, abut_shape **out);

/** One more reference to a shape. Null is allowed. [any] */
ABUT_API void abut_shape_retain(abut_shape *shape);

/**
 * One reference less; the last one destroys the shape. Geometries hold references of their own. Null is allowed. [any]
 */
ABUT_API void abut_shape_release(abut_shape *shape);

/** Kind of a shape; 0 for null. [any] */
ABUT_API abut_shape_kind abut_shape_kind_of(const abut_shape *shape);

/** Parameters of a shape by count-then-fill, in the order of its kind. [any] */
ABUT_API abut_status abut_shape_parameters(const abut_shape *shape, double *parameters, size_t capacity, size_t *count);

/** Box around a shape under a pose; infinite sides for unbounded shapes. [any] */
ABUT_API abut_status abut_shape_aabb(const abut_shape *shape, const abut_pose *pose, abut_aabb *out);

/**
 * Surface of a mesh, height field, hull, box or distance field as triangles in the local frame, by count-then-fill;
 * of a mesh or a height field, triangle i is the feature (ABUT_FEATURE_FACE, i) of ray hits and contacts. Removed and
 * missing triangles have three equal corners. Those of a height field with ABUT_BELOW_SOLID close it: the floors of all
 * cells follow the triangles, walls of holes take the numbers of missing ones, and walls of the border come last;
 * the faces of boxes and hulls become several triangles each, in order. ABUT_UNSUPPORTED for
 * curved and unbounded shapes, which rays meet exactly through abut_shape_cast_ray.
 * @param xyz        vertex_capacity * 3 numbers
 * @param triangles  triangle_capacity * 3 indices
 * [any]
 */
ABUT_API abut_status abut_shape_triangles(const abut_shape *shape, double *xyz, size_t vertex_capacity,
                                          size_t *vertex_count, uint32_t *triangles, size_t triangle_capacity,
                                          size_t *triangle_count);

/**
 * Makes what queries of a shape make when they first need it, such as the tree of a mesh; of a composite, for all
 * children. So no query waits for it later. Shapes that need nothing of the kind are left as they are. Queries give the
 * same bits afterwards, for any number of threads.
 * @param threads  how many share the work: 0 for as many as there may be, as in abut_universe_options. More than 1 is
 *                 ABUT_UNSUPPORTED in a build without the feature threads
 * Complexity O(n log n). Source: binned surface area heuristic, Wald 2007. [any]
 */
ABUT_API abut_status abut_shape_prepare(const abut_shape *shape, uint32_t threads);

/** A ray. Distances are measured in world units. */
typedef struct abut_ray {
  abut_vec3 origin;
  abut_vec3 direction; /**< of any length but zero */
  double max_distance; /**< not negative; may be infinite */
} abut_ray;

typedef struct abut_ray_hit {
  double distance;      /**< from the origin, along the unit direction */
  abut_vec3 point;      /**< world frame */
  abut_vec3 normal;     /**< unit, world frame, out of the solid; of a mesh: by winding */
  abut_feature feature; /**< what was hit */
  uint32_t child;       /**< of a composite; 0 for all other shapes */
  uint32_t reserved;    /**< zero */
} abut_ray_hit;

/**
 * First crossing of a ray with the surface of a shape; a ray that starts inside meets the far side.
 * @param hit    written when *found is 1
 * @param found  receives 1 or 0
 * [any]
 */
ABUT_API abut_status abut_shape_cast_ray(const abut_shape *shape, const abut_pose *pose, const abut_ray *ray,
                                         abut_ray_hit *hit, uint32_t *found);

/* ------------------------------------------------------------------------------------------------
 * Pairs of shapes
 * --------------------------------------------------------------------------------------------- */

typedef uint32_t abut_algorithm;
enum abut_algorithm_value ABUT_ENUM(uint32_t) {
  ABUT_ALGORITHM_AUTO = 0,        /**< the fastest that keeps the error bound */
  ABUT_ALGORITHM_ANALYTIC = 1,    /**< closed forms of the pair, where it has any */
  ABUT_ALGORITHM_SAT = 2,         /**< separating axes */
  ABUT_ALGORITHM_GJK_EPA = 3,     /**< support points, our own */
  ABUT_ALGORITHM_LIBCCD_GJK = 4,  /**< libccd's GJK and EPA */
  ABUT_ALGORITHM_LIBCCD_MPR = 5,  /**< libccd's Minkowski portal refinement; overlapping pairs only */
  /* Those below are told of answers and never asked for. */
  ABUT_ALGORITHM_FLAT_GROUND = 6, /**< a surface that is flat around the other shape, taken for a half-space */
  ABUT_ALGORITHM_SEPARATING_TRANSLATION = 7, /**< the shortest translation found that parts a shape from a surface */
  ABUT_ALGORITHM_SOLID = 8,       /**< the shortest way out of a solid surface */
  ABUT_ALGORITHM_FIELD = 9,       /**< points that go down the values of a distance field */
  ABUT_ALGORITHM_HOLE = 10,       /**< the walls of a hole */
  ABUT_ALGORITHM_RIMS = 11        /**< all directions in which the overlap of round rims may be least */
};

/** Bits of the flags of queries. */
typedef uint32_t abut_query_flags;
enum abut_query_flags_value ABUT_ENUM(uint32_t) {
  ABUT_QUERY_WELDS = 1 /**< convex children of a composite without holes that lie side by side have contacts, and a
                            depth, as one shape; see the section on welds. Asks each child that has a contact where
                            another one covers it once more */
};

typedef struct abut_query_options {
  uint32_t struct_size;
  abut_algorithm algorithm; /**< default ABUT_ALGORITHM_AUTO */
  /** Allowed upper - lower of a distance, relative to the size of the shapes; 0 for the default: 1e-12, and
   * 1e-9 where a cylinder, a cone or an ellipsoid takes part. */
  double error_bound;
  double margin;            /**< contacts are reported up to this distance; default 0; may be negative */
  /** How many contacts a patch keeps: exactly the deepest, and those that span the largest area with it. Contacts whose
   * normals agree (cosine at least 0.98) form a patch, of each pair of children by itself. Two convex shapes mostly
   * have one patch. A surface has one for every way that it faces, and for every region of it: the feet of a table that
   * is a mesh are four. A gap wider than a quarter of what the contacts of a normal span is between two regions.
   * 0 keeps all; default 4. */
  uint32_t max_contacts;
  uint32_t max_pair_contacts; /**< how many all patches of the pair keep together: the deepest, then the deepest of
                                   patches that face furthest from each other; 0, the default, keeps all */
  uint32_t threads;           /**< of a batch, whose name begins with abut_pairs_: 0, the default, for as many as there
                                   may be, as in abut_universe_options; batches of few pairs take one. Results are the
                                   same bits for any number. More than 1 is ABUT_UNSUPPORTED in a build without the
                                   feature threads */
  abut_query_flags flags;     /**< of distances and contacts; default 0 */
  double time_budget;         /**< seconds for one question, by which its algorithm and its error bound are chosen; not
                                   negative; 0, the default, chooses nothing. Of distances and contacts; see
                                   abut_pair_routes */
} abut_query_options;

ABUT_API void abut_query_options_init(abut_query_options *options, uint32_t struct_size);

/** Bits of the flags of a route. */
typedef uint32_t abut_route_flags;
enum abut_route_flags_value ABUT_ENUM(uint32_t) {
  ABUT_ROUTE_CHOSEN = 1,  /**< the options take it */
  ABUT_ROUTE_IN_TIME = 2, /**< its seconds fit the time budget of the options, or that is 0 */
  ABUT_ROUTE_IN_BOUND = 4 /**< its worst error keeps the error bound of the options, or that is 0 */
};

/** A way to ask two kinds of shape, as it was measured over ordinary pairs of them. */
typedef struct abut_route {
  abut_algorithm algorithm;
  abut_route_flags flags;
  double error_bound; /**< as in abut_query_options; 0: the default one */
  double seconds;     /**< of one question, on the average; of distances half of the pairs overlap, of contacts all */
  double worst_error; /**< of upper - lower, or of the deepest contact, relative to the size of the shapes */
} abut_route;

/**
 * The measured routes of two kinds, in either order, and which of them a time budget takes, by count-then-fill:
 *  - with a time budget alone: of the routes that fit, the one with the least worst error, and the cheapest of equals;
 *    if none fits, the cheapest of all, which then has no ABUT_ROUTE_IN_TIME;
 *  - with an error bound as well: the cheapest whose worst error keeps the bound, whether or not it fits the budget.
 *    The error bound stays that of the options, and holds for each pair. If none keeps it, nothing is chosen;
 *  - without a time budget, with another algorithm than ABUT_ALGORITHM_AUTO, and for pairs without routes, nothing is
 *    chosen: the options are taken as they are.
 * Routes are there for spheres, capsules, boxes, cylinders, cones, ellipsoids and hulls of 32 points. Results depend on
 * the table of routes, which abut_routes_load renews. So two machines may give other bits where a budget is set.
 * ABUT_UNKNOWN_VALUE for a number that is no kind of this build, or no query.
 * @param options  may be null; error_bound, time_budget and algorithm count
 * [any]
 */
ABUT_API abut_status abut_pair_routes(abut_shape_kind kind_a, abut_shape_kind kind_b, abut_query query,
                                      const abut_query_options *options, abut_route *routes, size_t capacity,
                                      size_t *count);

/**
 * Puts a table of routes in place of the one that abut comes with, for all pairs of the process. `abut tune` measures a
 * machine and writes its table. Rows of kinds that this build has not are left out. ABUT_INVALID_ARGUMENT where a line
 * is wrong; the message has its number. Call it before other threads ask: no other function of abut may run.
 * @param text  may be null, for the table that abut comes with
 * [exclusive]
 */
ABUT_API abut_status abut_routes_load(const char *text);

/** Signed distance of two shapes. */
typedef struct abut_distance {
  double distance;          /**< negative: the depth by which they overlap, the least translation that parts them. On a
                               surface: the shortest one found, never too short; in a valley it is longer than the
                               deepest contact is deep */
  double lower;             /**< the true distance lies in [lower, upper], up to rounding */
  double upper;             /**< infinite where holes have left nothing of the solids that could be met */
  abut_vec3 point_a;        /**< on the surface of a, world frame */
  abut_vec3 point_b;        /**< on the surface of b, world frame */
  abut_vec3 normal;         /**< unit, from a to b; dot(point_b - point_a, normal) == distance */
  abut_algorithm algorithm; /**< what was used */
  uint32_t iterations;      /**< steps that it took */
} abut_distance;

/** Bits of the flags of a contact. */
typedef uint32_t abut_contact_flags;
enum abut_contact_flags_value ABUT_ENUM(uint32_t) {
  ABUT_CONTACT_SENSOR = 1,      /**< a geometry of the pair is a sensor: report it, do not respond to it */
  ABUT_CONTACT_SPECULATIVE = 2, /**< ahead of a touch: `toi` is above 0, or it is a contact of
                                     ABUT_GEOMETRY_SPECULATIVE that does not touch yet */
  ABUT_CONTACT_REDUCED_AWAY = 4 /**< a reduction left it out. Reserved: nothing sets it in this version */
};

/**
 * Bit of the ids of contacts that are hashed. They are hashed where children of composites, triangles of surfaces or
 * indices from 2^28 on take part. So are the ids of features that touch more than once. All other ids are packed:
 *  - bits 59 to 61 are the kind, and bits 31 to 58 the index of the feature of one shape;
 *  - bits 28 to 30 are the kind, and bits 0 to 27 the index of the feature of the other shape;
 *  - bit 62 is set.
 * Which shape comes first depends on the kinds of both.
 */
#define ABUT_CONTACT_ID_HASHED 0x8000000000000000u

/**
 * One contact point, 192 bytes. Swapping a and b swaps points and features and negates the normal. Two equal shapes at
 * one pose are the same in both orders, and so is the answer.
 * The friction frame is (tangent, cross(normal, tangent), normal): orthonormal and right-handed, and a function of the
 * normal alone, which jumps only where normal.z changes its sign. Source: Duff et al., "Building an orthonormal basis,
 * revisited" (2017).
 */
typedef struct abut_contact {
  abut_geometry_id geometry_a; /**< null in pair queries */
  abut_geometry_id geometry_b;
  uint64_t id;                 /**< unique within the pair; the same while the same features touch; packed from their
                                    kinds and indices, or hashed: ABUT_CONTACT_ID_HASHED */
  abut_feature feature_a;
  abut_feature feature_b;
  uint32_t child_a;            /**< of a composite, or else the particle; 0 for all other shapes. A particle of a child
                                    is told by the feature */
  uint32_t child_b;
  abut_vec3 point_a;           /**< on the surface of a, world frame */
  abut_vec3 point_b;           /**< on the surface of b, world frame */
  abut_vec3 normal;            /**< unit, from a to b */
  double distance;             /**< dot(point_b - point_a, normal); negative: overlapping */
  double toi;                  /**< fraction of the step before the first touch, in [0, 1]; above 0 only in pairs
                                    with ABUT_GEOMETRY_FAST */
  abut_contact_flags flags;
  uint32_t age;                /**< steps in a row before this one that reported it; 0 when it is new, and in pair
                                    queries */
  uint64_t user_data;          /**< as abut_contacts_set_user_data left it, while the contact stays; 0 when it is new */
  uint32_t material_a;         /**< of the geometries, or of children that have one of their own; 0 in pair queries.
                                    See abut_material_pair_get */
  uint32_t material_b;
  abut_vec3 tangent;           /**< unit, at right angles to the normal: the first axis of friction */
  uint64_t reserved;           /**< zero */
} abut_contact;

/**
 * Checks one record, such as one that went through a file or was made by hand:
 *  - coordinates are finite and within the limit of coordinates, `toi` lies in [0, 1], `reserved` is zero;
 *  - `normal` and `tangent` are unit and at right angles, within 1e-9;
 *  - `distance` is dot(point_b - point_a, normal), within 1e-9 of |point_a| + |point_b|, or of 1 where that is less;
 *  - kinds of features and flags are known.
 * The message names the first field that is wrong, and its value. Every contact that abut reports passes, of shapes of
 * sizes up to 10^6. [any]
 */
ABUT_API abut_status abut_contact_validate(const abut_contact *contact);

/**
 * Signed distance, closest or deepest points and normal of two shapes.
 * ABUT_UNSUPPORTED for planes against planes, for holes against what is no solid, and for an algorithm that the pair
 * does not have.
 * @param options  may be null
 * Source: GJK with signed volumes (Montanari et al. 2017), EPA (van den Bergen 2001). [any]
 */
ABUT_API abut_status abut_pair_distance(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                        const abut_pose *pose_b, const abut_query_options *options, abut_distance *out);

/**
 * The same for `count` pairs of poses of the same two shapes; the first failure ends it, nothing is written then. [any]
 */
ABUT_API abut_status abut_pairs_distance(const abut_shape *a, const abut_pose *poses_a, const abut_shape *b,
                                         const abut_pose *poses_b, size_t count, const abut_query_options *options,
                                         abut_distance *out);

/**
 * Contact points of two shapes by count-then-fill, deepest first; none when they are further apart
 * than the margin.
 * @param options  may be null
 * [any]
 */
ABUT_API abut_status abut_pair_contacts(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                        const abut_pose *pose_b, const abut_query_options *options,
                                        abut_contact *contacts, size_t capacity, size_t *count);

/**
 * What queries remember of a pair of shapes, 64 bytes of the caller: zero it before the first query, then hand it in
 * with every query of the same two shapes in the same order. It makes queries faster where the two move little:
 * - distances of hulls and triangles that are apart, from each other and from boxes, capsules, segments and balls;
 * - contacts of hulls, cylinders and cones that overlap, with each other and with boxes, capsules and segments.
 * Others gain nothing. It says where a search begins and proves nothing: with a memory of other shapes, of poses far
 * away, or with any other bytes, answers are as good as without. The last digits of distances depend on it, within the
 * error bound. Only one thread at a time may use it.
 */
typedef struct abut_pair_memory {
  uint64_t opaque[8];
} abut_pair_memory;

/** abut_pair_distance with a memory of the pair, which it updates when it succeeds. [any] */
ABUT_API abut_status abut_pair_distance_with_memory(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                                    const abut_pose *pose_b, const abut_query_options *options,
                                                    abut_pair_memory *memory, abut_distance *out);

/** abut_pairs_distance with `count` memories, one for each pair of poses. [any] */
ABUT_API abut_status abut_pairs_distance_with_memories(const abut_shape *a, const abut_pose *poses_a,
                                                       const abut_shape *b, const abut_pose *poses_b, size_t count,
                                                       const abut_query_options *options, abut_pair_memory *memories,
                                                       abut_distance *out);

/**
 * Contact points of `pair_count` pairs of poses of the same two shapes. Those of pair i are contacts[offsets[i]] up to
 * contacts[offsets[i + 1]], deepest first, and the same bits as abut_pair_contacts finds. The first failure ends it,
 * nothing is written then.
 * @param options  may be null
 * @param offsets  pair_count + 1 numbers, all written
 * @param count    the last of them; `contacts` is filled as far as `capacity`
 * [any]
 */
ABUT_API abut_status abut_pairs_contacts(const abut_shape *a, const abut_pose *poses_a, const abut_shape *b,
                                         const abut_pose *poses_b, size_t pair_count,
                                         const abut_query_options *options, uint64_t *offsets, abut_contact *contacts,
                                         size_t capacity, size_t *count);

/** abut_pair_contacts with a memory of the pair. Contacts are the same bit by bit. [any] */
ABUT_API abut_status abut_pair_contacts_with_memory(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                                    const abut_pose *pose_b, const abut_query_options *options,
                                                    abut_pair_memory *memory, abut_contact *contacts, size_t capacity,
                                                    size_t *count);

/** abut_pairs_contacts with `pair_count` memories, one for each pair of poses. [any] */
ABUT_API abut_status abut_pairs_contacts_with_memories(const abut_shape *a, const abut_pose *poses_a,
                                                       const abut_shape *b, const abut_pose *poses_b,
                                                       size_t pair_count, const abut_query_options *options,
                                                       abut_pair_memory *memories, uint64_t *offsets,
                                                       abut_contact *contacts, size_t capacity, size_t *count);

/**
 * Whether two shapes are within options.margin of each other; `out` becomes 1 or 0. With a margin of 0 that is whether
 * they overlap or touch. It ends at the first separating axis or the first common point, so it costs a fraction of a
 * distance or of contacts. Use it where depth and contacts are not needed.
 *
 * - The answer is 1 where abut_pair_distance is at most the margin. Within rounding of that (some 1e-14 of the largest
 *   coordinate; 1e-9 of the size where a cylinder, a cone or an ellipsoid takes part) it may be either; shapes that
 *   touch there mostly count as overlapping.
 * - Surfaces count from both sides, also one-sided ones, and solid surfaces with all that they enclose.
 * - Swapping a and b never changes the answer.
 * - Composites with holes, lone holes, planes against surfaces, and distance fields near their surface are answered by
 *   the distance, at the cost of that. So are margins below 0 that no radius covers, where the shapes do overlap.
 *
 * ABUT_UNSUPPORTED as for abut_pair_distance, and for an options.algorithm other than ABUT_ALGORITHM_AUTO.
 * @param options  may be null; error_bound, time_budget, max_contacts, max_pair_contacts and threads have no effect
 * Complexity: of surfaces O(log triangles) mostly. Source: Gilbert, Johnson, Keerthi 1988; separating axes (Gottschalk,
 * Lin, Manocha 1996). [any]
 */
ABUT_API abut_status abut_pair_overlaps(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                        const abut_pose *pose_b, const abut_query_options *options, uint32_t *out);

/**
 * The same for `count` pairs of shapes, each with poses of its own; a shape may be named more than once. The first
 * failure ends it, nothing is written then.
 * @param options  may be null; `threads` as for other batches
 * @param out      `count` numbers, each 1 or 0
 * [any]
 */
ABUT_API abut_status abut_pairs_overlap(const abut_shape *const *shapes_a, const abut_pose *poses_a,
                                        const abut_shape *const *shapes_b, const abut_pose *poses_b, size_t count,
                                        const abut_query_options *options, uint32_t *out);

/* ------------------------------------------------------------------------------------------------
 * Vertices on straight lines: what the triangles of meshes that deform ask about each other
 * --------------------------------------------------------------------------------------------- */

/** When two features whose vertices move on straight lines first touch. Time runs from 0 to 1. */
typedef struct abut_first_touch {
  uint32_t touches;  /**< 1 or 0 */
  uint32_t reserved; /**< zero */
  double lower;      /**< before it nothing touches; 0 where nothing does */
  double upper;      /**< by then they have touched; 0 where nothing does */
} abut_first_touch;

/**
 * When vertices first touch faces, for `count` of both. Each of the four vertices moves from its place in `start`, at
 * time 0, to its place in `end`, at time 1, at a constant speed.
 *
 * With a separation of 0 the answer is exact. It is that of the numbers as they are, without any tolerance. A face
 * holds its edges and corners, and shapes that come to one point touch. Faces without area and features that do not
 * move are allowed. upper - lower is at most 1e-9.
 *
 * With a separation above 0 features touch that come as near as that. At `upper` they are no farther apart than
 * separation + tolerance, and what is not decided by then counts as a touch.
 *
 * The first wrong number ends it, and nothing is written then.
 * @param start       count * 12 numbers: the vertex, then the three corners of the face
 * @param end         count * 12 numbers, in the same order
 * @param separation  not negative
 * @param tolerance   above 0; only read where separation is above 0
 * @param out         count answers
 * Complexity: 0.1 microseconds for most, up to a millisecond where exact numbers have to decide.
 * Source: docs/deforming.md. [any]
 */
ABUT_API abut_status abut_vertices_touch_faces(const double *start, const double *end, size_t count, double separation,
                                               double tolerance, abut_first_touch *out);

/**
 * The same for pairs of edges: 12 numbers each, the two ends of one edge, then those of the other. [any]
 */
ABUT_API abut_status abut_edges_touch_edges(const double *start, const double *end, size_t count, double separation,
                                            double tolerance, abut_first_touch *out);

/* ------------------------------------------------------------------------------------------------
 * Elements: what is near, touches or crosses in meshes that deform. docs/deformables.md
 * --------------------------------------------------------------------------------------------- */

/**
 * The vertices, edges and faces of a mesh whose vertices move, a tree around them, and the memory of its searches. Only
 * one thread at a time may use it. A build without the feature "deforming" answers ABUT_UNSUPPORTED to all functions
 * of this section, but for abut_elements_options_init.
 */
typedef struct abut_elements abut_elements;

/**
 * Elements of the surface of a shape that has triangles: see abut_shape_triangles. Vertices and faces have the numbers
 * that they have there. Edges are numbered in the order of their ends. A triangle that names a vertex twice is an edge
 * without a face. Later the shape may be released.
 *
 * The vertices rest where the shape has them, and also begin there, in the frame of the shape.
 * ABUT_UNSUPPORTED for shapes without triangles, ABUT_OUT_OF_RANGE for coordinates beyond 1e50.
 * Complexity O(n log n); of 92,000 triangles some 0.2 s. [any]
 */
ABUT_API abut_status abut_elements_create(const abut_shape *shape, abut_elements **out);

/** Null is allowed. [any] */
ABUT_API void abut_elements_destroy(abut_elements *elements);

/** How many elements there are. */
typedef struct abut_element_counts {
  uint64_t vertices;  /**< of the shape, also those without triangles */
  uint64_t edges;
  uint64_t triangles; /**< numbers of faces are below that */
  uint64_t faces;     /**< triangles that have three different vertices */
} abut_element_counts;

/** How many elements there are. [any] */
ABUT_API abut_status abut_elements_count(const abut_elements *elements, abut_element_counts *out);

/**
 * The ends of all edges, the lower number first, by count-then-fill.
 * @param vertices  capacity * 2 numbers
 * @param count     of edges
 * [any]
 */
ABUT_API abut_status abut_elements_edges(const abut_elements *elements, uint32_t *vertices, size_t capacity,
                                         size_t *count);

/**
 * Where the vertices are: at the start of a step, and at its end. Between the two they move on straight lines.
 * @param start         vertex_count * 3 numbers, copied, at most 1e50 in magnitude
 * @param end           vertex_count * 3 numbers of the end, likewise; may be null: nothing moves
 * @param vertex_count  as many as there are, else ABUT_INVALID_ARGUMENT
 * The tree keeps the form that it has from the rest shape. Its boxes are fitted by the next search, at 3 ms for 92,000
 * triangles. Complexity O(n). [any]
 */
ABUT_API abut_status abut_elements_set_vertices(abut_elements *elements, const double *start, const double *end,
                                                size_t vertex_count);

/** Which closest features abut_elements_closest tells. SOFA's names are in brackets. */
typedef uint32_t abut_closest_method;
enum abut_closest_method_value ABUT_ENUM(uint32_t) {
  ABUT_CLOSEST_FEATURES = 0,    /**< of a vertex each feature in whose Voronoi region it is, once; and pairs of edges */
  ABUT_CLOSEST_OF_FACES = 1,    /**< what is nearest of two faces, once for all faces around it (ProximityIntersection).
                                     Faces that share a vertex are no pair, and edges without faces have none */
  ABUT_CLOSEST_ALL = 2,         /**< all closest features of a vertex and a face, once; and pairs of edges
                                     (MinProximityIntersection) */
  ABUT_CLOSEST_OF_VERTICES = 3, /**< of a vertex the nearest feature; pairs of edges only if `kinds` asks for them
                                     (NewProximityIntersection) */
  ABUT_CLOSEST_LOCAL_MINIMA = 4 /**< those of ABUT_CLOSEST_FEATURES where both features lie in the other one's cone of
                                     directions (LocalMinDistance) */
};

/** Which features a stencil is of. */
typedef uint32_t abut_stencil_kind;
enum abut_stencil_kind_value ABUT_ENUM(uint32_t) {
  ABUT_STENCIL_VERTEX_FACE = 0,
  ABUT_STENCIL_EDGE_EDGE = 1,
  ABUT_STENCIL_VERTEX_EDGE = 2,
  ABUT_STENCIL_VERTEX_VERTEX = 3
};

/** Sets of kinds of stencils: bit k stands for kind k. */
typedef uint32_t abut_stencil_kinds;

/** Bits of the flags of abut_elements_options. */
typedef uint32_t abut_elements_flags;
enum abut_elements_flags_value ABUT_ENUM(uint32_t) {
  ABUT_ELEMENTS_FRONTS_ONLY = 1 /**< ABUT_CLOSEST_LOCAL_MINIMA: what lies behind a feature is left out */
};

/** What a search of elements looks for. */
typedef struct abut_elements_options {
  uint32_t struct_size;
  abut_closest_method method; /**< of abut_elements_closest; default ABUT_CLOSEST_FEATURES */
  abut_stencil_kinds kinds;   /**< which are told; default 0: those of the method */
  abut_elements_flags flags;  /**< default 0 */
  uint32_t threads;           /**< default 0: as many as there may be. Answers are the same bits for any number */
  uint32_t reserved;          /**< zero */
  double reach;               /**< how near, not negative; default 0. Of first touches: the separation */
  double tolerance;           /**< of first touches with a reach above 0: see abut_vertices_touch_faces; default 1e-9 */
  double rest_distance;       /**< of a mesh with itself: elements that were nearer than this in the rest shape are left
                                   out; default 0: none. With `reach`, or a bit more, neighbours are no contacts */
  double cone_angle;          /**< ABUT_CLOSEST_LOCAL_MINIMA: a cosine by which cones are wider, in [0, 1]; default 0 */
  double cone_factor;         /**< the same: how much of the cosine of a slope is added, in [0, 1]; default 0.5 */
} abut_elements_options;

ABUT_API void abut_elements_options_init(abut_elements_options *options, uint32_t struct_size);

/**
 * Up to four vertices of two features that are near each other, 104 bytes. The sum of weights times places of vertices
 * is the way from the point of a to that of b. So it is distance * normal, and the gradient of the distance with
 * respect to vertex i is weights[i] * normal. (kind, of_a, element_a, element_b) is unique in a list.
 */
typedef struct abut_stencil {
  abut_stencil_kind kind;
  uint32_t of_a;        /**< so many vertices are of a, the first ones; the others are of b */
  uint32_t element_a;   /**< the number of the vertex, edge or face of a */
  uint32_t element_b;
  uint32_t vertices[4]; /**< in the order of the mesh; those that a kind does not have repeat the last one */
  double weights[4];    /**< of a negative with the sum -1, of b positive with the sum 1; of repeated vertices 0 */
  abut_vec3 normal;     /**< unit, from a to b. At distance 0 across the face or both edges; of first touches against
                             the motion */
  double distance;      /**< not negative */
  double toi;           /**< of first touches: the time, as a fraction of the step, before which they do not touch; else
                             0 */
} abut_stencil;

/** Two features whose boxes come near each other. */
typedef uint32_t abut_element_pair_kind;
enum abut_element_pair_kind_value ABUT_ENUM(uint32_t) {
  ABUT_ELEMENT_PAIR_VERTEX_FACE = 0,
  ABUT_ELEMENT_PAIR_EDGE_EDGE = 1,
  ABUT_ELEMENT_PAIR_FACE_VERTEX = 2 /**< of two meshes: a face of a and a vertex of b */
};

typedef struct abut_element_pair {
  abut_element_pair_kind kind;
  uint32_t a; /**< the number of the vertex, edge or face of a */
  uint32_t b;
} abut_element_pair;

/** An edge that passes a face. */
typedef struct abut_crossing {
  uint32_t edge;
  uint32_t face;
  uint32_t edge_is_of_b; /**< 1: the edge is of b and the face of a; 0 of a mesh with itself */
  uint32_t reserved;     /**< zero */
  double share;          /**< of the way from the lower end of the edge */
  abut_vec3 point;
} abut_crossing;

/*
 * Searches of a mesh with itself, where b is null or a, and of two meshes in one frame. Each pair of features occurs
 * once; features of one mesh that share a vertex are no pair. Arrays are filled by count-then-fill. Each call searches:
 * so hand in an array of the size of the last answer, and ask again where `count` exceeds it.
 */

/**
 * Pairs of a vertex and a face, and of two edges, whose boxes come within options->reach of each other. The boxes hold
 * the features from start to end. This is for solvers with tests of their own. Kinds other than
 * ABUT_STENCIL_VERTEX_FACE and ABUT_STENCIL_EDGE_EDGE are ABUT_INVALID_ARGUMENT. The order is that of the tree: the
 * same for the same input.
 * @param b        may be null
 * @param options  may be null
 * Complexity: 60 million pairs a second on one thread. [any]
 */
ABUT_API abut_status abut_elements_candidates(abut_elements *a, abut_elements *b, const abut_elements_options *options,
                                              abut_element_pair *pairs, size_t capacity, size_t *count);

/**
 * Closest features within options->reach, where the vertices are at the start. Vertices of a come first, in the order
 * of their numbers, those of one vertex by distance. Then come vertices of b with edges and faces of a, then pairs of
 * edges by their numbers. Two vertices are told once: of one mesh the lower number is first. ABUT_CLOSEST_FEATURES,
 * ABUT_CLOSEST_ALL and ABUT_CLOSEST_OF_VERTICES tell of each vertex the feature that is nearest.
 * @param b        may be null
 * @param options  may be null
 * Complexity: candidates at 15 million a second on one thread, plus k log k for the k features near a vertex. Source:
 * docs/deformables.md. [any]
 */
ABUT_API abut_status abut_elements_closest(abut_elements *a, abut_elements *b, const abut_elements_options *options,
                                           abut_stencil *stencils, size_t capacity, size_t *count);

/**
 * What first touches on the way from start to end: each pair of a vertex and a face, and of two edges, that does, as it
 * lies then. With a reach of 0 whether they touch is exact, as abut_vertices_touch_faces tells; with a reach above 0
 * they touch where they come as near as that. Kinds as for abut_elements_candidates. Sorted by kind, then by whose the
 * vertex is, then by numbers.
 * @param b        may be null
 * @param options  may be null
 * Complexity: candidates at 9 million a second on one thread. [any]
 */
ABUT_API abut_status abut_elements_first_touches(abut_elements *a, abut_elements *b,
                                                 const abut_elements_options *options, abut_stencil *stencils,
                                                 size_t capacity, size_t *count);

/**
 * Edges that pass faces where the vertices are at the start, exactly: what is to be free of intersections has none. An
 * edge that touches a face counts. Of `options` only `threads` is read. Edges of a come first, each by its number.
 * @param b        may be null
 * @param options  may be null
 * Complexity: as abut_elements_first_touches. [any]
 */
ABUT_API abut_status abut_elements_crossings(abut_elements *a, abut_elements *b, const abut_elements_options *options,
                                             abut_crossing *crossings, size_t capacity, size_t *count);

/* ------------------------------------------------------------------------------------------------
 * Bodies that move and turn: when two of them first touch
 * --------------------------------------------------------------------------------------------- */

/**
 * How a body moves, in the world, by the unit of time. After a time t its centre has moved by
 * velocity * t + acceleration * t^2 / 2. It has turned by the rotation whose axis times angle is
 * angular_velocity * t + angular_acceleration * t^2 / 2.
 */
typedef struct abut_movement {
  abut_vec3 velocity;
  abut_vec3 angular_velocity; /**< radians */
  abut_vec3 acceleration;
  abut_vec3 angular_acceleration;
  abut_vec3 centre; /**< the point around which it turns, in the frame of the shape */
} abut_movement;

/**
 * The motion that leads from one pose to another: the centre on a straight line with constant speed, and a turn around
 * a fixed axis with constant speed, by the shorter way.
 * @param centre    in the frame of the shape
 * @param duration  above 0
 * [any]
 */
ABUT_API abut_status abut_movement_between(const abut_pose *start, const abut_pose *end, const abut_vec3 *centre,
                                           double duration, abut_movement *out);

typedef uint32_t abut_impact_state;
enum abut_impact_state_value ABUT_ENUM(uint32_t) {
  ABUT_IMPACT_APART = 0,           /**< they do not touch within the time */
  ABUT_IMPACT_TOUCHES = 1,         /**< they come to touch */
  ABUT_IMPACT_STARTS_TOGETHER = 2, /**< they touch at the start */
  ABUT_IMPACT_UNDECIDED = 3        /**< apart before `lower`; what comes then is not proven */
};

/** Options of times of impact. Fill with abut_impact_options_init, then change fields. */
typedef struct abut_impact_options {
  uint32_t struct_size;
  uint32_t most_rounds; /**< of the search, for each two convex parts; default 1024 */
  double tolerance;     /**< of the distance at `upper`; default 0: 1e-12 of the size of the shapes */
  double margin;        /**< they touch when they come as near as this; not negative, default 0 */
  uint32_t threads;     /**< of a batch, as in abut_query_options */
  uint32_t reserved;    /**< zero */
} abut_impact_options;

ABUT_API void abut_impact_options_init(abut_impact_options *options, uint32_t struct_size);

/**
 * When two shapes first touch. Before `lower` they are further apart than the margin, proven with rounding. At `upper`
 * they are no further apart than margin + tolerance. `upper` is the duration where it is undecided. Where shapes stay
 * apart, both are the duration. Less may be proven of distance fields and holes: `lower` may be too early then.
 */
typedef struct abut_impact {
  abut_impact_state state;
  uint32_t rounds;       /**< how many the search took */
  double lower;
  double upper;
  abut_distance contact; /**< at `upper`, in the world; zeros unless they touch */
  uint32_t child_a;      /**< of a composite, or the particle; 0 for all other shapes */
  uint32_t child_b;
} abut_impact;

/**
 * When two shapes that move and turn first touch, from time 0 to `duration`. Shapes that are less apart than the
 * tolerance at the start start together. Meshes with ABUT_SIDES_FRONT and height fields let through what comes from
 * behind. Within the tolerance of their front a body starts together with them only where it moves into them.
 *
 * ABUT_OUT_OF_RANGE for a motion of more than 16 revolutions within the duration. ABUT_UNSUPPORTED for pairs that have
 * no distance, and in a build without the feature motion.
 * @param duration  above 0
 * @param options   may be null
 * Complexity: some ten distances of two convex shapes; of meshes those of all triangles that are near each other.
 * Source: docs/continuous.md. [any]
 */
ABUT_API abut_status abut_pair_time_of_impact(const abut_shape *a, const abut_pose *pose_a,
                                              const abut_movement *movement_a, const abut_shape *b,
                                              const abut_pose *pose_b, const abut_movement *movement_b,
                                              double duration, const abut_impact_options *options, abut_impact *out);

/**
 * The same for `count` pairs of poses and motions of the same two shapes. The first failure ends it, nothing is written
 * then. [any]
 */
ABUT_API abut_status abut_pairs_time_of_impact(const abut_shape *a, const abut_pose *poses_a,
                                               const abut_movement *movements_a, const abut_shape *b,
                                               const abut_pose *poses_b, const abut_movement *movements_b,
                                               size_t count, double duration,
                                               const abut_impact_options *options, abut_impact *out);

/* ------------------------------------------------------------------------------------------------
 * Universe
 *
 * A build without the feature "universe" answers ABUT_UNSUPPORTED to all functions that take an abut_universe.
 * --------------------------------------------------------------------------------------------- */

/** A space in which parts meet. Owned by its creator. */
typedef struct abut_universe abut_universe;

typedef uint32_t abut_broadphase;
enum abut_broadphase_value ABUT_ENUM(uint32_t) {
  ABUT_BROADPHASE_AUTO = 0,
  ABUT_BROADPHASE_BRUTE = 1,           /**< every pair of boxes; for a few dozen geometries */
  ABUT_BROADPHASE_TREE = 2,            /**< dynamic box trees, one of what moves and one of what does not */
  ABUT_BROADPHASE_SWEEP_AND_PRUNE = 3, /**< sorted ends on three axes, kept from step to step */
  ABUT_BROADPHASE_HASH_GRID = 4        /**< grids of cells, each four times as coarse as the one before; for many
                                            boxes of about one size */
};

typedef uint32_t abut_tolerance_mode;
enum abut_tolerance_mode_value ABUT_ENUM(uint32_t) {
  ABUT_TOLERANCE_DEAD_BAND = 0, /**< an overlap is reported when it exceeds the tolerance */
  ABUT_TOLERANCE_MARGIN = 1     /**< a separation is reported when it is below the tolerance */
};

/** Which events a step writes down. */
typedef uint32_t abut_event_bits;
enum abut_event_bits_value ABUT_ENUM(uint32_t) {
  ABUT_EVENTS_PAIRS = 1,   /**< pairs that begin and end to touch */
  ABUT_EVENTS_PERSIST = 2, /**< also those that still touch */
  ABUT_EVENTS_CONTACTS = 4, /**< the same of each contact */
  ABUT_EVENTS_ELEMENTS = 8  /**< the same of each element contact */
};

/** Bits of the flags of a universe. */
typedef uint32_t abut_universe_flags;
enum abut_universe_flags_value ABUT_ENUM(uint32_t) {
  ABUT_UNIVERSE_LOCAL_POINTS = 1, /**< keeps what abut_universe_local_points lends; steps of many contacts take an
                                      eighth longer */
  ABUT_UNIVERSE_WELDS = 2 /**< static and animated geometries that are convex or half-spaces, and surfaces beside them,
                               have contacts as one shape where they lie side by side; so have convex children of a
                               composite without holes. A body that slides over a floor of boxes meets no walls
                               between them. See the section on welds. Steps look at each body that touches two such
                               geometries */
};

typedef struct abut_universe_options {
  uint32_t struct_size;
  abut_broadphase broadphase;         /**< default ABUT_BROADPHASE_AUTO */
  abut_tolerance_mode tolerance_mode; /**< default ABUT_TOLERANCE_DEAD_BAND */
  uint32_t max_contacts;              /**< of a patch: points that hold it and stay from step to step. The deepest
                                           contact of a patch is always kept: it is one more where it is none of
                                           them, unless this is 1; 0 keeps all; default 4 */
  abut_vec3 origin;                   /**< boxes of the broad phase are stored relative to it; default 0 */
  uint32_t threads;                   /**< of a step; 0: as many as there may be; the most are those that the machine
                                           runs at once, or that the process allows oneTBB; default 1. Results are
                                           the same bits for any number. More than 1 is ABUT_UNSUPPORTED in a
                                           build without the feature threads */
  abut_event_bits events;             /**< which events steps write down; default ABUT_EVENTS_PAIRS |
                                           ABUT_EVENTS_PERSIST */
  abut_universe_flags flags;          /**< default 0 */
  uint32_t max_pair_contacts;         /**< of all patches of a pair, as in abut_query_options; 0, the default, keeps
                                           all */
} abut_universe_options;

ABUT_API void abut_universe_options_init(abut_universe_options *options, uint32_t struct_size);

/** Creates a universe; the caller frees it with abut_universe_destroy. `options` may be null. [any] */
ABUT_API abut_status abut_universe_create(const abut_universe_options *options, abut_universe **out);

/**
 * Destroys a universe and everything in it. Null is allowed. From a callback of the universe it does nothing. Where
 * objects of extension libraries stand on it (abut_universe_attach), such as pickers, it goes with the last of them; no
 * other call may name it from now on. [exclusive]
 */
ABUT_API void abut_universe_destroy(abut_universe *universe);

/**
 * A universe as bytes, by count-then-fill: for files, for other machines, and for going back. In them are
 *  - options, parts, geometries and shapes, rules, policies, materials, the focus;
 *  - what steps keep: contacts with ages and values of yours, events, islands, sleep, velocities;
 *  - changes that no step has seen yet.
 * The filter, the back end and their contexts, statistics and attached extension libraries are not.
 * The bytes are the same on every machine. They begin with a mark, a version and a checksum.
 * ABUT_BUSY from a callback. Complexity O(everything). [const]
 * @param bytes     capacity bytes; null with capacity 0 asks for the size
 * @param size      receives the number of bytes; nothing is written when they do not all fit
 */
ABUT_API abut_status abut_universe_save(const abut_universe *universe, void *bytes, size_t capacity, size_t *size);

/**
 * Makes a universe of the bytes of another one; the caller frees it with abut_universe_destroy.
 *  - All ids name what they named there, new ones are those that the other universe would give out next, and steps give
 *    the same bits. Shapes that were shared are shared.
 *  - A filter has to be set again; all pairs are then asked about. Until then its answers stay.
 *  - A back end has to be set again. Until then abut answers its pairs.
 *  - Numbers of threads are as they were.
 * ABUT_UNSUPPORTED for bytes of another version of their format, or with kinds of shape that this build has not.
 * ABUT_INVALID_ARGUMENT, or the status that a call with the same value would have, for bytes that are cut off, changed,
 * or made up. The message tells what is wrong.
 * Complexity O(everything). [any]
 */
ABUT_API abut_status abut_universe_load(const void *bytes, size_t size, abut_universe **out);

/** How a part moves. Pairs of parts of which neither is dynamic are never examined. */
typedef uint32_t abut_motion;
enum abut_motion_value ABUT_ENUM(uint32_t) {
  ABUT_MOTION_DYNAMIC = 0,
  ABUT_MOTION_ANIMATED = 1, /**< moved by a script; meets dynamic parts only */
  ABUT_MOTION_STATIC = 2    /**< does not move; meets dynamic parts only. Setting its pose is allowed, and slower */
};

typedef struct abut_part_options {
  uint32_t struct_size;
  abut_motion motion;  /**< default ABUT_MOTION_DYNAMIC */
  abut_pose pose;      /**< default identity */
  uint64_t user_data;  /**< yours; default 0 */
} abut_part_options;

ABUT_API void abut_part_options_init(abut_part_options *options, uint32_t struct_size);

/** Creates a part. `options` may be null. Geometries of one part never collide with each other. [exclusive] */
ABUT_API abut_status abut_part_create(abut_universe *universe, const abut_part_options *options, abut_part_id *out);

/** Creates `count` parts, all or none; `options` is an array of `count`. [exclusive] */
ABUT_API abut_status abut_parts_create(abut_universe *universe, const abut_part_options *options, size_t count,
                                       abut_part_id *out);

/** Destroys a part and its geometries. [exclusive] */
ABUT_API abut_status abut_part_destroy(abut_universe *universe, abut_part_id part);

/** Destroys `count` parts, all or none; an id that occurs twice is stale the second time. [exclusive] */
ABUT_API abut_status abut_parts_destroy(abut_universe *universe, const abut_part_id *parts, size_t count);

/** Places a part; takes effect for pairs at the next step. [exclusive] */
ABUT_API abut_status abut_part_set_pose(abut_universe *universe, abut_part_id part, const abut_pose *pose);

/** Places `count` parts, all or none. [exclusive] */
ABUT_API abut_status abut_parts_set_poses(abut_universe *universe, const abut_part_id *parts, const abut_pose *poses,
                                          size_t count);

/** Pose of a part. [const] */
ABUT_API abut_status abut_part_pose(const abut_universe *universe, abut_part_id part, abut_pose *out);

/** Poses of `count` parts. [const] */
ABUT_API abut_status abut_parts_poses(const abut_universe *universe, const abut_part_id *parts, size_t count,
                                      abut_pose *out);

/** How a part moves, for a part that exists; takes effect at the next step. [exclusive] */
ABUT_API abut_status abut_part_set_motion(abut_universe *universe, abut_part_id part, abut_motion motion);

/** The same for `count` parts, all or none. [exclusive] */
ABUT_API abut_status abut_parts_set_motions(abut_universe *universe, const abut_part_id *parts,
                                            const abut_motion *motions, size_t count);

/** How a part moves. [const] */
ABUT_API abut_status abut_part_motion(const abut_universe *universe, abut_part_id part, abut_motion *out);

/** Your value on a part. [const] */
ABUT_API abut_status abut_part_user_data(const abut_universe *universe, abut_part_id part, uint64_t *out);

/** Puts a value of yours on a part, and changes nothing else: no pair is asked again, no part wakes. [exclusive] */
ABUT_API abut_status abut_part_set_user_data(abut_universe *universe, abut_part_id part, uint64_t user_data);

/** The same for `count` parts, all or none. [exclusive] */
ABUT_API abut_status abut_parts_set_user_data(abut_universe *universe, const abut_part_id *parts,
                                              const uint64_t *user_data, size_t count);

/** Geometries of a part by count-then-fill, in order of creation. [const] */
ABUT_API abut_status abut_part_geometries(const abut_universe *universe, abut_part_id part,
                                          abut_geometry_id *geometries, size_t capacity, size_t *count);

/**
 * When a part has come to rest. It is calm in a step when its speeds and accelerations are at most these; they follow
 * from its poses in this step and the two before. Zeros: it has to stand still.
 */
typedef struct abut_sleep {
  uint32_t struct_size;
  uint32_t steps;              /**< at least 1: calm ones in a row; default 10 */
  double linear_speed;         /**< of the origin of the part; default 0.14 */
  double linear_acceleration;  /**< default 0.045 */
  double angular_speed;        /**< in radians; default 0.03 */
  double angular_acceleration; /**< default 0.045 */
} abut_sleep;

ABUT_API void abut_sleep_init(abut_sleep *sleep, uint32_t struct_size);

/**
 * Lets a part fall asleep. `sleep` may be null: it never does by itself, which is the default. Dynamic parts that touch
 * fall asleep together, in the step in which each of them has been calm for its steps. They stay awake while one of
 * their touches begins or ends. They also do while one of them never sleeps, or an animated or static part that they
 * touch has moved. Only abut_universe_step with dt above 0 measures, counts and sends to sleep. A sleeping part wakes
 * in the next step or detection, with all dynamic parts that it touches, directly or through others, when
 *  - its pose changes in any way, or its motion, its thresholds, or the geometries that it has, their shapes or
 *  options;
 *  - the surface of an animated or static part changes where its box reaches;
 *  - a touch of it begins or ends, by moving, parking, destruction, filters or anything else: removing a support wakes
 *  what it carried;
 *  - an animated or static part that it touches moves, or changes its motion or geometries;
 *  - abut_part_wake says so.
 * Touches of sensors and of pairs whose policy wants no contacts count for nothing. Sleep changes no contact:
 * detections cover sleeping parts like any others. It tells the caller what need not be simulated.
 * Complexity of a step O(parts that may sleep + pairs). [exclusive]
 */
ABUT_API abut_status abut_part_set_sleep(abut_universe *universe, abut_part_id part, const abut_sleep *sleep);

/** The same for `count` parts, all or none; `sleeps` is an array of `count`, or null. [exclusive] */
ABUT_API abut_status abut_parts_set_sleep(abut_universe *universe, const abut_part_id *parts, const abut_sleep *sleeps,
                                          size_t count);

/** Whether a part slept at the end of the last step or detection; `out` becomes 1 or 0. [const] */
ABUT_API abut_status abut_part_is_asleep(const abut_universe *universe, abut_part_id part, uint32_t *out);

/** Wakes a part at the next step or detection; its calm steps are counted anew, whether it slept or not. [exclusive] */
ABUT_API abut_status abut_part_wake(abut_universe *universe, abut_part_id part);

/** The same for `count` parts, all or none. [exclusive] */
ABUT_API abut_status abut_parts_wake(abut_universe *universe, const abut_part_id *parts, size_t count);

/**
 * Whether a geometry takes part. A parked one is in no contact, event or query; it can be moved, reshaped and
 * destroyed. Its contacts end with the next step, and coming back into an overlap is a new begin.
 */
typedef uint32_t abut_parking;
enum abut_parking_value ABUT_ENUM(uint32_t) {
  ABUT_PARKING_NONE = 0,
  ABUT_PARKING_SHORT_TERM = 1, /**< keeps its place in the broad phase: parking and coming back are quick */
  ABUT_PARKING_LONG_TERM = 2   /**< leaves the broad phase: a step costs nothing for it, coming back costs an
                                    insertion */
};

/** Bits of the flags of a geometry. */
typedef uint32_t abut_geometry_flags;
enum abut_geometry_flags_value ABUT_ENUM(uint32_t) {
  ABUT_GEOMETRY_SENSOR = 1,    /**< its contacts carry ABUT_CONTACT_SENSOR */
  ABUT_GEOMETRY_SELF_PAIRS = 2, /**< it meets itself; see the section on self pairs */
  ABUT_GEOMETRY_FAST = 4,       /**< steps with time follow its path, so that it passes through nothing; see the
                                     section on fast geometries. ABUT_UNSUPPORTED in a build without the feature
                                     motion */
  ABUT_GEOMETRY_SPECULATIVE = 8, /**< steps with time report contacts as far away as its motion may close; not
                                      together with ABUT_GEOMETRY_FAST. ABUT_UNSUPPORTED as that */
  ABUT_GEOMETRY_KEEPS_SIDE = 16  /**< pairs of a convex shape and a surface that is no solid, of which either has this
                                      flag, remember from which side of the surface the shape came. While the two
                                      touch, depth and normal lead back to that side, also after the centre of the
                                      shape has passed the surface. So do particles, and children of composites
                                      without holes, each by itself. Takes O(triangles that are touched) per pair */
};

/**
 * Two geometries are examined when all of this holds, in this order: they are on different parts, of which one is
 * dynamic; neither is parked; they have no exclusion bit in common; each one's layers meet the other one's mask; the
 * most specific rule does not disable the pair (abut_rule_set); the filter keeps it (abut_universe_set_filter).
 */
typedef struct abut_geometry_options {
  uint32_t struct_size;
  abut_geometry_flags flags; /**< default 0 */
  abut_pose pose;            /**< in the frame of the part; default identity */
  double tolerance;          /**< not negative; the tolerance of a pair is the sum of both; default 0 */
  uint64_t user_data;        /**< yours; default 0 */
  uint64_t layers;           /**< what it is, as bits of your meaning; default 1 */
  uint64_t mask;             /**< the layers that it meets; default all */
  uint64_t exclusion;        /**< geometries that have a bit in common never meet; default 0 */
  uint32_t label;            /**< for rules; default 0 */
  uint32_t tag;              /**< for policies, below 64; default 0 */
  uint32_t material;         /**< carried to its contacts; default 0 */
  abut_parking parking;      /**< default ABUT_PARKING_NONE */
} abut_geometry_options;

ABUT_API void abut_geometry_options_init(abut_geometry_options *options, uint32_t struct_size);

/** Puts a shape on a part; the universe holds a reference to the shape. `options` may be null. [exclusive] */
ABUT_API abut_status abut_geometry_create(abut_universe *universe, abut_part_id part, const abut_shape *shape,
                                          const abut_geometry_options *options, abut_geometry_id *out);

/** Puts `count` shapes on `count` parts, all or none; `options` is an array of `count`, or null. [exclusive] */
ABUT_API abut_status abut_geometries_create(abut_universe *universe, const abut_part_id *parts,
                                            const abut_shape *const *shapes, const abut_geometry_options *options,
                                            size_t count, abut_geometry_id *out);

/** Takes a geometry away. [exclusive] */
ABUT_API abut_status abut_geometry_destroy(abut_universe *universe, abut_geometry_id geometry);

/** Takes `count` geometries away, all or none; an id that occurs twice is stale the second time. [exclusive] */
ABUT_API abut_status abut_geometries_destroy(abut_universe *universe, const abut_geometry_id *geometries, size_t count);

/** Replaces the options of a geometry, all of them; describe it first to change one. [exclusive] */
ABUT_API abut_status abut_geometry_set_options(abut_universe *universe, abut_geometry_id geometry,
                                               const abut_geometry_options *options);

/** The same for `count` geometries, all or none; `options` is an array of `count`. [exclusive] */
ABUT_API abut_status abut_geometries_set_options(abut_universe *universe, const abut_geometry_id *geometries,
                                                 const abut_geometry_options *options, size_t count);

/**
 * Puts a value of yours on a geometry, which abut_geometry_describe tells, and changes nothing else: no pair is asked
 * again, no part wakes. [exclusive]
 */
ABUT_API abut_status abut_geometry_set_user_data(abut_universe *universe, abut_geometry_id geometry,
                                                 uint64_t user_data);

/** The same for `count` geometries, all or none. [exclusive] */
ABUT_API abut_status abut_geometries_set_user_data(abut_universe *universe, const abut_geometry_id *geometries,
                                                   const uint64_t *user_data, size_t count);

/**
 * Gives a geometry another shape. Its contacts of the step before end, since features of another shape are other
 * features. The shape that abut_geometry_describe lent out is let go. [exclusive]
 */
ABUT_API abut_status abut_geometry_set_shape(abut_universe *universe, abut_geometry_id geometry,
                                             const abut_shape *shape);

/** The same for `count` geometries, all or none. [exclusive] */
ABUT_API abut_status abut_geometries_set_shapes(abut_universe *universe, const abut_geometry_id *geometries,
                                                const abut_shape *const *shapes, size_t count);

/**
 * Changes the parameters of the shape of a geometry, for this geometry alone: handles and geometries that share the
 * shape keep it as it was. A shape that nobody else holds is changed in place, so release what abut_geometry_create was
 * given; any other is copied once. What has the same features as before keeps its contacts, with ids, ages and user
 * data; the next step or detection examines the pairs of the geometry again, and islands that touch it wake. From then
 * on abut_geometry_describe lends out another handle where the shape was copied.
 * @param parameters  parameter_count numbers, as abut_shape_desc.parameters takes them, and checked as
 *                    abut_shape_create does
 * ABUT_UNSUPPORTED for kinds that are made of more than their parameters: hull, mesh, height_field, particles,
 * composite, distance_field, uv_grid.
 * Complexity O(1). [exclusive]
 */
ABUT_API abut_status abut_geometry_set_parameters(abut_universe *universe, abut_geometry_id geometry,
                                                  const double *parameters, size_t parameter_count);

/**
 * The same for `count` geometries that take equally many parameters, all or none.
 * @param parameters  count * parameter_count numbers, geometry by geometry
 * [exclusive]
 */
ABUT_API abut_status abut_geometries_set_parameters(abut_universe *universe, const abut_geometry_id *geometries,
                                                    const double *parameters, size_t parameter_count, size_t count);

/**
 * Changes heights of the height field of a geometry, as abut_geometry_set_parameters changes parameters. Where its box
 * stays the same, only pairs near the changed samples are examined again.
 * @param column   the first sample along X that changes
 * @param row      the first sample along Y that changes
 * @param columns  how many change along X; with 0 nothing changes
 * @param rows     how many change along Y; with 0 nothing changes
 * @param heights  columns * rows numbers or NaN, X fastest, copied
 * ABUT_INDEX_OUT_OF_RANGE beyond the field, ABUT_EMPTY where no triangle would be left, ABUT_UNSUPPORTED for other
 * kinds.
 * Complexity O(columns * rows + log(samples)), and O(samples) once where the shape has other holders. [exclusive]
 */
ABUT_API abut_status abut_geometry_set_heights(abut_universe *universe, abut_geometry_id geometry, uint32_t column,
                                               uint32_t row, uint32_t columns, uint32_t rows, const double *heights);

/**
 * Changes values of the distance field of a geometry, as abut_geometry_set_parameters changes parameters. Where its box
 * stays the same, only pairs near the changed samples are examined again; of a container all are.
 * @param column   the first sample along X that changes
 * @param row      the first sample along Y that changes
 * @param layer    the first sample along Z that changes
 * @param columns  how many change along X; with 0 nothing changes
 * @param rows     how many change along Y; with 0 nothing changes
 * @param layers   how many change along Z; with 0 nothing changes
 * @param values   columns * rows * layers numbers, X fastest, then Y, copied.
 * ABUT_INDEX_OUT_OF_RANGE beyond the field, ABUT_UNSUPPORTED for other kinds and where the field holds no samples.
 * Complexity O(columns * rows * layers + samples / 512), and O(samples) once where the shape has other holders.
 * [exclusive]
 */
ABUT_API abut_status abut_geometry_set_field_values(abut_universe *universe, abut_geometry_id geometry, uint32_t column,
                                                    uint32_t row, uint32_t layer, uint32_t columns, uint32_t rows,
                                                    uint32_t layers, const double *values);

/**
 * Bends the distance field of a geometry by a lattice, as abut_geometry_set_parameters changes parameters. Its points
 * are spread evenly over the grid of the field at rest, from the first sample to the last one along each axis. Between
 * eight points space goes where they go, tri-linearly; beyond the grid it goes on straight. All queries meet the bent
 * solid. Bounds of distances allow for the least stretch of ways. Points at rest give the answers of the field as it
 * was made. A lattice is part of the shape, so it is saved along with a universe.
 * @param columns  points along X, from 2 to 64, or 0 as rows and layers: without a lattice
 * @param rows     points along Y
 * @param layers   points along Z
 * @param xyz      columns * rows * layers * 3 numbers in the frame of the shape, X fastest, then Y, copied
 * ABUT_OUT_OF_RANGE where the points bend space too much: where an edge turns from the average of all edges by 90
 * degrees or more, or space shrinks to a fiftieth. ABUT_UNSUPPORTED for other kinds.
 * Complexity O(points + samples / 512), and O(samples) once where the shape has other holders. Source: Sederberg and
 * Parry (1986). [exclusive]
 */
ABUT_API abut_status abut_geometry_set_field_lattice(abut_universe *universe, abut_geometry_id geometry,
                                                     uint32_t columns, uint32_t rows, uint32_t layers,
                                                     const double *xyz);

/**
 * Moves particles of a geometry, as abut_geometry_set_parameters changes parameters.
 * @param first  the first one that changes
 * @param xyz    count * 3 numbers, the centres, copied
 * @param radii  count numbers, not negative, copied, for particles with radii of their own; may be null: radii stay as
 *               they are
 * @param count  how many change; with 0 nothing changes
 * ABUT_INDEX_OUT_OF_RANGE beyond the last particle, ABUT_UNSUPPORTED for other kinds, and for radii of particles with
 * one radius in common. Complexity O(particles); the grid is built anew when a query next needs it, in O(particles).
 * [exclusive]
 */
ABUT_API abut_status abut_geometry_set_particles(abut_universe *universe, abut_geometry_id geometry, size_t first,
                                                 const double *xyz, const double *radii, size_t count);

/**
 * Moves vertices of the mesh or the uv_grid of a geometry, as abut_geometry_set_parameters changes parameters. Contacts
 * of triangles that stay in touch keep ids, ages and user data. Where the box of the mesh stays the same, only pairs
 * near the triangles that changed are examined again. Vertices of a uv_grid move along the axis that is none of its
 * grid.
 * @param first  the first vertex that moves
 * @param xyz    count * 3 numbers, the new places, copied
 * @param count  how many move; with 0 nothing changes
 * ABUT_INDEX_OUT_OF_RANGE beyond the last vertex, ABUT_OUT_OF_RANGE for other moves in a uv_grid, ABUT_UNSUPPORTED for
 * other kinds. Complexity O(count + triangles around these vertices), and O(vertices + triangles) for the first change
 * and where the shape has other holders. Of a solid each of these triangles takes O(log triangles). The tree,
 * and what a solid encloses, are fitted to what moved. Once queries cost more by a half, the next one makes them
 * anew. [exclusive]
 */
ABUT_API abut_status abut_geometry_set_vertices(abut_universe *universe, abut_geometry_id geometry, size_t first,
                                                const double *xyz, size_t count);

/**
 * The same for vertices of a list. Of a vertex that is there twice, the last place counts.
 * @param vertices  count indices of vertices, copied
 * @param xyz       count * 3 numbers, the new places, copied
 * [exclusive]
 */
ABUT_API abut_status abut_geometry_set_vertices_at(abut_universe *universe, abut_geometry_id geometry,
                                                   const uint32_t *vertices, const double *xyz, size_t count);

/**
 * Lends the vertices of the mesh or the uv_grid of a geometry, as they are now. Borrowed until the next [exclusive]
 * call.
 * @param xyz    3 numbers for each vertex, in the frame of the shape
 * @param count  how many vertices there are
 * ABUT_UNSUPPORTED for other kinds. Complexity O(1). [const]
 */
ABUT_API abut_status abut_geometry_vertices(const abut_universe *universe, abut_geometry_id geometry,
                                            const double **xyz, size_t *count);

/**
 * Lends memory for the next vertices of the mesh or the uv_grid of a geometry. The caller writes where they move to.
 * Then abut_geometry_advance brings them there without a copy. At first the memory holds the present vertices, after an
 * advance those before it. So write all of them. Each geometry has memory of its own, also where a shape is shared.
 *
 * The memory is there until the geometry advances, is destroyed, or gets another shape or mesh. All other calls leave
 * it as it is. Do not write while another call on the universe runs. A call with the memory already lent lends the same
 * again. A step with time looks at it where the geometry is fast (ABUT_GEOMETRY_FAST): see the section on element
 * contacts. Otherwise nothing looks at it before the advance. A saved universe does not hold it.
 * @param xyz    3 numbers for each vertex, in the frame of the shape
 * @param count  how many vertices there are
 * ABUT_UNSUPPORTED for other kinds. Complexity O(vertices) for the first call, then O(log lent geometries). [exclusive]
 */
ABUT_API abut_status abut_geometry_next_vertices(abut_universe *universe, abut_geometry_id geometry, double **xyz,
                                                 size_t *count);

/**
 * The next vertices of a geometry, which abut_geometry_next_vertices has lent, become the present ones: the two arrays
 * are exchanged. All else is as after abut_geometry_set_vertices for all vertices.
 *
 * Nothing changes where a number is not finite or too large (ABUT_NOT_FINITE, ABUT_OUT_OF_RANGE; `next[7]` is the
 * second coordinate of the third vertex), nor for other moves in a uv_grid than along its axis. ABUT_INVALID_ARGUMENT
 * where nothing is lent. Complexity O(vertices + triangles), and a copy of the mesh where its shape has other holders.
 * [exclusive]
 */
ABUT_API abut_status abut_geometry_advance(abut_universe *universe, abut_geometry_id geometry);
/**
 * The same for several geometries: all advance, or none.
 * @param geometries  count different ones, each with vertices that are lent
 * @param count       with 0 nothing changes
 * [exclusive]
 */
ABUT_API abut_status abut_geometries_advance(abut_universe *universe, const abut_geometry_id *geometries, size_t count);

/**
 * Takes triangles out of the mesh or the uv_grid of a geometry, as abut_geometry_set_parameters changes parameters. The
 * others keep their numbers, and their contacts keep ids, ages and user data. A triangle that has gone keeps its number
 * too: it meets nothing from then on, and abut_shape_triangles names one vertex three times for it.
 * @param triangles  count numbers of triangles, copied; those that have gone before, or are there twice, are no error
 * @param count      with 0 nothing changes
 * ABUT_INDEX_OUT_OF_RANGE beyond the last triangle, ABUT_EMPTY where none would be left, ABUT_UNSUPPORTED for other
 * kinds. Complexity O(count), and O(vertices + triangles) once where the shape has other holders. The next query makes
 * what a solid encloses anew, in O(triangles * log triangles). [exclusive]
 */
ABUT_API abut_status abut_geometry_remove_triangles(abut_universe *universe, abut_geometry_id geometry,
                                                    const uint32_t *triangles, size_t count);

/**
 * Makes the mesh or the uv_grid of a geometry anew of triangles, on the sides and cells that it has. Unlike
 * abut_geometry_set_shape it ends no contact where the same triangle, by its number, still touches. Parameters as those
 * of abut_mesh_create. [exclusive]
 */
ABUT_API abut_status abut_geometry_set_mesh(abut_universe *universe, abut_geometry_id geometry, const double *xyz,
                                            size_t vertex_count, const uint32_t *triangles, size_t triangle_count);

/**
 * The shape that a geometry has at present, with a reference that belongs to the caller: release it. While the caller
 * holds it, the next change of the geometry's shape copies it. [const]
 */
ABUT_API abut_status abut_geometry_shape(const abut_universe *universe, abut_geometry_id geometry, abut_shape **out);

/**
 * Parks a geometry, or brings it back. Parking twice changes nothing; changing between short and long term is allowed.
 * The one [exclusive] call that a filter may make: it takes effect when the step is over.
 * Complexity O(1); O(log n) for long term. [exclusive]
 */
ABUT_API abut_status abut_geometry_park(abut_universe *universe, abut_geometry_id geometry, abut_parking parking);

/** The same for `count` geometries, all or none. [exclusive] */
ABUT_API abut_status abut_geometries_park(abut_universe *universe, const abut_geometry_id *geometries, size_t count,
                                          abut_parking parking);

/** What a geometry is and where. Set struct_size, or use the _init function, before asking. */
typedef struct abut_geometry_info {
  uint32_t struct_size;
  abut_shape_kind kind;
  abut_part_id part;
  abut_shape *shape;  /**< borrowed until the geometry is destroyed or changes its shape; retain it to keep it */
  abut_pose pose;     /**< in the world */
  abut_pose local;    /**< in the frame of the part */
  double tolerance;
  uint64_t user_data;
  uint64_t layers;
  uint64_t mask;
  uint64_t exclusion;
  uint32_t label;
  uint32_t tag;
  uint32_t material;
  abut_parking parking;
  abut_geometry_flags flags;
  uint32_t reserved;  /**< zero */
} abut_geometry_info;

ABUT_API void abut_geometry_info_init(abut_geometry_info *info, uint32_t struct_size);

/** Describes a geometry. [const] */
ABUT_API abut_status abut_geometry_describe(const abut_universe *universe, abut_geometry_id geometry,
                                            abut_geometry_info *out);

/** World poses of `count` geometries. [const] */
ABUT_API abut_status abut_geometries_poses(const abut_universe *universe, const abut_geometry_id *geometries,
                                           size_t count, abut_pose *out);

/** All parts by count-then-fill, ordered by slot. [const] */
ABUT_API abut_status abut_universe_parts(const abut_universe *universe, abut_part_id *parts, size_t capacity,
                                         size_t *count);

/** All geometries by count-then-fill, ordered by slot. [const] */
ABUT_API abut_status abut_universe_geometries(const abut_universe *universe, abut_geometry_id *geometries,
                                              size_t capacity, size_t *count);

/** Counters that tell tools what changed since they last looked. */
typedef struct abut_revision {
  uint64_t geometries; /**< grows when a geometry is created, destroyed, parked, given options or another shape, or its
                            shape changes */
  uint64_t poses;      /**< grows when a pose is set, of a part or with the options of a geometry */
} abut_revision;

/** Change counters of a universe. O(1). [const] */
ABUT_API abut_status abut_universe_revision(const abut_universe *universe, abut_revision *out);

/**
 * The change counters themselves, for tools that look often: pointers to the numbers of
 * abut_universe_revision, good for as long as the universe is there. Reading them counts as a [const]
 * call. [const]
 */
ABUT_API abut_status abut_universe_counters(const abut_universe *universe, const uint64_t **geometries,
                                            const uint64_t **poses);

/**
 * Which geometries have changed since a revision, for tools that follow a universe, by count-then-fill and ordered by
 * slot: those that came, moved, were parked or given options or another shape, and those whose shape has changed. Of
 * one that has gone the generation is 0. A universe remembers the last 512 changes of geometries.
 * @param since     what abut_universe_revision told
 * @param is_known  receives 1; 0 where more has changed than is remembered. Then all geometries are to be looked at,
 *                  count becomes 0 and nothing is written
 * Complexity O(changes). [const]
 */
ABUT_API abut_status abut_universe_changes(const abut_universe *universe, const abut_revision *since,
                                           abut_geometry_id *geometries, size_t capacity, size_t *count,
                                           uint32_t *is_known);

/** What a rule speaks of. */
typedef uint32_t abut_collidable_kind;
enum abut_collidable_kind_value ABUT_ENUM(uint32_t) {
  ABUT_COLLIDABLE_GEOMETRY = 0,
  ABUT_COLLIDABLE_PART = 1,  /**< all geometries of a part */
  ABUT_COLLIDABLE_LABEL = 2, /**< all geometries with a label */
  ABUT_COLLIDABLE_ANY = 3
};

typedef struct abut_collidable {
  abut_collidable_kind kind;
  uint32_t slot;       /**< of the geometry or the part; the label; 0 for any */
  uint32_t generation; /**< of the geometry or the part; else 0 */
} abut_collidable;

typedef uint32_t abut_rule;
enum abut_rule_value ABUT_ENUM(uint32_t) {
  ABUT_RULE_NONE = 0, /**< takes the rule away */
  ABUT_RULE_ENABLE = 1,
  ABUT_RULE_DISABLE = 2
};

/**
 * Says whether two collidables meet. The most specific rule that fits a pair counts: first by its more specific side,
 * then by the other; a geometry before a part, that before a label, that before any. Of two that are equally specific
 * the one that disables wins. Rules end with the geometry or the part that they name. Takes effect at the next step,
 * where pairs that no longer meet end.
 * Complexity O(log rules), and the next step looks at every pair once. [exclusive]
 */
ABUT_API abut_status abut_rule_set(abut_universe *universe, const abut_collidable *a, const abut_collidable *b,
                                   abut_rule rule);

/** Takes all rules away. [exclusive] */
ABUT_API abut_status abut_rules_clear(abut_universe *universe);

/**
 * The rule that counts for two geometries: what it says, and the collidables that it names, `a` being or holding
 * geometry_a. Where no rule speaks of the two, `rule` is ABUT_RULE_NONE, and both are any. The two may be one geometry.
 * Complexity O(log rules). [const]
 */
ABUT_API abut_status abut_rule_between(const abut_universe *universe, abut_geometry_id geometry_a,
                                       abut_geometry_id geometry_b, abut_rule *rule, abut_collidable *a,
                                       abut_collidable *b);

/**
 * Decides about a pair: 0 leaves it out. The thread that steps calls it once for each pair that comes near and is not
 * left out before. Calls are ordered by slots. It may make [const] calls, and park; contacts and events are those of
 * the step before then. It must not throw: what gets out of it makes the step answer ABUT_INTERNAL.
 */
typedef uint32_t (*abut_filter)(void *context, const abut_universe *universe, abut_geometry_id geometry_a,
                                abut_geometry_id geometry_b);

/**
 * Sets the filter; null for none. `context` is kept and handed to it. All pairs are asked about at the next step.
 * [exclusive]
 */
ABUT_API abut_status abut_universe_set_filter(abut_universe *universe, abut_filter filter, void *context);

/** An abut_filter for languages whose callbacks take no structs by value. Both ids are borrowed for the call. */
typedef uint32_t (*abut_pointer_filter)(void *context, const abut_universe *universe,
                                        const abut_geometry_id *geometry_a, const abut_geometry_id *geometry_b);

/** The same as abut_universe_set_filter with a filter of the other form: a universe has one filter. [exclusive] */
ABUT_API abut_status abut_universe_set_pointer_filter(abut_universe *universe, abut_pointer_filter filter,
                                                      void *context);

/** Asks the filter about all pairs again at the next step. [exclusive] */
ABUT_API abut_status abut_universe_refilter(abut_universe *universe);

/** How much of a pair is found. */
typedef uint32_t abut_detail;
enum abut_detail_value ABUT_ENUM(uint32_t) {
  ABUT_DETAIL_MANIFOLD = 0, /**< all contacts */
  ABUT_DETAIL_POINT = 1,    /**< the deepest one */
  ABUT_DETAIL_BOX = 2,      /**< whether the boxes overlap: events without contacts */
  ABUT_DETAIL_TOUCH = 3,    /**< whether the shapes touch, as abut_universe_overlaps finds out: events without
                                 contacts. The algorithm and the error bound of the policy have no effect */
  ABUT_DETAIL_ELEMENTS = 4  /**< which vertices, edges and faces are near: element contacts and events, no contacts. See
                                 abut_universe_element_contacts. A pair with a shape without triangles is treated as
                                 with ABUT_DETAIL_MANIFOLD */
};

/** How the pairs of two tags are treated: their algorithm, precision and rate. */
typedef struct abut_policy {
  uint32_t struct_size;
  abut_algorithm algorithm; /**< default ABUT_ALGORITHM_AUTO, which also takes pairs that do not have the one asked
                                 for, or where it gives up */
  abut_detail detail;       /**< default ABUT_DETAIL_MANIFOLD */
  uint32_t period;          /**< at least 1: found anew once in so many steps, kept in between; new pairs at once;
                                 default 1 */
  double tolerance;         /**< of a pair; negative: the sum of both geometries; default -1 */
  double error_bound;       /**< as in abut_query_options; default 0 */
  /* ABUT_DETAIL_ELEMENTS alone looks at the following fields; see abut_elements_options. */
  abut_closest_method method; /**< default ABUT_CLOSEST_FEATURES */
  abut_stencil_kinds kinds;   /**< which are told; default 0: those of the method */
  abut_elements_flags flags;  /**< default 0 */
  uint32_t reserved;          /**< zero */
  double contact_distance;    /**< where the gap is 0, and how near is a first touch; not negative; default 0 */
  double rest_distance;       /**< of a geometry with itself; not negative; default 0 */
  double cone_angle;          /**< in [0, 1]; default 0 */
  double cone_factor;         /**< in [0, 1]; default 0.5 */
  /* Of all details again. */
  double time_budget;         /**< as in abut_query_options, for the contacts of one pair; not negative; default 0 */
} abut_policy;

ABUT_API void abut_policy_init(abut_policy *policy, uint32_t struct_size);

/**
 * Sets how geometries of two tags (`tag_a` and `tag_b` are below 64) meet, in either order. `policy` may be null, which
 * goes back to the default. One broad phase serves all policies. ABUT_DETAIL_ELEMENTS is ABUT_UNSUPPORTED in a universe
 * without ABUT_TOLERANCE_MARGIN, and in a build without the feature "deforming". [exclusive]
 */
ABUT_API abut_status abut_policy_set(abut_universe *universe, uint32_t tag_a, uint32_t tag_b,
                                     const abut_policy *policy);

/**
 * How geometries of two tags meet; `tag_a` and `tag_b` are below 64. Set struct_size, or use the _init function, before
 * asking. [const]
 */
ABUT_API abut_status abut_policy_get(const abut_universe *universe, uint32_t tag_a, uint32_t tag_b, abut_policy *out);

/**
 * Two tags that follow the distance of geometries from centres, such as those of a camera and of what is held: near
 * ones and far ones may then have policies of their own.
 */
typedef struct abut_focus {
  uint32_t struct_size;
  uint32_t near_tag;    /**< below 64; default 0, which geometries have that say nothing */
  uint32_t far_tag;     /**< below 64, another one; default 1 */
  uint32_t reserved;    /**< zero */
  double near_distance; /**< not negative; default 0: nothing is near */
  double far_distance;  /**< not below near_distance; default 0 */
} abut_focus;

ABUT_API void abut_focus_init(abut_focus *focus, uint32_t struct_size);

/**
 * Switches geometries that have one of the two tags, from the next step or detection on. One whose box comes nearer
 * than near_distance to a centre gets near_tag. One that is farther than far_distance from all centres gets far_tag. In
 * between it keeps its tag. abut_geometry_describe shows it. Pairs of a geometry whose tag changes are found anew in
 * that step, whatever their period, if it covers them; the filter is not asked again. Parked geometries keep their tag
 * until they come back. Boxes are those of the broad phase: in single precision, rounded outwards, inflated in
 * ABUT_TOLERANCE_MARGIN. `focus` may be null, which is the default, and leaves tags as they are. Without centres
 * everything is far. Complexity O(count), without an allocation unless there are more centres than ever; the next step
 * O(geometries * count) if anything has changed, and O(moved geometries * count) each later one. [exclusive]
 */
ABUT_API abut_status abut_universe_set_focus(abut_universe *universe, const abut_focus *focus, const abut_vec3 *centres,
                                             size_t count);

/** What the contacts of two materials are like: plain numbers that abut stores and hands out, and applies none of. */
typedef struct abut_contact_material {
  uint32_t struct_size;
  uint32_t reserved;            /**< zero */
  double friction_primary;      /**< coefficients along the two axes of the contact plane; default 0 */
  double friction_secondary;
  double friction_spin;         /**< about the normal; default 0 */
  double friction_roll;         /**< about axes of the contact plane; default 0 */
  double static_scale;          /**< of the coefficients while nothing slides; default 1 */
  double slip;                  /**< default 0 */
  double compliance;            /**< default 0 */
  double damping;               /**< default 0 */
  double restitution;           /**< default 0 */
  double restitution_threshold; /**< below that speed nothing bounces; default 0.001 */
  double adhesive_force;        /**< default 0 */
} abut_contact_material;

ABUT_API void abut_contact_material_init(abut_contact_material *material, uint32_t struct_size);

/**
 * Sets the row of two materials, in either order; `row` may be null, which takes it away. Numbers are finite and not
 * negative.
 * Complexity O(log rows). [exclusive]
 */
ABUT_API abut_status abut_material_pair_set(abut_universe *universe, uint32_t material_a, uint32_t material_b,
                                            const abut_contact_material *row);

/**
 * What contacts of two materials are like. Without a row of their own they are combined from the rows of each material
 * with itself. A material without one counts as the default. The values are combined as geometric mean of frictions and
 * static scales, sum of slips, compliances and adhesive forces, the greater of damping, restitution and threshold. Set
 * struct_size, or use the _init function, before asking. [const]
 */
ABUT_API abut_status abut_material_pair_get(const abut_universe *universe, uint32_t material_a, uint32_t material_b,
                                            abut_contact_material *out);

/**
 * A pair of geometries that a back end is asked about: a detector of the caller, which answers in place of the narrow
 * phase of abut. Both shapes are borrowed for the call.
 */
typedef struct abut_backend_pair {
  abut_geometry_id geometry_a; /**< that of the lower slot */
  abut_geometry_id geometry_b;
  const abut_shape *shape_a;
  const abut_shape *shape_b;
  abut_pose pose_a;            /**< from the frame of the shape to the world */
  abut_pose pose_b;
  double margin;               /**< contacts with a distance below it are reported; at 0 those with a distance of at
                                    most 0. Negative in a dead band */
} abut_backend_pair;

/**
 * Whether a back end answers pairs of two kinds of shapes: 0 for no. abut_backend_set calls it once for each two kinds,
 * in either order of the two, and nothing else does. It must not throw.
 */
typedef uint32_t (*abut_backend_accepts)(void *context, abut_shape_kind kind_a, abut_shape_kind kind_b);

/**
 * Answers pairs, each by one call of abut_backend_answer. A detection calls it at most once, on the thread that steps,
 * with all pairs that it examines and that the back end accepts. Pairs come in the order of the slots. A pair without
 * an answer is answered by abut, as without a back end. It may make [const] calls on the universe. It must not throw:
 * what gets out of it makes the step answer ABUT_INTERNAL.
 */
typedef void (*abut_backend_find)(void *context, abut_universe *universe, const abut_backend_pair *pairs, size_t count);

/**
 * Sets the back end of a universe: two functions, and a context that is kept and handed to both. `find` is null for
 * none. `accepts` is null for all kinds. All pairs are found anew at the next step, and the filter is asked again.
 * Not asked about: pairs that abut does not support, and pairs of a geometry with itself. Nor about those with
 * ABUT_DETAIL_ELEMENTS, ABUT_DETAIL_BOX or ABUT_GEOMETRY_KEEPS_SIDE, and what fast and speculative geometries touch on
 * their way. Queries are answered by abut.
 * Complexity O(kinds * kinds), and the next step looks at every pair. [exclusive]
 */
ABUT_API abut_status abut_backend_set(abut_universe *universe, abut_backend_accepts accepts, abut_backend_find find,
                                      void *context);

/** A contact that a back end has found. Its distance is dot(point_b - point_a, normal). */
typedef struct abut_backend_contact {
  abut_vec3 point_a;       /**< on the surface of a, world frame */
  abut_vec3 point_b;       /**< on the surface of b, world frame */
  abut_vec3 normal;        /**< from a to b; its length is off 1 by at most 1e-3, and then made 1 */
  abut_feature feature_a;  /**< what touches */
  abut_feature feature_b;
  uint32_t child_a;        /**< as in abut_contact */
  uint32_t child_b;
  uint64_t id;             /**< tells the contact apart from step to step; 0 for one that is made of the features */
} abut_backend_contact;

/**
 * Answers a pair, from within abut_backend_find alone. No contacts are the answer that the two do not touch. Contacts
 * that the margin leaves out are dropped, and what options and policies say of reduction applies. Of equal ids in one
 * answer all but the first become other ones.
 * @param pair      the place of the pair among those of the call; each is answered once
 * @param contacts  count contacts
 * ABUT_BUSY outside of such a call. ABUT_INDEX_OUT_OF_RANGE for a pair past the last one. ABUT_INVALID_ARGUMENT for a
 * pair that has its answer. After an error the pair is as before. [exclusive]
 */
ABUT_API abut_status abut_backend_answer(abut_universe *universe, size_t pair, const abut_backend_contact *contacts,
                                         size_t count);

/**
 * Detects over [t, t + dt]; moves nothing. Contacts are those of the present poses, but in pairs with
 * ABUT_GEOMETRY_FAST or ABUT_GEOMETRY_SPECULATIVE. Pairs of which nothing has changed keep their contacts.
 * @param dt  not negative. ABUT_OUT_OF_RANGE where the universe has such geometries, and in that time a part would turn
 *            more than 16 times, or get further than 1e70
 * Complexity O(n log n + pairs) for n moved geometries. [exclusive]
 */
ABUT_API abut_status abut_universe_step(abut_universe *universe, double dt);

/**
 * A step that finds every pair anew. Where max_contacts is 0, contacts are the same bits as those of any other way to
 * get there; else points that are as good as each other win when the detection before has kept them. [exclusive]
 */
ABUT_API abut_status abut_universe_detect_all(abut_universe *universe);

/** A step without time. [exclusive] */
ABUT_API abut_status abut_universe_detect_changed(abut_universe *universe);

/**
 * A step that looks, of the pairs that have changed, at the given ones only. All others keep the contacts that they
 * have, as old as they are and without an event, until a detection covers them; pairs that are not near each other any
 * more end all the same.
 * @param a      count geometries
 * @param b      count geometries; pair i is a[i] with b[i], in either order; those that cannot meet are passed over
 * Complexity as a step for the given pairs, O(pairs) for the others. [exclusive]
 */
ABUT_API abut_status abut_universe_detect_pairs(abut_universe *universe, const abut_geometry_id *a,
                                                const abut_geometry_id *b, size_t count);

/**
 * The same for the pairs whose boxes both meet a region, and so for every contact in it.
 * @param region  its sides may be infinite
 * [exclusive]
 */
ABUT_API abut_status abut_universe_detect_region(abut_universe *universe, const abut_aabb *region);

/**
 * Brings the boxes up to date with the poses without detecting anything: queries see poses as of the last step or
 * refresh. [exclusive]
 */
ABUT_API abut_status abut_universe_refresh(abut_universe *universe);

typedef uint32_t abut_event_kind;
enum abut_event_kind_value ABUT_ENUM(uint32_t) {
  ABUT_EVENT_BEGIN = 0,
  ABUT_EVENT_PERSIST = 1,
  ABUT_EVENT_END = 2
};

typedef uint32_t abut_event_flags;
enum abut_event_flags_value ABUT_ENUM(uint32_t) {
  ABUT_EVENT_SENSOR = 1, /**< a geometry of the pair is a sensor */
  ABUT_EVENT_CONTACT = 2, /**< about one contact, not about the pair */
  ABUT_EVENT_ASLEEP = 4,  /**< the pair touches, but none of its dynamic parts is awake */
  ABUT_EVENT_ELEMENTS = 8 /**< about one element contact: `contact_id` is its id, and `first_contact` its place among
                               the element contacts */
};

/**
 * A pair, or one of its contacts, that began to touch, still touches or ended. Every touch is one begin, then a persist
 * in each step, then one end. It also ends by parking, filtering, reshaping or destruction.
 */
typedef struct abut_event {
  abut_event_kind kind;
  abut_event_flags flags;
  abut_geometry_id geometry_a; /**< may be destroyed at an end */
  abut_geometry_id geometry_b;
  uint64_t contact_id;         /**< of the contact; 0 for a pair */
  uint32_t first_contact;      /**< index of the first contact of the pair, or of the contact; 0 at an end */
  uint32_t contact_count;      /**< of the pair; 1 for a contact; 0 at an end, and for pairs that are treated as
                                    boxes or by elements */
} abut_event;

/**
 * Events of the last step, ordered by the slots of the two geometries; of one pair, ends of those that had the slots
 * before come first, and the pair before its contacts and element contacts. Borrowed until the next [exclusive] call.
 * [const]
 */
ABUT_API abut_status abut_universe_events(const abut_universe *universe, const abut_event **events, size_t *count);

/** A part that fell asleep or woke. */
typedef struct abut_sleep_change {
  abut_part_id part;  /**< may be destroyed since */
  uint32_t is_asleep; /**< 1: fell asleep; 0: woke */
  uint32_t reserved;  /**< zero */
} abut_sleep_change;

/**
 * Parts that fell asleep or woke in the last step or detection, ordered by slot. Borrowed until the next [exclusive]
 * call. [const]
 */
ABUT_API abut_status abut_universe_sleep_changes(const abut_universe *universe, const abut_sleep_change **changes,
                                                 size_t *count);

/**
 * Hash of every bit of the contacts, element contacts, events and sleep changes of the last step, but of generations
 * and times: equal runs have equal hashes. [const]
 */
ABUT_API abut_status abut_universe_hash(const abut_universe *universe, uint64_t *out);

/**
 * Contacts of the last step, ordered by the slots of the two geometries, then deepest first. Borrowed until the next
 * [exclusive] call. [const]
 */
ABUT_API abut_status abut_universe_contacts(const abut_universe *universe, const abut_contact **contacts,
                                            size_t *count);

/**
 * The points of one contact in the frames of its two geometries, as these lay when it was found. Geometry a at a pose P
 * has its point at P * a. In the pair queries these are the points under the inverse of pose_a and pose_b.
 */
typedef struct abut_local_points {
  abut_vec3 a;
  abut_vec3 b;
} abut_local_points;

/**
 * Local points of the contacts of the last step, one for each, in their order. ABUT_UNSUPPORTED for a universe without
 * ABUT_UNIVERSE_LOCAL_POINTS. Borrowed until the next [exclusive] call. [const]
 */
ABUT_API abut_status abut_universe_local_points(const abut_universe *universe, const abut_local_points **points,
                                                size_t *count);

/**
 * Puts a value of yours on each contact of the last step, in their order. A contact that the next step reports as well,
 * of the same geometries and with the same id, keeps it.
 * @param count  the number of contacts
 * [exclusive]
 */
ABUT_API abut_status abut_contacts_set_user_data(abut_universe *universe, const uint64_t *user_data, size_t count);

/** What the last step did. */
typedef struct abut_step_stats {
  uint32_t struct_size;
  uint32_t reserved;
  uint64_t parts;
  uint64_t geometries;
  uint64_t parked;                 /**< geometries that are parked */
  uint64_t moved;                  /**< geometries whose box was refreshed */
  uint64_t candidate_pairs;        /**< pairs of overlapping boxes that the filters admit and that have an algorithm */
  uint64_t filtered_pairs;         /**< pairs of overlapping boxes that the filters left out */
  uint64_t examined_pairs;         /**< candidates handed to the narrow phase */
  uint64_t kept_pairs;             /**< candidates that kept what they had */
  uint64_t touching_pairs;         /**< pairs with at least one contact, treated as boxes, or with ABUT_DETAIL_TOUCH
                                        touching */
  uint64_t contacts;
  uint64_t unsupported_pairs;      /**< admitted pairs that have no algorithm, by declaration */
  uint64_t events;
  uint64_t bytes;                  /**< memory held by the universe, without shapes */
  double refresh_microseconds;     /**< poses to boxes */
  double broadphase_microseconds;  /**< boxes to pairs */
  double pair_microseconds;        /**< filters, and what pairs keep from step to step */
  double narrowphase_microseconds; /**< pairs to manifolds, reduced */
  double contact_microseconds;     /**< contacts and events in order */
  uint64_t asleep;                 /**< parts that sleep */
} abut_step_stats;

ABUT_API void abut_step_stats_init(abut_step_stats *stats, uint32_t struct_size);

/** Counts and times of the last step; zeros before the first. [const] */
ABUT_API abut_status abut_universe_stats(const abut_universe *universe, abut_step_stats *out);

/**
 * The plan in words: stages, algorithm per pair of kinds and why, extensions, what was left out, counts, bytes and
 * microseconds of the last step. Those of pairs of kinds are measured from the first step after the first question on.
 * @param text      capacity bytes, always terminated when capacity > 0; null with capacity 0 asks for the size
 * @param needed    bytes of the whole text with its terminator
 * [const]
 */
ABUT_API abut_status abut_universe_explain(const abut_universe *universe, char *text, size_t capacity, size_t *needed);

/** The same as JSON; docs/universe.md lists the fields. [const] */
ABUT_API abut_status abut_universe_explain_json(const abut_universe *universe, char *text, size_t capacity,
                                                size_t *needed);

/** What keeps two geometries from being examined, as bits. */
typedef uint32_t abut_apart_reasons;
enum abut_apart_reasons_value ABUT_ENUM(uint32_t) {
  ABUT_APART_PART = 1,       /**< they are on one part, or are one geometry without ABUT_GEOMETRY_SELF_PAIRS */
  ABUT_APART_MOTION = 2,     /**< neither part is dynamic */
  ABUT_APART_PARKING = 4,    /**< one of them is parked */
  ABUT_APART_EXCLUSION = 8,  /**< they have an exclusion bit in common */
  ABUT_APART_LAYERS = 16,    /**< the layers of one do not meet the mask of the other */
  ABUT_APART_RULE = 32,      /**< the rule that counts disables them; abut_rule_between tells which one that is */
  ABUT_APART_FILTER = 64,    /**< the filter said no when it was asked last */
  ABUT_APART_KINDS = 128,    /**< their kinds have no algorithm */
  ABUT_APART_BOXES = 256,    /**< their boxes do not overlap */
  ABUT_APART_POLICY = 512,   /**< a policy asks about their boxes only: events without contacts */
  ABUT_APART_DETECTION = 1024, /**< the last detection has not looked at them as they are now: something has changed
                                    since, or its scope or a policy with a period left them out */
  ABUT_APART_SIDE = 2048       /**< they were examined: one is a surface of one side, and the other overlaps it from
                                    the back, where it stops nothing */
};

/**
 * Tells why two geometries are not examined, and so get no new contacts: all reasons that hold. With none of them, 0,
 * the last detection has examined them or has kept what it had, and the distance of their shapes decides
 * (abut_pair_distance).
 * Options, rules, motions and parking are the present ones. Boxes are those of the last step or refresh, as queries see
 * them. The filter is not called: its last answer counts. The order of the two does not matter. They may be one
 * geometry.
 * Complexity O(log pairs + log rules), and O(triangles) where a surface of one side was examined without a contact.
 * [const]
 */
ABUT_API abut_status abut_universe_why_apart(const abut_universe *universe, abut_geometry_id geometry_a,
                                             abut_geometry_id geometry_b, abut_apart_reasons *out);

/** What will surprise whoever built a scene. */
typedef uint32_t abut_finding_code;
enum abut_finding_code_value ABUT_ENUM(uint32_t) {
  ABUT_FINDING_NOTHING_MOVES = 0,       /**< no part is dynamic: no pair is ever examined */
  ABUT_FINDING_MEETS_NOTHING = 1,       /**< the layers or the mask of a geometry are empty */
  ABUT_FINDING_KINDS_UNSUPPORTED = 2,   /**< two geometries that could meet are of kinds without an algorithm */
  ABUT_FINDING_TOLERANCE_TOO_LARGE = 3, /**< a tolerance above the smallest side of the shape */
  ABUT_FINDING_FAR_FROM_ORIGIN = 4,     /**< boxes of the broad phase are coarser there than a hundredth of the shape */
  ABUT_FINDING_EXCLUDED_FROM_ALL = 5,   /**< no geometry has a layer that it meets, or none meets its own */
  ABUT_FINDING_RULE_DISABLES_ALL = 6,   /**< a rule disables any with any, and no rule enables anything */
  ABUT_FINDING_EXCLUSION_IN_COMMON = 7, /**< all geometries have an exclusion bit in common */
  ABUT_FINDING_FILTER_KEEPS_NONE = 8,   /**< the filter has said no each time, since it was set or all pairs were to be
                                             asked about again */
  ABUT_FINDING_ALL_PARKED = 9,          /**< every geometry is parked */
  ABUT_FINDING_ALL_ON_ONE_PART = 10,    /**< geometries of one part never meet each other */
  ABUT_FINDING_INSIDE_OUT = 11,         /**< a solid mesh has been turned inside out by edits: it has no inside */
  ABUT_FINDING_HOLLOW = 12              /**< a geometry lies inside of a closed mesh of ABUT_SIDES_BOTH, which is a
                                             hollow sheet; told once for each mesh */
};

typedef struct abut_finding {
  abut_finding_code code;
  uint32_t reserved;         /**< zero */
  abut_geometry_id geometry; /**< null where none is meant */
  abut_geometry_id other;    /**< null where no second one is meant */
  char message[168];         /**< for people; terminated, cut to what fits */
} abut_finding;

/**
 * Looks for what is odd about a scene, by count-then-fill; ordered by code, then by slots. An empty answer means that
 * nothing was found. Complexity O(n log n) in geometries and in triangles of meshes, and O(kinds squared). [const]
 */
ABUT_API abut_status abut_universe_validate(const abut_universe *universe, abut_finding *findings, size_t capacity,
                                            size_t *count);

/* ------------------------------------------------------------------------------------------------
 * Welds
 *
 * Boxes that lie side by side make a floor without walls, yet each of them has a wall on every side: a body that slides
 * over the floor is pushed back by it. ABUT_UNIVERSE_WELDS takes static and animated geometries that a body touches at
 * once for one shape, ABUT_QUERY_WELDS the children of a composite. Parts are convex shapes, half-spaces, and the
 * surfaces beside them. Sensors, distance fields, particles and composites with holes take no part.
 *  - A contact stays as it is where the outside of its part is that of the whole: at a step, at a wall, at the open
 *    side of a single box. It does so for all points under one normal where that holds for one of them.
 *  - Another part may go on past all of these points. Then they give way to contacts of their own part, under the
 *    normals of the whole.
 *  - Gaps and differences in height of up to 1e-4 of the smaller one of a part and the body are none. A higher step is
 *    a wall. Parts may overlap by any length.
 *  - Pairs that a detection does not examine stay as they are, and dynamic geometries have no welds with each other.
 *    Impacts of fast geometries have the normals of one part, as if it were alone.
 * Cost: nothing where it is not asked for. Else a step sorts the pairs that touch such parts. Where the contacts of a
 * body have several normals, it asks support points and distances of points. A part whose contacts give way is asked
 * once more.
 * --------------------------------------------------------------------------------------------- */

/* ------------------------------------------------------------------------------------------------
 * Islands
 * --------------------------------------------------------------------------------------------- */

/**
 * Dynamic parts that touch each other, directly or through others. A part that touches no other dynamic part is an
 * island of its own. Animated and static parts are in none, or the ground would join them all. Touches of sensors
 * and of pairs whose policy wants no contacts join nobody.
 */
typedef struct abut_island {
  uint64_t id;         /**< not 0, and never used again in this universe */
  uint32_t first_part; /**< index of its first part in abut_universe_island_parts */
  uint32_t part_count; /**< at least 1 */
} abut_island;

/**
 * Says whether steps and detections find islands, 1 or 0; 0 is the default, and costs nothing. Ids stay:
 *  - the id of an island goes on to the island that has the lowest slot of those parts which were in it;
 *  - an island that would get several ids so, by merging, keeps the least of them, which is the oldest;
 *  - an island that gets none is new.
 * So an island keeps its id while its parts touch. Where one falls apart, the piece with the lowest slot keeps it. The
 * same for any number of threads. Sleep finds the same islands, whatever this says. Complexity of a step O(pairs +
 * parts). [exclusive]
 */
ABUT_API abut_status abut_universe_follow_islands(abut_universe *universe, uint32_t are_followed);

/**
 * Islands of the last step or detection, ordered by their lowest slots; none before the first one.
 * ABUT_UNSUPPORTED while they are not followed. Borrowed until the next [exclusive] call. O(1) after the first
 * call of a step. [const]
 */
ABUT_API abut_status abut_universe_islands(const abut_universe *universe, const abut_island **islands, size_t *count);

/**
 * Parts of all islands, island by island, each ordered by slot; some may be destroyed since. ABUT_UNSUPPORTED while
 * islands are not followed. Borrowed until the next [exclusive] call. O(1) after the first call of a step. [const]
 */
ABUT_API abut_status abut_universe_island_parts(const abut_universe *universe, const abut_part_id **parts,
                                                size_t *count);

/**
 * Island of a part in the last step or detection; zeros for a part that was in none: not dynamic, or created since.
 * ABUT_UNSUPPORTED while islands are not followed. O(1). [const]
 */
ABUT_API abut_status abut_part_island(const abut_universe *universe, abut_part_id part, abut_island *out);

/* ------------------------------------------------------------------------------------------------
 * Velocities of parts
 *
 * They are stored, handed out and counted by abut_universe_explain. Pairs with fast or speculative geometries go by
 * them; all others do not, and sleep goes by poses. They move nothing and wake nobody.
 * --------------------------------------------------------------------------------------------- */

/** In the world frame. A point p of the part moves by linear + angular x (p - position of the part). */
typedef struct abut_velocity {
  abut_vec3 linear;  /**< of the origin of the part, per second */
  abut_vec3 angular; /**< unit axis times radians per second, by the right-hand rule */
} abut_velocity;

/** Where the velocity of a part comes from. */
typedef uint32_t abut_velocity_source;
enum abut_velocity_source_value ABUT_ENUM(uint32_t) {
  ABUT_VELOCITY_NONE = 0,      /**< it has none, which reads as zero */
  ABUT_VELOCITY_GIVEN = 1,     /**< abut_part_set_velocity; stays until it is set again */
  ABUT_VELOCITY_FROM_POSES = 2 /**< abut_part_measure_velocity */
};

/**
 * Gives a part a velocity; `velocity` may be null, which takes it away. Numbers are finite and at most 1e70. O(1).
 * [exclusive]
 */
ABUT_API abut_status abut_part_set_velocity(abut_universe *universe, abut_part_id part, const abut_velocity *velocity);

/** The same for `count` parts, all or none; `velocities` is an array of `count`, or null. O(count). [exclusive] */
ABUT_API abut_status abut_parts_set_velocities(abut_universe *universe, const abut_part_id *parts,
                                               const abut_velocity *velocities, size_t count);

/**
 * From now on the velocity of a part follows from its poses. It is zero until abut_universe_step with dt above 0 finds
 * it: the constant velocity that leads in dt from the pose before to the present one. Of two turns it takes the shorter
 * one. The pose before is that of the last such step, or that of this call. Steps without time and detections leave it
 * as it is. Numbers are cut to 1e70. A part that is measured already goes on. O(1), and O(parts that are measured) in
 * each step. [exclusive]
 */
ABUT_API abut_status abut_part_measure_velocity(abut_universe *universe, abut_part_id part);

/** The same for `count` parts, all or none. O(count). [exclusive] */
ABUT_API abut_status abut_parts_measure_velocities(abut_universe *universe, const abut_part_id *parts, size_t count);

/** Velocity of a part and where it comes from; `source` may be null. O(1). [const] */
ABUT_API abut_status abut_part_velocity(const abut_universe *universe, abut_part_id part, abut_velocity *out,
                                        abut_velocity_source *source);

/** Velocities of `count` parts. O(count). [const] */
ABUT_API abut_status abut_parts_velocities(const abut_universe *universe, const abut_part_id *parts, size_t count,
                                           abut_velocity *out);

/** How the velocity of a part changes within a step, in the world frame. */
typedef struct abut_acceleration {
  abut_vec3 linear;  /**< of the origin of the part, per second squared */
  abut_vec3 angular; /**< radians per second squared */
} abut_acceleration;

/**
 * Gives a part an acceleration; `acceleration` may be null, which takes it away. It stays until it is set again, and
 * changes no velocity. A part without a velocity starts from rest. Of a part that is measured it counts for nothing.
 * Numbers are finite and at most 1e70. O(1). [exclusive]
 */
ABUT_API abut_status abut_part_set_acceleration(abut_universe *universe, abut_part_id part,
                                                const abut_acceleration *acceleration);

/** The same for `count` parts, all or none; `accelerations` is an array of `count`, or null. O(count). [exclusive] */
ABUT_API abut_status abut_parts_set_accelerations(abut_universe *universe, const abut_part_id *parts,
                                                  const abut_acceleration *accelerations, size_t count);

/** Accelerations of `count` parts; zeros for those that have none. O(count). [const] */
ABUT_API abut_status abut_parts_accelerations(const abut_universe *universe, const abut_part_id *parts, size_t count,
                                              abut_acceleration *out);

/* ------------------------------------------------------------------------------------------------
 * Fast geometries
 *
 * A step with dt above 0 follows the paths of geometries with ABUT_GEOMETRY_FAST through the step: touches on them are
 * proven, whatever the speed. Everything that such a geometry may meet takes part: also other fast ones, what
 * is static or asleep, and sensors. Each part moves like this, fast or not:
 *
 *  - With a given velocity or an acceleration it starts at its pose. Its origin follows linear * t + acceleration *
 *    t^2 / 2, and it turns about its origin by angular * t + acceleration * t^2 / 2.
 *  - With a measured velocity (abut_part_measure_velocity) it starts at its pose at the end of the last step with time,
 *    and ends at its present pose, with constant velocities.
 *  - All others stay where they are.
 *
 * A pair with a fast geometry has contacts of one of these:
 *  - It touches at the start of the step: the contacts there; `toi` is 0.
 *  - It touches later: the contacts of that touch. Each of the two points is where its body has it at the start
 *    of the step; `normal` is that of the touch; `distance` is along it. `toi` tells when, and
 *    ABUT_CONTACT_SPECULATIVE is set. abut_universe_local_points tells the points on their bodies.
 *  - It touches again, as if nothing had stopped it, once the two have been apart by a 64th of the smaller one: the
 *    contacts of each such touch, in order of time, with ids of their own. Who is apart for less than a 64th of the
 *    step may be passed over. A pair has at most eight touches after the start.
 *  - It does not touch: none.
 * It touches where the distance is 0, or the tolerance in ABUT_TOLERANCE_MARGIN; a dead band does not count. Such pairs
 * are looked at in every step with time, whatever the period of their policy.
 *
 * A pair with ABUT_GEOMETRY_SPECULATIVE, and without ABUT_GEOMETRY_FAST, has the contacts of the start of the step. It
 * also has those that are further apart, as far as the motion may close the distance along the normal within the step.
 * They are found faster, but may stop a body at a corner that it passes by.
 *
 * Detections, and steps without time, know no paths: contacts are those of the present poses. A universe without such
 * geometries pays nothing.
 * --------------------------------------------------------------------------------------------- */

/** A touch of two geometries on their paths through a step. */
typedef struct abut_step_impact {
  abut_geometry_id geometry_a;
  abut_geometry_id geometry_b;
  double lower;           /**< fraction of the step; proven to be apart before it */
  double upper;           /**< fraction of the step; they touch there, unless it is undecided */
  uint32_t first_contact; /**< index of its first contact in abut_universe_contacts */
  uint32_t contact_count;
  uint32_t is_undecided;  /**< 1: the search has ended early, and nothing is known after `lower` */
  uint32_t reserved;      /**< zero */
} abut_step_impact;

/**
 * Impacts of the last step in order of time, then of slots: touches of pairs with a fast geometry on their paths, after
 * the start of the step. Borrowed until the next [exclusive] call. [const]
 */
ABUT_API abut_status abut_universe_impacts(const abut_universe *universe, const abut_step_impact **impacts,
                                           size_t *count);

/**
 * Moves all parts along their paths through dt, until the first of the fast geometries would touch: for those who stop
 * the world there. Up to `lower` of the impact, which is where the parts are then, no fast geometry touches anything,
 * which is proven. They touch as in a step: in ABUT_TOLERANCE_MARGIN at the tolerance. A step with time that follows
 * has the contacts of that touch; a detection has those of the present poses. Pairs that touch at the start hold
 * nothing up until they have parted, as above. Sensors hold nothing up, nor do pairs that a policy treats as boxes.
 * Velocities stay as they are. Fast geometries that have lent their next vertices advance by the same share of the way,
 * and lend them no longer. First touches of their elements hold the world up, as in a step. Vertices go on straight
 * lines, also those of bodies that turn. It brings boxes up to date as
 * abut_universe_refresh does, finds velocities that are measured, and may ask the filter. It detects no contacts.
 * @param dt   not negative, as in abut_universe_step
 * @param out  the impact, without contacts. Where there is none, the geometries are null, and `lower` and `upper` 1
 * Complexity as a step for the fast geometries. [exclusive]
 */
ABUT_API abut_status abut_universe_advance_to_first_impact(abut_universe *universe, double dt, abut_step_impact *out);

/* ------------------------------------------------------------------------------------------------
 * Self pairs
 *
 * A geometry with ABUT_GEOMETRY_SELF_PAIRS in its flags meets itself. It is a pair of its own: contacts and events
 * have it as geometry_a and as geometry_b, before its pairs with others.
 *
 *  - A mesh: each two triangles that have no corner in common, corners being compared by place. Both sides of a
 *    triangle count. feature_a is the face of the lower number, feature_b that of the higher one.
 *  - Particles: each two of them; child_a is the lower number, child_b the higher one.
 *  - Other kinds do not meet themselves: asking for it is ABUT_UNSUPPORTED. A geometry that gets such a shape later
 *    counts in unsupported_pairs of abut_step_stats.
 *
 * Rules, the filter, parking, events, sensors and the policy of the tag with itself apply. Layers, masks and exclusion
 * bits do not, as they speak of two geometries, and it does not matter how the part moves. The tolerance is twice that
 * of the geometry. Sleep and islands do not look at self pairs.
 *
 * The pair is examined whenever the geometry moves or changes, as one job. Complexity O(n log n + contacts) for n
 * triangles or particles of about one size. A universe without the flag pays nothing.
 * --------------------------------------------------------------------------------------------- */

/* ------------------------------------------------------------------------------------------------
 * Element contacts: which vertices, edges and faces of two geometries are near or touch. docs/deformables.md
 *
 * A pair whose policy has ABUT_DETAIL_ELEMENTS, and whose shapes both have triangles, has element contacts in place of
 * contacts. So has a mesh with ABUT_GEOMETRY_SELF_PAIRS, by the policy of its tag with itself.
 *
 *  - They are closest features within the tolerance of the pair, where the vertices are: what abut_elements_closest
 *    tells. The pair touches while it has any. Its events have no contacts; ABUT_EVENTS_ELEMENTS asks for those of each
 *    element contact.
 *  - A pair with ABUT_GEOMETRY_FAST has first touches in steps with time: what abut_elements_first_touches tells. Each
 *    vertex moves on a straight line in the world: from where it was in the last step with time to where it is now,
 *    whether its mesh was edited or its part was moved. A geometry that is new starts where it is. Velocities are not
 *    looked at. Features touch at the contact distance of the policy, at most the tolerance of the pair.
 *  - A fast geometry that has lent its next vertices (abut_geometry_next_vertices) looks ahead instead: it moves from
 *    where it is to these, which stay where they are. So a solver may look at a step before it takes it. Numbers that
 *    are not finite, or too large, are refused by the step.
 *  - The rest shape is the one that the first detection with such a policy sees, or the first one after
 *    abut_geometry_set_shape.
 *
 * A pair of which nothing has moved or changed keeps its element contacts, at no cost. For islands and sleep a pair
 * with element contacts is one with contacts. Coordinates in the world beyond 1e50 have none. A universe without such a
 * policy pays nothing.
 * --------------------------------------------------------------------------------------------- */

/** A vertex, edge or face of one geometry near one of another, or of the same geometry. 144 bytes. */
typedef struct abut_element_contact {
  abut_geometry_id geometry_a; /**< the one of the lower slot */
  abut_geometry_id geometry_b; /**< the same one in a self pair */
  abut_stencil stencil;        /**< in the world */
  double gap;                  /**< the distance less the contact distance of the policy */
  uint64_t id;                 /**< of the two features: from step to step the same, and unique within the pair */
  uint32_t age;                /**< how many steps ago the contact began, of those that looked at the pair; 0: now */
  uint32_t reserved;           /**< zero */
} abut_element_contact;

/**
 * Element contacts of the last step, ordered by the slots of the two geometries, then as abut_elements_closest or
 * abut_elements_first_touches orders them. Borrowed until the next [exclusive] call. [const]
 */
ABUT_API abut_status abut_universe_element_contacts(const abut_universe *universe,
                                                    const abut_element_contact **contacts, size_t *count);

/* ------------------------------------------------------------------------------------------------
 * Extension libraries of a universe
 * --------------------------------------------------------------------------------------------- */

/**
 * For extension libraries: an object of such a library, for example a picker, now stands on a universe. The universe
 * stays until the object is detached, also after abut_universe_destroy. Objects are counted by name;
 * abut_universe_explain tells the counts.
 * @param name  1 to 63 letters, digits, '_', '-' or '.'; copied
 * Complexity O(log names). [const]
 */
ABUT_API abut_status abut_universe_attach(const abut_universe *universe, const char *name);

/**
 * Takes one such object back; ABUT_UNKNOWN_VALUE when none of that name is attached. After abut_universe_destroy the
 * last one destroys the universe. [const]
 */
ABUT_API abut_status abut_universe_detach(const abut_universe *universe, const char *name);

/* ------------------------------------------------------------------------------------------------
 * Queries on a universe
 *
 * They see poses as of the last step or abut_universe_refresh, never a parked geometry, and change nothing: all are
 * [const] and may run on many threads at once. Pairs of kinds that have no answer (abut_pair_support) are passed over.
 * --------------------------------------------------------------------------------------------- */

typedef uint32_t abut_query_filter_flags;
enum abut_query_filter_flags_value ABUT_ENUM(uint32_t) {
  ABUT_QUERY_FILTER_SKIP_SENSORS = 1 /**< leaves sensors out */
};

/** What a ray meets that starts inside a solid. */
typedef uint32_t abut_ray_start;
enum abut_ray_start_value ABUT_ENUM(uint32_t) {
  ABUT_RAY_START_FAR_SIDE = 0, /**< its far side, as abut_shape_cast_ray does */
  ABUT_RAY_START_SOLID = 1,    /**< the solid, at distance 0 and with a normal of zeros, since there is none */
  ABUT_RAY_START_SKIP = 2      /**< nothing of that geometry */
};

/**
 * Which geometries a query looks at: those that it does not ignore, whose layers meet its mask and whose mask meets its
 * layers. A filter may be null, which is the default one.
 */
typedef struct abut_query_filter {
  uint32_t struct_size;
  abut_query_filter_flags flags;           /**< default 0 */
  uint64_t layers;                  /**< default all */
  uint64_t mask;                    /**< default all */
  abut_part_id ignore_part;         /**< with all its geometries; default null for none */
  abut_geometry_id ignore_geometry; /**< default null for none */
  abut_ray_start ray_start;         /**< of rays only; default ABUT_RAY_START_FAR_SIDE */
  uint32_t reserved;                /**< zero */
} abut_query_filter;

ABUT_API void abut_query_filter_init(abut_query_filter *filter, uint32_t struct_size);

/** How many of the geometries that are met are reported. */
typedef uint32_t abut_hit_mode;
enum abut_hit_mode_value ABUT_ENUM(uint32_t) {
  ABUT_HIT_NEAREST = 0, /**< the one that is met first; of several at once that of the lowest slot */
  ABUT_HIT_ANY = 1,     /**< one, whichever is found first: the quickest way to know whether there is any */
  ABUT_HIT_ALL = 2      /**< each geometry once, in the order in which they are met, then by slot */
};

/** Where a ray meets a geometry. */
typedef struct abut_query_hit {
  abut_geometry_id geometry; /**< null in a batch: the ray meets nothing */
  abut_feature feature;      /**< what of the shape is met */
  uint32_t child;            /**< of a composite; 0 for all other shapes */
  uint32_t reserved;         /**< zero */
  double distance;           /**< from the origin, along the unit direction; not above max_distance */
  abut_vec3 point;           /**< world frame */
  abut_vec3 normal;          /**< unit, out of the solid; zeros where the ray starts inside it (abut_ray_start) */
} abut_query_hit;

/**
 * Geometries that a ray meets, by count-then-fill; each with its first crossing. A ray that just reaches a surface
 * meets it.
 * @param filter  may be null
 * Complexity O(log n) for each geometry near the ray. [const]
 */
ABUT_API abut_status abut_universe_cast_ray(const abut_universe *universe, const abut_ray *ray,
                                            const abut_query_filter *filter, abut_hit_mode mode, abut_query_hit *hits,
                                            size_t capacity, size_t *count);

/** The nearest hit of each of `count` rays; its geometry is null where there is none. [const] */
ABUT_API abut_status abut_universe_cast_rays(const abut_universe *universe, const abut_ray *rays, size_t count,
                                             const abut_query_filter *filter, abut_query_hit *hits);

/**
 * Where a moving shape (a) first touches another (b). It does not touch before `fraction`, and there it is no further
 * away than contact.upper. Shapes that touch at the start have fraction 0 and the deepest contact. Meshes with
 * ABUT_SIDES_FRONT and height fields let through what comes from behind. What touches their front within rounding is
 * stopped where it moves into them; else it moves off or along them freely.
 */
typedef struct abut_cast_hit {
  abut_geometry_id geometry; /**< what is met (b); null for two shapes alone, and in a batch where nothing is met */
  double fraction;           /**< of the displacement, in [0, 1]; infinite where abut_pairs_cast finds no touch */
  abut_distance contact;     /**< at that time, in the world */
  abut_feature feature_a;    /**< the triangle of a mesh or a height field; of others ABUT_FEATURE_WHOLE, or what
                                  touches at the start */
  abut_feature feature_b;
  uint32_t child_a;          /**< of a composite, or the particle; 0 for all other shapes */
  uint32_t child_b;
} abut_cast_hit;

/**
 * Geometries that a shape meets while it moves by a displacement without turning, by count-then-fill.
 * @param filter  may be null
 * Complexity O(log n) for each geometry near its way, and some distances each. Source: conservative advancement along
 * separating planes (van den Bergen 2004). [const]
 */
ABUT_API abut_status abut_universe_cast_shape(const abut_universe *universe, const abut_shape *shape,
                                              const abut_pose *pose, const abut_vec3 *displacement,
                                              const abut_query_filter *filter, abut_hit_mode mode, abut_cast_hit *hits,
                                              size_t capacity, size_t *count);

/** The nearest hit of each of `count` shapes, each with a pose and a displacement of its own. [const] */
ABUT_API abut_status abut_universe_cast_shapes(const abut_universe *universe, const abut_shape *const *shapes,
                                               const abut_pose *poses, const abut_vec3 *displacements, size_t count,
                                               const abut_query_filter *filter, abut_cast_hit *hits);

/** What a shape meets that moves and turns (a): a geometry (b), and when. */
typedef struct abut_impact_hit {
  abut_geometry_id geometry; /**< null in a batch: nothing is met */
  abut_impact impact;        /**< never apart; undecided where it may be met, from `lower` on */
} abut_impact_hit;

/**
 * Geometries that a shape meets while it moves, turns and speeds up, by count-then-fill. They are ordered by
 * impact.lower: nothing is met before that of the first one. The geometries stay where they are. A cast by
 * abut_universe_cast_shape is the case without a turn.
 *
 * ABUT_OUT_OF_RANGE and ABUT_UNSUPPORTED as for abut_pair_time_of_impact.
 * @param movement  abut_movement_between makes one of two poses
 * @param duration  above 0
 * @param options   may be null; `threads` has no effect
 * @param filter    may be null
 * Complexity O(log n) for each geometry near its way, and a time of impact each. Source: docs/continuous.md. [const]
 */
ABUT_API abut_status abut_universe_cast_movement(const abut_universe *universe, const abut_shape *shape,
                                                 const abut_pose *pose, const abut_movement *movement,
                                                 double duration, const abut_impact_options *options,
                                                 const abut_query_filter *filter, abut_hit_mode mode,
                                                 abut_impact_hit *hits, size_t capacity, size_t *count);

/**
 * The first hit of each of `count` shapes, each with a pose and a movement of its own. Parameters as those of
 * abut_universe_cast_movement. [const]
 */
ABUT_API abut_status abut_universe_cast_movements(const abut_universe *universe, const abut_shape *const *shapes,
                                                  const abut_pose *poses, const abut_movement *movements,
                                                  size_t count, double duration, const abut_impact_options *options,
                                                  const abut_query_filter *filter, abut_impact_hit *hits);

/**
 * Geometries with which a shape has contacts up to a distance, by count-then-fill, ordered by slot. No contacts are
 * made: the first common point decides, as with abut_pair_overlaps. A one-sided surface counts where the shape reaches
 * before its front, also around its border, where there may be no contact.
 * @param filter  may be null
 * @param margin  as in abut_query_options; 0 for what touches, may also be less
 * [const]
 */
ABUT_API abut_status abut_universe_overlaps(const abut_universe *universe, const abut_shape *shape,
                                            const abut_pose *pose, const abut_query_filter *filter, double margin,
                                            abut_geometry_id *geometries, size_t capacity, size_t *count);

/**
 * The same for each of `query_count` shapes. Those of query i are geometries[offsets[i]] up to geometries[offsets[i +
 * 1]].
 * @param offsets     query_count + 1 numbers, always all written
 * @param count       the last of them; `geometries` is filled as far as `capacity`
 * [const]
 */
ABUT_API abut_status abut_universe_overlaps_of_each(const abut_universe *universe, const abut_shape *const *shapes,
                                                    const abut_pose *poses, size_t query_count,
                                                    const abut_query_filter *filter, double margin, uint64_t *offsets,
                                                    abut_geometry_id *geometries, size_t capacity, size_t *count);

/** Solids that hold a point, and surfaces that it lies on, by count-then-fill, ordered by slot. [const] */
ABUT_API abut_status abut_universe_at_point(const abut_universe *universe, const abut_vec3 *position,
                                            const abut_query_filter *filter, abut_geometry_id *geometries,
                                            size_t capacity, size_t *count);

/** The same for each of `query_count` points, answered as by abut_universe_overlaps_of_each. [const] */
ABUT_API abut_status abut_universe_at_points(const abut_universe *universe, const abut_vec3 *positions,
                                             size_t query_count, const abut_query_filter *filter, uint64_t *offsets,
                                             abut_geometry_id *geometries, size_t capacity, size_t *count);

/** What is closest to a shape. */
typedef struct abut_closest {
  abut_geometry_id geometry; /**< null in a batch: nothing is near */
  abut_distance distance;    /**< from the shape (a) to the geometry (b); negative where they overlap */
} abut_closest;

/**
 * The geometry of the least signed distance; of several the one of the lowest slot.
 * @param max_distance  not negative, may be infinite; what is further away does not count
 * @param filter        may be null
 * @param out           written when *found is 1
 * @param found         receives 1 or 0
 * [const]
 */
ABUT_API abut_status abut_universe_closest(const abut_universe *universe, const abut_shape *shape,
                                           const abut_pose *pose, double max_distance, const abut_query_filter *filter,
                                           abut_closest *out, uint32_t *found);

/** The same for each of `count` shapes; the geometry is null where nothing is near. [const] */
ABUT_API abut_status abut_universe_closest_to_each(const abut_universe *universe, const abut_shape *const *shapes,
                                                   const abut_pose *poses, size_t count, double max_distance,
                                                   const abut_query_filter *filter, abut_closest *out);

/**
 * When two shapes that both move without turning first touch, or come as near as options->margin.
 * ABUT_UNSUPPORTED for pairs that have no distance, and for algorithms other than ABUT_ALGORITHM_AUTO.
 * @param options  may be null; the margin is not negative
 * @param hit      written when *found is 1
 * @param found    receives 1 or 0
 * Source: as abut_universe_cast_shape. [any]
 */
ABUT_API abut_status abut_pair_cast(const abut_shape *a, const abut_pose *pose_a, const abut_vec3 *displacement_a,
                                    const abut_shape *b, const abut_pose *pose_b, const abut_vec3 *displacement_b,
                                    const abut_query_options *options, abut_cast_hit *hit, uint32_t *found);

/**
 * The same for `count` pairs of poses and displacements of the same two shapes. Where two never touch, the fraction of
 * their hit is infinite, and all else in it is zero. The first failure ends it, nothing is written then. [any]
 */
ABUT_API abut_status abut_pairs_cast(const abut_shape *a, const abut_pose *poses_a, const abut_vec3 *displacements_a,
                                     const abut_shape *b, const abut_pose *poses_b, const abut_vec3 *displacements_b,
                                     size_t count, const abut_query_options *options, abut_cast_hit *hits);

/* ------------------------------------------------------------------------------------------------
 * Layout report, for bindings that want to check their own structs
 * --------------------------------------------------------------------------------------------- */

typedef struct abut_layout_entry {
  const char *type;  /**< such as "abut_pose" */
  const char *field; /**< such as "orientation"; empty for the struct itself */
  uint64_t offset;   /**< of the field; 0 for the struct itself */
  uint64_t size;     /**< of the field or struct */
} abut_layout_entry;

/** Number of entries of the layout report. [any] */
ABUT_API size_t abut_layout_count(void);

/** One entry of the layout report; ABUT_INDEX_OUT_OF_RANGE past the end. [any] */
ABUT_API abut_status abut_layout_at(size_t index, abut_layout_entry *out);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif /* ABUT_ABUT_H */
