// SPDX-License-Identifier: Apache-2.0
// The C interface as far as the package uses it: structs, functions, failures. include/abut/abut.h describes each.
import koffi from 'koffi';
import { Codec } from './codec.mjs';

const vector = koffi.struct('abut_vec3', { x: 'double', y: 'double', z: 'double' });
const quaternion = koffi.struct('abut_quat', { w: 'double', x: 'double', y: 'double', z: 'double' });
const pose = koffi.struct('abut_pose', { position: vector, orientation: quaternion });
const id = { slot: 'uint32_t', generation: 'uint32_t' };
const partId = koffi.struct('abut_part_id', id);
const geometryId = koffi.struct('abut_geometry_id', id);
const feature = koffi.struct('abut_feature', { kind: 'uint32_t', index: 'uint32_t' });
const distance = koffi.struct('abut_distance', {
  distance: 'double', lower: 'double', upper: 'double', pointA: vector, pointB: vector, normal: vector,
  algorithm: 'uint32_t', iterations: 'uint32_t',
});

export const structs = {
  vector, quaternion, pose, partId, geometryId, feature, distance,
  contact: koffi.struct('abut_contact', {
    geometryA: geometryId, geometryB: geometryId, id: 'uint64_t', featureA: feature, featureB: feature,
    childA: 'uint32_t', childB: 'uint32_t', pointA: vector, pointB: vector, normal: vector, distance: 'double',
    toi: 'double', flags: 'uint32_t', age: 'uint32_t', userData: 'uint64_t', materialA: 'uint32_t',
    materialB: 'uint32_t', tangent: vector, reserved: 'uint64_t',
  }),
  event: koffi.struct('abut_event', {
    kind: 'uint32_t', flags: 'uint32_t', geometryA: geometryId, geometryB: geometryId, contactId: 'uint64_t',
    firstContact: 'uint32_t', contactCount: 'uint32_t',
  }),
  ray: koffi.struct('abut_ray', { origin: vector, direction: vector, maxDistance: 'double' }),
  hit: koffi.struct('abut_query_hit', {
    geometry: geometryId, feature, child: 'uint32_t', reserved: 'uint32_t', distance: 'double', point: vector,
    normal: vector,
  }),
  castHit: koffi.struct('abut_cast_hit', {
    geometry: geometryId, fraction: 'double', contact: distance, featureA: feature, featureB: feature,
    childA: 'uint32_t', childB: 'uint32_t',
  }),
  closest: koffi.struct('abut_closest', { geometry: geometryId, distance }),
  heightFieldDesc: koffi.struct('abut_height_field_desc', {
    structSize: 'uint32_t', diagonal: 'uint32_t', columns: 'uint32_t', rows: 'uint32_t', spacingX: 'double',
    spacingY: 'double', heights: 'double *', below: 'uint32_t', reserved: 'uint32_t',
  }),
  collidable: koffi.struct('abut_collidable', { kind: 'uint32_t', slot: 'uint32_t', generation: 'uint32_t' }),
  shapeDesc: koffi.struct('abut_shape_desc', {
    structSize: 'uint32_t', kind: 'uint32_t', parameters: 'double *', parameterCount: 'uint64_t', reals: 'double *',
    realCount: 'uint64_t', indices: 'uint32_t *', indexCount: 'uint64_t',
  }),
  meshOptions: koffi.struct('abut_mesh_options', {
    structSize: 'uint32_t', sides: 'uint32_t', corners: 'uint32_t', mergesVertices: 'uint32_t', mergeDistance: 'double',
    tree: 'uint32_t', reserved: 'uint32_t',
  }),
  queryOptions: koffi.struct('abut_query_options', {
    structSize: 'uint32_t', algorithm: 'uint32_t', errorBound: 'double', margin: 'double', maxContacts: 'uint32_t',
    maxPairContacts: 'uint32_t', threads: 'uint32_t', reserved: 'uint32_t',
  }),
  universeOptions: koffi.struct('abut_universe_options', {
    structSize: 'uint32_t', broadphase: 'uint32_t', toleranceMode: 'uint32_t', maxContacts: 'uint32_t', origin: vector,
    threads: 'uint32_t', events: 'uint32_t', flags: 'uint32_t', maxPairContacts: 'uint32_t',
  }),
  partOptions: koffi.struct('abut_part_options', {
    structSize: 'uint32_t', motion: 'uint32_t', pose, userData: 'uint64_t',
  }),
  geometryOptions: koffi.struct('abut_geometry_options', {
    structSize: 'uint32_t', flags: 'uint32_t', pose, tolerance: 'double', userData: 'uint64_t', layers: 'uint64_t',
    mask: 'uint64_t', exclusion: 'uint64_t', label: 'uint32_t', tag: 'uint32_t', material: 'uint32_t',
    parking: 'uint32_t',
  }),
  queryFilter: koffi.struct('abut_query_filter', {
    structSize: 'uint32_t', flags: 'uint32_t', layers: 'uint64_t', mask: 'uint64_t', ignorePart: partId,
    ignoreGeometry: geometryId, rayStart: 'uint32_t', reserved: 'uint32_t',
  }),
  layoutEntry: koffi.struct('abut_layout_entry', { type: 'str', field: 'str', offset: 'uint64_t', size: 'uint64_t' }),
};

