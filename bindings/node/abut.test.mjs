// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { test } from 'node:test';
import koffi from 'koffi';
import { AbutError, Shape, Universe, pairCast, pairCasts, pairContactLists, pairContacts, pairDistance, pairDistances, pairOverlaps, pairsOverlap,
  pose, version } from 'abut';
import { abut } from './library.mjs';
import { structs } from './raw.mjs';

const vector = (x, y, z) => ({ x, y, z });
const square = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0];

// A universe with a row of balls of radius 1, each 1.5 from the next.
function row(count) {
  const universe = new Universe();
  const ball = Shape.sphere(1);
  const parts = Array.from({ length: count }, (_, i) => universe.addPart({ pose: pose(1.5 * i) }));
  const geometries = parts.map((part) => universe.addGeometry(part, ball));
  ball.release();
  return { universe, parts, geometries };
}

function contactsOfAStep(universe) {
  universe.step(0.01);
  return universe.contacts().length;
}

const refused = (status, words, call) =>
  assert.throws(call, (thrown) => thrown instanceof AbutError && thrown.status === status && thrown.message.includes(words));

test('structs are those of the library', () => {
  const byName = Object.fromEntries(Object.values(structs).map((struct) => [struct.name, struct]));
  for (let i = 0; i < Number(abut.abut_layout_count()); ++i) {
    const entry = {};
    abut.abut_layout_at(i, entry);
    const struct = byName[entry.type];
    assert.ok(struct, entry.type);
    if (entry.field === '') {
      assert.equal(koffi.sizeof(struct), Number(entry.size), entry.type);
      continue;
    }
    const field = entry.field.replace(/_(.)/g, (_, letter) => letter.toUpperCase());
    assert.equal(koffi.offsetof(struct, field), Number(entry.offset), `${entry.type}.${field}`);
  }
  assert.match(version(), /^0\.2\./);
});

test('every kind can be made', () => {
  const ball = Shape.sphere(1);
  for (const [kind, shape] of Object.entries({
    box: Shape.box(1, 2, 3),
    capsule: Shape.capsule(0.5, 2),
    cylinder: Shape.cylinder(0.5, 2),
    plane: Shape.plane(vector(0, 0, 2), 0),
    hull: Shape.hull(Float32Array.from(square)),
    mesh: Shape.mesh(square, [0, 1, 2, 0, 2, 3], { sides: 'front' }),
    height_field: Shape.heightField(2, 3, 1, 1, [0, 0, 0, 0, 0, 0]),
    particles: Shape.particles(square, 0.1),
    composite: Shape.composite([ball, ball], [pose(), pose(3)]),
    cone: Shape.ofKind('cone', 1, 2),
  })) {
    assert.equal(shape.kind, kind);
  }
});

test('bad input is named', () => {
  refused('ABUT_OUT_OF_RANGE', 'radius is -1', () => Shape.sphere(-1));
  refused('ABUT_NOT_FINITE', 'radius', () => Shape.sphere(NaN));
  refused('ABUT_UNKNOWN_VALUE', 'kind', () => Shape.ofKind('blob'));
  refused('ABUT_INVALID_ARGUMENT', 'xyz has 4 numbers', () => Shape.hull([1, 2, 3, 4]));
  refused('ABUT_INVALID_ARGUMENT', 'heights has 1 numbers', () => Shape.heightField(2, 2, 1, 1, [0]));
  refused('ABUT_INVALID_ARGUMENT', 'triangles has 2 numbers', () => Shape.mesh(square, [0, 1]));
  refused('ABUT_INVALID_ARGUMENT', 'sides is back; expected one of both, front, solid', () => Shape.mesh(square, [], { sides: 'back' }));
  const ball = Shape.sphere(1);
  refused('ABUT_INVALID_ARGUMENT', 'posesB has 0', () => pairDistances(ball, [pose()], ball, []));
  refused('ABUT_INVALID_ARGUMENT', 'marign is no option; there are algorithm, errorBound, margin',
    () => pairDistance(ball, pose(), ball, pose(), { marign: 1 }));
  ball.release();
  ball.release();
  refused('ABUT_INVALID_ARGUMENT', 'has been released', () => pairDistance(ball, pose(), ball, pose()));
  const { universe, parts, geometries } = row(1);
  refused('ABUT_INVALID_ARGUMENT', 'motion is still', () => universe.addPart({ motion: 'still' }));
  refused('ABUT_INVALID_ARGUMENT', 'poses has 0', () => universe.setPoses(parts, []));
  universe.removePart(parts[0]);
  refused('ABUT_STALE_ID', 'part', () => universe.setPose(parts[0], pose()));
  refused('ABUT_STALE_ID', 'geometry', () => universe.park(geometries[0], 'shortTerm'));
  universe.destroy();
  universe.destroy();
  refused('ABUT_INVALID_ARGUMENT', 'has been destroyed', () => universe.step(0.01));
  assert.throws(() => new Shape(), TypeError);
});

