// SPDX-License-Identifier: Apache-2.0
//! Shapes, and queries on two of them.

use abut::{FeatureKind, Pair, PairMemory, Pose, QueryOptions, Ray, Shape, Sides, Status, Vec3};

const CORNERS: [Vec3; 4] = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];

fn cube_of_points() -> Shape {
    let corner = |i: u32| [f64::from(i & 1) - 0.5, f64::from(i >> 1 & 1) - 0.5, f64::from(i >> 2) - 0.5];
    Shape::hull(&(0..8).map(corner).collect::<Vec<_>>()).unwrap()
}

#[test]
fn every_kind_can_be_made() {
    let ball = Shape::sphere(1.0).unwrap();
    let kinds = [
        ("box", Shape::cuboid([1.0, 2.0, 3.0])),
        ("capsule", Shape::capsule(0.5, 2.0)),
        ("cylinder", Shape::cylinder(0.5, 2.0)),
        ("plane", Shape::plane([0.0, 0.0, 2.0], 0.0)),
        ("hull", Shape::hull(&CORNERS)),
        ("mesh", Shape::mesh(&CORNERS, &[[0, 1, 2], [0, 2, 3]], Sides::Front)),
        ("height_field", Shape::height_field(2, 3, [1.0, 1.0], &[0.0; 6])),
        ("particles", Shape::particles(&CORNERS, 0.1)),
        ("composite", Shape::composite(&[&ball, &ball], &[Pose::IDENTITY, Pose::at(3.0, 0.0, 0.0)])),
        ("cone", Shape::of_kind("cone", &[1.0, 2.0])),
    ];
    for (kind, shape) in kinds {
        assert_eq!(shape.unwrap().kind(), kind);
    }
    let capsule = Shape::capsule(0.5, 2.0).unwrap();
    assert_eq!(format!("{:?}", capsule), "capsule([0.5, 2.0])");
    assert_eq!(capsule.aabb(&Pose::at(0.0, 0.0, 1.0)).unwrap().maximum, [0.5, 0.5, 3.5]);
}

#[test]
fn surfaces_have_triangles() {
    let (vertices, triangles) = Shape::cuboid([1.0, 2.0, 3.0]).unwrap().triangles().unwrap();
    assert_eq!((vertices.len(), triangles.len()), (8, 12));
    assert!(vertices.iter().all(|[x, y, z]| [x.abs(), y.abs(), z.abs()] == [1.0, 2.0, 3.0]));
    assert!(triangles.iter().flatten().all(|&index| index < 8));
    assert_eq!(Shape::sphere(1.0).unwrap().triangles().unwrap_err().status(), Status::Unsupported);
}

#[test]
fn bad_input_is_named() {
    let failure = Shape::sphere(-1.0).unwrap_err();
    assert_eq!(failure.status(), Status::OutOfRange);
    assert!(failure.message().contains("radius is -1"), "{}", failure);
    assert_eq!(Shape::sphere(f64::NAN).unwrap_err().status(), Status::NotFinite);
    assert_eq!(Shape::hull(&[]).unwrap_err().status(), Status::Empty);
    assert_eq!(Shape::of_kind("blob", &[]).unwrap_err().status(), Status::UnknownValue);
    let ball = Shape::sphere(1.0).unwrap();
    for (failure, words) in [
        (Shape::height_field(2, 3, [1.0, 1.0], &[0.0; 5]).unwrap_err(), "heights has 5 numbers"),
        (Shape::composite(&[&ball], &[]).unwrap_err(), "children has 1 elements and poses has 0"),
        (Pair::new(&ball, &ball).distances(&[Pose::IDENTITY], &[]).unwrap_err(), "poses_a has 1"),
    ] {
        assert_eq!(failure.status(), Status::InvalidArgument);
        assert!(failure.to_string().contains(words), "{}", failure);
    }
}

#[test]
fn a_clone_outlives_its_shape() {
    let ball = Shape::sphere(1.0).unwrap();
    let clone = ball.clone();
    drop(ball);
    assert_eq!(clone.parameters().unwrap(), [1.0]);
}

#[test]
fn two_boxes_have_a_distance_and_contacts() {
    let cube = Shape::cuboid([1.0; 3]).unwrap();
    let pair = Pair::new(&cube, &cube);
    let apart = pair.distance(&Pose::IDENTITY, &Pose::at(3.5, 0.0, 0.0)).unwrap();
    assert_eq!((apart.distance, apart.normal), (1.5, [1.0, 0.0, 0.0]));
    assert!(apart.lower <= 1.5 && 1.5 <= apart.upper);
    let touching = pair.contacts(&Pose::IDENTITY, &Pose::at(0.0, 0.0, 1.75)).unwrap();
    assert_eq!(touching.len(), 4);
    assert!(touching.iter().all(|contact| contact.depth() == 0.25 && contact.normal == [0.0, 0.0, 1.0]));
    let one = QueryOptions { max_contacts: 1, ..QueryOptions::default() };
    let deepest = Pair::with_options(&cube, &cube, one).contacts(&Pose::IDENTITY, &Pose::at(0.0, 0.0, 1.75)).unwrap();
    assert_eq!(deepest.len(), 1);
}