/** How structs that calls take and answer lie in memory. */
export const codecs = Object.fromEntries(
  ['vector', 'pose', 'partId', 'geometryId', 'distance', 'contact', 'event', 'ray', 'hit', 'castHit', 'closest', 'collidable']
    .map((name) => [name, new Codec(structs[name])]));

koffi.opaque('abut_shape');
koffi.opaque('abut_universe');
export const Filter = koffi.pointer(koffi.proto(
  'uint32_t abut_filter(void *context, void *universe, abut_geometry_id a, abut_geometry_id b)'));

/** The library of that name, or the file that a variable of the environment names. */
export function load(soname, variable) {
  const name = process.env[variable] ?? soname;
  try {
    return koffi.load(name);
  } catch (thrown) {
    throw new Error(`${name} cannot be loaded; install abut, or name the file of the library in ${variable}`, { cause: thrown });
  }
}

const library = load('libabut.so.0.2', 'ABUT_LIBRARY');

// A declaration becomes a function; one that answers a status throws what it stands for.
function declare(its, prototype) {
  const call = its.func(prototype);
  return prototype.startsWith('int32_t ') ? (...values) => check(call(...values)) : call;
}

const message = library.func('const char *abut_last_error_message()');
const nameOf = library.func('const char *abut_status_name(int32_t status)');

/** A call that failed, and changed nothing. `status` is its name in abut.h, such as "ABUT_OUT_OF_RANGE". */
export class AbutError extends Error {
  constructor(status, text) {
    super(text);
    this.name = 'AbutError';
    this.status = status;
  }
}

function check(status) {
  if (status !== 0) throw new AbutError(nameOf(status), message());
}

export function refuse(text) {
  throw new AbutError('ABUT_INVALID_ARGUMENT', text);
}

