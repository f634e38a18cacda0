// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { AbutError, Shape, Universe, pose } from 'abut';

const vector = (x, y, z) => ({ x, y, z });
const skip = process.env.ABUT_PICKING_LIBRARY ? false : 'ABUT_PICKING_LIBRARY names no library';
const { Camera, Picker } = skip ? {} : await import('abut/picking');

// A universe with two balls of radius 1 along X, seen from -X.
function room() {
  const universe = new Universe();
  const ball = Shape.sphere(1);
  const geometries = [0, 4].map((x) => universe.addGeometry(universe.addPart({ pose: pose(x) }), ball, { layers: 1 + x }));
  return { universe, geometries, picker: new Picker(universe) };
}
const along = [vector(-5, 0, 0), vector(1, 0, 0)];

test('rays meet what is first, or everything', { skip }, () => {
  const { universe, geometries, picker } = room();
  const first = picker.castRay(...along);
  assert.deepEqual(first.geometry, geometries[0]);
  assert.ok(Math.abs(first.distance - 4) < 1e-9);
  assert.deepEqual(first.normal, vector(-1, 0, 0));
  assert.deepEqual(picker.castRay(...along, { mask: 4n }).geometry, geometries[1]);
  assert.equal(picker.castRay(...along, { maxDistance: 3 }), null);
  assert.deepEqual(picker.castRayAll(...along).map((hit) => Math.round(hit.distance)), [4, 6, 8, 10]);
  const rays = [{ origin: along[0], direction: along[1] }, { origin: along[0], direction: vector(0, 1, 0) }];
  for (const coherence of ['none', 'neighbours']) {
    assert.deepEqual(picker.castRays(rays, { coherence }).map((hit) => hit?.geometry), [geometries[0], undefined]);
  }
  const [part] = universe.parts();
  universe.setPose(part, pose(0, 9));
  assert.deepEqual(picker.castRay(...along).geometry, geometries[1], 'a picker sees poses as they are set');
});

test('a camera sees what lies under its pixels', { skip }, () => {
  const { geometries, picker } = room();
  const camera = new Camera({ eye: vector(-5, 0, 0), target: vector(0, 0, 0), width: 16, height: 8 });
  assert.deepEqual(picker.pickPixel(camera, 8, 4).geometry, geometries[0]);
  assert.equal(picker.pickPixel(camera, 0.5, 0.5), null);
  assert.deepEqual(picker.pickPixel(camera, 0.5, 4, { radius: 16 }).geometry, geometries[0]);
  const picture = picker.render(camera);
  assert.equal(picture.length, 128);
  // Seen from five radii the ball is 3 pixels wide: it covers the centres of the middle four.
  assert.equal(picture.filter((hit) => hit !== null).length, 4);
  const { origin, direction } = camera.ray(8, 4);
  assert.deepEqual(origin, vector(-5, 0, 0));
  assert.ok(direction.x / Math.hypot(direction.x, direction.y, direction.z) > 1 - 1e-12);
});

test('wrong input is refused', { skip }, () => {
  const refused = (status, words, call) => assert.throws(call, (thrown) => {
    assert.ok(thrown instanceof AbutError);
    assert.equal(thrown.status, status);
    assert.ok(thrown.message.includes(words), thrown.message);
    return true;
  });
  const { picker } = room();
  refused('ABUT_ZERO_VECTOR', 'direction', () => picker.castRay(along[0], vector(0, 0, 0)));
  refused('ABUT_INVALID_ARGUMENT', 'coherence is much; expected one of none, neighbours',
    () => picker.castRays([], { coherence: 'much' }));
  refused('ABUT_INVALID_ARGUMENT', 'fov is no option; there are width, height, projection, pose, verticalFov',
    () => new Camera({ fov: 1 }));
  refused('ABUT_ZERO_VECTOR', 'eye', () => new Camera({ eye: along[0], target: along[0] }));
});

test('a picker ends with its universe, or before', { skip }, () => {
  const { universe, picker } = room();
  const other = new Picker(universe);
  other.destroy();
  other.destroy();
  assert.throws(() => other.update(), /the picker has been destroyed/);
  assert.ok(picker.castRay(...along));
  universe.destroy();
  assert.throws(() => picker.update(), /with its universe/);
  picker.destroy();
});

test('pickers and universes that nobody holds are freed in any order', { skip }, async () => {
  for (let i = 0; i < 200; ++i) room().picker.castRay(...along);
  for (let i = 0; i < 5; ++i) {
    globalThis.gc?.();
    await new Promise((resolve) => setTimeout(resolve, 1));
  }
  assert.ok(room().picker.castRay(...along));
});

test('rectangles, sensors and rays of yes or no', { skip }, () => {
  const { universe, picker } = room();
  const [origin, direction] = along;
  const camera = new Camera({ width: 16, height: 8, eye: origin, target: vector(0, 0, 0) });
  const first = picker.castRay(...along).geometry;
  assert.ok(picker.select(camera, 0, 0, 16, 8).some((geometry) => geometry.slot === first.slot));
  assert.deepEqual(picker.select(camera, 0, 0, 0.25, 0.25), []);
  assert.equal(picker.rayHits(origin, direction), true);
  assert.equal(picker.rayHits(origin, vector(-direction.x, -direction.y, -direction.z)), false);
  const crossings = picker.castRayAll(...along).length;
  picker.setFlags({ skipsBackFaces: true });
  assert.equal(picker.castRayAll(...along).length, crossings / 2);
  assert.throws(() => picker.select(camera, '0', 0, 1, 1), /x0 is "0"; expected a number/);
  universe.destroy();
});
