// SPDX-License-Identifier: Apache-2.0
//! Shapes that change on a geometry. What keeps its features keeps its contacts.

use crate::error::{check, expect_as_many};
use crate::value::{GeometryId, Vec3};
use crate::{raw, Error, Result, Universe};
use std::ops::Range;
use std::ptr::null;

impl Universe {
    /// Changes the numbers that describe the shape of a geometry, such as a radius, for this geometry alone.
    pub fn set_parameters(&mut self, geometry: GeometryId, parameters: &[f64]) -> Result<()> {
        // SAFETY: the universe is alive, here and below; slices are as long as the count and live for the call.
        check(unsafe {
            raw::abut_geometry_set_parameters(self.as_ptr(), geometry.raw(), parameters.as_ptr(), parameters.len())
        })
    }

    /// Changes heights of a height field: those of some columns in some rows, X fastest.
    pub fn set_heights(
        &mut self,
        geometry: GeometryId,
        columns: Range<u32>,
        rows: Range<u32>,
        heights: &[f64],
    ) -> Result<()> {
        let (width, depth) = (columns.end.saturating_sub(columns.start), rows.end.saturating_sub(rows.start));
        let samples = u64::from(width) * u64::from(depth);
        if heights.len() as u64 != samples {
            let count = heights.len();
            return Err(Error::invalid(format!(
                "heights has {count} numbers; expected columns * rows, which is {samples}"
            )));
        }
        // SAFETY: see set_parameters; there are as many heights as the library reads.
        check(unsafe {
            raw::abut_geometry_set_heights(
                self.as_ptr(),
                geometry.raw(),
                columns.start,
                rows.start,
                width,
                depth,
                heights.as_ptr(),
            )
        })
    }

    /// Moves particles from the given one on; radii are for particles that have some of their own.
    pub fn set_particles(
        &mut self,
        geometry: GeometryId,
        first: usize,
        centres: &[Vec3],
        radii: Option<&[f64]>,
    ) -> Result<()> {
        if let Some(radii) = radii {
            expect_as_many(("centres", centres.len()), ("radii", radii.len()))?;
        }
        let radii = radii.map_or(null(), <[f64]>::as_ptr);
        // SAFETY: see set_parameters; three numbers of each centre lie in a row.
        check(unsafe {
            raw::abut_geometry_set_particles(
                self.as_ptr(),
                geometry.raw(),
                first,
                centres.as_ptr().cast(),
                radii,
                centres.len(),
            )
        })
    }
}