test('numbers that C would cut are named', () => {
  const ball = Shape.sphere(1);
  refused('ABUT_INVALID_ARGUMENT', 'radius is "1"; expected a number', () => Shape.sphere('1'));
  refused('ABUT_INVALID_ARGUMENT', 'columns is 1.5; expected a whole number from 0 to 4294967295',
    () => Shape.heightField(1.5, 2, 1, 1, [0, 0, 0]));
  refused('ABUT_INVALID_ARGUMENT', 'triangles[2] is 4294967296', () => Shape.mesh(square, [0, 1, 2 ** 32]));
  refused('ABUT_INVALID_ARGUMENT', 'triangles[0] is -1', () => Shape.mesh(square, [-1, 1, 2]));
  refused('ABUT_INVALID_ARGUMENT', 'threads is 1.5', () => new Universe({ threads: 1.5 }));
  refused('ABUT_INVALID_ARGUMENT', 'maxContacts is 4294967296',
    () => pairContacts(ball, pose(), ball, pose(), { maxContacts: 2 ** 32 }));
  refused('ABUT_INVALID_ARGUMENT', 'b is [object Object]; expected a Shape', () => pairDistance(ball, pose(), {}, pose()));
  refused('ABUT_INVALID_ARGUMENT', 'poseB is undefined; expected an object with position, orientation',
    () => pairDistance(ball, pose(), ball));
  refused('ABUT_INVALID_ARGUMENT', 'posesB[1].position is undefined',
    () => pairDistances(ball, [pose(), pose()], ball, [pose(), {}]));
  refused('ABUT_INVALID_ARGUMENT', 'xyz is undefined', () => Shape.hull());
  const { universe, parts, geometries } = row(2);
  refused('ABUT_INVALID_ARGUMENT', 'part is undefined; expected an id', () => universe.setPose(undefined, pose()));
  refused('ABUT_INVALID_ARGUMENT', 'part.slot is 1.5', () => universe.setPose({ slot: 1.5, generation: 1 }, pose()));
  refused('ABUT_INVALID_ARGUMENT', 'parts[1].slot is 4294967296',
    () => universe.setPoses([parts[0], { ...parts[1], slot: 2 ** 32 }], [pose(), pose()]));
  refused('ABUT_INVALID_ARGUMENT', 'layers is 0.5', () => universe.addGeometry(parts[0], ball, { layers: 0.5 }));
  refused('ABUT_INVALID_ARGUMENT', 'pose.orientation is undefined',
    () => universe.addPart({ pose: { position: vector(0, 0, 0) } }));
  refused('ABUT_INVALID_ARGUMENT', 'pose.position.y is undefined; expected a number',
    () => universe.addPart({ pose: { position: { x: 0 }, orientation: pose().orientation } }));
  refused('ABUT_INVALID_ARGUMENT', 'shape is [object Object]; expected a Shape', () => universe.addGeometry(parts[0], universe));
  refused('ABUT_INVALID_ARGUMENT', 'dt is undefined; expected a number', () => universe.step());
  assert.equal(universe.geometriesOf(parts[0]).length, 1);
  assert.equal(geometries.length, 2);
  universe.destroy();
});

