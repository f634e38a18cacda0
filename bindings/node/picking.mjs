// SPDX-License-Identifier: Apache-2.0
// abut/picking for Node: rays and the mouse against a universe, through Embree. picking.d.ts describes all of it.
import { codecs, declaredIn, load, numberOf, options, refuse } from './library.mjs';
import { prototypes, structs } from './raw.mjs';
import { Universe } from './universe.mjs';

const picking = declaredIn(load('libabut_picking', 'ABUT_PICKING_LIBRARY'), prototypes.picking);

const cameraOptions = (fields) => options(structs.camera, fields, picking);
const picksOf = (memory, count) => memory.first(count).map((pick) => (pick.geometry.slot === 0 ? null : pick));

export class Camera {
  constructor({ eye, target, up = { x: 0, y: 0, z: 1 }, ...fields } = {}) {
    this.fields = cameraOptions(fields);
    if (eye || target) this.lookAt(eye, target, up);
  }

  lookAt(eye, target, up = { x: 0, y: 0, z: 1 }) {
    picking.abut_camera_look_at(this.fields, eye, target, up);
  }

  ray(x, y) {
    const out = codecs.ray.room();
    picking.abut_camera_ray(this.fields, x, y, out.bytes);
    return out.get();
  }
}

// The universe frees pickers that are left, before itself. What is held names neither the picker nor the universe.
const forgotten = new FinalizationRegistry((held) => held.free());

export class Picker {
  #held;
  #universe;

  constructor(universe) {
    const out = [null];
    picking.abut_picker_create(universe.pointer, out);
    const pickers = Universe.pickersOf(universe);
    const held = { pointer: out[0], free: () => pickers.delete(held) && picking.abut_picker_destroy(held.pointer) };
    pickers.add(held);
    this.#universe = universe;
    this.#held = { held, pickers };
    forgotten.register(this, held, this);
  }

  get pointer() {
    const { held, pickers } = this.#held;
    return pickers.has(held) ? held.pointer : refuse('the picker has been destroyed, by itself or with its universe');
  }

  get universe() {
    return this.#universe;
  }

  destroy() {
    forgotten.unregister(this);
    this.#held.held.free();
  }

  update() {
    picking.abut_picker_update(this.pointer);
  }

  castRay(origin, direction, { maxDistance = Infinity, ...filter } = {}) {
    return this.castRays([{ origin, direction, maxDistance }], filter)[0];
  }

  castRays(rays, { coherence = 'none', ...filter } = {}) {
    const out = codecs.hit.room(rays.length);
    const all = codecs.ray.encode(rays.map((ray) => ({ maxDistance: Infinity, ...ray })), 'rays');
    picking.abut_picker_cast_rays(this.pointer, all, rays.length, numberOf('coherence', coherence),
      options(structs.queryFilter, filter), out.bytes);
    return picksOf(out, rays.length);
  }

  castRayAll(origin, direction, { maxDistance = Infinity, ...filter } = {}) {
    const ray = codecs.ray.encode([{ origin, direction, maxDistance }], 'rays');
    const its = options(structs.queryFilter, filter);
    return codecs.hit.fill((place, capacity, count) => picking.abut_picker_cast_ray_all(
      this.pointer, ray, its, place, capacity, count));
  }

  pickPixel(its, x, y, { radius = 0, ...filter } = {}) {
    const out = codecs.hit.room();
    picking.abut_picker_pick_pixel(this.pointer, its.fields, x, y, radius, options(structs.queryFilter, filter), out.bytes);
    return picksOf(out, 1)[0];
  }

  setFlags({ sensors = false, skipsBackFaces = false } = {}) {
    picking.abut_picker_set_flags(this.pointer, (sensors ? 1 : 0) | (skipsBackFaces ? 2 : 0));
  }

  rayHits(origin, direction, { maxDistance = Infinity, ...filter } = {}) {
    const ray = codecs.ray.encode([{ origin, direction, maxDistance }], 'rays');
    const out = [0];
    picking.abut_picker_ray_hits(this.pointer, ray, options(structs.queryFilter, filter), out);
    return out[0] === 1;
  }

  select(its, x0, y0, x1, y1, { inside = false, ...filter } = {}) {
    return codecs.geometryId.fill((place, capacity, count) => picking.abut_picker_select_rectangle(
      this.pointer, its.fields, x0, y0, x1, y1, inside ? 1 : 0, options(structs.queryFilter, filter), place, capacity, count), 64);
  }

  render(its, filter) {
    const count = its.fields.width * its.fields.height;
    const out = codecs.hit.room(count);
    picking.abut_picker_render(this.pointer, its.fields, options(structs.queryFilter, filter), out.bytes, count);
    return picksOf(out, count);
  }
}
