/* SPDX-License-Identifier: Apache-2.0 */
/*
 * picking.h - rays and the mouse against a universe, through Embree.
 *
 * A library of its own (libabut_picking.so) on top of the public interface of libabut.so: a program
 * that never picks never loads Embree. The conventions of abut.h hold; docs/picking.md tells more.
 *
 * A picker follows its universe. Each query compares the universe's change counters with those it has
 * seen, and brings the scene of rays up to date when they differ: geometries that came, went, moved,
 * were parked, reshaped or given other options. Poses are those that are set now, without a step or a
 * refresh. Queries of one picker may run together, and count as [const] calls on its universe. A picker keeps
 * its universe: after abut_universe_destroy it goes on to see the universe as it was, which goes with its last picker.
 *
 * Rays meet what they meet in abut_universe_cast_ray, with the same feature, child and normal. Which
 * surface is first is decided in single precision for meshes, height fields and large hulls. It is
 * decided in double for all other shapes, such as distance fields. The hit itself is computed in double,
 * on the triangle that was found.
 *
 * A world far from zero costs no digits: the scene of rays lies around what is in it, so there is no origin to set.
 *
 * Coordinates of origins and cameras are at most 1e70 in size, otherwise ABUT_OUT_OF_RANGE.
 */
#ifndef ABUT_PICKING_H
#define ABUT_PICKING_H

#include "abut.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Rays against one universe, which see no sensors by default. Owned by its creator. */
typedef struct abut_picker abut_picker;

/** Where a ray meets a geometry; the same fields as abut_query_hit. */
typedef struct abut_pick {
  abut_geometry_id geometry; /**< null when nothing was hit */
  abut_feature feature;      /**< what of the shape is met */
  uint32_t child;            /**< of a composite; 0 for all other shapes */
  uint32_t reserved;         /**< zero */
  double distance;           /**< along the unit direction; infinite when nothing was hit */
  abut_vec3 point;           /**< world frame */
  abut_vec3 normal;          /**< unit, world frame, out of the solid; of a mesh by winding; of a point or segment 0 */
} abut_pick;

/** How a camera maps space to its picture. */
typedef uint32_t abut_projection;
enum abut_projection_value ABUT_ENUM(uint32_t) {
  ABUT_PROJECTION_PERSPECTIVE = 0, /**< all rays start at the eye */
  ABUT_PROJECTION_ORTHOGRAPHIC = 1 /**< all rays are parallel to the axis */
};

/** Along which line near_distance and far_distance of a camera are measured. */
typedef uint32_t abut_depth_axis;
enum abut_depth_axis_value ABUT_ENUM(uint32_t) {
  ABUT_DEPTH_ALONG_RAY = 0, /**< along each ray: near and far are spheres around the eye */
  ABUT_DEPTH_ALONG_AXIS = 1 /**< along the axis of the camera: near and far are planes, as in a projection matrix */
};

/** A camera that looks along its local -Z, with local +Y up. */
typedef struct abut_camera {
  uint32_t struct_size;
  uint32_t width;             /**< pixels, at least 1 */
  uint32_t height;            /**< pixels, at least 1 */
  abut_projection projection; /**< default ABUT_PROJECTION_PERSPECTIVE */
  abut_pose pose;             /**< default identity */
  double vertical_fov;        /**< of a perspective camera: angle between the upper and the lower edge; radians in
                                   (0, pi); default 1 */
  double near_distance;       /**< rays start here; default 0; negative in an orthographic camera only */
  double far_distance;        /**< rays end here; default infinite */
  double vertical_extent;     /**< of an orthographic camera: length between the lower and the upper edge, in metres;
                                   positive; default 1 */
  double pixel_aspect;        /**< width of a pixel divided by its height; positive; default 1 */
  double shift_x;             /**< pixels from the middle of the picture to the axis, to the right; default 0 */
  double shift_y;             /**< the same, downwards; default 0 */
  abut_depth_axis depth_axis; /**< default ABUT_DEPTH_ALONG_RAY */
  uint32_t reserved;          /**< zero */
} abut_camera;