test('two boxes', () => {
  const box = Shape.box(1, 1, 1);
  const apart = pairDistance(box, pose(), box, pose(3.5));
  assert.equal(pairOverlaps(box, pose(), box, pose(3.5)), false);
  assert.equal(pairOverlaps(box, pose(), box, pose(3.5), { margin: 2 }), true);
  assert.deepEqual(pairsOverlap([box, box], [pose(), pose()], [box, box], [pose(1), pose(3.5)]), [true, false]);
  refused('ABUT_INVALID_ARGUMENT', 'shapesB has 1', () => pairsOverlap([box, box], [pose(), pose()], [box], [pose(), pose()]));
  assert.equal(apart.distance, 1.5);
  assert.deepEqual(apart.normal, vector(1, 0, 0));
  const many = pairDistances(box, [pose(), pose()], box, [pose(3), pose(4)]);
  assert.deepEqual(many.map((each) => each.distance), [1, 2]);
  const numbers = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0);
  assert.deepEqual(pairDistances(box, numbers, box, [pose(3), pose(4)]), many);
  refused('ABUT_INVALID_ARGUMENT', 'posesA has 13 numbers', () => pairDistances(box, numbers.subarray(1), box, [pose()]));
  refused('ABUT_NOT_FINITE', 'pose_a', () => pairDistance(box, { position: {}, orientation: {} }, box, pose()));
  assert.deepEqual(pairDistances(box, [], box, []), []);
  const contacts = pairContacts(box, pose(), box, pose(0, 0, 1.75));
  assert.deepEqual(contacts.map((contact) => contact.distance), [-0.25, -0.25, -0.25, -0.25]);
  assert.equal(pairContacts(box, pose(), box, pose(0, 0, 1.75), { maxContacts: 1 }).length, 1);
});

test('batches have the contacts and casts of each pair', () => {
  const [box, still] = [Shape.box(1, 1, 1), vector(0, 0, 0)];
  const [here, there] = [[pose(), pose(), pose()], [pose(0, 0, 1.75), pose(9), pose(1.5)]];
  const lists = pairContactLists(box, here, box, there, { threads: 1 });
  assert.deepEqual(lists, here.map((at, i) => pairContacts(box, at, box, there[i])));
  assert.deepEqual(lists.map((contacts) => contacts.length), [4, 0, 4]);
  const ways = Float64Array.of(0, 0, 4, 0, 0, 4, 4, 0, 0);
  const casts = pairCasts(box, here, ways, box, there, [still, still, still]);
  assert.deepEqual(casts.map((hit) => hit?.fraction), [0, undefined, 0]);
  assert.deepEqual(pairCasts(box, [], [], box, [], []), []);
  refused('ABUT_INVALID_ARGUMENT', 'displacementsB has 0', () => pairCasts(box, here, ways, box, there, []));
});

test('casts of two shapes meet or miss', () => {
  const box = Shape.box(1, 1, 1);
  const still = vector(0, 0, 0);
  assert.ok(Math.abs(pairCast(box, pose(), still, box, pose(4), vector(-4, 0, 0)).fraction - 0.5) < 1e-9);
  assert.equal(pairCast(box, pose(), still, box, pose(4), vector(4, 0, 0)), null);
});

test('more contacts than expected are all there', () => {
  const ball = Shape.sphere(0.5);
  const poses = Array.from({ length: 20 }, (_, i) => pose(i, 0, 0.25));
  const many = Shape.composite(poses.map(() => ball), poses);
  const contacts = pairContacts(many, pose(), Shape.plane(vector(0, 0, 1), 0), pose());
  assert.deepEqual(contacts.map((contact) => contact.childA).sort((a, b) => a - b), poses.map((_, i) => i));
});

test('steps find contacts and events', () => {
  const { universe, parts, geometries } = row(2);
  assert.equal(contactsOfAStep(universe), 1);
  const [contact] = universe.contacts();
  assert.equal(contact.distance, -0.5);
  assert.equal(typeof contact.id, 'bigint');
  assert.deepEqual([contact.geometryA, contact.geometryB], geometries);
  assert.equal(universe.events()[0].kind, 'begin');
  assert.match(universe.explain(), /2 geometries/);
  universe.setPoses(parts, [pose(), pose(9)]);
  assert.equal(contactsOfAStep(universe), 0);
  assert.equal(universe.events()[0].kind, 'end');
  assert.deepEqual(universe.pose(parts[1]), pose(9));
  universe.addGeometry(universe.addPart({ motion: 'static', pose: pose(9) }), Shape.sphere(1), { mask: 2n });
  assert.equal(contactsOfAStep(universe), 0, 'the masks say no');
});

