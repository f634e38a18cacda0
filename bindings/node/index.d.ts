// SPDX-License-Identifier: Apache-2.0
// abut finds where 3D shapes touch: distances, contacts and rays, for two shapes or for a universe of many that move.
//
// Frames are right-handed; lengths are in metres or any other unit of yours. Calls that fail throw an AbutError and change
// nothing. Shapes and universes are freed when nobody holds them any more; release and destroy do it at once.

/** A call that failed, and changed nothing. The message names the argument, the value and what was expected. */
export class AbutError extends Error {
  /** Its name in abut.h, such as "ABUT_OUT_OF_RANGE". */
  readonly status: string;
}

/** Version of the library that was loaded, such as "0.2.0". */
export function version(): string;

export interface Vector {
  x: number;
  y: number;
  z: number;
}

/** Unit quaternion. */
export interface Quaternion {
  w: number;
  x: number;
  y: number;
  z: number;
}

/** Maps local points p to orientation * p + position. */
export interface Pose {
  position: Vector;
  orientation: Quaternion;
}

/** Poses as objects, or 7 numbers each: x, y, z of the position, then w, x, y, z of the orientation. */
export type Poses = readonly Pose[] | Float64Array;

/** Vectors as objects, or 3 numbers each. */
export type Vectors = readonly Vector[] | Float64Array;

/** A pose at x, y, z, not turned unless an orientation says so. */
export function pose(x?: number, y?: number, z?: number, orientation?: Quaternion): Pose;

declare const kind: unique symbol;

/** A part of a universe: a body with a pose. When the part is gone, calls throw ABUT_STALE_ID. */
export interface PartId {
  readonly slot: number;
  readonly generation: number;
  readonly [kind]?: 'part';
}

/** A geometry of a universe: a shape on a part. A slot of 0 names none. */
export interface GeometryId {
  readonly slot: number;
  readonly generation: number;
  readonly [kind]?: 'geometry';
}

/** What of a shape touches or is hit: a kind as in abut.h, and the shape's own number. */
export interface Feature {
  kind: number;
  index: number;
}

type Numbers = ArrayLike<number> & Iterable<number>;

/** A shape. It never changes, so geometries and universes may share it. */
export class Shape {
  private constructor();
  /** A solid ball, centred. */
  static sphere(radius: number): Shape;
  /** A solid box, centred, from half extents. */
  static box(x: number, y: number, z: number): Shape;
  /** All points within a radius of a segment along local Z. */
  static capsule(radius: number, halfHeight: number): Shape;
  /** A solid cylinder along local Z. */
  static cylinder(radius: number, halfHeight: number): Shape;
  /** The half-space of the points p with dot(normal, p) <= offset. */
  static plane(normal: Vector, offset: number): Shape;
  /** The convex hull of points, x, y, z each. */
  static hull(xyz: Numbers): Shape;
  /** A surface of triangles, three indices each, counter-clockwise seen from the front. */
  static mesh(xyz: Numbers, triangles: Numbers, options?: { sides?: 'both' | 'front' }): Shape;
  /** Terrain over a grid: sample (i, j) lies at (i * spacingX, j * spacingY, heights[j * columns + i]). */
  static heightField(columns: number, rows: number, spacingX: number, spacingY: number, heights: Numbers): Shape;
  /** Many small balls of one radius. */
  static particles(xyz: Numbers, radius: number): Shape;
  /** Shapes of any kind as one, each at a pose of its own. */
  static composite(children: readonly Shape[], poses: Poses): Shape;
  /** Any kind that numbers describe, such as ofKind('cone', radius, halfHeight); docs/shapes.md lists them. */
  static ofKind(kind: string, ...parameters: number[]): Shape;
  /** Name of its kind, such as "sphere". */
  readonly kind: string;
  /** The pointer of the C interface, for calls of your own. */
  readonly pointer: bigint;
  /** Gives the shape back now; geometries keep theirs. Twice is allowed. */
  release(): void;
}

export interface QueryOptions {
  algorithm?: 'auto' | 'analytic' | 'sat' | 'gjkEpa' | 'libccdGjk' | 'libccdMpr';
  errorBound?: number;
  /** Contacts are reported up to this distance. */
  margin?: number;
  /** How many contacts a patch keeps; 0 for all. */
  maxContacts?: number;
  /** How many all patches of a pair keep together; 0 for all. */
  maxPairContacts?: number;
  /** Of pairDistances; 0 for as many as there may be, which is the default. */
  threads?: number;
  /** Bits of ABUT_QUERY_: 1 welds convex children of composites that lie side by side. */
  flags?: number;
}