const prototypes = [
  'int32_t abut_check_version(uint32_t major, uint32_t minor)',
  'const char *abut_version_string()',
  'size_t abut_layout_count()',
  'int32_t abut_layout_at(size_t index, _Out_ abut_layout_entry *out)',

  'int32_t abut_sphere_create(double radius, _Out_ abut_shape **out)',
  'int32_t abut_box_create(double x, double y, double z, _Out_ abut_shape **out)',
  'int32_t abut_capsule_create(double radius, double half_height, _Out_ abut_shape **out)',
  'int32_t abut_cylinder_create(double radius, double half_height, _Out_ abut_shape **out)',
  'int32_t abut_plane_create(const abut_vec3 *normal, double offset, _Out_ abut_shape **out)',
  'int32_t abut_hull_create(const double *xyz, size_t count, _Out_ abut_shape **out)',
  'int32_t abut_mesh_create(const double *xyz, size_t count, const uint32_t *triangles, size_t triangle_count, ' +
    'const abut_mesh_options *options, _Out_ abut_shape **out)',
  'int32_t abut_height_field_create(const abut_height_field_desc *desc, _Out_ abut_shape **out)',
  'int32_t abut_particles_create(const double *xyz, size_t count, double radius, _Out_ abut_shape **out)',
  'int32_t abut_composite_create(abut_shape **children, const abut_pose *poses, size_t count, _Out_ abut_shape **out)',
  'int32_t abut_shape_create(const abut_shape_desc *desc, _Out_ abut_shape **out)',
  'void abut_shape_release(abut_shape *shape)',
  'uint32_t abut_shape_kind_by_name(const char *name)',
  'const char *abut_shape_kind_name(uint32_t kind)',
  'uint32_t abut_shape_kind_of(abut_shape *shape)',

  'int32_t abut_pair_distance(abut_shape *a, const abut_pose *pose_a, abut_shape *b, const abut_pose *pose_b, ' +
    'const abut_query_options *options, abut_distance *out)',
  'int32_t abut_pair_overlaps(abut_shape *a, const abut_pose *pose_a, abut_shape *b, const abut_pose *pose_b, ' +
    'const abut_query_options *options, _Out_ uint32_t *out)',
  'int32_t abut_pairs_overlap(abut_shape **shapes_a, const abut_pose *poses_a, abut_shape **shapes_b, ' +
    'const abut_pose *poses_b, size_t count, const abut_query_options *options, void *out)',
  'int32_t abut_pairs_distance(abut_shape *a, const abut_pose *poses_a, abut_shape *b, const abut_pose *poses_b, ' +
    'size_t count, const abut_query_options *options, void *out)',
  'int32_t abut_pair_contacts(abut_shape *a, const abut_pose *pose_a, abut_shape *b, const abut_pose *pose_b, ' +
    'const abut_query_options *options, void *contacts, size_t capacity, _Out_ size_t *count)',

  'int32_t abut_pair_cast(abut_shape *a, const abut_pose *pose_a, const abut_vec3 *displacement_a, abut_shape *b, ' +
    'const abut_pose *pose_b, const abut_vec3 *displacement_b, const abut_query_options *options, void *hit, ' +
    '_Out_ uint32_t *found)',

  'int32_t abut_pairs_contacts(abut_shape *a, const abut_pose *poses_a, abut_shape *b, const abut_pose *poses_b, ' +
    'size_t pair_count, const abut_query_options *options, void *offsets, void *contacts, size_t capacity, ' +
    '_Out_ size_t *count)',
  'int32_t abut_pairs_cast(abut_shape *a, const abut_pose *poses_a, const abut_vec3 *displacements_a, abut_shape *b, ' +
    'const abut_pose *poses_b, const abut_vec3 *displacements_b, size_t count, const abut_query_options *options, ' +
    'void *hits)',

  'int32_t abut_universe_create(const abut_universe_options *options, _Out_ abut_universe **out)',
  'void abut_universe_destroy(abut_universe *universe)',
  'int32_t abut_part_create(abut_universe *universe, const abut_part_options *options, abut_part_id *out)',
  'int32_t abut_part_destroy(abut_universe *universe, abut_part_id part)',
  'int32_t abut_part_set_pose(abut_universe *universe, abut_part_id part, const abut_pose *pose)',
  'int32_t abut_parts_set_poses(abut_universe *universe, const abut_part_id *parts, const abut_pose *poses, size_t count)',
  'int32_t abut_part_pose(abut_universe *universe, abut_part_id part, abut_pose *out)',
  'int32_t abut_part_set_motion(abut_universe *universe, abut_part_id part, uint32_t motion)',
  'int32_t abut_part_user_data(abut_universe *universe, abut_part_id part, _Out_ uint64_t *out)',
  'int32_t abut_part_geometries(abut_universe *universe, abut_part_id part, void *geometries, size_t capacity, ' +
    '_Out_ size_t *count)',
  'int32_t abut_universe_parts(abut_universe *universe, void *parts, size_t capacity, _Out_ size_t *count)',
  'int32_t abut_geometry_create(abut_universe *universe, abut_part_id part, abut_shape *shape, ' +
    'const abut_geometry_options *options, abut_geometry_id *out)',
  'int32_t abut_geometry_destroy(abut_universe *universe, abut_geometry_id geometry)',
  'int32_t abut_geometry_set_options(abut_universe *universe, abut_geometry_id geometry, ' +
    'const abut_geometry_options *options)',
  'int32_t abut_geometry_set_shape(abut_universe *universe, abut_geometry_id geometry, abut_shape *shape)',
  'int32_t abut_rule_set(abut_universe *universe, const abut_collidable *a, const abut_collidable *b, uint32_t rule)',
  'int32_t abut_rules_clear(abut_universe *universe)',
  'int32_t abut_universe_why_apart(abut_universe *universe, abut_geometry_id a, abut_geometry_id b, _Out_ uint32_t *out)',
  'int32_t abut_geometry_park(abut_universe *universe, abut_geometry_id geometry, uint32_t parking)',
  'int32_t abut_universe_set_filter(abut_universe *universe, abut_filter *filter, void *context)',
  'int32_t abut_universe_refilter(abut_universe *universe)',
  'int32_t abut_universe_step(abut_universe *universe, double dt)',
  'int32_t abut_universe_detect_all(abut_universe *universe)',
  'int32_t abut_universe_refresh(abut_universe *universe)',
  'int32_t abut_universe_contacts(abut_universe *universe, _Out_ void **contacts, _Out_ size_t *count)',
  'int32_t abut_universe_events(abut_universe *universe, _Out_ void **events, _Out_ size_t *count)',
  'int32_t abut_universe_explain(abut_universe *universe, void *text, size_t capacity, _Out_ size_t *needed)',
  'int32_t abut_universe_cast_rays(abut_universe *universe, const abut_ray *rays, size_t count, ' +
    'const abut_query_filter *filter, void *hits)',
  'int32_t abut_universe_cast_shape(abut_universe *universe, abut_shape *shape, const abut_pose *pose, ' +
    'const abut_vec3 *displacement, const abut_query_filter *filter, uint32_t mode, void *hits, size_t capacity, ' +
    '_Out_ size_t *count)',
  'int32_t abut_universe_overlaps(abut_universe *universe, abut_shape *shape, const abut_pose *pose, ' +
    'const abut_query_filter *filter, double margin, void *geometries, size_t capacity, _Out_ size_t *count)',
  'int32_t abut_universe_closest(abut_universe *universe, abut_shape *shape, const abut_pose *pose, double max_distance, ' +
    'const abut_query_filter *filter, abut_closest *out, _Out_ uint32_t *found)',
  ...Object.entries(structs).filter(([name]) => /Options|Filter|Desc/.test(name)).map(([, struct]) =>
    `void ${struct.name}_init(_Out_ ${struct.name} *out, uint32_t struct_size)`),
];

