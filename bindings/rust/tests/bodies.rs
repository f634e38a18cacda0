// SPDX-License-Identifier: Apache-2.0
//! What a simulation asks of a universe: velocities, sleep, islands, policies, materials, shapes that change.

use abut::{
    ContactMaterial, Detail, GeometryId, GeometryOptions, Motion, PartId, PartOptions, Policy, Pose, Shape, Sides,
    Sleep, Status, Universe, UniverseOptions, Velocity,
};

fn empty() -> Universe {
    Universe::new(&UniverseOptions::default()).unwrap()
}

fn add(universe: &mut Universe, shape: &Shape, pose: Pose) -> (PartId, GeometryId) {
    let part = universe.add_part(&PartOptions::at(pose)).unwrap();
    (part, universe.add_geometry(part, shape, &GeometryOptions::default()).unwrap())
}

fn contacts_of_a_step(universe: &mut Universe) -> usize {
    universe.step(0.5).unwrap();
    universe.contacts().unwrap().len()
}

#[test]
fn velocities_are_given_or_measured() {
    let mut universe = empty();
    let ball = Shape::sphere(1.0).unwrap();
    let parts = [add(&mut universe, &ball, Pose::IDENTITY).0, add(&mut universe, &ball, Pose::at(9.0, 0.0, 0.0)).0];
    let given = Velocity { linear: [1.0, 2.0, 3.0], angular: [0.0, 0.0, 1.0] };
    universe.set_velocities(&parts[..1], &[given]).unwrap();
    universe.measure_velocities(&parts[1..]).unwrap();
    universe.set_pose(parts[1], &Pose::at(10.0, 0.0, 0.0)).unwrap();
    universe.step(0.5).unwrap();
    let found = universe.velocities(&parts).unwrap();
    assert_eq!((found[0], found[1].linear), (given, [2.0, 0.0, 0.0]));
    let failure = universe.set_velocities(&parts, &[given]).unwrap_err();
    assert!(failure.message().contains("parts has 2 elements and velocities has 1"), "{}", failure);
}

#[test]
fn parts_fall_asleep_and_wake() {
    let mut universe = empty();
    let (part, _) = add(&mut universe, &Shape::sphere(1.0).unwrap(), Pose::IDENTITY);
    universe.set_sleep(part, Some(&Sleep { steps: 2, ..Sleep::default() })).unwrap();
    let mut steps = 0;
    while !universe.is_asleep(part).unwrap() {
        universe.step(0.5).unwrap();
        steps += 1;
        assert!(steps < 10);
    }
    let changes: Vec<_> =
        universe.sleep_changes().unwrap().iter().map(|change| (change.part, change.is_asleep())).collect();
    assert_eq!(changes, [(part, true)]);
    universe.wake(part).unwrap();
    universe.step(0.5).unwrap();
    assert!(!universe.is_asleep(part).unwrap());
    universe.set_sleep(part, None).unwrap();
    for _ in 0..9 {
        universe.step(0.5).unwrap();
    }
    assert!(!universe.is_asleep(part).unwrap());
}

#[test]
fn islands_hold_parts_that_touch() {
    let mut universe = empty();
    let ball = Shape::sphere(1.0).unwrap();
    let parts = [0.0, 1.5, 9.0].map(|x| add(&mut universe, &ball, Pose::at(x, 0.0, 0.0)).0);
    assert_eq!(universe.islands().map(Iterator::count).unwrap_err().status(), Status::Unsupported);
    universe.follow_islands(true).unwrap();
    universe.step(0.5).unwrap();
    let islands: Vec<_> = universe.islands().unwrap().collect();
    assert_eq!((islands[0].1, islands[1].1), (&parts[..2], &parts[2..]));
    assert_ne!(islands[0].0, islands[1].0);
}

