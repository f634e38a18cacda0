// SPDX-License-Identifier: Apache-2.0
// abut for Node: shapes, queries on two of them, and universes. index.d.ts describes all of it.
import {
  abut, answer, codecs, expectAsMany, made, options, pointerOf, poseAt, posesOf, refuse, shapes, vectorAt, vectorsOf, wholesOf,
} from './library.mjs';
import { structs } from './raw.mjs';

export { AbutError } from './library.mjs';
export { Universe } from './universe.mjs';

export const version = abut.abut_version_string;

export function pose(x = 0, y = 0, z = 0, orientation = { w: 1, x: 0, y: 0, z: 0 }) {
  return { position: { x, y, z }, orientation };
}

// What nobody holds any more is released, at the latest when the process ends.
const forgotten = new FinalizationRegistry((pointer) => abut.abut_shape_release(pointer));

function expectThrees(name, values) {
  if (typeof values?.length !== 'number') refuse(`${name} is ${values}; expected an array of numbers`);
  if (values.length % 3 !== 0) refuse(`${name} has ${values.length} numbers, which is not a multiple of 3`);
  return values.length / 3;
}

export class Shape {
  #pointer;

  constructor(pointer) {
    if (typeof pointer !== 'bigint') throw new TypeError('shapes are made by Shape.sphere, Shape.box and so on');
    this.#pointer = pointer;
    shapes.add(this);
    forgotten.register(this, pointer, this);
  }

  static sphere(radius) {
    return new Shape(made(abut.abut_sphere_create, radius));
  }

  static box(x, y, z) {
    return new Shape(made(abut.abut_box_create, x, y, z));
  }

  static capsule(radius, halfHeight) {
    return new Shape(made(abut.abut_capsule_create, radius, halfHeight));
  }

  static cylinder(radius, halfHeight) {
    return new Shape(made(abut.abut_cylinder_create, radius, halfHeight));
  }

  static plane(normal, offset) {
    return new Shape(made(abut.abut_plane_create, vectorAt(normal, 0, 'normal'), offset));
  }

  static hull(xyz) {
    const count = expectThrees('xyz', xyz);
    return new Shape(made(abut.abut_hull_create, Float64Array.from(xyz), count));
  }

  static mesh(xyz, triangles, { sides = 'both' } = {}) {
    const count = expectThrees('xyz', xyz);
    const triangleCount = expectThrees('triangles', triangles);
    const its = options(structs.meshOptions, { sides });
    return new Shape(made(
      abut.abut_mesh_create, Float64Array.from(xyz), count, wholesOf('triangles', triangles), triangleCount, its));
  }

  static heightField(columns, rows, spacingX, spacingY, heights) {
    if (heights?.length !== columns * rows) {
      refuse(`heights has ${heights?.length} numbers; expected columns * rows, which is ${columns * rows}`);
    }
    return new Shape(made(abut.abut_height_field_create, options(structs.heightFieldDesc, {
      columns, rows, spacingX, spacingY, heights: Float64Array.from(heights),
    })));
  }

  static particles(xyz, radius) {
    const count = expectThrees('xyz', xyz);
    return new Shape(made(abut.abut_particles_create, Float64Array.from(xyz), count, radius));
  }

  static composite(children, poses) {
    const { bytes, count } = posesOf('poses', poses);
    expectAsMany('children', children.length, 'poses', count);
    return new Shape(made(abut.abut_composite_create, children.map((child, i) => pointerOf(`children[${i}]`, child)), bytes, count));
  }

  static ofKind(kind, ...parameters) {
    return new Shape(made(abut.abut_shape_create, options(structs.shapeDesc, {
      kind: abut.abut_shape_kind_by_name(kind), parameters: Float64Array.from(parameters),
      parameterCount: parameters.length,
    })));
  }

  get kind() {
    return abut.abut_shape_kind_name(abut.abut_shape_kind_of(this.pointer));
  }

  get pointer() {
    return this.#pointer ?? refuse('the shape has been released');
  }