export interface Distance {
  /** Negative where they overlap; the true distance lies in [lower, upper]. */
  distance: number;
  lower: number;
  upper: number;
  pointA: Vector;
  pointB: Vector;
  /** Unit, from a to b. */
  normal: Vector;
  algorithm: number;
  iterations: number;
}

export interface Contact {
  /** Slot 0 outside of a universe. */
  geometryA: GeometryId;
  geometryB: GeometryId;
  /** The same while the same features touch. */
  id: bigint;
  featureA: Feature;
  featureB: Feature;
  childA: number;
  childB: number;
  pointA: Vector;
  pointB: Vector;
  /** Unit, from a to b. */
  normal: Vector;
  /** Negative: overlapping. */
  distance: number;
  toi: number;
  flags: number;
  /** Steps in a row before this one that reported it. */
  age: number;
  userData: bigint;
  materialA: number;
  materialB: number;
  tangent: Vector;
}

/** Signed distance of two shapes. */
export function pairDistance(a: Shape, poseA: Pose, b: Shape, poseB: Pose, options?: QueryOptions): Distance;

/** Whether two shapes are within the margin, by default 0. */
export function pairOverlaps(a: Shape, poseA: Pose, b: Shape, poseB: Pose, options?: QueryOptions): boolean;

/** The same pair by pair, in one call: for as many shapes as poses on either side. */
export function pairsOverlap(
  shapesA: Shape[], posesA: Poses, shapesB: Shape[], posesB: Poses, options?: QueryOptions): boolean[];

/** Signed distances for many pairs of poses of two shapes, in one call. */
export function pairDistances(
  a: Shape, posesA: Poses, b: Shape, posesB: Poses, options?: QueryOptions): Distance[];

/** Contact points of two shapes, deepest first. */
export function pairContacts(a: Shape, poseA: Pose, b: Shape, poseB: Pose, options?: QueryOptions): Contact[];

/** The same for many pairs of poses of two shapes, in one call: a list for each pair. */
export function pairContactLists(
  a: Shape, posesA: Poses, b: Shape, posesB: Poses, options?: QueryOptions): Contact[][];

/** When two shapes first touch that both move by a displacement without turning; null when they do not. */
export function pairCast(
  a: Shape, poseA: Pose, displacementA: Vector, b: Shape, poseB: Pose, displacementB: Vector,
  options?: QueryOptions): CastHit | null;

/** The same for many poses and displacements, in one call. */
export function pairCasts(
  a: Shape, posesA: Poses, displacementsA: Vectors, b: Shape, posesB: Poses, displacementsB: Vectors,
  options?: QueryOptions): (CastHit | null)[];

/** What keeps two geometries from being examined. */
export type ApartReason = 'part' | 'motion' | 'parking' | 'exclusion' | 'layers' | 'rule' | 'filter' | 'kinds' | 'boxes' |
  'policy' | 'detection' | 'side';

export interface UniverseOptions {
  broadphase?: 'auto' | 'brute' | 'tree' | 'sweepAndPrune' | 'hashGrid';
  toleranceMode?: 'deadBand' | 'margin';
  maxContacts?: number;
  maxPairContacts?: number;
  origin?: Vector;
  /** Of a step; 0 for as many as there may be. */
  threads?: number;
  /** Bits of ABUT_EVENTS_. */
  events?: number;
  /** Bits of ABUT_UNIVERSE_: 2 welds static geometries that lie side by side. */
  flags?: number;
}

/** How a part moves. Pairs of parts of which neither is dynamic are never examined. */
export type Motion = 'dynamic' | 'animated' | 'static';

/** A side of a rule. */
export type Collidable = { geometry: GeometryId } | { part: PartId } | { label: number } | 'any';

export interface PartOptions {
  motion?: Motion;
  pose?: Pose;
  userData?: number | bigint;
}

export interface GeometryOptions {
  /** Bits of ABUT_GEOMETRY_. */
  flags?: number;
  /** In the frame of the part. */
  pose?: Pose;
  tolerance?: number;
  userData?: number | bigint;
  layers?: number | bigint;
  mask?: number | bigint;
  exclusion?: number | bigint;
  label?: number;
  tag?: number;
  material?: number;
  parking?: Parking;
}

export type Parking = 'none' | 'shortTerm' | 'longTerm';

/** Which geometries a query looks at; by default all. */
export interface QueryFilter {
  /** Bits of ABUT_QUERY_FILTER_. */
  flags?: number;
  layers?: number | bigint;
  mask?: number | bigint;
  ignorePart?: PartId;
  ignoreGeometry?: GeometryId;
  rayStart?: 'farSide' | 'solid' | 'skip';
}

