// SPDX-License-Identifier: Apache-2.0
// A universe: parts that move, geometries on them, and steps that find what touches.
import koffi from 'koffi';
import { Filter, abut, decode, fill, made, numberOf, options, refuse, room, structs } from './library.mjs';

const eventKinds = ['begin', 'persist', 'end'];
const hitNearest = 0;

const forgotten = new FinalizationRegistry(free);

function free({ pointer, callback }) {
  abut.abut_universe_destroy(pointer);
  if (callback) koffi.unregister(callback);
}

export class Universe {
  // Apart from the universe itself, so that it can be freed when nobody holds that any more: the filter that koffi holds
  // must not name the universe.
  #held;

  constructor(fields) {
    const pointer = made(abut.abut_universe_create, options(structs.universeOptions, fields));
    this.#held = { pointer, callback: null, failure: null };
    forgotten.register(this, this.#held, this);
  }

  get pointer() {
    return this.#held?.pointer ?? refuse('the universe has been destroyed');
  }

  destroy() {
    if (this.#held === undefined) return;
    forgotten.unregister(this);
    free(this.#held);
    this.#held = undefined;
  }

  addPart(fields) {
    const out = {};
    abut.abut_part_create(this.pointer, options(structs.partOptions, fields), out);
    return out;
  }

  removePart(part) {
    abut.abut_part_destroy(this.pointer, part);
  }

  setPose(part, pose) {
    abut.abut_part_set_pose(this.pointer, part, pose);
  }

  setPoses(parts, poses) {
    if (parts.length !== poses.length) {
      refuse(`parts has ${parts.length} elements and poses has ${poses.length}; expected as many`);
    }
    abut.abut_parts_set_poses(this.pointer, parts, poses, parts.length);
  }

  pose(part) {
    const out = {};
    abut.abut_part_pose(this.pointer, part, out);
    return out;
  }

  addGeometry(part, shape, fields) {
    const out = {};
    abut.abut_geometry_create(this.pointer, part, shape.pointer, options(structs.geometryOptions, fields), out);
    return out;
  }

  removeGeometry(geometry) {
    abut.abut_geometry_destroy(this.pointer, geometry);
  }

  park(geometry, parking) {
    abut.abut_geometry_park(this.pointer, geometry, numberOf('parking', parking));
  }

  setFilter(keeps) {
    const { pointer } = this;
    const held = this.#held;
    const ask = (_context, _universe, a, b) => {
      try {
        return held.failure || keeps(a, b) ? 1 : 0;
      } catch (thrown) {
        // Nothing may be thrown through C.
        held.failure = { thrown };
        return 1;
      }
    };
    const callback = keeps ? koffi.register(ask, Filter) : null;
    abut.abut_universe_set_filter(pointer, callback, null);
    if (held.callback) koffi.unregister(held.callback);
    held.callback = callback;
  }

  refilter() {
    abut.abut_universe_refilter(this.pointer);
  }

  #detect(call, ...values) {
    const { pointer } = this;
    try {
      call(pointer, ...values);
    } finally {
      const { failure } = this.#held;
      this.#held.failure = null;
      if (failure) throw failure.thrown;
    }
  }

  step(dt) {
    this.#detect(abut.abut_universe_step, dt);
  }

  detectAll() {
    this.#detect(abut.abut_universe_detect_all);
  }

  refresh() {
    abut.abut_universe_refresh(this.pointer);
  }

  #lent(call, struct) {
    const pointer = [null];
    const count = [0];
    call(this.pointer, pointer, count);
    return decode(pointer[0], struct, count[0]);
  }

  contacts() {
    return this.#lent(abut.abut_universe_contacts, structs.contact);
  }

  events() {
    return this.#lent(abut.abut_universe_events, structs.event).map(
      (event) => ({ ...event, kind: eventKinds[event.kind] }));
  }

  explain() {
    const needed = [0];
    abut.abut_universe_explain(this.pointer, null, 0, needed);
    const text = Buffer.alloc(Number(needed[0]));
    abut.abut_universe_explain(this.pointer, text, text.length, needed);
    return text.toString('utf8', 0, text.indexOf(0));
  }

  castRay(origin, direction, { maxDistance = Infinity, ...filter } = {}) {
    return this.castRays([{ origin, direction, maxDistance }], filter)[0];
  }

  castRays(rays, filter) {
    const out = room(structs.hit, rays.length);
    const all = rays.map((ray) => ({ maxDistance: Infinity, ...ray }));
    abut.abut_universe_cast_rays(this.pointer, all, all.length, options(structs.queryFilter, filter), out);
    return decode(out, structs.hit, all.length).map((hit) => (hit.geometry.slot === 0 ? null : hit));
  }

  castShape(shape, pose, displacement, filter) {
    const its = options(structs.queryFilter, filter);
    const hits = fill(structs.castHit, (place, capacity, count) => abut.abut_universe_cast_shape(
      this.pointer, shape.pointer, pose, displacement, its, hitNearest, place, capacity, count));
    return hits[0] ?? null;
  }

  overlaps(shape, pose, { margin = 0, ...filter } = {}) {
    const its = options(structs.queryFilter, filter);
    return fill(structs.geometryId, (place, capacity, count) => abut.abut_universe_overlaps(
      this.pointer, shape.pointer, pose, its, margin, place, capacity, count));
  }

  closest(shape, pose, { maxDistance = Infinity, ...filter } = {}) {
    const out = {};
    const found = [0];
    const its = options(structs.queryFilter, filter);
    abut.abut_universe_closest(this.pointer, shape.pointer, pose, maxDistance, its, out, found);
    return found[0] === 1 ? out : null;
  }
}
