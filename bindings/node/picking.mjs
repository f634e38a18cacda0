// SPDX-License-Identifier: Apache-2.0
// abut/picking for Node: rays and the mouse against a universe, through Embree. picking.d.ts describes all of it.
import koffi from 'koffi';
import { codecs, declaredIn, load, numberOf, options, refuse, structs } from './library.mjs';
import { Universe } from './universe.mjs';

const camera = koffi.struct('abut_camera', {
  structSize: 'uint32_t', width: 'uint32_t', height: 'uint32_t', reserved: 'uint32_t', pose: structs.pose,
  verticalFov: 'double', nearDistance: 'double', farDistance: 'double',
});
koffi.opaque('abut_picker');

const picking = declaredIn(load('libabut_picking.so.0.2', 'ABUT_PICKING_LIBRARY'), [
  'void abut_camera_init(_Out_ abut_camera *camera, uint32_t struct_size)',
  'int32_t abut_camera_look_at(_Inout_ abut_camera *camera, const abut_vec3 *eye, const abut_vec3 *target, ' +
    'const abut_vec3 *up)',
  'int32_t abut_camera_ray(const abut_camera *camera, double x, double y, void *out)',
  'int32_t abut_picker_create(abut_universe *universe, _Out_ abut_picker **out)',
  'void abut_picker_destroy(abut_picker *picker)',
  'int32_t abut_picker_update(abut_picker *picker)',
  'int32_t abut_picker_cast_rays(abut_picker *picker, const abut_ray *rays, size_t count, uint32_t coherence, ' +
    'const abut_query_filter *filter, void *out)',
  'int32_t abut_picker_cast_ray_all(abut_picker *picker, const abut_ray *ray, const abut_query_filter *filter, ' +
    'void *picks, size_t capacity, _Out_ size_t *count)',
  'int32_t abut_picker_pick_pixel(abut_picker *picker, const abut_camera *camera, double x, double y, double radius, ' +
    'const abut_query_filter *filter, void *out)',
  'int32_t abut_picker_render(abut_picker *picker, const abut_camera *camera, const abut_query_filter *filter, void *out, ' +
    'size_t capacity)',
]);

const cameraOptions = (fields) => options(camera, fields, picking);
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
    const all = codecs.ray.encode(rays.map((ray) => ({ maxDistance: Infinity, ...ray })));
    picking.abut_picker_cast_rays(this.pointer, all, rays.length, numberOf('coherence', coherence),
      options(structs.queryFilter, filter), out.bytes);
    return picksOf(out, rays.length);
  }

  castRayAll(origin, direction, { maxDistance = Infinity, ...filter } = {}) {
    const ray = codecs.ray.encode([{ origin, direction, maxDistance }]);
    const its = options(structs.queryFilter, filter);
    return codecs.hit.fill((place, capacity, count) => picking.abut_picker_cast_ray_all(
      this.pointer, ray, its, place, capacity, count));
  }

  pickPixel(its, x, y, { radius = 0, ...filter } = {}) {
    const out = codecs.hit.room();
    picking.abut_picker_pick_pixel(this.pointer, its.fields, x, y, radius, options(structs.queryFilter, filter), out.bytes);
    return picksOf(out, 1)[0];
  }

  render(its, filter) {
    const count = its.fields.width * its.fields.height;
    const out = codecs.hit.room(count);
    picking.abut_picker_render(this.pointer, its.fields, options(structs.queryFilter, filter), out.bytes, count);
    return picksOf(out, count);
  }
}
