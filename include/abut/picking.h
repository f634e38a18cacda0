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

/** Rays against one universe. Owned by its creator. */
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

/** A pinhole camera that looks along its local -Z, with local +Y up. */
typedef struct abut_camera {
  uint32_t struct_size;
  uint32_t width;            /**< pixels, at least 1 */
  uint32_t height;           /**< pixels, at least 1 */
  uint32_t reserved;         /**< zero */
  abut_pose pose;            /**< default identity */
  double vertical_fov;       /**< angle between the upper and the lower edge; radians in (0, pi); default 1 */
  double near_distance;      /**< rays start here, measured along the ray; default 0 */
  double far_distance;       /**< rays end here; default infinite */
} abut_camera;

/** Fills in the defaults: 640 x 480, identity pose, vertical_fov 1. */
ABUT_API void abut_camera_init(abut_camera *camera, uint32_t struct_size);

/**
 * Turns a camera so that it looks from `eye` to `target` with `up` upwards in the picture; `up` is of any length.
 * ABUT_ZERO_VECTOR when eye and target coincide or `up` is parallel to the line of sight. [any]
 */
ABUT_API abut_status abut_camera_look_at(abut_camera *camera, const abut_vec3 *eye, const abut_vec3 *target,
                                         const abut_vec3 *up);

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

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif /* ABUT_PICKING_H */
