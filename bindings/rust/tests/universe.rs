// SPDX-License-Identifier: Apache-2.0
//! A universe: steps, contacts, events, filters, queries.

use abut::{
    Collidable, EventKind, GeometryId, GeometryOptions, Motion, Parking, PartId, PartOptions, Pose, QueryFilter, Ray,
    Rule, Shape, Status, Universe, UniverseOptions,
};
use std::sync::{Arc, Mutex};

/// A row of balls of radius 1, each 1.5 from the next.
struct Row {
    universe: Universe,
    parts: Vec<PartId>,
    geometries: Vec<GeometryId>,
}

fn row(count: u32) -> Row {
    let ball = Shape::sphere(1.0).unwrap();
    let mut universe = Universe::new(&UniverseOptions::default()).unwrap();
    let options: Vec<_> = (0..count).map(|i| PartOptions::at(Pose::at(1.5 * f64::from(i), 0.0, 0.0))).collect();
    let parts = universe.add_parts(&options).unwrap();
    let geometries = universe.add_geometries(&parts, &vec![&ball; parts.len()], &[]).unwrap();
    Row { universe, parts, geometries }
}

impl Row {
    fn contacts_of_a_step(&mut self) -> usize {
        self.universe.step(0.01).unwrap();
        self.universe.contacts().unwrap().len()
    }

    fn kinds_of_events(&self) -> Vec<EventKind> {
        self.universe.events().unwrap().iter().map(|event| event.kind()).collect()
    }
}

#[test]
fn steps_find_contacts_and_events() {
    let mut row = row(2);
    assert_eq!(row.contacts_of_a_step(), 1);
    let contact = row.universe.contacts().unwrap()[0];
    assert_eq!((contact.depth(), contact.normal, contact.age), (0.5, [1.0, 0.0, 0.0], 0));
    assert_eq!([contact.geometry_a, contact.geometry_b], row.geometries[..]);
    assert_eq!(row.kinds_of_events(), [EventKind::Begin]);
    row.universe.set_contact_data(&[77]).unwrap();
    row.universe.set_pose(row.parts[1], &Pose::at(1.6, 0.0, 0.0)).unwrap();
    assert_eq!(row.contacts_of_a_step(), 1);
    let contact = row.universe.contacts().unwrap()[0];
    assert_eq!((contact.age, contact.user_data), (1, 77));
    assert_eq!(row.kinds_of_events(), [EventKind::Persist]);
    row.universe.set_poses(&row.parts, &[Pose::IDENTITY, Pose::at(9.0, 0.0, 0.0)]).unwrap();
    assert_eq!(row.contacts_of_a_step(), 0);
    assert_eq!(row.kinds_of_events(), [EventKind::End]);
    assert_eq!(row.universe.stats().unwrap().geometries, 2);
    assert!(row.universe.explain().unwrap().contains("2 geometries"));
}

#[test]
fn what_was_put_in_comes_out() {
    let mut row = row(2);
    let options = PartOptions { user_data: 5, motion: Motion::Static, pose: Pose::at(1.0, 2.0, 3.0) };
    let part = row.universe.add_part(&options).unwrap();
    let shape = Shape::cuboid([1.0; 3]).unwrap();
    let options = GeometryOptions { user_data: 6, ..GeometryOptions::default() };
    let geometry = row.universe.add_geometry(part, &shape, &options).unwrap();
    let universe = &row.universe;
    assert_eq!(universe.parts().unwrap(), [&row.parts[..], &[part]].concat());
    assert_eq!(universe.geometries().unwrap(), [&row.geometries[..], &[geometry]].concat());
    assert_eq!(universe.geometries_of(part).unwrap(), [geometry]);
    assert_eq!(universe.pose(part).unwrap(), Pose::at(1.0, 2.0, 3.0));
    assert_eq!((universe.user_data(part).unwrap(), universe.geometry_user_data(geometry).unwrap()), (5, 6));
    assert_eq!(universe.part_of(geometry).unwrap(), part);
    assert_eq!(universe.shape_of(geometry).unwrap().kind(), "box");
    assert_eq!(universe.validate().unwrap(), Vec::<String>::new());
}

#[test]
fn stale_ids_are_refused() {
    let mut row = row(2);
    row.universe.remove_parts(&row.parts[..1]).unwrap();
    let failure = row.universe.set_pose(row.parts[0], &Pose::IDENTITY).unwrap_err();
    assert_eq!(failure.status(), Status::StaleId);
    assert_eq!(row.universe.geometry_user_data(row.geometries[0]).unwrap_err().status(), Status::StaleId);
    let failure = row.universe.set_poses(&row.parts, &[]).unwrap_err();
    assert!(failure.message().contains("parts has 2 elements and poses has 0"), "{}", failure);
    assert_eq!(row.universe.pose(row.parts[1]).unwrap(), Pose::at(1.5, 0.0, 0.0));
}

