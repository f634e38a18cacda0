// SPDX-License-Identifier: Apache-2.0
//! Rays and the mouse.
#![cfg(feature = "picking")]

use abut::picking::{Camera, ClipPlane, Picker, PickerFlags, Selection};
use abut::raw_picking::{ABUT_SNAP_EDGE, ABUT_SNAP_VERTEX};
use abut::{GeometryId, GeometryOptions, PartOptions, Pose, QueryFilter, Ray, Shape, Universe, UniverseOptions};

/// A row of unit cubes along X, 4 apart, and a camera in front of the one in the middle.
fn row() -> (Universe, Vec<GeometryId>, Camera) {
    let mut universe = Universe::new(&UniverseOptions::default()).unwrap();
    let cube = Shape::cuboid([1.0; 3]).unwrap();
    let geometries = [-4.0, 0.0, 4.0].map(|x| {
        let part = universe.add_part(&PartOptions::at(Pose::at(x, 0.0, 0.0))).unwrap();
        universe.add_geometry(part, &cube, &GeometryOptions::default()).unwrap()
    });
    let mut camera = Camera::new(200, 100);
    camera.look_at([0.0, -10.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]).unwrap();
    (universe, geometries.to_vec(), camera)
}

#[test]
fn the_mouse_finds_what_is_under_it() {
    let (universe, geometries, camera) = row();
    let all = QueryFilter::default();
    let mut picker = Picker::new(&universe).unwrap();
    let hit = picker.pick_pixel(&universe, &camera, 100.0, 50.0, 0.0, &all).unwrap().unwrap();
    assert_eq!((hit.geometry, hit.distance), (geometries[1], 9.0));
    assert_eq!(picker.pick_pixel(&universe, &camera, 100.0, 2.0, 0.0, &all).unwrap(), None);
    assert_eq!(camera.pose().position, [0.0, -10.0, 0.0]);
    let rectangle = [[0.0, 0.0], [101.0, 100.0]];
    let touching = picker.select_rectangle(&universe, &camera, rectangle, Selection::Touching, &all).unwrap();
    let inside = picker.select_rectangle(&universe, &camera, rectangle, Selection::Inside, &all).unwrap();
    assert_eq!((touching, inside), (geometries[..2].to_vec(), geometries[..1].to_vec()));
    let snap =
        picker.snap(&universe, &camera, 110.0, 40.0, 5.0, ABUT_SNAP_VERTEX | ABUT_SNAP_EDGE, &all).unwrap().unwrap();
    assert_eq!((snap.geometry, snap.kind, snap.point), (geometries[1], ABUT_SNAP_VERTEX, [1.0, -1.0, 1.0]));
    let picture = picker.render(&universe, &camera, &all).unwrap();
    assert_eq!(picture.len(), 20_000);
    assert!(picture[100 + 200 * 50].is_some() && picture[0].is_none());
}

#[test]
fn rays_see_what_is_chosen() {
    let (universe, geometries, _) = row();
    let all = QueryFilter::default();
    let mut picker = Picker::new(&universe).unwrap();
    let ray = Ray::new([-10.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let first = |picker: &mut Picker| picker.cast_ray(&universe, &ray, &all).unwrap().unwrap();
    assert_eq!((first(&mut picker).geometry, first(&mut picker).distance), (geometries[0], 5.0));
    assert_eq!(picker.cast_ray_all(&universe, &ray, &all).unwrap().len(), 6);
    picker.set_flags(PickerFlags { skips_back_faces: true, sensors: false }).unwrap();
    assert_eq!(picker.cast_ray_all(&universe, &ray, &all).unwrap().len(), 3);
    picker.set_clip_planes(&[ClipPlane { normal: [1.0, 0.0, 0.0], offset: -2.0 }]).unwrap();
    assert_eq!(first(&mut picker).geometry, geometries[1]);
    assert!(picker.ray_hits(&universe, &ray, &all).unwrap());
    let aside = Ray::new([-10.0, 0.0, 3.0], [1.0, 0.0, 0.0]);
    let hits = picker.cast_rays(&universe, &[ray, aside], true, &all).unwrap();
    assert!(hits[0].is_some() && hits[1].is_none());
}

#[test]
fn wrong_arguments_are_named() {
    let (universe, _, camera) = row();
    let all = QueryFilter::default();
    let mut picker = Picker::new(&universe).unwrap();
    let other = row().0;
    let failure = picker.pick_pixel(&other, &camera, 1.0, 1.0, 0.0, &all).unwrap_err();
    assert!(failure.message().starts_with("universe is another one"));
    let failure = picker.pick_pixel(&universe, &camera, 1.0, 1.0, -1.0, &all).unwrap_err();
    assert!(failure.message().starts_with("radius is -1"), "{failure}");
    let flat = ClipPlane { normal: [0.0; 3], offset: 0.0 };
    assert!(picker.set_clip_planes(&[flat]).unwrap_err().message().contains("planes[0].normal"));
    drop(universe);
}
