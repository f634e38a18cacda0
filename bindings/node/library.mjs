// SPDX-License-Identifier: Apache-2.0
// The C interface as functions that throw, and structs as objects. include/abut/abut.h describes each.
import koffi from 'koffi';
import { Codec } from './codec.mjs';
import { expectNumber, expectStruct, expectWhole, refusal } from './given.mjs';
import { prototypes, structs, version } from './raw.mjs';

/** How structs that calls take and answer lie in memory. */
export const codecs = Object.fromEntries(
  ['vector', 'pose', 'partId', 'geometryId', 'distance', 'contact', 'event', 'ray', 'hit', 'castHit', 'closest', 'collidable']
    .map((name) => [name, new Codec(structs[name])]));

// Below 1.0 the structs of each minor version differ.
const soversion = version.major === 0 ? `0.${version.minor}` : version.major;

/** The library of that name, or the file that a variable of the environment names. */
export function load(file, variable) {
  const name = process.env[variable] ?? `${file}.so.${soversion}`;
  try {
    return koffi.load(name);
  } catch (thrown) {
    throw new Error(`${name} cannot be loaded; install abut, or name the file of the library in ${variable}`, { cause: thrown });
  }
}

const library = load('libabut', 'ABUT_LIBRARY');

function expectId(name, value) {
  if (value === null || typeof value !== 'object') refuse(`${name} is ${value}; expected an id of a universe`);
  expectWhole(`${name}.slot`, value.slot, 32);
  expectWhole(`${name}.generation`, value.generation, 32);
}

// What koffi would cut, or refuse without the name of the parameter.
const expectations = {
  double: expectNumber,
  uint32_t: (name, value) => expectWhole(name, value, 32),
  uint64_t: (name, value) => expectWhole(name, value, 64),
  size_t: (name, value) => expectWhole(name, value, 64),
  abut_part_id: expectId,
  abut_geometry_id: expectId,
};

// Parameters of a declaration that are given by value, with their places.
function expectedBy(prototype) {
  const parameters = /\((.*)\)$/.exec(prototype)[1].split(', ').map((text) => text.split(' '));
  return parameters.flatMap(([type, name], place) => (type in expectations && /^\w+$/.test(name)
    ? [{ place, expect: expectations[type], name: name.replace(/_(.)/g, (_, letter) => letter.toUpperCase()) }] : []));
}

// A declaration becomes a function; one that answers a status throws what it stands for.
function declare(its, prototype) {
  const call = its.func(prototype);
  if (!prototype.startsWith('int32_t ')) return call;
  const expected = expectedBy(prototype);
  return (...values) => {
    for (const { place, expect, name } of expected) expect(name, values[place]);
    check(call(...values));
  };
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

refusal.throws = refuse;

// Shapes that index.mjs has made.
export const shapes = new WeakSet();

/** The pointer of a shape that a caller has given. */
export function pointerOf(name, shape) {
  return shapes.has(shape) ? shape.pointer : refuse(`${name} is ${shape}; expected a Shape`);
}

/** Whole numbers of 32 bits in an array of their own. */
export function wholesOf(name, values) {
  if (values instanceof Uint32Array) return values;
  Array.from(values, (value, i) => expectWhole(`${name}[${i}]`, value, 32));
  return Uint32Array.from(values);
}

/** Functions of a library, by their names in its header. */
export function declaredIn(its, declarations) {
  return Object.fromEntries(declarations.map((text) => [/(abut_\w+)\(/.exec(text)[1], declare(its, text)]));
}

export const abut = declaredIn(library, prototypes.abut);

abut.abut_check_version(version.major, version.minor);

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

export function poseAt(pose, place = 0, name = 'pose') {
  scratch.pose[place].set(pose, 0, name);
  return scratch.pose[place].bytes;
}

export function vectorAt(vector, place = 0, name = 'vector') {
  scratch.vector[place].set(vector, 0, name);
  return scratch.vector[place].bytes;
}

// Structs of `width` numbers as they are, or as these numbers.
function rowsOf(codec, width, name, values) {
  if (!(values instanceof Float64Array)) return { bytes: codec.encode(values, name), count: values.length };
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

// A value for a field of that type.
function expectField(field, type, value) {
  if (type.primitive === 'UInt32' || type.primitive === 'UInt64') {
    if (typeof value === 'boolean') return Number(value);
    expectWhole(field, value, type.primitive === 'UInt32' ? 32 : 64);
  } else if (type.primitive === 'Float64') {
    expectNumber(field, value);
  } else if (type.members) {
    expectStruct(field, type, value, true);
  }
  return value;
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
    if (value !== undefined) all[field] = field in words ? numberOf(field, value) : expectField(field, struct.members[field].type, value);
  }
  return all;
}
