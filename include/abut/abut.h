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
 *  - Arrays of unknown length are filled by count-then-fill: `capacity` elements fit into the array,
 *    `count` receives how many there are; nothing past `capacity` is written. A null array with
 *    capacity 0 asks for the count only.
 *  - Thread rule of each function: [any] any thread at any time; [const] together with other [const]
 *    calls on the same universe, not during an [exclusive] one; [exclusive] alone on its universe.
 *    Shapes never change after creation, so calls that only read shapes are [any].
 *  - Structs that begin with struct_size grow over time. Fill them with their _init function, which
 *    is told sizeof of the struct as the caller knows it, then change fields. A caller compiled against
 *    an older header stays valid.
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
#define ABUT_VERSION_MINOR 1
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
  ABUT_OUT_OF_MEMORY = 15,
  ABUT_INTERNAL = 16              /**< a defect of abut; the universe answers only this from now on */
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

/** Version of the library that was loaded, such as "0.1.0". Static. [any] */
ABUT_API const char *abut_version_string(void);

/**
 * Checks that the loaded library understands the header that the caller was compiled with; pass
 * ABUT_VERSION_MAJOR and ABUT_VERSION_MINOR. ABUT_UNSUPPORTED when it does not. [any]
 */
ABUT_API abut_status abut_check_version(uint32_t major, uint32_t minor);

/** 1 when this build contains the feature ("libccd", "hull"), otherwise 0. [any] */
ABUT_API uint32_t abut_has_feature(const char *name);

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
  ABUT_FEATURE_WHOLE = 0,  /**< the shape as a whole: spheres, planes, caps */
  ABUT_FEATURE_VERTEX = 1,
  ABUT_FEATURE_EDGE = 2,
  ABUT_FEATURE_FACE = 3    /**< of a mesh or a height field: the triangle */
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
 * "cylinder_hole", "box_hole". 0 if none in this build. docs/shapes.md lists what they take. [any]
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
  ABUT_QUERY_DISTANCE = 0, /**< abut_shapes_distance and abut_shapes_distances */
  ABUT_QUERY_CONTACTS = 1  /**< abut_shapes_contacts, and contacts in a universe */
};

/**
 * Whether two kinds of shape answer a query, in either order; docs/pairs.md is the table of it. `out` becomes 1
 * or 0. ABUT_UNKNOWN_VALUE for a number that is no kind of this build, or no query. [any]
 */
ABUT_API abut_status abut_pair_support(abut_shape_kind kind_a, abut_shape_kind kind_b, abut_query query, uint32_t *out);

/** Solid ball of a positive radius, centred. [any] */
ABUT_API abut_status abut_sphere_create(double radius, abut_shape **out);

/** Solid box, centred; half extents are positive, or zero for a flat box. [any] */
ABUT_API abut_status abut_box_create(double half_x, double half_y, double half_z, abut_shape **out);

/**
 * Solid capsule along local Z: all points within `radius` (positive) of the segment from
 * (0, 0, -half_height) to (0, 0, half_height), half_height >= 0. [any]
 */
ABUT_API abut_status abut_capsule_create(double radius, double half_height, abut_shape **out);

/** Solid cylinder along local Z with flat ends, centred; neither is negative. [any] */
ABUT_API abut_status abut_cylinder_create(double radius, double half_height, abut_shape **out);

/**
 * Half-space of the points p with dot(normal, p) <= offset. The normal points out of the solid, has
 * any length but zero, and is normalised; the offset is measured along the unit normal. [any]
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
  ABUT_SIDES_BOTH = 0, /**< a sheet: pushed out on the side where the other shape lies */
  ABUT_SIDES_FRONT = 1 /**< only the counter-clockwise side stops other shapes */
};

typedef struct abut_mesh_options {
  uint32_t struct_size;
  abut_sides sides; /**< default ABUT_SIDES_BOTH */
} abut_mesh_options;

ABUT_API void abut_mesh_options_init(abut_mesh_options *options, uint32_t struct_size);

/**
 * Triangle mesh: a surface without inside.
 * @param xyz             vertex_count * 3 numbers, copied
 * @param triangles       triangle_count * 3 indices into the vertices, counter-clockwise seen from
 *                        the front, copied; triangles without area are kept
 * @param options         may be null
 * Complexity O(n); its tree is built when a query first needs it, in O(n log n). [any]
 */
