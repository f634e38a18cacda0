// SPDX-License-Identifier: Apache-2.0
// Distance and contacts of two shapes, and one step of a universe.
import { Shape, Universe, pairContacts, pairDistance, pose } from 'abut';

const ball = Shape.sphere(1);
const box = Shape.box(1, 1, 1);
const origin = pose();
const above = pose(0, 0, 1.75);

const { distance, normal } = pairDistance(box, origin, ball, above);
console.log(`distance ${distance}, normal (${normal.x}, ${normal.y}, ${normal.z})`);
console.log(`two boxes touch in ${pairContacts(box, origin, box, above).length} points`);

const universe = new Universe();
universe.addGeometry(universe.addPart({ pose: origin }), box);
universe.addGeometry(universe.addPart({ pose: above }), ball);
universe.step(0.01);
for (const contact of universe.contacts()) {
  console.log(`contact ${-contact.distance} deep`);
}
universe.destroy();