#[test]
fn more_contacts_than_expected_are_all_there() {
    let (ball, ground) = (Shape::sphere(0.5).unwrap(), Shape::plane([0.0, 0.0, 1.0], 0.0).unwrap());
    let poses: Vec<_> = (0..20).map(|i| Pose::at(f64::from(i), 0.0, 0.25)).collect();
    let row = Shape::composite(&[&ball; 20], &poses).unwrap();
    let contacts = Pair::new(&row, &ground).contacts(&Pose::IDENTITY, &Pose::IDENTITY).unwrap();
    let mut children: Vec<_> = contacts.iter().map(|contact| contact.child_a).collect();
    children.sort_unstable();
    assert_eq!(children, (0..20).collect::<Vec<_>>());
}

#[test]
fn batches_and_memories_change_no_answer() {
    let cube = cube_of_points();
    let pair = Pair::new(&cube, &cube);
    let here = vec![Pose::IDENTITY; 3];
    let there: Vec<_> = (0..3).map(|i| Pose::at(2.0 + f64::from(i), 0.0, 0.0)).collect();
    let distances = |found: Vec<abut::Distance>| found.iter().map(|each| each.distance).collect::<Vec<_>>();
    assert_eq!(distances(pair.distances(&here, &there).unwrap()), [1.0, 2.0, 3.0]);
    assert_eq!(pair.overlaps_of_each(&here, &there).unwrap(), [false; 3]);
    let near = Pair::with_options(&cube, &cube, abut::QueryOptions { margin: 2.5, ..Default::default() });
    assert_eq!(near.overlaps_of_each(&here, &there).unwrap(), [true, true, false]);
    assert!(near.overlaps(&here[0], &there[0]).unwrap() && !near.overlaps(&here[0], &there[2]).unwrap());
    let mut memories = vec![PairMemory::default(); 3];
    assert_eq!(distances(pair.distances_from(&mut memories, &here, &there).unwrap()), [1.0, 2.0, 3.0]);
    let memory = &mut memories[0];
    assert_eq!(pair.distance_from(memory, &here[0], &there[2]).unwrap().distance, 3.0);
    let contacts = pair.contacts_from(memory, &Pose::IDENTITY, &Pose::at(0.9, 0.0, 0.0)).unwrap();
    assert_eq!(contacts, pair.contacts(&Pose::IDENTITY, &Pose::at(0.9, 0.0, 0.0)).unwrap());
}

#[test]
fn contacts_and_casts_of_many_poses_are_those_of_each() {
    let cube = cube_of_points();
    let pair = Pair::with_options(&cube, &cube, QueryOptions { threads: 1, ..QueryOptions::default() });
    let here = vec![Pose::IDENTITY; 3];
    let there: Vec<_> = (0..3).map(|i| Pose::at(0.75 * f64::from(i), 0.0, 0.0)).collect();
    let lists = pair.contacts_of_each(&here, &there).unwrap();
    assert_eq!((lists.len(), lists.is_empty(), lists.all().len()), (3, false, 8));
    let mut memories = vec![PairMemory::default(); 3];
    let warm = pair.contacts_of_each_from(&mut memories, &here, &there).unwrap();
    for (i, (contacts, of_warm)) in lists.iter().zip(warm.iter()).enumerate() {
        assert_eq!(contacts, pair.contacts(&here[i], &there[i]).unwrap());
        assert_eq!(of_warm, contacts);
    }
    let (ways, still) = (vec![[1.0, 0.0, 0.0], [0.0, 9.0, 0.0], [1.0, 0.0, 0.0]], vec![[0.0; 3]; 3]);
    let hits = pair.casts((&here, &ways), (&there, &still)).unwrap();
    assert_eq!(hits.iter().map(|hit| hit.is_some()).collect::<Vec<_>>(), [true, true, true]);
    assert_eq!(hits[2], pair.cast((&here[2], ways[2]), (&there[2], still[2])).unwrap());
    let away = vec![[-1.0, 0.0, 0.0]; 3];
    assert_eq!(pair.casts((&here, &away), (&there, &still)).unwrap()[2], None);
    assert!(pair.casts((&here, &ways), (&there, &still[1..])).unwrap_err().message().contains("displacements_b"));
}

#[test]
fn rays_and_casts_meet_or_miss() {
    let cube = Shape::cuboid([1.0; 3]).unwrap();
    let ray = Ray::new([0.0, 0.0, 5.0], [0.0, 0.0, -1.0]);
    let hit = cube.cast_ray(&Pose::IDENTITY, &ray).unwrap().unwrap();
    assert_eq!((hit.distance, hit.normal, hit.feature.kind()), (4.0, [0.0, 0.0, 1.0], FeatureKind::Face));
    assert_eq!(cube.cast_ray(&Pose::IDENTITY, &Ray { max_distance: 3.0, ..ray }).unwrap(), None);
    let pair = Pair::new(&cube, &cube);
    let still = (&Pose::IDENTITY, [0.0; 3]);
    let cast = pair.cast(still, (&Pose::at(4.0, 0.0, 0.0), [-4.0, 0.0, 0.0])).unwrap().unwrap();
    assert!((cast.fraction - 0.5).abs() < 1e-9);
    assert_eq!(pair.cast(still, (&Pose::at(4.0, 0.0, 0.0), [4.0, 0.0, 0.0])).unwrap(), None);
}

#[test]
fn threads_share_a_shape() {
    let cube = cube_of_points();
    std::thread::scope(|scope| {
        for i in 0..4 {
            let cube = &cube;
            scope.spawn(move || {
                let found = Pair::new(cube, cube).distance(&Pose::IDENTITY, &Pose::at(2.0 + f64::from(i), 0.0, 0.0));
                assert_eq!(found.unwrap().distance, 1.0 + f64::from(i));
            });
        }
    });
}
