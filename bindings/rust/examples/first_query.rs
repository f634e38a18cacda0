// SPDX-License-Identifier: Apache-2.0
//! Distance and contacts of two shapes, and one step of a universe.

use abut::{GeometryOptions, Pair, PartOptions, Pose, Shape, Universe, UniverseOptions};

fn main() -> abut::Result<()> {
    let ball = Shape::sphere(1.0)?;
    let cube = Shape::cuboid([1.0, 1.0, 1.0])?;
    let (origin, above) = (Pose::IDENTITY, Pose::at(0.0, 0.0, 1.75));

    let found = Pair::new(&cube, &ball).distance(&origin, &above)?;
    let [x, y, z] = found.normal;
    println!("distance {}, normal ({}, {}, {})", found.distance, x, y, z);
    println!("two boxes touch in {} points", Pair::new(&cube, &cube).contacts(&origin, &above)?.len());

    let mut universe = Universe::new(&UniverseOptions::default())?;
    let floor = universe.add_part(&PartOptions::at(origin))?;
    let body = universe.add_part(&PartOptions::at(above))?;
    universe.add_geometry(floor, &cube, &GeometryOptions::default())?;
    universe.add_geometry(body, &ball, &GeometryOptions::default())?;
    universe.step(0.01)?;
    for contact in universe.contacts()? {
        println!("contact {} deep", contact.depth());
    }
    Ok(())
}
