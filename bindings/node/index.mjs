// SPDX-License-Identifier: Apache-2.0
// abut for Node: shapes, queries on two of them, and universes. index.d.ts describes all of it.
import { abut, decode, fill, made, options, refuse, room, structs } from './library.mjs';

export { AbutError } from './library.mjs';
export { Universe } from './universe.mjs';

export const version = abut.abut_version_string;

export function pose(x = 0, y = 0, z = 0, orientation = { w: 1, x: 0, y: 0, z: 0 }) {
  return { position: { x, y, z }, orientation };
}

// What nobody holds any more is released, at the latest when the process ends.
const forgotten = new FinalizationRegistry((pointer) => abut.abut_shape_release(pointer));

function expectThrees(name, values) {
  if (values.length % 3 !== 0) refuse(`${name} has ${values.length} numbers, which is not a multiple of 3`);
  return values.length / 3;
}

export function expectAsMany(nameA, a, nameB, b) {
  if (a.length !== b.length) refuse(`${nameA} has ${a.length} elements and ${nameB} has ${b.length}; expected as many`);
}

export class Shape {
  #pointer;

  constructor(pointer) {
    if (typeof pointer !== 'bigint') throw new TypeError('shapes are made by Shape.sphere, Shape.box and so on');
    this.#pointer = pointer;
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
    return new Shape(made(abut.abut_plane_create, normal, offset));
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
      abut.abut_mesh_create, Float64Array.from(xyz), count, Uint32Array.from(triangles), triangleCount, its));
  }

  static particles(xyz, radius) {
    const count = expectThrees('xyz', xyz);
    return new Shape(made(abut.abut_particles_create, Float64Array.from(xyz), count, radius));
  }

  static composite(children, poses) {
    expectAsMany('children', children, 'poses', poses);
    return new Shape(made(abut.abut_composite_create, children.map((child) => child.pointer), poses, poses.length));
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
  const out = {};
  abut.abut_pair_distance(a.pointer, poseA, b.pointer, poseB, options(structs.queryOptions, fields), out);
  return out;
}

export function pairDistances(a, posesA, b, posesB, fields) {
  expectAsMany('posesA', posesA, 'posesB', posesB);
  const out = room(structs.distance, posesA.length);
  const its = options(structs.queryOptions, fields);
  abut.abut_pairs_distance(a.pointer, posesA, b.pointer, posesB, posesA.length, its, out);
  return decode(out, structs.distance, posesA.length);
}

export function pairContacts(a, poseA, b, poseB, fields) {
  const its = options(structs.queryOptions, fields);
  return fill(structs.contact, (place, capacity, count) =>
    abut.abut_pair_contacts(a.pointer, poseA, b.pointer, poseB, its, place, capacity, count));
}