/** Fills in the defaults: a perspective camera of 640 x 480 pixels, identity pose, vertical_fov 1. */
ABUT_API void abut_camera_init(abut_camera *camera, uint32_t struct_size);

/**
 * Turns a camera so that it looks from `eye` to `target` with `up` upwards in the picture; `up` is of any length.
 * ABUT_ZERO_VECTOR when eye and target coincide or `up` is parallel to the line of sight. [any]
 */
ABUT_API abut_status abut_camera_look_at(abut_camera *camera, const abut_vec3 *eye, const abut_vec3 *target,
                                         const abut_vec3 *up);

/** Which depths a projection matrix maps the near and the far plane to. */
typedef uint32_t abut_clip_depth;
enum abut_clip_depth_value ABUT_ENUM(uint32_t) {
  ABUT_CLIP_DEPTH_SIGNED = 0,  /**< from -1 to 1: OpenGL, WebGL */
  ABUT_CLIP_DEPTH_UNSIGNED = 1 /**< from 0 to 1: Vulkan, Direct3D, Metal, WebGPU */
};

/**
 * Takes a projection matrix apart into the fields of a camera: projection, vertical_fov or vertical_extent,
 * pixel_aspect, shift_x, shift_y, near_distance, far_distance and depth_axis (ABUT_DEPTH_ALONG_AXIS). The size of the
 * picture and the pose stay; the pose is the inverse of the view matrix.
 *
 * The matrix multiplies column vectors of a frame that looks along -Z with +Y up, and its picture has +Y up. Off-centre
 * frusta, reversed depth and an infinite far plane are understood. ABUT_UNSUPPORTED for any other matrix, such as one
 * with an oblique near plane or one that looks along +Z; the message names the element. ABUT_OUT_OF_RANGE where near
 * or far is not what a camera may have.
 * @param matrix  16 numbers, column by column, as OpenGL keeps them: matrix[12] to matrix[15] are the last column
 * [any]
 */
ABUT_API abut_status abut_camera_set_projection(abut_camera *camera, const double *matrix, abut_clip_depth depth);

/**
 * Ray through a point (x, y) of the picture, x to the right and y down, in pixels. (0.5, 0.5) is the centre of the
 * first pixel; the point may lie outside of the picture. [any]
 */
ABUT_API abut_status abut_camera_ray(const abut_camera *camera, double x, double y, abut_ray *out);

/** Creates a picker. Nothing is built before the first query. [const] on the universe. */
ABUT_API abut_status abut_picker_create(abut_universe *universe, abut_picker **out);

/** Destroys a picker. Null is allowed. [exclusive] on the picker. */
ABUT_API void abut_picker_destroy(abut_picker *picker);

/** Follows the universe now rather than at the next query. [const] */
ABUT_API abut_status abut_picker_update(abut_picker *picker);

/** What the queries of a picker see. */
typedef uint32_t abut_picker_flags;
enum abut_picker_flags_value ABUT_ENUM(uint32_t) {
  ABUT_PICKER_SENSORS = 1,        /**< sensors as well; a filter may still leave them out */
  ABUT_PICKER_SKIP_BACK_FACES = 2 /**< no surface whose normal points along the ray */
};

/**
 * Sets what all later queries see; a new picker has no flags. A change of ABUT_PICKER_SENSORS makes the next query
 * build the scene of rays anew. [exclusive] on the picker.
 */
ABUT_API abut_status abut_picker_set_flags(abut_picker *picker, abut_picker_flags flags);

/** Keeps the points p with dot(normal, p) >= offset, and cuts all others away. */
typedef struct abut_clip_plane {
  abut_vec3 normal; /**< towards what is kept; of any length but zero, and normalised */
  double offset;    /**< along the unit normal, in metres */
} abut_clip_plane;

/**
 * Sets the clip planes of all later queries, in place of those before; a new picker has none. What a plane cuts away is
 * not hit and hides nothing. A cut solid is open: a ray that starts at the cut meets its far side.
 * @param planes  copied
 * @param count   below 33; 0 for none
 * [exclusive] on the picker.
 */
