// SPDX-License-Identifier: Apache-2.0
//! How pairs are treated: policies of tags, and what contacts of two materials are like.

use crate::error::check;
use crate::options::{defaults, Algorithm};
use crate::{raw, Result, Universe, View};
use std::ptr::null;

/// How much of a pair is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Detail {
    /// All contacts.
    Manifold = raw::ABUT_DETAIL_MANIFOLD,
    /// The deepest one.
    Point = raw::ABUT_DETAIL_POINT,
    /// Whether the boxes overlap: events without contacts.
    Box = raw::ABUT_DETAIL_BOX,
    /// Whether the shapes touch: events without contacts.
    Touch = raw::ABUT_DETAIL_TOUCH,
}

/// How geometries of two tags meet.
#[derive(Clone, Copy, Debug)]
pub struct Policy {
    /// Which search answers; pairs that do not have it take another.
    pub algorithm: Algorithm,
    /// How much is found.
    pub detail: Detail,
    /// Found anew once in so many steps, and kept in between.
    pub period: u32,
    /// Of a pair; None: the sum of both geometries.
    pub tolerance: Option<f64>,
    /// As in `QueryOptions`.
    pub error_bound: f64,
}

impl Default for Policy {
    fn default() -> Policy {
        Policy { algorithm: Algorithm::Auto, detail: Detail::Manifold, period: 1, tolerance: None, error_bound: 0.0 }
    }
}

/// What contacts of two materials are like: numbers that abut stores and hands out, and applies none of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactMaterial {
    /// Coefficient along the tangent of a contact.
    pub friction_primary: f64,
    /// Coefficient at right angles to it.
    pub friction_secondary: f64,
    /// About the normal.
    pub friction_spin: f64,
    /// About axes of the contact plane.
    pub friction_roll: f64,
    /// Of the coefficients while nothing slides.
    pub static_scale: f64,
    /// How much it gives way along the plane.
    pub slip: f64,
    /// How soft it is.
    pub compliance: f64,
    /// How fast it calms down.
    pub damping: f64,
    /// How much it bounces.
    pub restitution: f64,
    /// Below that speed nothing bounces.
    pub restitution_threshold: f64,
    /// How much it holds on.
    pub adhesive_force: f64,
}

impl ContactMaterial {
    fn from_raw(its: &raw::abut_contact_material) -> ContactMaterial {
        ContactMaterial {
            friction_primary: its.friction_primary,
            friction_secondary: its.friction_secondary,
            friction_spin: its.friction_spin,
            friction_roll: its.friction_roll,
            static_scale: its.static_scale,
            slip: its.slip,
            compliance: its.compliance,
            damping: its.damping,
            restitution: its.restitution,
            restitution_threshold: its.restitution_threshold,
            adhesive_force: its.adhesive_force,
        }
    }

    fn raw(&self) -> raw::abut_contact_material {
        let mut material = defaults!(abut_contact_material, raw::abut_contact_material_init);
        material.friction_primary = self.friction_primary;
        material.friction_secondary = self.friction_secondary;
        material.friction_spin = self.friction_spin;
        material.friction_roll = self.friction_roll;
        material.static_scale = self.static_scale;
        material.slip = self.slip;
        material.compliance = self.compliance;
        material.damping = self.damping;
        material.restitution = self.restitution;
        material.restitution_threshold = self.restitution_threshold;
        material.adhesive_force = self.adhesive_force;
        material
    }
}

impl Default for ContactMaterial {
    fn default() -> ContactMaterial {
        ContactMaterial::from_raw(&defaults!(abut_contact_material, raw::abut_contact_material_init))
    }
}

impl Universe {
    /// Sets how geometries of two tags (below 64) meet, in either order.
    pub fn set_policy(&mut self, tag_a: u32, tag_b: u32, policy: &Policy) -> Result<()> {
        let mut its = defaults!(abut_policy, raw::abut_policy_init);
        its.algorithm = policy.algorithm as u32;
        its.detail = policy.detail as u32;
        its.period = policy.period;
        its.tolerance = policy.tolerance.unwrap_or(its.tolerance);
        its.error_bound = policy.error_bound;
        // SAFETY: the universe is alive, here and below; what is handed in lives for the call.
        check(unsafe { raw::abut_policy_set(self.as_ptr(), tag_a, tag_b, &its) })
    }

    /// Sets what contacts of two materials are like, in either order; None takes it away.
    pub fn set_material_pair(&mut self, a: u32, b: u32, row: Option<&ContactMaterial>) -> Result<()> {
        let raw = row.map(ContactMaterial::raw);
        let pointer = raw.as_ref().map_or(null(), |row| row as *const _);
        // SAFETY: see set_policy.
        check(unsafe { raw::abut_material_pair_set(self.as_ptr(), a, b, pointer) })
    }
}

impl View {
    /// What contacts of two materials are like, from their row or combined from those of each.
    pub fn material_pair(&self, a: u32, b: u32) -> Result<ContactMaterial> {
        let mut out = defaults!(abut_contact_material, raw::abut_contact_material_init);
        // SAFETY: see set_policy.
        check(unsafe { raw::abut_material_pair_get(self.as_ptr(), a, b, &mut out) })?;
        Ok(ContactMaterial::from_raw(&out))
    }
}
