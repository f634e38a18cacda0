// SPDX-License-Identifier: Apache-2.0
// What compiles and what does not; the compiler checks it, and nobody runs it.
import {
  Shape, Universe, pairContactLists, pairContacts, pairDistance, pose, type Contact, type GeometryId, type Hit, type PartId,
} from 'abut';
import { Camera, Picker } from 'abut/picking';

const ball: Shape = Shape.sphere(1);
const hull: Shape = Shape.hull(new Float32Array(12));
const found: number = pairDistance(ball, pose(), hull, pose(0, 0, 2), { margin: 1 }).distance;
const contacts: Contact[] = pairContacts(ball, pose(), ball, pose());
const lists: Contact[][] = pairContactLists(ball, new Float64Array(7), ball, [pose()], { threads: 2 });

const universe = new Universe({ threads: 2, broadphase: 'tree' });
const part: PartId = universe.addPart({ motion: 'static', pose: pose(1) });
const geometry: GeometryId = universe.addGeometry(part, ball, { mask: 2n });
universe.setFilter((a, b) => a.slot !== b.slot);
const hit: number | undefined = universe.castRay({ x: 0, y: 0, z: 5 }, { x: 0, y: 0, z: -1 })?.distance;

// @ts-expect-error: an id of a geometry is not that of a part
universe.removePart(geometry);
// @ts-expect-error: shapes are made by functions
new Shape();
// @ts-expect-error: there is no such motion
universe.addPart({ motion: 'still' });
// @ts-expect-error: a ray may meet nothing
universe.castRay({ x: 0, y: 0, z: 5 }, { x: 0, y: 0, z: -1 }).distance;

const picker = new Picker(universe);
const seen: Hit | null = picker.pickPixel(new Camera({ width: 320, height: 200 }), 160, 100, { radius: 2 });
// @ts-expect-error: no such word
picker.castRays([], { coherence: 'much' });

export { contacts, found, hit, lists, seen };
