// SPDX-License-Identifier: Apache-2.0
// abut/picking for Node: rays and the mouse against a universe, through Embree. It needs libabut_picking.
// include/abut/picking.h is the reference of what each call does.
import type { GeometryId, Hit, Pose, QueryFilter, Ray, Universe, Vector } from 'abut';

export interface CameraOptions {
  /** Where it stands; with `target` it looks there. */
  eye?: Vector;
  target?: Vector;
  /** What is upwards in the picture; Z by default. */
  up?: Vector;
  /** In place of eye and target. It looks along its local -Z, with local +Y up. */
  pose?: Pose;
  /** Pixels; 640 and 480 by default. */
  width?: number;
  height?: number;
  /** 0: all rays start at the eye, which is the default; 1: all are parallel to the axis. */
  projection?: number;
  /** Between the upper and the lower edge, in radians; 1 by default. */
  verticalFov?: number;
  nearDistance?: number;
  farDistance?: number;
  /** Of parallel rays: between the lower and the upper edge, in metres; 1 by default. */
  verticalExtent?: number;
  /** Width of a pixel divided by its height; 1 by default. */
  pixelAspect?: number;
  /** Pixels from the middle of the picture to the axis, to the right and down. */
  shiftX?: number;
  shiftY?: number;
  /** Along what near and far are measured. 0: each ray, which is the default; 1: the axis. */
  depthAxis?: number;
}

/** A camera, which looks along its local -Z. */
export class Camera {
  constructor(options?: CameraOptions);
  lookAt(eye: Vector, target: Vector, up?: Vector): void;
  /** The ray through a point of the picture, x to the right and y down, in pixels. */
  ray(x: number, y: number): Ray;
}

/** Rays against one universe, which it follows. It ends with its universe. */
export class Picker {
  constructor(universe: Universe);
  readonly universe: Universe;
  /** The pointer of the C interface, for calls of your own. */
  readonly pointer: bigint;
  /** Frees it now. Twice is allowed. */
  destroy(): void;
  /** Follows the universe now rather than at the next query. */
  update(): void;
  /** The first thing that a ray meets. */
  castRay(origin: Vector, direction: Vector, options?: QueryFilter & { maxDistance?: number }): Hit | null;
  /** The same for many rays, in one call; neighbours in space are traced faster when they are told. */
  castRays(rays: readonly Ray[], options?: QueryFilter & { coherence?: 'none' | 'neighbours' }): (Hit | null)[];
  /** Every crossing of a surface, nearest first. */
  castRayAll(origin: Vector, direction: Vector, options?: QueryFilter & { maxDistance?: number }): Hit[];
  /** What lies under the mouse, or within `radius` pixels of it. */
  pickPixel(camera: Camera, x: number, y: number, options?: QueryFilter & { radius?: number }): Hit | null;
  /** Chooses whether queries meet sensors, and leave out surfaces whose normal points along the ray. */
  setFlags(flags?: { sensors?: boolean; skipsBackFaces?: boolean }): void;
  /** Whether a ray meets anything. */
  rayHits(origin: Vector, direction: Vector, options?: QueryFilter & { maxDistance?: number }): boolean;
  /** Geometries of which any point lies in the rectangle from (x0, y0) to (x1, y1); with `inside`, all points. */
  select(camera: Camera, x0: number, y0: number, x1: number, y1: number,
    options?: QueryFilter & { inside?: boolean }): GeometryId[];
  /** One ray through the centre of each pixel, row by row from the top. */
  render(camera: Camera, filter?: QueryFilter): (Hit | null)[];
}
