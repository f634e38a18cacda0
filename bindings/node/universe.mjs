// SPDX-License-Identifier: Apache-2.0
// A universe: parts that move, geometries on them, and steps that find what touches.
import koffi from 'koffi';
import {
  abut, answer, codecs, expectAsMany, made, numberOf, options, pointerOf, poseAt, posesOf, refuse, vectorAt,
} from './library.mjs';
import { callbacks, structs } from './raw.mjs';

const eventKinds = ['begin', 'persist', 'end'];
const hitNearest = 0;
const geometryKind = 0;
const partKind = 1;
const labelKind = 2;
const anyKind = 3;

// What a rule speaks of, in the memory of a call.
function collidable(what) {
  let its = { kind: anyKind, slot: 0, generation: 0 };
  if (what?.geometry) its = { ...what.geometry, kind: geometryKind };
  else if (what?.part) its = { ...what.part, kind: partKind };
  else if (what?.label !== undefined) its = { ...its, kind: labelKind, slot: what.label };
  else if (what !== 'any') refuse("a side of a rule is { geometry }, { part }, { label } or 'any'");
  return codecs.collidable.encode([its], 'side');
}

// Why two geometries are not examined, bit by bit.
const reasons = [
  'part', 'motion', 'parking', 'exclusion', 'layers', 'rule', 'filter', 'kinds', 'boxes', 'policy', 'detection', 'side',
];

const forgotten = new FinalizationRegistry(free);

function free({ pointer, callback, pickers }) {
  for (const picker of [...pickers]) picker.free();
  abut.abut_universe_destroy(pointer);
  if (callback) koffi.unregister(callback);
}

export class Universe {
  // Apart from the universe itself, so that it can be freed when nobody holds that any more: the filter that koffi holds
  // must not name the universe.
  #held;

  constructor(fields) {
    const pointer = made(abut.abut_universe_create, options(structs.universeOptions, fields));
    this.#held = { pointer, callback: null, failure: null, pickers: new Set() };
    forgotten.register(this, this.#held, this);
  }

  // What is to be freed before a universe: pickers are of a library of their own.
  static pickersOf(universe) {
    return universe.#held.pickers;
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
    return answer(codecs.partId, abut.abut_part_create, this.pointer, options(structs.partOptions, fields));
  }

  removePart(part) {
    abut.abut_part_destroy(this.pointer, part);
  }

  setPose(part, pose) {
    abut.abut_part_set_pose(this.pointer, part, poseAt(pose));
  }

  setPoses(parts, poses) {
    const { bytes, count } = posesOf('poses', poses);
    expectAsMany('parts', parts.length, 'poses', count);
    abut.abut_parts_set_poses(this.pointer, codecs.partId.encode(parts, 'parts'), bytes, count);
  }

  pose(part) {
    return answer(codecs.pose, abut.abut_part_pose, this.pointer, part);
  }

  setMotion(part, motion) {
    abut.abut_part_set_motion(this.pointer, part, numberOf('motion', motion));
  }

  userData(part) {
    const out = [0];
    abut.abut_part_user_data(this.pointer, part, out);
    return BigInt(out[0]);
  }

  parts() {
    return codecs.partId.fill((place, capacity, count) =>
      abut.abut_universe_parts(this.pointer, place, capacity, count));
  }

  geometriesOf(part) {
    return codecs.geometryId.fill((place, capacity, count) =>
      abut.abut_part_geometries(this.pointer, part, place, capacity, count));
  }

  addGeometry(part, shape, fields) {
    const its = options(structs.geometryOptions, fields);
    return answer(codecs.geometryId, abut.abut_geometry_create, this.pointer, part, pointerOf('shape', shape), its);
  }

  removeGeometry(geometry) {
    abut.abut_geometry_destroy(this.pointer, geometry);
  }

  setOptions(geometry, fields = {}) {
    abut.abut_geometry_set_options(this.pointer, geometry, options(structs.geometryOptions, fields));
  }

  setShape(geometry, shape) {
    abut.abut_geometry_set_shape(this.pointer, geometry, pointerOf('shape', shape));
  }

  setRule(a, b, rule) {
    abut.abut_rule_set(this.pointer, collidable(a), collidable(b), numberOf('rule', rule));
  }

  clearRules() {
    abut.abut_rules_clear(this.pointer);
  }

  whyApart(a, b) {
    const bits = made(abut.abut_universe_why_apart, this.pointer, a, b);
    return reasons.filter((_, bit) => (bits >> bit & 1) !== 0);
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
    const callback = keeps ? koffi.register(ask, callbacks.filter) : null;
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

  #lent(call, codec) {
    const pointer = [null];
    const count = [0];
    call(this.pointer, pointer, count);
    return codec.copies(pointer[0], Number(count[0]));
  }

  contacts() {
    return this.#lent(abut.abut_universe_contacts, codecs.contact);
  }

  events() {
    return this.#lent(abut.abut_universe_events, codecs.event).map(
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
    const out = codecs.hit.room(rays.length);
    const all = codecs.ray.encode(rays.map((ray) => ({ maxDistance: Infinity, ...ray })), 'rays');
    abut.abut_universe_cast_rays(this.pointer, all, rays.length, options(structs.queryFilter, filter), out.bytes);
    return out.first(rays.length).map((hit) => (hit.geometry.slot === 0 ? null : hit));
  }

  castShape(shape, pose, displacement, filter) {
    const its = options(structs.queryFilter, filter);
    const hits = codecs.castHit.fill((place, capacity, count) => abut.abut_universe_cast_shape(
      this.pointer, pointerOf('shape', shape), poseAt(pose), vectorAt(displacement, 0, 'displacement'), its, hitNearest, place, capacity, count));
    return hits[0] ?? null;
  }

  overlaps(shape, pose, { margin = 0, ...filter } = {}) {
    const its = options(structs.queryFilter, filter);
    return codecs.geometryId.fill((place, capacity, count) => abut.abut_universe_overlaps(
      this.pointer, pointerOf('shape', shape), poseAt(pose), its, margin, place, capacity, count));
  }

  closest(shape, pose, { maxDistance = Infinity, ...filter } = {}) {
    const out = codecs.closest.room();
    const found = [0];
    const its = options(structs.queryFilter, filter);
    abut.abut_universe_closest(this.pointer, pointerOf('shape', shape), poseAt(pose), maxDistance, its, out.bytes, found);
    return found[0] === 1 ? out.get() : null;
  }
}