/** Functions of a library, by their names in its header. */
export function declaredIn(its, declarations) {
  return Object.fromEntries(declarations.map((text) => [/(abut_\w+)\(/.exec(text)[1], declare(its, text)]));
}

export const abut = declaredIn(library, prototypes);

abut.abut_check_version(0, 2);

/** What a call writes to a pointer that is its last argument. */
export function made(call, ...values) {
  const out = [null];
  call(...values, out);
  return out[0];
}

/** The one struct that a call writes to its last argument. */
export function answer(codec, call, ...values) {
  const out = codec.room();
  call(...values, out.bytes);
  return out.get();
}

// Poses and vectors are read before a call returns, so each place in a call has memory that is used again and again.
const scratch = { pose: [codecs.pose.room(), codecs.pose.room()], vector: [codecs.vector.room(), codecs.vector.room()] };

export function poseAt(pose, place = 0) {
  scratch.pose[place].set(pose);
  return scratch.pose[place].bytes;
}

export function vectorAt(vector, place = 0) {
  scratch.vector[place].set(vector);
  return scratch.vector[place].bytes;
}

// Structs of `width` numbers as they are, or as these numbers.
function rowsOf(codec, width, name, values) {
  if (!(values instanceof Float64Array)) return { bytes: codec.encode(values), count: values.length };
  if (values.length % width !== 0) refuse(`${name} has ${values.length} numbers, which is not a multiple of ${width}`);
  return { bytes: new Uint8Array(values.buffer, values.byteOffset, values.byteLength), count: values.length / width };
}

/** Poses as they are, or 7 numbers each: x, y, z of the position, then w, x, y, z of the orientation. */
export function posesOf(name, poses) {
  return rowsOf(codecs.pose, 7, name, poses);
}

/** Vectors as they are, or 3 numbers each. */
export function vectorsOf(name, vectors) {
  return rowsOf(codecs.vector, 3, name, vectors);
}

export function expectAsMany(nameA, countA, nameB, countB) {
  if (countA !== countB) refuse(`${nameA} has ${countA} elements and ${nameB} has ${countB}; expected as many`);
}

// Fields that are words here and numbers there.
const words = {
  algorithm: ['auto', 'analytic', 'sat', 'gjkEpa', 'libccdGjk', 'libccdMpr'],
  broadphase: ['auto', 'brute', 'tree', 'sweepAndPrune', 'hashGrid'],
  toleranceMode: ['deadBand', 'margin'],
  motion: ['dynamic', 'animated', 'static'],
  parking: ['none', 'shortTerm', 'longTerm'],
  rayStart: ['farSide', 'solid', 'skip'],
  sides: ['both', 'front', 'solid'],
  rule: ['none', 'enable', 'disable'],
  coherence: ['none', 'neighbours'],
};

/** The number of a word of a field. */
export function numberOf(field, word) {
  const number = words[field].indexOf(word);
  return number >= 0 ? number : refuse(`${field} is ${word}; expected one of ${words[field].join(', ')}`);
}

/** Options with the defaults of their library, and the given fields on top; null where none is given. */
export function options(struct, fields, functions = abut) {
  if (fields === undefined) return null;
  const all = {};
  functions[`${struct.name}_init`](all, koffi.sizeof(struct));
  for (const [field, value] of Object.entries(fields)) {
    if (!(field in all) || field === 'structSize') {
      const known = Object.keys(all).filter((name) => name !== 'structSize' && name !== 'reserved').join(', ');
      refuse(`${field} is no option; there are ${known}`);
    }
    if (value !== undefined) all[field] = field in words ? numberOf(field, value) : value;
  }
  return all;
}