ABUT_API abut_status abut_picker_set_clip_planes(abut_picker *picker, const abut_clip_plane *planes, size_t count);

/**
 * First thing that a ray meets; out->geometry is null when there is none.
 * @param filter  which geometries count, here and below; may be null. Its ray_start must be ABUT_RAY_START_FAR_SIDE,
 *                otherwise ABUT_UNSUPPORTED
 * Complexity O(log n), and O(n) for shapes without bounds. [const]
 */
ABUT_API abut_status abut_picker_cast_ray(abut_picker *picker, const abut_ray *ray, const abut_query_filter *filter,
                                          abut_pick *out);

/** How similar the rays of a batch are; a hint that changes only the speed. */
typedef uint32_t abut_coherence;
enum abut_coherence_value ABUT_ENUM(uint32_t) {
  ABUT_COHERENCE_NONE = 0,      /**< unrelated rays */
  ABUT_COHERENCE_NEIGHBOURS = 1 /**< neighbours in the array are neighbours in space, as in a picture */
};

/** First things that `count` rays meet; `out` is an array of `count`. Nothing is traced when a ray is bad. [const] */
ABUT_API abut_status abut_picker_cast_rays(abut_picker *picker, const abut_ray *rays, size_t count,
                                           abut_coherence coherence, const abut_query_filter *filter, abut_pick *out);

/**
 * Whether a ray meets anything; `out` becomes 1 or 0. It is 1 where abut_picker_cast_ray finds a geometry, and costs
 * less, since any surface will do. [const]
 */
ABUT_API abut_status abut_picker_ray_hits(abut_picker *picker, const abut_ray *ray, const abut_query_filter *filter,
                                          uint32_t *out);

/**
 * The same for `count` rays.
 * @param out  `count` numbers, each 1 or 0
 * Nothing is traced when a ray is bad. [const]
 */
ABUT_API abut_status abut_picker_rays_hit(abut_picker *picker, const abut_ray *rays, size_t count,
                                          abut_coherence coherence, const abut_query_filter *filter, uint32_t *out);

/**
 * Everything that a ray meets, nearest first, by count-then-fill. Each crossing of a surface counts, also those of one
 * geometry, its children and its particles. A ray through an edge or a corner of triangles crosses what a ray beside it
 * would cross: closed surfaces are left as often as they are entered. [const]
 */
ABUT_API abut_status abut_picker_cast_ray_all(abut_picker *picker, const abut_ray *ray, const abut_query_filter *filter,
                                              abut_pick *picks, size_t capacity, size_t *count);

/**
 * What lies under the mouse, the first of these that there is:
 * - the point or segment nearest to (x, y) in the picture, within `radius` pixels, that nothing hides;
 * - the first thing that the ray through (x, y) meets;
 * - the surface nearest to (x, y) in the picture, within `radius` pixels.
 * The distance of a point or segment is that of its point nearest in the picture.
 * @param radius  pixels, not negative
 * Complexity O(n) in geometries, and in triangles of those near (x, y), where the ray meets nothing; O(n) in geometries
 * where there are points or segments. [const]
 */
ABUT_API abut_status abut_picker_pick_pixel(abut_picker *picker, const abut_camera *camera, double x, double y,
                                            double radius, const abut_query_filter *filter, abut_pick *out);

/** One ray through the centre of each pixel; `out` holds width * height picks, row by row from the top. [const] */
ABUT_API abut_status abut_picker_render(abut_picker *picker, const abut_camera *camera, const abut_query_filter *filter,
                                        abut_pick *out, size_t capacity);

/** Which geometries a rectangle selects. */
typedef uint32_t abut_selection;
enum abut_selection_value ABUT_ENUM(uint32_t) {
  ABUT_SELECTION_TOUCHING = 0, /**< those of which any point lies in the rectangle */
  ABUT_SELECTION_INSIDE = 1    /**< those of which all points lie in it */
};