#[test]
fn policies_say_how_much_is_found() {
    let mut universe = empty();
    let cube = Shape::cuboid([1.0; 3]).unwrap();
    add(&mut universe, &cube, Pose::IDENTITY);
    add(&mut universe, &cube, Pose::at(0.0, 0.0, 1.75));
    assert_eq!(contacts_of_a_step(&mut universe), 4);
    universe.set_policy(0, 0, &Policy { detail: Detail::Point, ..Policy::default() }).unwrap();
    assert_eq!(contacts_of_a_step(&mut universe), 1);
    universe.set_policy(0, 0, &Policy { tolerance: Some(0.5), ..Policy::default() }).unwrap();
    assert_eq!(contacts_of_a_step(&mut universe), 0);
    assert_eq!(universe.set_policy(64, 0, &Policy::default()).unwrap_err().status(), Status::OutOfRange);
}

#[test]
fn materials_are_combined() {
    let mut universe = empty();
    for (material, friction) in [(1, 0.25), (2, 1.0)] {
        let row = ContactMaterial { friction_primary: friction, ..ContactMaterial::default() };
        universe.set_material_pair(material, material, Some(&row)).unwrap();
    }
    assert_eq!(universe.material_pair(1, 2).unwrap().friction_primary, 0.5);
    let own = ContactMaterial { restitution: 0.75, ..ContactMaterial::default() };
    universe.set_material_pair(1, 2, Some(&own)).unwrap();
    assert_eq!(universe.material_pair(2, 1).unwrap(), own);
    universe.set_material_pair(1, 2, None).unwrap();
    assert_eq!(universe.material_pair(1, 2).unwrap().restitution, 0.0);
}

#[test]
fn shapes_change_in_place() {
    let mut universe = empty();
    let field = Shape::height_field(3, 3, [1.0, 1.0], &[0.0; 9]).unwrap();
    let options = PartOptions { motion: Motion::Static, ..PartOptions::default() };
    let ground = universe.add_part(&options).unwrap();
    let ground = universe.add_geometry(ground, &field, &GeometryOptions::default()).unwrap();
    let (_, ball) = add(&mut universe, &Shape::sphere(0.25).unwrap(), Pose::at(1.0, 1.0, 0.5));
    assert_eq!(contacts_of_a_step(&mut universe), 0);
    universe.set_parameters(ball, &[0.75]).unwrap();
    assert!(contacts_of_a_step(&mut universe) > 0);
    universe.set_parameters(ball, &[0.25]).unwrap();
    universe.set_heights(ground, 1..2, 1..2, &[0.4]).unwrap();
    assert!(contacts_of_a_step(&mut universe) > 0);
    let failure = universe.set_heights(ground, 1..2, 1..2, &[]).unwrap_err();
    assert!(failure.message().contains("heights has 0 numbers"), "{}", failure);
    let cloud = Shape::particles(&[[0.0; 3], [5.0; 3]], 0.1).unwrap();
    let (_, cloud) = add(&mut universe, &cloud, Pose::at(20.0, 0.0, 0.0));
    universe.set_particles(cloud, 1, &[[-19.0, 1.0, 0.5]], None).unwrap();
    universe.step(0.5).unwrap();
    assert!(universe.contacts().unwrap().iter().any(|contact| contact.geometry_b == cloud));
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let mesh = Shape::mesh(&square, &[[0, 1, 2], [0, 2, 3]], Sides::Both).unwrap();
    let (_, mesh) = add(&mut universe, &mesh, Pose::at(50.0, 0.0, 0.0));
    universe.set_vertices(mesh, 3, &[[0.0, 1.0, 7.0]]).unwrap();
    universe.set_vertices_at(mesh, &[0], &[[0.0, 0.0, 1.0]]).unwrap();
    assert!(universe.set_vertices_at(mesh, &[0, 1], &[[0.0; 3]]).is_err());
    universe.remove_triangles(mesh, &[1]).unwrap();
    assert_eq!(universe.remove_triangles(mesh, &[0]).unwrap_err().status(), Status::Empty);
    universe.set_mesh(mesh, &square[..3], &[[0, 1, 2]]).unwrap();
    assert_eq!(universe.set_particles(ball, 0, &[[0.0; 3]], None).unwrap_err().status(), Status::Unsupported);
}