  release() {
    if (this.#pointer === undefined) return;
    forgotten.unregister(this);
    abut.abut_shape_release(this.#pointer);
    this.#pointer = undefined;
  }
}

export function pairDistance(a, poseA, b, poseB, fields) {
  return answer(codecs.distance, abut.abut_pair_distance, pointerOf('a', a), poseAt(poseA, 0, 'poseA'), pointerOf('b', b), poseAt(poseB, 1, 'poseB'),
    options(structs.queryOptions, fields));
}

export function pairDistances(a, posesA, b, posesB, fields) {
  const [first, second] = [posesOf('posesA', posesA), posesOf('posesB', posesB)];
  expectAsMany('posesA', first.count, 'posesB', second.count);
  const out = codecs.distance.room(first.count);
  abut.abut_pairs_distance(pointerOf('a', a), first.bytes, pointerOf('b', b), second.bytes, first.count,
    options(structs.queryOptions, fields), out.bytes);
  return out.first(first.count);
}

export function pairOverlaps(a, poseA, b, poseB, fields) {
  const found = [0];
  abut.abut_pair_overlaps(pointerOf('a', a), poseAt(poseA, 0, 'poseA'), pointerOf('b', b), poseAt(poseB, 1, 'poseB'),
    options(structs.queryOptions, fields), found);
  return found[0] === 1;
}

export function pairsOverlap(shapesA, posesA, shapesB, posesB, fields) {
  const [first, second] = [posesOf('posesA', posesA), posesOf('posesB', posesB)];
  expectAsMany('posesA', first.count, 'posesB', second.count);
  expectAsMany('posesA', first.count, 'shapesA', shapesA.length);
  expectAsMany('posesA', first.count, 'shapesB', shapesB.length);
  const out = new Uint32Array(first.count);
  abut.abut_pairs_overlap(shapesA.map((shape, i) => pointerOf(`shapesA[${i}]`, shape)), first.bytes, shapesB.map((shape, i) => pointerOf(`shapesB[${i}]`, shape)),
    second.bytes, first.count, options(structs.queryOptions, fields), out);
  return Array.from(out, (answer) => answer === 1);
}

export function pairContacts(a, poseA, b, poseB, fields) {
  const its = options(structs.queryOptions, fields);
  return codecs.contact.fill((place, capacity, count) => abut.abut_pair_contacts(
    pointerOf('a', a), poseAt(poseA, 0, 'poseA'), pointerOf('b', b), poseAt(poseB, 1, 'poseB'), its, place, capacity, count));
}

export function pairContactLists(a, posesA, b, posesB, fields) {
  const [first, second] = [posesOf('posesA', posesA), posesOf('posesB', posesB)];
  expectAsMany('posesA', first.count, 'posesB', second.count);
  const its = options(structs.queryOptions, fields);
  const offsets = new BigUint64Array(first.count + 1);
  const all = codecs.contact.fill((place, capacity, count) => abut.abut_pairs_contacts(
    pointerOf('a', a), first.bytes, pointerOf('b', b), second.bytes, first.count, its, offsets, place, capacity, count), 4 * first.count);
  return Array.from({ length: first.count }, (_, i) => all.slice(Number(offsets[i]), Number(offsets[i + 1])));
}

export function pairCast(a, poseA, displacementA, b, poseB, displacementB, fields) {
  const out = codecs.castHit.room();
  const found = [0];
  abut.abut_pair_cast(
    pointerOf('a', a), poseAt(poseA, 0, 'poseA'), vectorAt(displacementA, 0, 'displacementA'), pointerOf('b', b), poseAt(poseB, 1, 'poseB'), vectorAt(displacementB, 1, 'displacementB'),
    options(structs.queryOptions, fields), out.bytes, found);
  return found[0] === 1 ? out.get() : null;
}

export function pairCasts(a, posesA, displacementsA, b, posesB, displacementsB, fields) {
  const given = {
    posesA: posesOf('posesA', posesA), displacementsA: vectorsOf('displacementsA', displacementsA),
    posesB: posesOf('posesB', posesB), displacementsB: vectorsOf('displacementsB', displacementsB),
  };
  const { count } = given.posesA;
  for (const [name, each] of Object.entries(given)) expectAsMany('posesA', count, name, each.count);
  const out = codecs.castHit.room(count);
  abut.abut_pairs_cast(
    pointerOf('a', a), given.posesA.bytes, given.displacementsA.bytes, pointerOf('b', b), given.posesB.bytes, given.displacementsB.bytes,
    count, options(structs.queryOptions, fields), out.bytes);
  return out.first(count).map((hit) => (Number.isFinite(hit.fraction) ? hit : null));
}