/**
 * Geometries in a rectangle of the picture, in the order of their slots, by count-then-fill. Hidden ones count as well:
 * the rectangle is a frustum in space, between near and far, which are planes here whatever depth_axis says. Clip
 * planes bound it like its sides, so nothing that a plane cuts is inside.
 *
 * Solids are filled, also closed solid meshes; of other surfaces only the surface counts. A shape without bounds is
 * never inside.
 * @param x0  pixels; (x0, y0) and (x1, y1) are opposite corners.
 * Complexity O(n) in geometries at some nanoseconds each, and a test of overlap for those at the edge of the
 * rectangle. [const]
 */
ABUT_API abut_status abut_picker_select_rectangle(abut_picker *picker, const abut_camera *camera, double x0, double y0,
                                                  double x1, double y1, abut_selection selection,
                                                  const abut_query_filter *filter, abut_geometry_id *geometries,
                                                  size_t capacity, size_t *count);

/** What a cursor may snap to. */
typedef uint32_t abut_snap_kinds;
enum abut_snap_kinds_value ABUT_ENUM(uint32_t) {
  ABUT_SNAP_VERTEX = 1,
  ABUT_SNAP_MIDPOINT = 2, /**< the middle of an edge */
  ABUT_SNAP_EDGE = 4      /**< the point of an edge that is nearest in the picture */
};

/** A vertex, or a point of an edge. */
typedef struct abut_snap {
  abut_geometry_id geometry; /**< null when nothing was found */
  abut_snap_kinds kind;      /**< one of them; 0 when nothing was found */
  uint32_t vertices[2];      /**< of abut_shape_triangles: the vertex twice, or the ends of the edge; of a segment 0
                                  at -Z and 1 at +Z, of a point 0 */
  uint32_t reserved;         /**< zero */
  double parameter;          /**< along the edge, from 0 at vertices[0] to 1 at vertices[1] */
  double pixels;             /**< from (x, y) to the point, in the picture; infinite when nothing was found */
  double distance;           /**< from the start of the ray through the point, as that of a pick */
  abut_vec3 point;           /**< world frame */
} abut_snap;

/**
 * What a cursor at (x, y) snaps to, within `radius` pixels, that nothing hides: the nearest vertex, else the nearest
 * middle of an edge, else the nearest point of an edge. Points, segments and all shapes that abut_shape_triangles knows
 * have vertices and edges, but for distance fields. A box and a hull have the edges between their faces, all others
 * those of their triangles.
 * @param radius  pixels, not negative
 * @param kinds   0 for all
 * Complexity O(n) in geometries at some nanoseconds each, and in triangles of those near (x, y). [const]
 */
ABUT_API abut_status abut_picker_snap(abut_picker *picker, const abut_camera *camera, double x, double y, double radius,
                                      abut_snap_kinds kinds, const abut_query_filter *filter, abut_snap *out);

/** A point of a triangle, as weights of its corners, which add up to 1. */
typedef struct abut_barycentric {
  uint32_t triangle;    /**< of abut_shape_triangles */
  uint32_t vertices[3]; /**< its corners */
  double weights[3];    /**< of the corners; negative outside of the triangle */
} abut_barycentric;

/**
 * Where a point lies in a face of a geometry that a ray has hit: weights with which values at vertices, such as colours
 * and texture coordinates, are interpolated. Of the triangles of a face it is the one that holds the point.
 * ABUT_UNSUPPORTED for shapes without triangles and for children of composites, ABUT_INDEX_OUT_OF_RANGE for a face that
 * is not there, ABUT_ZERO_VECTOR for a triangle without area.
 * @param face   the index of the feature of a pick
 * @param point  world frame, under the present pose; projected to the plane of the triangle
 * Complexity O(triangles) for the first point of a shape, then O(1); of hulls O(triangles). [const]
 */
ABUT_API abut_status abut_picker_barycentric(abut_picker *picker, abut_geometry_id geometry, uint32_t face,
                                             const abut_vec3 *point, abut_barycentric *out);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif /* ABUT_PICKING_H */