export interface Event {
  kind: 'begin' | 'persist' | 'end';
  flags: number;
  geometryA: GeometryId;
  geometryB: GeometryId;
  /** 0 for a pair. */
  contactId: bigint;
  firstContact: number;
  contactCount: number;
}

export interface Ray {
  origin: Vector;
  direction: Vector;
  /** Infinite by default. */
  maxDistance?: number;
}

export interface Hit {
  geometry: GeometryId;
  feature: Feature;
  child: number;
  distance: number;
  point: Vector;
  normal: Vector;
}

export interface CastHit {
  geometry: GeometryId;
  /** Of the displacement. */
  fraction: number;
  contact: Distance;
  featureA: Feature;
  featureB: Feature;
  childA: number;
  childB: number;
}

/** A space in which parts meet. */
export class Universe {
  constructor(options?: UniverseOptions);
  /** The pointer of the C interface, for calls of your own. */
  readonly pointer: bigint;
  /** Frees it now. Twice is allowed. */
  destroy(): void;
  addPart(options?: PartOptions): PartId;
  /** Destroys a part with its geometries. */
  removePart(part: PartId): void;
  /** Places a part; takes effect for contacts at the next step. */
  setPose(part: PartId, pose: Pose): void;
  /** Places parts, all or none. */
  setPoses(parts: readonly PartId[], poses: Poses): void;
  pose(part: PartId): Pose;
  setMotion(part: PartId, motion: Motion): void;
  /** Your number on a part. */
  userData(part: PartId): bigint;
  /** All parts, ordered by slot. */
  parts(): PartId[];
  /** Geometries of a part, in order of creation. */
  geometriesOf(part: PartId): GeometryId[];
  /** Puts a shape on a part. The universe keeps the shape alive. */
  addGeometry(part: PartId, shape: Shape, options?: GeometryOptions): GeometryId;
  removeGeometry(geometry: GeometryId): void;
  /** Replaces the options of a geometry, all of them. */
  setOptions(geometry: GeometryId, options?: GeometryOptions): void;
  /** Gives a geometry another shape. */
  setShape(geometry: GeometryId, shape: Shape): void;
  /** Says whether two collidables meet; the most specific rule that fits a pair counts. */
  setRule(a: Collidable, b: Collidable, rule: 'none' | 'enable' | 'disable'): void;
  /** Takes all rules away. */
  clearRules(): void;
  /** Why two geometries are not examined; empty where they are, so that the distance of their shapes decides. */
  whyApart(a: GeometryId, b: GeometryId): ApartReason[];
  /** Parks a geometry, or brings it back with 'none'. A filter may do that, too. */
  park(geometry: GeometryId, parking: Parking): void;
  /**
   * Says which pairs that come near are kept; null keeps all. What it throws keeps the pair, and comes out of the step.
   * One that names its universe keeps it alive: destroy the universe then.
   */
  setFilter(keeps: ((a: GeometryId, b: GeometryId) => boolean) | null): void;
  /** Asks the filter about all pairs again at the next step. */
  refilter(): void;
  /** Finds what touches at the present poses; dt is the time since the step before. Moves nothing. */
  step(dt: number): void;
  /** A step that finds every pair anew. */
  detectAll(): void;
  /** Brings what queries see up to date with the poses, without detecting anything. */
  refresh(): void;
  /** Contacts of the last step, copied, ordered by the slots of the two geometries. */
  contacts(): Contact[];
  /** Events of the last step, copied. */
  events(): Event[];
  /** What the last step did and why, in words. */
  explain(): string;
  /** The first geometry that a ray meets. */
  castRay(origin: Vector, direction: Vector, options?: QueryFilter & { maxDistance?: number }): Hit | null;
  /** The same for many rays, in one call. */
  castRays(rays: readonly Ray[], filter?: QueryFilter): (Hit | null)[];
  /** The first geometry that a shape meets while it moves without turning. */
  castShape(shape: Shape, pose: Pose, displacement: Vector, filter?: QueryFilter): CastHit | null;
  /** Geometries that a shape touches, or has within a margin. */
  overlaps(shape: Shape, pose: Pose, options?: QueryFilter & { margin?: number }): GeometryId[];
  /** The geometry nearest to a shape. */
  closest(shape: Shape, pose: Pose, options?: QueryFilter & { maxDistance?: number }):
    { geometry: GeometryId; distance: Distance } | null;
}