ABUT_API abut_status abut_mesh_create(const double *xyz, size_t vertex_count, const uint32_t *triangles,
                                      size_t triangle_count, const abut_mesh_options *options, abut_shape **out);

/**
 * Terrain over a regular grid. Sample (i, j) is the point (i * spacing_x, j * spacing_y,
 * heights[j * columns + i]) - each cell holds two triangles, split from (i, j) to (i + 1, j + 1).
 * One-sided: the front is +Z.
 */
typedef struct abut_height_field_desc {
  uint32_t struct_size;
  uint32_t reserved;     /**< zero */
  uint32_t columns;      /**< samples along X, from 2 to 65535 */
  uint32_t rows;         /**< samples along Y, from 2 to 65535 */
  double spacing_x;      /**< positive */
  double spacing_y;      /**< positive */
  const double *heights; /**< columns * rows numbers, X fastest, copied */
} abut_height_field_desc;

ABUT_API void abut_height_field_desc_init(abut_height_field_desc *desc, uint32_t struct_size);

/** Terrain. Complexity O(samples). Source: grid cells found by division, SPEC VX-11. [any] */
ABUT_API abut_status abut_height_field_create(const abut_height_field_desc *desc, abut_shape **out);

/**
 * Many small balls in one shape; a hash grid of its own finds those near another shape.
 * @param xyz     count * 3 numbers, the centres, copied
 * @param count   at least 1
 * @param radius  of each, positive; particles of various radii come through abut_shape_create
 * Complexity O(n); the grid is built when a query first needs it, in O(n). [any]
 */
ABUT_API abut_status abut_particles_create(const double *xyz, size_t count, double radius, abut_shape **out);

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
 * The generic door: any kind of shape from its parameters and buffers. What each kind takes is
 * listed in docs/shapes.md.
 */
typedef struct abut_shape_desc {
  uint32_t struct_size;
  abut_shape_kind kind;
  const double *parameters; /**< parameter_count numbers, in the order of abut_shape_kind_parameter_name */
  uint64_t parameter_count;
  const double *reals;      /**< vertices (x, y, z each) or heights; null where the kind has none */
  uint64_t real_count;      /**< how many numbers, not how many points */
  const uint32_t *indices;  /**< triangles (three each); null where the kind has none */
  uint64_t index_count;
} abut_shape_desc;

ABUT_API void abut_shape_desc_init(abut_shape_desc *desc, uint32_t struct_size);

/** Creates a shape of any kind; the named functions above are shorthands for it. [any] */
ABUT_API abut_status abut_shape_create(const abut_shape_desc *desc, abut_shape **out);

/** One more reference to a shape. Null is allowed. [any] */
ABUT_API void abut_shape_retain(abut_shape *shape);

/** One reference less; the last one destroys the shape. Geometries hold references of their own. Null is allowed. [any] */
ABUT_API void abut_shape_release(abut_shape *shape);

/** Kind of a shape; 0 for null. [any] */
ABUT_API abut_shape_kind abut_shape_kind_of(const abut_shape *shape);

/** Parameters of a shape by count-then-fill, in the order of its kind. [any] */
ABUT_API abut_status abut_shape_parameters(const abut_shape *shape, double *parameters, size_t capacity, size_t *count);

/** Box around a shape under a pose; infinite sides for unbounded shapes. [any] */
ABUT_API abut_status abut_shape_aabb(const abut_shape *shape, const abut_pose *pose, abut_aabb *out);

/**
 * Surface of a mesh, height field, hull or box as triangles in the local frame, by count-then-fill;
 * of a mesh or a height field, triangle i is the feature (ABUT_FEATURE_FACE, i) of ray hits and contacts;
 * the faces of boxes and hulls become several triangles each, in order. ABUT_UNSUPPORTED for
 * curved and unbounded shapes, which rays meet exactly through abut_shape_cast_ray.
 * @param xyz        vertex_capacity * 3 numbers
 * @param triangles  triangle_capacity * 3 indices
 * [any]
 */
ABUT_API abut_status abut_shape_triangles(const abut_shape *shape, double *xyz, size_t vertex_capacity, size_t *vertex_count,
                                          uint32_t *triangles, size_t triangle_capacity, size_t *triangle_count);