#[test]
fn parking_rules_and_masks_say_who_meets_whom() {
    let mut row = row(3);
    assert_eq!(row.contacts_of_a_step(), 2);
    row.universe.park(&row.geometries[..1], Parking::ShortTerm).unwrap();
    assert_eq!(row.contacts_of_a_step(), 1);
    row.universe.park(&row.geometries[..1], Parking::None).unwrap();
    row.universe.set_rule(Collidable::Geometry(row.geometries[1]), Collidable::Any, Rule::Disable).unwrap();
    let verdict = row.universe.rule_between(row.geometries[0], row.geometries[1]).unwrap();
    assert_eq!(verdict, (Rule::Disable, Collidable::Any, Collidable::Geometry(row.geometries[1])));
    let reasons = row.universe.why_apart(row.geometries[0], row.geometries[1]).unwrap();
    assert!(reasons.rule && reasons.detection && !reasons.part);
    assert_eq!(row.contacts_of_a_step(), 0);
    row.universe.clear_rules().unwrap();
    row.universe.set_options(row.geometries[2], &GeometryOptions { mask: 2, ..Default::default() }).unwrap();
    assert_eq!(row.contacts_of_a_step(), 1);
    row.universe.set_shape(row.geometries[0], &Shape::sphere(0.1).unwrap()).unwrap();
    assert_eq!(row.contacts_of_a_step(), 0);
}

#[test]
fn a_filter_is_asked_and_may_read_and_park() {
    let mut row = row(3);
    let asked = Arc::new(Mutex::new(Vec::new()));
    let (notes, left_out, parked) = (asked.clone(), row.geometries[2], row.geometries[0]);
    row.universe
        .set_filter(move |universe, a, b| {
            notes.lock().unwrap().push((universe.part_of(a).unwrap(), universe.part_of(b).unwrap()));
            universe.park(parked, Parking::LongTerm).unwrap();
            b != left_out
        })
        .unwrap();
    assert_eq!(row.contacts_of_a_step(), 1);
    assert_eq!(*asked.lock().unwrap(), [(row.parts[0], row.parts[1]), (row.parts[1], row.parts[2])]);
    assert_eq!(row.contacts_of_a_step(), 0, "parked when the step was over");
    row.universe.clear_filter().unwrap();
    assert_eq!(row.contacts_of_a_step(), 1);
    assert_eq!(Arc::strong_count(&asked), 1, "the filter is dropped");
}

#[test]
fn a_filter_that_panics_fails_the_step_and_nothing_else() {
    let mut row = row(2);
    row.universe.set_filter(|_, _, _| panic!("no idea")).unwrap();
    let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| row.universe.step(0.01))).unwrap_err();
    assert_eq!(*panic.downcast::<&str>().unwrap(), "no idea");
    assert_eq!(row.universe.contacts().unwrap().len(), 1);
    row.universe.set_filter(|_, _, _| false).unwrap();
    assert_eq!(row.contacts_of_a_step(), 0);
}

#[test]
fn queries_find_geometries() {
    let mut row = row(3);
    row.universe.refresh().unwrap();
    let (universe, all) = (&row.universe, QueryFilter::default());
    let along = Ray::new([-5.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    assert_eq!(universe.cast_ray(&along, &all).unwrap().unwrap().geometry, row.geometries[0]);
    assert_eq!(universe.cast_ray_all(&along, &all).unwrap().len(), 3);
    let away = Ray::new([-5.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    assert_eq!(universe.cast_rays(&[along, away], &all).unwrap()[1], None);
    let others = QueryFilter { ignore_part: row.parts[0], ..all };
    assert_eq!(universe.cast_ray(&along, &others).unwrap().unwrap().geometry, row.geometries[1]);
    let point = Shape::sphere(0.1).unwrap();
    let above = Pose::at(3.0, 0.0, 3.0);
    let closest = universe.closest(&point, &above, f64::INFINITY, &all).unwrap().unwrap();
    assert_eq!(closest.geometry, row.geometries[2]);
    assert!((closest.distance.distance - 1.9).abs() < 1e-9);
    assert_eq!(universe.closest(&point, &above, 1.0, &all).unwrap(), None);
    let each = universe.closest_to_each(&[&point, &point], &[above, Pose::at(9e3, 0.0, 0.0)], 5.0, &all).unwrap();
    assert_eq!((each[0], each[1]), (Some(closest), None));
    let cast = universe.cast_shape(&point, &above, [0.0, 0.0, -3.8], &all).unwrap().unwrap();
    assert!((cast.fraction - 0.5).abs() < 1e-9);
    assert_eq!(universe.cast_shape(&point, &above, [0.0, 0.0, 1.0], &all).unwrap(), None);
    assert_eq!(universe.overlaps(&point, &Pose::at(0.7, 0.0, 0.0), 0.0, &all).unwrap(), row.geometries[..2]);
    assert_eq!(universe.at_point([3.0, 0.0, 0.5], &all).unwrap(), row.geometries[2..]);
}

#[test]
fn threads_read_one_universe_and_step_their_own() {
    let mut first = row(3);
    first.contacts_of_a_step();
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| assert_eq!(first.universe.contacts().unwrap().len(), 2));
        }
    });
    let hash = first.universe.hash().unwrap();
    let mut second = row(3);
    let other = std::thread::spawn(move || {
        second.contacts_of_a_step();
        second.universe.hash().unwrap()
    });
    assert_eq!(other.join().unwrap(), hash);
}
