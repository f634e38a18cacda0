// SPDX-License-Identifier: Apache-2.0
//! The structs of the crate are those of the library that is loaded.

use abut::raw;
use std::collections::HashMap;
use std::ffi::CStr;
use std::mem::{size_of, MaybeUninit};
use std::ptr::addr_of;

type Report = HashMap<String, (u64, u64)>;

fn report() -> Report {
    let text = |pointer| unsafe { CStr::from_ptr(pointer) }.to_str().unwrap().to_owned();
    (0..unsafe { raw::abut_layout_count() })
        .map(|index| {
            let mut entry = MaybeUninit::<raw::abut_layout_entry>::zeroed();
            let status = unsafe { raw::abut_layout_at(index, entry.as_mut_ptr()) };
            assert_eq!(status, raw::ABUT_OK);
            let entry = unsafe { entry.assume_init() };
            (format!("{}.{}", text(entry.type_), text(entry.field)), (entry.offset, entry.size))
        })
        .collect()
}

fn size_of_field<T>(_: *const T) -> u64 {
    size_of::<T>() as u64
}

fn assert_size<T>(report: &Report, name: &str) {
    assert_eq!(report[&format!("{}.", name)].1, size_of::<T>() as u64, "{}", name);
}

// Compares the size of a struct, and the fields that can be named here.
macro_rules! assert_layout {
    ($report:expr, $type:ty, $name:expr, $($field:ident),*) => {{
        assert_size::<$type>(&$report, $name);
        let value = MaybeUninit::<$type>::uninit();
        let start = value.as_ptr();
        $(
            let field = unsafe { addr_of!((*start).$field) };
            let found = (field as u64 - start as u64, size_of_field(field));
            assert_eq!($report[&format!("{}.{}", $name, stringify!($field))], found, "{}.{}", $name, stringify!($field));
        )*
    }};
}

#[test]
fn values_are_those_of_the_library() {
    let report = report();
    assert_size::<abut::Vec3>(&report, "abut_vec3");
    assert_layout!(report, abut::Pose, "abut_pose", position, orientation);
    assert_layout!(report, abut::Aabb, "abut_aabb", minimum, maximum);
    assert_size::<abut::PartId>(&report, "abut_part_id");
    assert_size::<abut::GeometryId>(&report, "abut_geometry_id");
    assert_layout!(report, abut::Feature, "abut_feature", index);
    assert_layout!(report, abut::Ray, "abut_ray", origin, direction, max_distance);
    assert_layout!(report, abut::RayHit, "abut_ray_hit", distance, point, normal, feature, child);
    assert_layout!(report, abut::Hit, "abut_query_hit", geometry, feature, child, distance, point, normal);
    assert_layout!(report, abut::Closest, "abut_closest", geometry, distance);
    assert_size::<abut::PairMemory>(&report, "abut_pair_memory");
    assert_layout!(report, abut::Velocity, "abut_velocity", linear, angular);
    assert_layout!(report, abut::SleepChange, "abut_sleep_change", part);
    let distance = "abut_distance";
    assert_layout!(report, abut::Distance, distance, distance, lower, upper, point_a, point_b, normal, iterations);
    let cast = "abut_cast_hit";
    assert_layout!(report, abut::CastHit, cast, geometry, fraction, contact, feature_a, feature_b, child_a, child_b);
    let event = "abut_event";
    assert_layout!(report, abut::Event, event, geometry_a, geometry_b, contact_id, first_contact, contact_count);
    let contact = "abut_contact";
    assert_layout!(report, abut::Contact, contact, geometry_a, geometry_b, id, feature_a, feature_b, child_a, child_b);
    assert_layout!(report, abut::Contact, contact, point_a, point_b, normal, distance, toi, age, user_data);
    assert_layout!(report, abut::Contact, contact, material_a, material_b, tangent);
}

#[test]
fn options_are_those_of_the_library() {
    let report = report();
    assert_layout!(report, raw::abut_query_options, "abut_query_options", margin, max_contacts);
    assert_layout!(report, raw::abut_universe_options, "abut_universe_options", origin, threads, events);
    assert_layout!(report, raw::abut_part_options, "abut_part_options", motion, pose, user_data);
    assert_layout!(report, raw::abut_geometry_options, "abut_geometry_options", pose, layers, parking);
    assert_layout!(report, raw::abut_geometry_info, "abut_geometry_info", part, shape, user_data);
    assert_layout!(report, raw::abut_query_filter, "abut_query_filter", mask, ignore_geometry, ray_start);
    assert_layout!(report, raw::abut_shape_desc, "abut_shape_desc", kind, parameters, parameter_count);
    assert_layout!(report, raw::abut_height_field_desc, "abut_height_field_desc", columns, spacing_x, heights);
    assert_layout!(report, raw::abut_step_stats, "abut_step_stats", contacts, asleep);
    assert_layout!(report, raw::abut_finding, "abut_finding", code, message);
    assert_layout!(report, raw::abut_collidable, "abut_collidable", kind, slot, generation);
}

#[test]
fn the_library_understands_the_header() {
    let status = unsafe { raw::abut_check_version(raw::ABUT_VERSION_MAJOR, raw::ABUT_VERSION_MINOR) };
    assert_eq!(status, raw::ABUT_OK);
    assert_eq!(abut::version(), env!("CARGO_PKG_VERSION"));
}