/** A ray. The direction has any length but zero; distances are measured in world units. */
typedef struct abut_ray {
  abut_vec3 origin;
  abut_vec3 direction;
  double max_distance; /**< not negative; may be infinite */
} abut_ray;

typedef struct abut_ray_hit {
  double distance;      /**< from the origin, along the unit direction */
  abut_vec3 point;      /**< world frame */
  abut_vec3 normal;     /**< unit, world frame, out of the solid; of a mesh: by winding */
  abut_feature feature; /**< what was hit */
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
  ABUT_ALGORITHM_LIBCCD_MPR = 5   /**< libccd's Minkowski portal refinement; overlapping pairs only */
};

typedef struct abut_query_options {
  uint32_t struct_size;
  abut_algorithm algorithm; /**< default ABUT_ALGORITHM_AUTO */
  /** Allowed upper - lower of a distance, relative to the size of the shapes; 0 for the default: 1e-12, and
   * 1e-9 where a cylinder, a cone or an ellipsoid takes part. */
  double error_bound;
  double margin;            /**< contacts are reported up to this distance; default 0; may be negative */
  uint32_t max_contacts;    /**< a manifold of two shapes, or of two children, is reduced to this many, keeping the deepest and the largest area; 0 keeps all; default 4 */
  uint32_t reserved;        /**< zero */
} abut_query_options;

ABUT_API void abut_query_options_init(abut_query_options *options, uint32_t struct_size);

/** Signed distance of two shapes. */
typedef struct abut_distance {
  double distance;          /**< negative: the depth by which they overlap, the least translation that parts them */
  double lower;             /**< the true distance lies in [lower, upper], up to rounding */
  double upper;
  abut_vec3 point_a;        /**< on the surface of a, world frame */
  abut_vec3 point_b;        /**< on the surface of b, world frame */
  abut_vec3 normal;         /**< unit, from a to b; dot(point_b - point_a, normal) == distance */
  abut_algorithm algorithm; /**< what was used */
  uint32_t iterations;      /**< steps that it took */
} abut_distance;

/** One contact point. Swapping a and b swaps points and features and negates the normal. */
typedef struct abut_contact {
  abut_geometry_id geometry_a; /**< null in pair queries */
  abut_geometry_id geometry_b;
  uint64_t id;                 /**< unique within the pair; the same while the same features touch */
  abut_feature feature_a;
  abut_feature feature_b;
  uint32_t child_a;            /**< of a composite, or the particle; 0 for all other shapes */
  uint32_t child_b;
  abut_vec3 point_a;           /**< on the surface of a, world frame */
  abut_vec3 point_b;           /**< on the surface of b, world frame */
  abut_vec3 normal;            /**< unit, from a to b */
  double distance;             /**< dot(point_b - point_a, normal); negative: overlapping */
  double toi;                  /**< fraction of the step at first touch, in [0, 1]; 0 for discrete contacts */
  uint32_t flags;              /**< zero */
  uint32_t age;                /**< steps in a row before this one that reported it; 0 when it is new, and in pair queries */
  uint64_t user_data;          /**< as abut_contacts_set_user_data left it, while the contact stays; 0 when it is new */
} abut_contact;

/**
 * Signed distance, closest or deepest points and normal of two shapes.
 * ABUT_UNSUPPORTED for terrain against terrain, and for an algorithm that the pair does not have.
 * @param options  may be null
 * Source: GJK with signed volumes (Montanari et al. 2017), EPA (van den Bergen 2001). [any]
 */
ABUT_API abut_status abut_shapes_distance(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                          const abut_pose *pose_b, const abut_query_options *options, abut_distance *out);

/** The same for `count` pairs of poses of the same two shapes; the first failure ends it, nothing is written then. [any] */
ABUT_API abut_status abut_shapes_distances(const abut_shape *a, const abut_pose *poses_a, const abut_shape *b,
                                           const abut_pose *poses_b, size_t count, const abut_query_options *options,
                                           abut_distance *out);

/**
 * Contact points of two shapes by count-then-fill, deepest first; none when they are further apart
 * than the margin.
 * @param options  may be null
 * [any]
 */
ABUT_API abut_status abut_shapes_contacts(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                          const abut_pose *pose_b, const abut_query_options *options,
                                          abut_contact *contacts, size_t capacity, size_t *count);

