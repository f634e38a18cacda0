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

    /// Moves vertices of a mesh from the given one on.
    pub fn set_vertices(&mut self, geometry: GeometryId, first: usize, places: &[Vec3]) -> Result<()> {
        // SAFETY: see set_parameters; three numbers of each place lie in a row.
        check(unsafe {
            raw::abut_geometry_set_vertices(
                self.as_ptr(),
                geometry.raw(),
                first,
                places.as_ptr().cast(),
                places.len(),
            )
        })
    }

    /// Moves vertices of a mesh by their numbers. Of one that is there twice, the last place counts.
    pub fn set_vertices_at(&mut self, geometry: GeometryId, vertices: &[u32], places: &[Vec3]) -> Result<()> {
        expect_as_many(("vertices", vertices.len()), ("places", places.len()))?;
        // SAFETY: see set_vertices; there are as many places as vertices.
        check(unsafe {
            raw::abut_geometry_set_vertices_at(
                self.as_ptr(),
                geometry.raw(),
                vertices.as_ptr(),
                places.as_ptr().cast(),
                places.len(),
            )
        })
    }

    /// Takes triangles out of a mesh. The others keep their numbers.
    pub fn remove_triangles(&mut self, geometry: GeometryId, triangles: &[u32]) -> Result<()> {
        // SAFETY: see set_parameters.
        check(unsafe {
            raw::abut_geometry_remove_triangles(self.as_ptr(), geometry.raw(), triangles.as_ptr(), triangles.len())
        })
    }

    /// Makes a mesh anew. Contacts live on by the numbers of triangles.
    pub fn set_mesh(&mut self, geometry: GeometryId, vertices: &[Vec3], triangles: &[[u32; 3]]) -> Result<()> {
        // SAFETY: see set_parameters; three numbers of each vertex and triangle lie in a row.
        check(unsafe {
            raw::abut_geometry_set_mesh(
                self.as_ptr(),
                geometry.raw(),
                vertices.as_ptr().cast(),
                vertices.len(),
                triangles.as_ptr().cast(),
                triangles.len(),
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