test('rules, options, shapes and motions say who meets whom', () => {
  const { universe, parts, geometries } = row(3);
  assert.equal(contactsOfAStep(universe), 2);
  universe.setRule({ geometry: geometries[1] }, 'any', 'disable');
  assert.equal(contactsOfAStep(universe), 0);
  universe.setRule({ part: parts[0] }, { geometry: geometries[1] }, 'enable');
  assert.equal(contactsOfAStep(universe), 1, 'the more specific rule counts');
  universe.clearRules();
  universe.setOptions(geometries[2], { label: 7 });
  universe.setRule({ label: 7 }, 'any', 'disable');
  assert.equal(contactsOfAStep(universe), 1);
  universe.setShape(geometries[0], Shape.sphere(0.1));
  assert.equal(contactsOfAStep(universe), 0);
  universe.clearRules();
  assert.equal(contactsOfAStep(universe), 1);
  universe.setMotion(parts[1], 'static');
  universe.setMotion(parts[2], 'static');
  assert.equal(contactsOfAStep(universe), 0);
  assert.deepEqual(universe.whyApart(geometries[1], geometries[2]), ['motion']);
  assert.deepEqual(universe.whyApart(geometries[0], geometries[0]), ['part', 'kinds']);
  refused('ABUT_STALE_ID', 'geometry_b', () => universe.whyApart(geometries[0], { slot: 99, generation: 1 }));
  refused('ABUT_INVALID_ARGUMENT', 'a side of a rule is', () => universe.setRule(geometries[1], 'any', 'enable'));
  refused('ABUT_INVALID_ARGUMENT', 'rule is off', () => universe.setRule('any', 'any', 'off'));
});

test('what was put in comes out', () => {
  const { universe, parts, geometries } = row(2);
  const part = universe.addPart({ userData: 5n });
  assert.deepEqual(universe.parts(), [...parts, part]);
  assert.deepEqual(universe.geometriesOf(parts[1]), [geometries[1]]);
  assert.equal(universe.userData(part), 5n);
});

test('a filter is asked and may park', () => {
  const { universe, geometries } = row(3);
  const asked = [];
  universe.setFilter((a, b) => {
    asked.push([a.slot, b.slot]);
    universe.park(geometries[0], 'longTerm');
    return b.slot !== geometries[2].slot;
  });
  assert.equal(contactsOfAStep(universe), 1);
  assert.deepEqual(asked, [[1, 2], [2, 3]]);
  assert.equal(contactsOfAStep(universe), 0, 'parked when the step was over');
  universe.setFilter(null);
  assert.equal(contactsOfAStep(universe), 1);
});

test('what a filter throws comes out of the step', () => {
  const { universe } = row(2);
  universe.setFilter(() => {
    throw new RangeError('no idea');
  });
  assert.throws(() => universe.step(0.01), new RangeError('no idea'));
  assert.equal(universe.contacts().length, 1);
});

test('filters of destroyed universes make room for others', () => {
  // koffi has room for 8192 callbacks.
  for (let i = 0; i < 9000; ++i) {
    const universe = new Universe();
    universe.setFilter(() => true);
    universe.destroy();
  }
});

test('universes with filters are collected', async () => {
  const seen = new WeakRef(row(1).universe);
  seen.deref()?.setFilter(() => true);
  for (let i = 0; i < 20 && seen.deref() !== undefined; ++i) {
    await new Promise((resolve) => setTimeout(resolve));
    gc();
  }
  assert.equal(seen.deref(), undefined);
});

test('queries find geometries', () => {
  const { universe, parts, geometries } = row(3);
  universe.refresh();
  const along = [vector(-5, 0, 0), vector(1, 0, 0)];
  assert.deepEqual(universe.castRay(...along).geometry, geometries[0]);
  assert.deepEqual(universe.castRay(...along, { ignorePart: parts[0] }).geometry, geometries[1]);
  assert.equal(universe.castRay(...along, { maxDistance: 1 }), null);
  const rays = [{ origin: along[0], direction: along[1] }, { origin: along[0], direction: vector(-1, 0, 0) }];
  assert.deepEqual(universe.castRays(rays).map((hit) => hit?.distance), [4, undefined]);
  const point = Shape.sphere(0.1);
  const above = pose(3, 0, 3);
  assert.ok(Math.abs(universe.closest(point, above).distance.distance - 1.9) < 1e-9);
  assert.equal(universe.closest(point, above, { maxDistance: 1 }), null);
  assert.ok(Math.abs(universe.castShape(point, above, vector(0, 0, -3.8)).fraction - 0.5) < 1e-9);
  assert.equal(universe.castShape(point, above, vector(0, 0, 1)), null);
  assert.deepEqual(universe.overlaps(point, pose(0.7)), geometries.slice(0, 2));
});