/* ------------------------------------------------------------------------------------------------
 * Universe
 * --------------------------------------------------------------------------------------------- */

/** A space in which parts meet. Owned by its creator. */
typedef struct abut_universe abut_universe;

typedef uint32_t abut_broadphase;
enum abut_broadphase_value ABUT_ENUM(uint32_t) {
  ABUT_BROADPHASE_AUTO = 0,
  ABUT_BROADPHASE_BRUTE = 1, /**< every pair of boxes; for a few dozen geometries */
  ABUT_BROADPHASE_TREE = 2   /**< dynamic box tree */
};

typedef uint32_t abut_tolerance_mode;
enum abut_tolerance_mode_value ABUT_ENUM(uint32_t) {
  ABUT_TOLERANCE_DEAD_BAND = 0, /**< an overlap is reported when it exceeds the tolerance */
  ABUT_TOLERANCE_MARGIN = 1     /**< a separation is reported when it is below the tolerance */
};

typedef struct abut_universe_options {
  uint32_t struct_size;
  abut_broadphase broadphase;         /**< default ABUT_BROADPHASE_AUTO */
  abut_tolerance_mode tolerance_mode; /**< default ABUT_TOLERANCE_DEAD_BAND */
  uint32_t max_contacts;              /**< per pair of convex shapes or triangle patch; 0 keeps all; default 4 */
  abut_vec3 origin;                   /**< boxes of the broad phase are stored relative to it; default 0 */
} abut_universe_options;

ABUT_API void abut_universe_options_init(abut_universe_options *options, uint32_t struct_size);

/** Creates a universe; the caller frees it with abut_universe_destroy. `options` may be null. [any] */
ABUT_API abut_status abut_universe_create(const abut_universe_options *options, abut_universe **out);

/** Destroys a universe and everything in it. Null is allowed. [exclusive] */
ABUT_API void abut_universe_destroy(abut_universe *universe);

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
ABUT_API abut_status abut_parts_create(abut_universe *universe, const abut_part_options *options, size_t count, abut_part_id *out);

/** Destroys a part and its geometries. [exclusive] */
ABUT_API abut_status abut_part_destroy(abut_universe *universe, abut_part_id part);

/** Destroys `count` parts, all or none; an id that occurs twice is stale the second time. [exclusive] */
ABUT_API abut_status abut_parts_destroy(abut_universe *universe, const abut_part_id *parts, size_t count);

/** Places a part; takes effect for pairs at the next step. [exclusive] */
ABUT_API abut_status abut_part_set_pose(abut_universe *universe, abut_part_id part, const abut_pose *pose);

/** Places `count` parts, all or none. [exclusive] */
ABUT_API abut_status abut_parts_set_poses(abut_universe *universe, const abut_part_id *parts, const abut_pose *poses, size_t count);

/** Pose of a part. [const] */
ABUT_API abut_status abut_part_pose(const abut_universe *universe, abut_part_id part, abut_pose *out);

/** Poses of `count` parts. [const] */
ABUT_API abut_status abut_parts_poses(const abut_universe *universe, const abut_part_id *parts, size_t count, abut_pose *out);

/** Your value on a part. [const] */
ABUT_API abut_status abut_part_user_data(const abut_universe *universe, abut_part_id part, uint64_t *out);

/** Geometries of a part by count-then-fill, in order of creation. [const] */
ABUT_API abut_status abut_part_geometries(const abut_universe *universe, abut_part_id part, abut_geometry_id *geometries,
                                          size_t capacity, size_t *count);

typedef struct abut_geometry_options {
  uint32_t struct_size;
  uint32_t reserved;   /**< zero */
  abut_pose pose;      /**< in the frame of the part; default identity */
  double tolerance;    /**< not negative; the tolerance of a pair is the sum of both; default 0 */
  uint64_t user_data;  /**< yours; default 0 */
} abut_geometry_options;

ABUT_API void abut_geometry_options_init(abut_geometry_options *options, uint32_t struct_size);

/** Puts a shape on a part; the universe holds a reference to the shape. `options` may be null. [exclusive] */
ABUT_API abut_status abut_geometry_create(abut_universe *universe, abut_part_id part, const abut_shape *shape,
                                          const abut_geometry_options *options, abut_geometry_id *out);

