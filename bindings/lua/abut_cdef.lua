-- SPDX-License-Identifier: Apache-2.0
-- Made by bindings/lua/cdef.py from include/abut/abut.h, where each name is described. Do not edit.
require("ffi").cdef [[
typedef int32_t abut_status;
enum abut_status_value {
  ABUT_OK = 0,
  ABUT_INVALID_ARGUMENT = 1,
  ABUT_NULL_ARGUMENT = 2,
  ABUT_NOT_FINITE = 3,
  ABUT_OUT_OF_RANGE = 4,
  ABUT_ZERO_VECTOR = 5,
  ABUT_NOT_UNIT = 6,
  ABUT_INDEX_OUT_OF_RANGE = 7,
  ABUT_SIZE_OVERFLOW = 8,
  ABUT_EMPTY = 9,
  ABUT_STALE_ID = 10,
  ABUT_WRONG_STRUCT_SIZE = 11,
  ABUT_UNKNOWN_VALUE = 12,
  ABUT_UNSUPPORTED = 13,
  ABUT_NOT_CONVERGED = 14,
  ABUT_OUT_OF_MEMORY = 15,
  ABUT_INTERNAL = 16,
  ABUT_BUSY = 17
};
abut_status abut_set_last_error(abut_status status, const char *message);
const char *abut_status_name(abut_status status);
const char *abut_last_error_message(void);
typedef uint32_t abut_log_level;
enum abut_log_level_value {
  ABUT_LOG_NONE = 0,
  ABUT_LOG_ERROR = 1,
  ABUT_LOG_WARNING = 2
};
typedef void (*abut_log)(void *context, abut_log_level level, const char *message);
abut_status abut_set_log(abut_log log, void *context, abut_log_level most);
const char *abut_version_string(void);
abut_status abut_check_version(uint32_t major, uint32_t minor);
uint32_t abut_has_feature(const char *name);
typedef void *(*abut_allocate)(void *context, size_t size, size_t alignment);
typedef void (*abut_release)(void *context, void *memory, size_t size, size_t alignment);
abut_status abut_set_allocator(abut_allocate allocate, abut_release release, void *context);
abut_status abut_memory_in_use(uint64_t *bytes, uint64_t *blocks);
void *abut_memory_allocate(size_t size, size_t alignment);
void abut_memory_release(void *memory, size_t size, size_t alignment);
typedef struct abut_vec3 {
  double x;
  double y;
  double z;
} abut_vec3;
typedef struct abut_quat {
  double w;
  double x;
  double y;
  double z;
} abut_quat;
typedef struct abut_pose {
  abut_vec3 position;
  abut_quat orientation;
} abut_pose;
typedef struct abut_aabb {
  abut_vec3 minimum;
  abut_vec3 maximum;
} abut_aabb;
typedef struct abut_part_id {
  uint32_t slot;
  uint32_t generation;
} abut_part_id;
typedef struct abut_geometry_id {
  uint32_t slot;
  uint32_t generation;
} abut_geometry_id;
typedef uint32_t abut_feature_kind;
enum abut_feature_kind_value {
  ABUT_FEATURE_WHOLE = 0,
  ABUT_FEATURE_VERTEX = 1,
  ABUT_FEATURE_EDGE = 2,
  ABUT_FEATURE_FACE = 3,
  ABUT_FEATURE_CELL = 4,
  ABUT_FEATURE_PARTICLE = 5
};
typedef struct abut_feature {
  abut_feature_kind kind;
  uint32_t index;
} abut_feature;
typedef struct abut_shape abut_shape;
typedef uint32_t abut_shape_kind;
size_t abut_shape_kind_count(void);
abut_shape_kind abut_shape_kind_at(size_t index);
abut_shape_kind abut_shape_kind_by_name(const char *name);
const char *abut_shape_kind_name(abut_shape_kind kind);
size_t abut_shape_kind_parameter_count(abut_shape_kind kind);
const char *abut_shape_kind_parameter_name(abut_shape_kind kind, size_t index);
typedef uint32_t abut_query;
enum abut_query_value {
  ABUT_QUERY_DISTANCE = 0,
  ABUT_QUERY_CONTACTS = 1
};
abut_status abut_pair_support(abut_shape_kind kind_a, abut_shape_kind kind_b, abut_query query, uint32_t *out);
abut_status abut_sphere_create(double radius, abut_shape **out);
abut_status abut_box_create(double half_x, double half_y, double half_z, abut_shape **out);
abut_status abut_capsule_create(double radius, double half_height, abut_shape **out);
abut_status abut_cylinder_create(double radius, double half_height, abut_shape **out);
abut_status abut_cone_create(double radius, double half_height, abut_shape **out);
abut_status abut_ellipsoid_create(double radius_x, double radius_y, double radius_z, abut_shape **out);
abut_status abut_point_create(abut_shape **out);
abut_status abut_segment_create(double half_length, abut_shape **out);
abut_status abut_triangle_create(const abut_vec3 *a, const abut_vec3 *b, const abut_vec3 *c,
                                          abut_shape **out);
abut_status abut_plane_create(const abut_vec3 *normal, double offset, abut_shape **out);
abut_status abut_hull_create(const double *xyz, size_t point_count, abut_shape **out);
typedef struct abut_hull_report {
  uint32_t struct_size;
  uint32_t dimension;
  uint64_t point_count;
  uint64_t vertex_count;
  uint64_t edge_count;
  uint64_t face_count;
  double error;
} abut_hull_report;
void abut_hull_report_init(abut_hull_report *report, uint32_t struct_size);
abut_status abut_hull_describe(const abut_shape *shape, abut_hull_report *out);
typedef uint32_t abut_sides;
enum abut_sides_value {
  ABUT_SIDES_BOTH = 0,
  ABUT_SIDES_FRONT = 1,
  ABUT_SIDES_SOLID = 2
};
typedef uint32_t abut_mesh_tree;
enum abut_mesh_tree_value {
  ABUT_MESH_TREE_AUTO = 0,
  ABUT_MESH_TREE_AABB = 1,
  ABUT_MESH_TREE_OBB = 2,
  ABUT_MESH_TREE_SPHERE = 3
};
typedef struct abut_mesh_options {
  uint32_t struct_size;
  abut_sides sides;
  uint32_t corners;
  uint32_t merges_vertices;
  double merge_distance;
  abut_mesh_tree tree;
  uint32_t reserved;
} abut_mesh_options;
void abut_mesh_options_init(abut_mesh_options *options, uint32_t struct_size);
abut_status abut_mesh_create(const double *xyz, size_t vertex_count, const uint32_t *triangles,
                                      size_t triangle_count, const abut_mesh_options *options, abut_shape **out);
typedef struct abut_mesh_report {
  uint32_t struct_size;
  uint32_t reserved;
  uint64_t triangles;
  uint64_t vertices;
  uint64_t merged_vertices;
  uint64_t collapsed_triangles;
  uint64_t duplicate_vertices;
  uint64_t duplicate_triangles;
  uint64_t slivers;
  uint64_t open_edges;
  uint64_t non_manifold_edges;
  uint64_t reversed_triangles;
  uint64_t twisted_patches;
  uint64_t components;
  double merge_error;
  double volume;
} abut_mesh_report;
void abut_mesh_report_init(abut_mesh_report *report, uint32_t struct_size);
abut_status abut_mesh_describe(const double *xyz, size_t vertex_count, const uint32_t *triangles,
                                        size_t triangle_count, const abut_mesh_options *options,
                                        abut_mesh_report *out);
typedef uint32_t abut_axis;
enum abut_axis_value { ABUT_AXIS_X = 0, ABUT_AXIS_Y = 1, ABUT_AXIS_Z = 2 };
typedef struct abut_uv_grid_options {
  uint32_t struct_size;
  abut_sides sides;
  abut_axis axis_u;
  abut_axis axis_v;
  uint32_t cells_u;
  uint32_t cells_v;
  uint32_t corners;
  uint32_t merges_vertices;
  double merge_distance;
} abut_uv_grid_options;
void abut_uv_grid_options_init(abut_uv_grid_options *options, uint32_t struct_size);
abut_status abut_uv_grid_create(const double *xyz, size_t vertex_count, const uint32_t *triangles,
                                         size_t triangle_count, const abut_uv_grid_options *options, abut_shape **out);
typedef uint32_t abut_diagonal;
enum abut_diagonal_value {
  ABUT_DIAGONAL_RISING = 0,
  ABUT_DIAGONAL_FALLING = 1,
  ABUT_DIAGONAL_ALTERNATING = 2
};
typedef uint32_t abut_below;
enum abut_below_value {
  ABUT_BELOW_OPEN = 0,
  ABUT_BELOW_SOLID = 1
};
typedef struct abut_height_field_desc {
  uint32_t struct_size;
  abut_diagonal diagonal;
  uint32_t columns;
  uint32_t rows;
  double spacing_x;
  double spacing_y;
  const double *heights;
  abut_below below;
  uint32_t reserved;
} abut_height_field_desc;
void abut_height_field_desc_init(abut_height_field_desc *desc, uint32_t struct_size);
abut_status abut_height_field_create(const abut_height_field_desc *desc, abut_shape **out);
typedef uint32_t abut_interpolation;
enum abut_interpolation_value {
  ABUT_INTERPOLATION_LINEAR = 0,
  ABUT_INTERPOLATION_QUADRATIC = 1
};
typedef struct abut_distance_field_desc {
  uint32_t struct_size;
  uint32_t is_inside_out;
  uint32_t columns;
  uint32_t rows;
  uint32_t layers;
  abut_interpolation interpolation;
  abut_vec3 spacing;
  abut_vec3 origin;
  const double *values;
} abut_distance_field_desc;
void abut_distance_field_desc_init(abut_distance_field_desc *desc, uint32_t struct_size);
abut_status abut_distance_field_create(const abut_distance_field_desc *desc, abut_shape **out);
typedef struct abut_distance_field_options {
  uint32_t struct_size;
  uint32_t is_inside_out;
  double spacing;
  double band;
  abut_interpolation interpolation;
  uint32_t reserved;
} abut_distance_field_options;
void abut_distance_field_options_init(abut_distance_field_options *options, uint32_t struct_size);
abut_status abut_distance_field_from_mesh(const double *xyz, size_t vertex_count, const uint32_t *triangles,
                                                   size_t triangle_count, const abut_distance_field_options *options,
                                                   abut_shape **out);
typedef struct abut_distance_field_report {
  uint32_t struct_size;
  abut_interpolation interpolation;
  uint64_t block_count;
  uint64_t held_block_count;
  double error;
  double far_error;
  double least_stretch;
  double most_stretch;
} abut_distance_field_report;
void abut_distance_field_report_init(abut_distance_field_report *report, uint32_t struct_size);
abut_status abut_distance_field_describe(const abut_shape *shape, abut_distance_field_report *out);
abut_status abut_particles_create(const double *xyz, size_t count, double radius, abut_shape **out);
abut_status abut_particles_create_with_radii(const double *xyz, const double *radii, size_t count,
                                                      abut_shape **out);
abut_status abut_composite_create(const abut_shape *const *children, const abut_pose *poses, size_t count,
                                           abut_shape **out);
abut_status abut_composite_create_with_materials(const abut_shape *const *children, const abut_pose *poses,
                                                          const uint32_t *materials, size_t count, abut_shape **out);
abut_status abut_sphere_hole_create(double radius, abut_shape **out);
typedef uint32_t abut_open_ends;
enum abut_open_ends_value {
  ABUT_OPEN_TOP = 1,
  ABUT_OPEN_BOTTOM = 2
};
abut_status abut_cylinder_hole_create(double radius, double half_height, abut_open_ends open_ends,
                                               abut_shape **out);
typedef uint32_t abut_open_faces;
enum abut_open_faces_value {
  ABUT_OPEN_X_HIGH = 1,
  ABUT_OPEN_X_LOW = 2,
  ABUT_OPEN_Y_HIGH = 4,
  ABUT_OPEN_Y_LOW = 8,
  ABUT_OPEN_Z_HIGH = 16,
  ABUT_OPEN_Z_LOW = 32
};
abut_status abut_box_hole_create(double half_x, double half_y, double half_z, abut_open_faces open_faces,
                                          abut_shape **out);
typedef struct abut_shape_desc {
  uint32_t struct_size;
  abut_shape_kind kind;
  const double *parameters;
  uint64_t parameter_count;
  const double *reals;
  uint64_t real_count;
  const uint32_t *indices;
  uint64_t index_count;
} abut_shape_desc;
void abut_shape_desc_init(abut_shape_desc *desc, uint32_t struct_size);
abut_status abut_shape_create(const abut_shape_desc *desc, abut_shape **out);
void abut_shape_retain(abut_shape *shape);
void abut_shape_release(abut_shape *shape);
abut_shape_kind abut_shape_kind_of(const abut_shape *shape);
abut_status abut_shape_parameters(const abut_shape *shape, double *parameters, size_t capacity, size_t *count);
abut_status abut_shape_aabb(const abut_shape *shape, const abut_pose *pose, abut_aabb *out);
abut_status abut_shape_triangles(const abut_shape *shape, double *xyz, size_t vertex_capacity,
                                          size_t *vertex_count, uint32_t *triangles, size_t triangle_capacity,
                                          size_t *triangle_count);
abut_status abut_shape_prepare(const abut_shape *shape, uint32_t threads);
typedef struct abut_ray {
  abut_vec3 origin;
  abut_vec3 direction;
  double max_distance;
} abut_ray;
typedef struct abut_ray_hit {
  double distance;
  abut_vec3 point;
  abut_vec3 normal;
  abut_feature feature;
  uint32_t child;
  uint32_t reserved;
} abut_ray_hit;
abut_status abut_shape_cast_ray(const abut_shape *shape, const abut_pose *pose, const abut_ray *ray,
                                         abut_ray_hit *hit, uint32_t *found);
typedef uint32_t abut_algorithm;
enum abut_algorithm_value {
  ABUT_ALGORITHM_AUTO = 0,
  ABUT_ALGORITHM_ANALYTIC = 1,
  ABUT_ALGORITHM_SAT = 2,
  ABUT_ALGORITHM_GJK_EPA = 3,
  ABUT_ALGORITHM_LIBCCD_GJK = 4,
  ABUT_ALGORITHM_LIBCCD_MPR = 5,
  ABUT_ALGORITHM_FLAT_GROUND = 6,
  ABUT_ALGORITHM_SEPARATING_TRANSLATION = 7,
  ABUT_ALGORITHM_SOLID = 8,
  ABUT_ALGORITHM_FIELD = 9,
  ABUT_ALGORITHM_HOLE = 10
};
typedef struct abut_query_options {
  uint32_t struct_size;
  abut_algorithm algorithm;
  double error_bound;
  double margin;
  uint32_t max_contacts;
  uint32_t max_pair_contacts;
  uint32_t threads;
  uint32_t reserved;
} abut_query_options;
void abut_query_options_init(abut_query_options *options, uint32_t struct_size);
typedef struct abut_distance {
  double distance;
  double lower;
  double upper;
  abut_vec3 point_a;
  abut_vec3 point_b;
  abut_vec3 normal;
  abut_algorithm algorithm;
  uint32_t iterations;
} abut_distance;
typedef uint32_t abut_contact_flags;
enum abut_contact_flags_value {
  ABUT_CONTACT_SENSOR = 1,
  ABUT_CONTACT_SPECULATIVE = 2,
  ABUT_CONTACT_REDUCED_AWAY = 4
};
typedef struct abut_contact {
  abut_geometry_id geometry_a;
  abut_geometry_id geometry_b;
  uint64_t id;
  abut_feature feature_a;
  abut_feature feature_b;
  uint32_t child_a;
  uint32_t child_b;
  abut_vec3 point_a;
  abut_vec3 point_b;
  abut_vec3 normal;
  double distance;
  double toi;
  abut_contact_flags flags;
  uint32_t age;
  uint64_t user_data;
  uint32_t material_a;
  uint32_t material_b;
  abut_vec3 tangent;
  uint64_t reserved;
} abut_contact;
abut_status abut_contact_validate(const abut_contact *contact);
abut_status abut_pair_distance(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                        const abut_pose *pose_b, const abut_query_options *options, abut_distance *out);
abut_status abut_pairs_distance(const abut_shape *a, const abut_pose *poses_a, const abut_shape *b,
                                         const abut_pose *poses_b, size_t count, const abut_query_options *options,
                                         abut_distance *out);
abut_status abut_pair_contacts(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                        const abut_pose *pose_b, const abut_query_options *options,
                                        abut_contact *contacts, size_t capacity, size_t *count);
typedef struct abut_pair_memory {
  uint64_t opaque[8];
} abut_pair_memory;
abut_status abut_pair_distance_with_memory(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                                    const abut_pose *pose_b, const abut_query_options *options,
                                                    abut_pair_memory *memory, abut_distance *out);
abut_status abut_pairs_distance_with_memories(const abut_shape *a, const abut_pose *poses_a,
                                                       const abut_shape *b, const abut_pose *poses_b, size_t count,
                                                       const abut_query_options *options, abut_pair_memory *memories,
                                                       abut_distance *out);
abut_status abut_pairs_contacts(const abut_shape *a, const abut_pose *poses_a, const abut_shape *b,
                                         const abut_pose *poses_b, size_t pair_count,
                                         const abut_query_options *options, uint64_t *offsets, abut_contact *contacts,
                                         size_t capacity, size_t *count);
abut_status abut_pair_contacts_with_memory(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                                    const abut_pose *pose_b, const abut_query_options *options,
                                                    abut_pair_memory *memory, abut_contact *contacts, size_t capacity,
                                                    size_t *count);
abut_status abut_pairs_contacts_with_memories(const abut_shape *a, const abut_pose *poses_a,
                                                       const abut_shape *b, const abut_pose *poses_b,
                                                       size_t pair_count, const abut_query_options *options,
                                                       abut_pair_memory *memories, uint64_t *offsets,
                                                       abut_contact *contacts, size_t capacity, size_t *count);
abut_status abut_pair_overlaps(const abut_shape *a, const abut_pose *pose_a, const abut_shape *b,
                                        const abut_pose *pose_b, const abut_query_options *options, uint32_t *out);
abut_status abut_pairs_overlap(const abut_shape *const *shapes_a, const abut_pose *poses_a,
                                        const abut_shape *const *shapes_b, const abut_pose *poses_b, size_t count,
                                        const abut_query_options *options, uint32_t *out);
typedef struct abut_first_touch {
  uint32_t touches;
  uint32_t reserved;
  double lower;
  double upper;
} abut_first_touch;
abut_status abut_vertices_touch_faces(const double *start, const double *end, size_t count, double separation,
                                               double tolerance, abut_first_touch *out);
abut_status abut_edges_touch_edges(const double *start, const double *end, size_t count, double separation,
                                            double tolerance, abut_first_touch *out);
typedef struct abut_elements abut_elements;
abut_status abut_elements_create(const abut_shape *shape, abut_elements **out);
void abut_elements_destroy(abut_elements *elements);
typedef struct abut_element_counts {
  uint64_t vertices;
  uint64_t edges;
  uint64_t triangles;
  uint64_t faces;
} abut_element_counts;
abut_status abut_elements_count(const abut_elements *elements, abut_element_counts *out);
abut_status abut_elements_edges(const abut_elements *elements, uint32_t *vertices, size_t capacity,
                                         size_t *count);
abut_status abut_elements_set_vertices(abut_elements *elements, const double *start, const double *end,
                                                size_t vertex_count);
typedef uint32_t abut_closest_method;
enum abut_closest_method_value {
  ABUT_CLOSEST_FEATURES = 0,
  ABUT_CLOSEST_OF_FACES = 1,
  ABUT_CLOSEST_ALL = 2,
  ABUT_CLOSEST_OF_VERTICES = 3,
  ABUT_CLOSEST_LOCAL_MINIMA = 4
};
typedef uint32_t abut_stencil_kind;
enum abut_stencil_kind_value {
  ABUT_STENCIL_VERTEX_FACE = 0,
  ABUT_STENCIL_EDGE_EDGE = 1,
  ABUT_STENCIL_VERTEX_EDGE = 2,
  ABUT_STENCIL_VERTEX_VERTEX = 3
};
typedef uint32_t abut_stencil_kinds;
typedef uint32_t abut_elements_flags;
enum abut_elements_flags_value {
  ABUT_ELEMENTS_FRONTS_ONLY = 1
};
typedef struct abut_elements_options {
  uint32_t struct_size;
  abut_closest_method method;
  abut_stencil_kinds kinds;
  abut_elements_flags flags;
  uint32_t threads;
  uint32_t reserved;
  double reach;
  double tolerance;
  double rest_distance;
  double cone_angle;
  double cone_factor;
} abut_elements_options;
void abut_elements_options_init(abut_elements_options *options, uint32_t struct_size);
typedef struct abut_stencil {
  abut_stencil_kind kind;
  uint32_t of_a;
  uint32_t element_a;
  uint32_t element_b;
  uint32_t vertices[4];
  double weights[4];
  abut_vec3 normal;
  double distance;
  double toi;
} abut_stencil;
typedef uint32_t abut_element_pair_kind;
enum abut_element_pair_kind_value {
  ABUT_ELEMENT_PAIR_VERTEX_FACE = 0,
  ABUT_ELEMENT_PAIR_EDGE_EDGE = 1,
  ABUT_ELEMENT_PAIR_FACE_VERTEX = 2
};
typedef struct abut_element_pair {
  abut_element_pair_kind kind;
  uint32_t a;
  uint32_t b;
} abut_element_pair;
typedef struct abut_crossing {
  uint32_t edge;
  uint32_t face;
  uint32_t edge_is_of_b;
  uint32_t reserved;
  double share;
  abut_vec3 point;
} abut_crossing;
abut_status abut_elements_candidates(abut_elements *a, abut_elements *b, const abut_elements_options *options,
                                              abut_element_pair *pairs, size_t capacity, size_t *count);
abut_status abut_elements_closest(abut_elements *a, abut_elements *b, const abut_elements_options *options,
                                           abut_stencil *stencils, size_t capacity, size_t *count);
abut_status abut_elements_first_touches(abut_elements *a, abut_elements *b,
                                                 const abut_elements_options *options, abut_stencil *stencils,
                                                 size_t capacity, size_t *count);
abut_status abut_elements_crossings(abut_elements *a, abut_elements *b, const abut_elements_options *options,
                                             abut_crossing *crossings, size_t capacity, size_t *count);
typedef struct abut_movement {
  abut_vec3 velocity;
  abut_vec3 angular_velocity;
  abut_vec3 acceleration;
  abut_vec3 angular_acceleration;
  abut_vec3 centre;
} abut_movement;
abut_status abut_movement_between(const abut_pose *start, const abut_pose *end, const abut_vec3 *centre,
                                           double duration, abut_movement *out);
typedef uint32_t abut_impact_state;
enum abut_impact_state_value {
  ABUT_IMPACT_APART = 0,
  ABUT_IMPACT_TOUCHES = 1,
  ABUT_IMPACT_STARTS_TOGETHER = 2,
  ABUT_IMPACT_UNDECIDED = 3
};
typedef struct abut_impact_options {
  uint32_t struct_size;
  uint32_t most_rounds;
  double tolerance;
  double margin;
  uint32_t threads;
  uint32_t reserved;
} abut_impact_options;
void abut_impact_options_init(abut_impact_options *options, uint32_t struct_size);
typedef struct abut_impact {
  abut_impact_state state;
  uint32_t rounds;
  double lower;
  double upper;
  abut_distance contact;
  uint32_t child_a;
  uint32_t child_b;
} abut_impact;
abut_status abut_pair_time_of_impact(const abut_shape *a, const abut_pose *pose_a,
                                              const abut_movement *movement_a, const abut_shape *b,
                                              const abut_pose *pose_b, const abut_movement *movement_b,
                                              double duration, const abut_impact_options *options, abut_impact *out);
abut_status abut_pairs_time_of_impact(const abut_shape *a, const abut_pose *poses_a,
                                               const abut_movement *movements_a, const abut_shape *b,
                                               const abut_pose *poses_b, const abut_movement *movements_b,
                                               size_t count, double duration,
                                               const abut_impact_options *options, abut_impact *out);
typedef struct abut_universe abut_universe;
typedef uint32_t abut_broadphase;
enum abut_broadphase_value {
  ABUT_BROADPHASE_AUTO = 0,
  ABUT_BROADPHASE_BRUTE = 1,
  ABUT_BROADPHASE_TREE = 2,
  ABUT_BROADPHASE_SWEEP_AND_PRUNE = 3,
  ABUT_BROADPHASE_HASH_GRID = 4
};
typedef uint32_t abut_tolerance_mode;
enum abut_tolerance_mode_value {
  ABUT_TOLERANCE_DEAD_BAND = 0,
  ABUT_TOLERANCE_MARGIN = 1
};
typedef uint32_t abut_event_bits;
enum abut_event_bits_value {
  ABUT_EVENTS_PAIRS = 1,
  ABUT_EVENTS_PERSIST = 2,
  ABUT_EVENTS_CONTACTS = 4
};
typedef uint32_t abut_universe_flags;
enum abut_universe_flags_value {
  ABUT_UNIVERSE_LOCAL_POINTS = 1
};
typedef struct abut_universe_options {
  uint32_t struct_size;
  abut_broadphase broadphase;
  abut_tolerance_mode tolerance_mode;
  uint32_t max_contacts;
  abut_vec3 origin;
  uint32_t threads;
  abut_event_bits events;
  abut_universe_flags flags;
  uint32_t max_pair_contacts;
} abut_universe_options;
void abut_universe_options_init(abut_universe_options *options, uint32_t struct_size);
abut_status abut_universe_create(const abut_universe_options *options, abut_universe **out);
void abut_universe_destroy(abut_universe *universe);
abut_status abut_universe_save(const abut_universe *universe, void *bytes, size_t capacity, size_t *size);
abut_status abut_universe_load(const void *bytes, size_t size, abut_universe **out);
typedef uint32_t abut_motion;
enum abut_motion_value {
  ABUT_MOTION_DYNAMIC = 0,
  ABUT_MOTION_ANIMATED = 1,
  ABUT_MOTION_STATIC = 2
};
typedef struct abut_part_options {
  uint32_t struct_size;
  abut_motion motion;
  abut_pose pose;
  uint64_t user_data;
} abut_part_options;
void abut_part_options_init(abut_part_options *options, uint32_t struct_size);
abut_status abut_part_create(abut_universe *universe, const abut_part_options *options, abut_part_id *out);
abut_status abut_parts_create(abut_universe *universe, const abut_part_options *options, size_t count,
                                       abut_part_id *out);
abut_status abut_part_destroy(abut_universe *universe, abut_part_id part);
abut_status abut_parts_destroy(abut_universe *universe, const abut_part_id *parts, size_t count);
abut_status abut_part_set_pose(abut_universe *universe, abut_part_id part, const abut_pose *pose);
abut_status abut_parts_set_poses(abut_universe *universe, const abut_part_id *parts, const abut_pose *poses,
                                          size_t count);
abut_status abut_part_pose(const abut_universe *universe, abut_part_id part, abut_pose *out);
abut_status abut_parts_poses(const abut_universe *universe, const abut_part_id *parts, size_t count,
                                      abut_pose *out);
abut_status abut_part_set_motion(abut_universe *universe, abut_part_id part, abut_motion motion);
abut_status abut_parts_set_motions(abut_universe *universe, const abut_part_id *parts,
                                            const abut_motion *motions, size_t count);
abut_status abut_part_motion(const abut_universe *universe, abut_part_id part, abut_motion *out);
abut_status abut_part_user_data(const abut_universe *universe, abut_part_id part, uint64_t *out);
abut_status abut_part_set_user_data(abut_universe *universe, abut_part_id part, uint64_t user_data);
abut_status abut_parts_set_user_data(abut_universe *universe, const abut_part_id *parts,
                                              const uint64_t *user_data, size_t count);
abut_status abut_part_geometries(const abut_universe *universe, abut_part_id part,
                                          abut_geometry_id *geometries, size_t capacity, size_t *count);
typedef struct abut_sleep {
  uint32_t struct_size;
  uint32_t steps;
  double linear_speed;
  double linear_acceleration;
  double angular_speed;
  double angular_acceleration;
} abut_sleep;
void abut_sleep_init(abut_sleep *sleep, uint32_t struct_size);
abut_status abut_part_set_sleep(abut_universe *universe, abut_part_id part, const abut_sleep *sleep);
abut_status abut_parts_set_sleep(abut_universe *universe, const abut_part_id *parts, const abut_sleep *sleeps,
                                          size_t count);
abut_status abut_part_is_asleep(const abut_universe *universe, abut_part_id part, uint32_t *out);
abut_status abut_part_wake(abut_universe *universe, abut_part_id part);
abut_status abut_parts_wake(abut_universe *universe, const abut_part_id *parts, size_t count);
typedef uint32_t abut_parking;
enum abut_parking_value {
  ABUT_PARKING_NONE = 0,
  ABUT_PARKING_SHORT_TERM = 1,
  ABUT_PARKING_LONG_TERM = 2
};
typedef uint32_t abut_geometry_flags;
enum abut_geometry_flags_value {
  ABUT_GEOMETRY_SENSOR = 1,
  ABUT_GEOMETRY_SELF_PAIRS = 2,
  ABUT_GEOMETRY_FAST = 4,
  ABUT_GEOMETRY_SPECULATIVE = 8,
  ABUT_GEOMETRY_KEEPS_SIDE = 16
};
typedef struct abut_geometry_options {
  uint32_t struct_size;
  abut_geometry_flags flags;
  abut_pose pose;
  double tolerance;
  uint64_t user_data;
  uint64_t layers;
  uint64_t mask;
  uint64_t exclusion;
  uint32_t label;
  uint32_t tag;
  uint32_t material;
  abut_parking parking;
} abut_geometry_options;
void abut_geometry_options_init(abut_geometry_options *options, uint32_t struct_size);
abut_status abut_geometry_create(abut_universe *universe, abut_part_id part, const abut_shape *shape,
                                          const abut_geometry_options *options, abut_geometry_id *out);
abut_status abut_geometries_create(abut_universe *universe, const abut_part_id *parts,
                                            const abut_shape *const *shapes, const abut_geometry_options *options,
                                            size_t count, abut_geometry_id *out);
abut_status abut_geometry_destroy(abut_universe *universe, abut_geometry_id geometry);
abut_status abut_geometries_destroy(abut_universe *universe, const abut_geometry_id *geometries, size_t count);
abut_status abut_geometry_set_options(abut_universe *universe, abut_geometry_id geometry,
                                               const abut_geometry_options *options);
abut_status abut_geometries_set_options(abut_universe *universe, const abut_geometry_id *geometries,
                                                 const abut_geometry_options *options, size_t count);
abut_status abut_geometry_set_user_data(abut_universe *universe, abut_geometry_id geometry,
                                                 uint64_t user_data);
abut_status abut_geometries_set_user_data(abut_universe *universe, const abut_geometry_id *geometries,
                                                   const uint64_t *user_data, size_t count);
abut_status abut_geometry_set_shape(abut_universe *universe, abut_geometry_id geometry,
                                             const abut_shape *shape);
abut_status abut_geometries_set_shapes(abut_universe *universe, const abut_geometry_id *geometries,
                                                const abut_shape *const *shapes, size_t count);
abut_status abut_geometry_set_parameters(abut_universe *universe, abut_geometry_id geometry,
                                                  const double *parameters, size_t parameter_count);
abut_status abut_geometries_set_parameters(abut_universe *universe, const abut_geometry_id *geometries,
                                                    const double *parameters, size_t parameter_count, size_t count);
abut_status abut_geometry_set_heights(abut_universe *universe, abut_geometry_id geometry, uint32_t column,
                                               uint32_t row, uint32_t columns, uint32_t rows, const double *heights);
abut_status abut_geometry_set_field_values(abut_universe *universe, abut_geometry_id geometry, uint32_t column,
                                                    uint32_t row, uint32_t layer, uint32_t columns, uint32_t rows,
                                                    uint32_t layers, const double *values);
abut_status abut_geometry_set_field_lattice(abut_universe *universe, abut_geometry_id geometry,
                                                     uint32_t columns, uint32_t rows, uint32_t layers,
                                                     const double *xyz);
abut_status abut_geometry_set_particles(abut_universe *universe, abut_geometry_id geometry, size_t first,
                                                 const double *xyz, const double *radii, size_t count);
abut_status abut_geometry_set_vertices(abut_universe *universe, abut_geometry_id geometry, size_t first,
                                                const double *xyz, size_t count);
abut_status abut_geometry_set_vertices_at(abut_universe *universe, abut_geometry_id geometry,
                                                   const uint32_t *vertices, const double *xyz, size_t count);
abut_status abut_geometry_remove_triangles(abut_universe *universe, abut_geometry_id geometry,
                                                    const uint32_t *triangles, size_t count);
abut_status abut_geometry_set_mesh(abut_universe *universe, abut_geometry_id geometry, const double *xyz,
                                            size_t vertex_count, const uint32_t *triangles, size_t triangle_count);
abut_status abut_geometry_shape(const abut_universe *universe, abut_geometry_id geometry, abut_shape **out);
abut_status abut_geometry_park(abut_universe *universe, abut_geometry_id geometry, abut_parking parking);
abut_status abut_geometries_park(abut_universe *universe, const abut_geometry_id *geometries, size_t count,
                                          abut_parking parking);
typedef struct abut_geometry_info {
  uint32_t struct_size;
  abut_shape_kind kind;
  abut_part_id part;
  abut_shape *shape;
  abut_pose pose;
  abut_pose local;
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
  uint32_t reserved;
} abut_geometry_info;
void abut_geometry_info_init(abut_geometry_info *info, uint32_t struct_size);
abut_status abut_geometry_describe(const abut_universe *universe, abut_geometry_id geometry,
                                            abut_geometry_info *out);
abut_status abut_geometries_poses(const abut_universe *universe, const abut_geometry_id *geometries,
                                           size_t count, abut_pose *out);
abut_status abut_universe_parts(const abut_universe *universe, abut_part_id *parts, size_t capacity,
                                         size_t *count);
abut_status abut_universe_geometries(const abut_universe *universe, abut_geometry_id *geometries,
                                              size_t capacity, size_t *count);
typedef struct abut_revision {
  uint64_t geometries;
  uint64_t poses;
} abut_revision;
abut_status abut_universe_revision(const abut_universe *universe, abut_revision *out);
abut_status abut_universe_counters(const abut_universe *universe, const uint64_t **geometries,
                                            const uint64_t **poses);
abut_status abut_universe_changes(const abut_universe *universe, const abut_revision *since,
                                           abut_geometry_id *geometries, size_t capacity, size_t *count,
                                           uint32_t *is_known);
typedef uint32_t abut_collidable_kind;
enum abut_collidable_kind_value {
  ABUT_COLLIDABLE_GEOMETRY = 0,
  ABUT_COLLIDABLE_PART = 1,
  ABUT_COLLIDABLE_LABEL = 2,
  ABUT_COLLIDABLE_ANY = 3
};
typedef struct abut_collidable {
  abut_collidable_kind kind;
  uint32_t slot;
  uint32_t generation;
} abut_collidable;
typedef uint32_t abut_rule;
enum abut_rule_value {
  ABUT_RULE_NONE = 0,
  ABUT_RULE_ENABLE = 1,
  ABUT_RULE_DISABLE = 2
};
abut_status abut_rule_set(abut_universe *universe, const abut_collidable *a, const abut_collidable *b,
                                   abut_rule rule);
abut_status abut_rules_clear(abut_universe *universe);
abut_status abut_rule_between(const abut_universe *universe, abut_geometry_id geometry_a,
                                       abut_geometry_id geometry_b, abut_rule *rule, abut_collidable *a,
                                       abut_collidable *b);
typedef uint32_t (*abut_filter)(void *context, const abut_universe *universe, abut_geometry_id geometry_a,
                                abut_geometry_id geometry_b);
abut_status abut_universe_set_filter(abut_universe *universe, abut_filter filter, void *context);
typedef uint32_t (*abut_pointer_filter)(void *context, const abut_universe *universe,
                                        const abut_geometry_id *geometry_a, const abut_geometry_id *geometry_b);
abut_status abut_universe_set_pointer_filter(abut_universe *universe, abut_pointer_filter filter,
                                                      void *context);
abut_status abut_universe_refilter(abut_universe *universe);
typedef uint32_t abut_detail;
enum abut_detail_value {
  ABUT_DETAIL_MANIFOLD = 0,
  ABUT_DETAIL_POINT = 1,
  ABUT_DETAIL_BOX = 2,
  ABUT_DETAIL_TOUCH = 3
};
typedef struct abut_policy {
  uint32_t struct_size;
  abut_algorithm algorithm;
  abut_detail detail;
  uint32_t period;
  double tolerance;
  double error_bound;
} abut_policy;
void abut_policy_init(abut_policy *policy, uint32_t struct_size);
abut_status abut_policy_set(abut_universe *universe, uint32_t tag_a, uint32_t tag_b,
                                     const abut_policy *policy);
abut_status abut_policy_get(const abut_universe *universe, uint32_t tag_a, uint32_t tag_b, abut_policy *out);
typedef struct abut_focus {
  uint32_t struct_size;
  uint32_t near_tag;
  uint32_t far_tag;
  uint32_t reserved;
  double near_distance;
  double far_distance;
} abut_focus;
void abut_focus_init(abut_focus *focus, uint32_t struct_size);
abut_status abut_universe_set_focus(abut_universe *universe, const abut_focus *focus, const abut_vec3 *centres,
                                             size_t count);
typedef struct abut_contact_material {
  uint32_t struct_size;
  uint32_t reserved;
  double friction_primary;
  double friction_secondary;
  double friction_spin;
  double friction_roll;
  double static_scale;
  double slip;
  double compliance;
  double damping;
  double restitution;
  double restitution_threshold;
  double adhesive_force;
} abut_contact_material;
void abut_contact_material_init(abut_contact_material *material, uint32_t struct_size);
abut_status abut_material_pair_set(abut_universe *universe, uint32_t material_a, uint32_t material_b,
                                            const abut_contact_material *row);
abut_status abut_material_pair_get(const abut_universe *universe, uint32_t material_a, uint32_t material_b,
                                            abut_contact_material *out);
abut_status abut_universe_step(abut_universe *universe, double dt);
abut_status abut_universe_detect_all(abut_universe *universe);
abut_status abut_universe_detect_changed(abut_universe *universe);
abut_status abut_universe_detect_pairs(abut_universe *universe, const abut_geometry_id *a,
                                                const abut_geometry_id *b, size_t count);
abut_status abut_universe_detect_region(abut_universe *universe, const abut_aabb *region);
abut_status abut_universe_refresh(abut_universe *universe);
typedef uint32_t abut_event_kind;
enum abut_event_kind_value {
  ABUT_EVENT_BEGIN = 0,
  ABUT_EVENT_PERSIST = 1,
  ABUT_EVENT_END = 2
};
typedef uint32_t abut_event_flags;
enum abut_event_flags_value {
  ABUT_EVENT_SENSOR = 1,
  ABUT_EVENT_CONTACT = 2,
  ABUT_EVENT_ASLEEP = 4
};
typedef struct abut_event {
  abut_event_kind kind;
  abut_event_flags flags;
  abut_geometry_id geometry_a;
  abut_geometry_id geometry_b;
  uint64_t contact_id;
  uint32_t first_contact;
  uint32_t contact_count;
} abut_event;
abut_status abut_universe_events(const abut_universe *universe, const abut_event **events, size_t *count);
typedef struct abut_sleep_change {
  abut_part_id part;
  uint32_t is_asleep;
  uint32_t reserved;
} abut_sleep_change;
abut_status abut_universe_sleep_changes(const abut_universe *universe, const abut_sleep_change **changes,
                                                 size_t *count);
abut_status abut_universe_hash(const abut_universe *universe, uint64_t *out);
abut_status abut_universe_contacts(const abut_universe *universe, const abut_contact **contacts,
                                            size_t *count);
typedef struct abut_local_points {
  abut_vec3 a;
  abut_vec3 b;
} abut_local_points;
abut_status abut_universe_local_points(const abut_universe *universe, const abut_local_points **points,
                                                size_t *count);
abut_status abut_contacts_set_user_data(abut_universe *universe, const uint64_t *user_data, size_t count);
typedef struct abut_step_stats {
  uint32_t struct_size;
  uint32_t reserved;
  uint64_t parts;
  uint64_t geometries;
  uint64_t parked;
  uint64_t moved;
  uint64_t candidate_pairs;
  uint64_t filtered_pairs;
  uint64_t examined_pairs;
  uint64_t kept_pairs;
  uint64_t touching_pairs;
  uint64_t contacts;
  uint64_t unsupported_pairs;
  uint64_t events;
  uint64_t bytes;
  double refresh_microseconds;
  double broadphase_microseconds;
  double pair_microseconds;
  double narrowphase_microseconds;
  double contact_microseconds;
  uint64_t asleep;
} abut_step_stats;
void abut_step_stats_init(abut_step_stats *stats, uint32_t struct_size);
abut_status abut_universe_stats(const abut_universe *universe, abut_step_stats *out);
abut_status abut_universe_explain(const abut_universe *universe, char *text, size_t capacity, size_t *needed);
abut_status abut_universe_explain_json(const abut_universe *universe, char *text, size_t capacity,
                                                size_t *needed);
typedef uint32_t abut_apart_reasons;
enum abut_apart_reasons_value {
  ABUT_APART_PART = 1,
  ABUT_APART_MOTION = 2,
  ABUT_APART_PARKING = 4,
  ABUT_APART_EXCLUSION = 8,
  ABUT_APART_LAYERS = 16,
  ABUT_APART_RULE = 32,
  ABUT_APART_FILTER = 64,
  ABUT_APART_KINDS = 128,
  ABUT_APART_BOXES = 256,
  ABUT_APART_POLICY = 512,
  ABUT_APART_DETECTION = 1024,
  ABUT_APART_SIDE = 2048
};
abut_status abut_universe_why_apart(const abut_universe *universe, abut_geometry_id geometry_a,
                                             abut_geometry_id geometry_b, abut_apart_reasons *out);
typedef uint32_t abut_finding_code;
enum abut_finding_code_value {
  ABUT_FINDING_NOTHING_MOVES = 0,
  ABUT_FINDING_MEETS_NOTHING = 1,
  ABUT_FINDING_KINDS_UNSUPPORTED = 2,
  ABUT_FINDING_TOLERANCE_TOO_LARGE = 3,
  ABUT_FINDING_FAR_FROM_ORIGIN = 4,
  ABUT_FINDING_EXCLUDED_FROM_ALL = 5,
  ABUT_FINDING_RULE_DISABLES_ALL = 6,
  ABUT_FINDING_EXCLUSION_IN_COMMON = 7,
  ABUT_FINDING_FILTER_KEEPS_NONE = 8,
  ABUT_FINDING_ALL_PARKED = 9,
  ABUT_FINDING_ALL_ON_ONE_PART = 10,
  ABUT_FINDING_INSIDE_OUT = 11,
  ABUT_FINDING_HOLLOW = 12
};
typedef struct abut_finding {
  abut_finding_code code;
  uint32_t reserved;
  abut_geometry_id geometry;
  abut_geometry_id other;
  char message[168];
} abut_finding;
abut_status abut_universe_validate(const abut_universe *universe, abut_finding *findings, size_t capacity,
                                            size_t *count);
typedef struct abut_island {
  uint64_t id;
  uint32_t first_part;
  uint32_t part_count;
} abut_island;
abut_status abut_universe_follow_islands(abut_universe *universe, uint32_t are_followed);
abut_status abut_universe_islands(const abut_universe *universe, const abut_island **islands, size_t *count);
abut_status abut_universe_island_parts(const abut_universe *universe, const abut_part_id **parts,
                                                size_t *count);
abut_status abut_part_island(const abut_universe *universe, abut_part_id part, abut_island *out);
typedef struct abut_velocity {
  abut_vec3 linear;
  abut_vec3 angular;
} abut_velocity;
typedef uint32_t abut_velocity_source;
enum abut_velocity_source_value {
  ABUT_VELOCITY_NONE = 0,
  ABUT_VELOCITY_GIVEN = 1,
  ABUT_VELOCITY_FROM_POSES = 2
};
abut_status abut_part_set_velocity(abut_universe *universe, abut_part_id part, const abut_velocity *velocity);
abut_status abut_parts_set_velocities(abut_universe *universe, const abut_part_id *parts,
                                               const abut_velocity *velocities, size_t count);
abut_status abut_part_measure_velocity(abut_universe *universe, abut_part_id part);
abut_status abut_parts_measure_velocities(abut_universe *universe, const abut_part_id *parts, size_t count);
abut_status abut_part_velocity(const abut_universe *universe, abut_part_id part, abut_velocity *out,
                                        abut_velocity_source *source);
abut_status abut_parts_velocities(const abut_universe *universe, const abut_part_id *parts, size_t count,
                                           abut_velocity *out);
typedef struct abut_acceleration {
  abut_vec3 linear;
  abut_vec3 angular;
} abut_acceleration;
abut_status abut_part_set_acceleration(abut_universe *universe, abut_part_id part,
                                                const abut_acceleration *acceleration);
abut_status abut_parts_set_accelerations(abut_universe *universe, const abut_part_id *parts,
                                                  const abut_acceleration *accelerations, size_t count);
abut_status abut_parts_accelerations(const abut_universe *universe, const abut_part_id *parts, size_t count,
                                              abut_acceleration *out);
typedef struct abut_step_impact {
  abut_geometry_id geometry_a;
  abut_geometry_id geometry_b;
  double lower;
  double upper;
  uint32_t first_contact;
  uint32_t contact_count;
  uint32_t is_undecided;
  uint32_t reserved;
} abut_step_impact;
abut_status abut_universe_impacts(const abut_universe *universe, const abut_step_impact **impacts,
                                           size_t *count);
abut_status abut_universe_advance_to_first_impact(abut_universe *universe, double dt, abut_step_impact *out);
abut_status abut_universe_attach(const abut_universe *universe, const char *name);
abut_status abut_universe_detach(const abut_universe *universe, const char *name);
typedef uint32_t abut_query_filter_flags;
enum abut_query_filter_flags_value {
  ABUT_QUERY_FILTER_SKIP_SENSORS = 1
};
typedef uint32_t abut_ray_start;
enum abut_ray_start_value {
  ABUT_RAY_START_FAR_SIDE = 0,
  ABUT_RAY_START_SOLID = 1,
  ABUT_RAY_START_SKIP = 2
};
typedef struct abut_query_filter {
  uint32_t struct_size;
  abut_query_filter_flags flags;
  uint64_t layers;
  uint64_t mask;
  abut_part_id ignore_part;
  abut_geometry_id ignore_geometry;
  abut_ray_start ray_start;
  uint32_t reserved;
} abut_query_filter;
void abut_query_filter_init(abut_query_filter *filter, uint32_t struct_size);
typedef uint32_t abut_hit_mode;
enum abut_hit_mode_value {
  ABUT_HIT_NEAREST = 0,
  ABUT_HIT_ANY = 1,
  ABUT_HIT_ALL = 2
};
typedef struct abut_query_hit {
  abut_geometry_id geometry;
  abut_feature feature;
  uint32_t child;
  uint32_t reserved;
  double distance;
  abut_vec3 point;
  abut_vec3 normal;
} abut_query_hit;
abut_status abut_universe_cast_ray(const abut_universe *universe, const abut_ray *ray,
                                            const abut_query_filter *filter, abut_hit_mode mode, abut_query_hit *hits,
                                            size_t capacity, size_t *count);
abut_status abut_universe_cast_rays(const abut_universe *universe, const abut_ray *rays, size_t count,
                                             const abut_query_filter *filter, abut_query_hit *hits);
typedef struct abut_cast_hit {
  abut_geometry_id geometry;
  double fraction;
  abut_distance contact;
  abut_feature feature_a;
  abut_feature feature_b;
  uint32_t child_a;
  uint32_t child_b;
} abut_cast_hit;
abut_status abut_universe_cast_shape(const abut_universe *universe, const abut_shape *shape,
                                              const abut_pose *pose, const abut_vec3 *displacement,
                                              const abut_query_filter *filter, abut_hit_mode mode, abut_cast_hit *hits,
                                              size_t capacity, size_t *count);
abut_status abut_universe_cast_shapes(const abut_universe *universe, const abut_shape *const *shapes,
                                               const abut_pose *poses, const abut_vec3 *displacements, size_t count,
                                               const abut_query_filter *filter, abut_cast_hit *hits);
typedef struct abut_impact_hit {
  abut_geometry_id geometry;
  abut_impact impact;
} abut_impact_hit;
abut_status abut_universe_cast_movement(const abut_universe *universe, const abut_shape *shape,
                                                 const abut_pose *pose, const abut_movement *movement,
                                                 double duration, const abut_impact_options *options,
                                                 const abut_query_filter *filter, abut_hit_mode mode,
                                                 abut_impact_hit *hits, size_t capacity, size_t *count);
abut_status abut_universe_cast_movements(const abut_universe *universe, const abut_shape *const *shapes,
                                                  const abut_pose *poses, const abut_movement *movements,
                                                  size_t count, double duration, const abut_impact_options *options,
                                                  const abut_query_filter *filter, abut_impact_hit *hits);
abut_status abut_universe_overlaps(const abut_universe *universe, const abut_shape *shape,
                                            const abut_pose *pose, const abut_query_filter *filter, double margin,
                                            abut_geometry_id *geometries, size_t capacity, size_t *count);
abut_status abut_universe_overlaps_of_each(const abut_universe *universe, const abut_shape *const *shapes,
                                                    const abut_pose *poses, size_t query_count,
                                                    const abut_query_filter *filter, double margin, uint64_t *offsets,
                                                    abut_geometry_id *geometries, size_t capacity, size_t *count);
abut_status abut_universe_at_point(const abut_universe *universe, const abut_vec3 *position,
                                            const abut_query_filter *filter, abut_geometry_id *geometries,
                                            size_t capacity, size_t *count);
abut_status abut_universe_at_points(const abut_universe *universe, const abut_vec3 *positions,
                                             size_t query_count, const abut_query_filter *filter, uint64_t *offsets,
                                             abut_geometry_id *geometries, size_t capacity, size_t *count);
typedef struct abut_closest {
  abut_geometry_id geometry;
  abut_distance distance;
} abut_closest;
abut_status abut_universe_closest(const abut_universe *universe, const abut_shape *shape,
                                           const abut_pose *pose, double max_distance, const abut_query_filter *filter,
                                           abut_closest *out, uint32_t *found);
abut_status abut_universe_closest_to_each(const abut_universe *universe, const abut_shape *const *shapes,
                                                   const abut_pose *poses, size_t count, double max_distance,
                                                   const abut_query_filter *filter, abut_closest *out);
abut_status abut_pair_cast(const abut_shape *a, const abut_pose *pose_a, const abut_vec3 *displacement_a,
                                    const abut_shape *b, const abut_pose *pose_b, const abut_vec3 *displacement_b,
                                    const abut_query_options *options, abut_cast_hit *hit, uint32_t *found);
abut_status abut_pairs_cast(const abut_shape *a, const abut_pose *poses_a, const abut_vec3 *displacements_a,
                                     const abut_shape *b, const abut_pose *poses_b, const abut_vec3 *displacements_b,
                                     size_t count, const abut_query_options *options, abut_cast_hit *hits);
typedef struct abut_layout_entry {
  const char *type;
  const char *field;
  uint64_t offset;
  uint64_t size;
} abut_layout_entry;
size_t abut_layout_count(void);
abut_status abut_layout_at(size_t index, abut_layout_entry *out);
]]
return {major = 0, minor = 2}