/** Puts `count` shapes on `count` parts, all or none; `options` is an array of `count`, or null. [exclusive] */
ABUT_API abut_status abut_geometries_create(abut_universe *universe, const abut_part_id *parts, const abut_shape *const *shapes,
                                            const abut_geometry_options *options, size_t count, abut_geometry_id *out);

/** Takes a geometry away. [exclusive] */
ABUT_API abut_status abut_geometry_destroy(abut_universe *universe, abut_geometry_id geometry);

/** Takes `count` geometries away, all or none; an id that occurs twice is stale the second time. [exclusive] */
ABUT_API abut_status abut_geometries_destroy(abut_universe *universe, const abut_geometry_id *geometries, size_t count);

/** What a geometry is and where. Set struct_size, or use the _init function, before asking. */
typedef struct abut_geometry_info {
  uint32_t struct_size;
  abut_shape_kind kind;
  abut_part_id part;
  abut_shape *shape;  /**< borrowed until the geometry is destroyed; retain it to keep it longer */
  abut_pose pose;     /**< in the world */
  abut_pose local;    /**< in the frame of the part */
  double tolerance;
  uint64_t user_data;
} abut_geometry_info;

ABUT_API void abut_geometry_info_init(abut_geometry_info *info, uint32_t struct_size);

/** Describes a geometry. [const] */
ABUT_API abut_status abut_geometry_describe(const abut_universe *universe, abut_geometry_id geometry, abut_geometry_info *out);

/** World poses of `count` geometries. [const] */
ABUT_API abut_status abut_geometries_poses(const abut_universe *universe, const abut_geometry_id *geometries, size_t count, abut_pose *out);

/** All parts by count-then-fill, ordered by slot. [const] */
ABUT_API abut_status abut_universe_parts(const abut_universe *universe, abut_part_id *parts, size_t capacity, size_t *count);

/** All geometries by count-then-fill, ordered by slot. [const] */
ABUT_API abut_status abut_universe_geometries(const abut_universe *universe, abut_geometry_id *geometries, size_t capacity, size_t *count);

/** Counters that tell tools what changed since they last looked. */
typedef struct abut_revision {
  uint64_t geometries; /**< grows when a geometry is created or destroyed */
  uint64_t poses;      /**< grows when a pose is set */
} abut_revision;

/** Change counters of a universe. O(1). [const] */
ABUT_API abut_status abut_universe_revision(const abut_universe *universe, abut_revision *out);

/**
 * Detects over [t, t + dt]; moves nothing. Discrete: contacts are those of the present poses.
 * @param dt  not negative
 * Complexity O(n log n + pairs) for n moved geometries. [exclusive]
 */
ABUT_API abut_status abut_universe_step(abut_universe *universe, double dt);

/** Contacts of the last step, ordered by the slots of the two geometries, then deepest first. Borrowed until the next [exclusive] call. [const] */
ABUT_API abut_status abut_universe_contacts(const abut_universe *universe, const abut_contact **contacts, size_t *count);

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
  uint64_t moved;                  /**< geometries whose box was refreshed */
  uint64_t candidate_pairs;        /**< pairs of overlapping boxes handed to the narrow phase */
  uint64_t touching_pairs;         /**< pairs with at least one contact */
  uint64_t contacts;
  uint64_t unsupported_pairs;      /**< candidates that have no algorithm by declaration */
  uint64_t bytes;                  /**< memory held by the universe, without shapes */
  double refresh_microseconds;     /**< poses to boxes */
  double broadphase_microseconds;  /**< boxes to pairs */
  double narrowphase_microseconds; /**< pairs to manifolds */
  double contact_microseconds;     /**< reduction and ordering */
} abut_step_stats;

ABUT_API void abut_step_stats_init(abut_step_stats *stats, uint32_t struct_size);

/** Counts and times of the last step; zeros before the first. [const] */
ABUT_API abut_status abut_universe_stats(const abut_universe *universe, abut_step_stats *out);

/**
 * The plan in words: stages, algorithm per pair of kinds and why, what was left out, counts, bytes
 * and microseconds of the last step.
 * @param text      capacity bytes, always terminated when capacity > 0; null with capacity 0 asks for the size
 * @param needed    bytes of the whole text with its terminator
 * [const]
 */
ABUT_API abut_status abut_universe_explain(const abut_universe *universe, char *text, size_t capacity, size_t *needed);

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
