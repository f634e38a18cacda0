// SPDX-License-Identifier: Apache-2.0
// An id of one kind where another is asked.
// expect: no known conversion from 'Id<Geometry>' to 'Id<Part>'
import abut;

struct Part;
struct Geometry;

bool is_null(abut::Id<Part> part);
bool is_null(abut::Id<Part> part) { return part.is_null(); }

bool mix(abut::Id<Geometry> geometry);
bool mix(abut::Id<Geometry> geometry) { return is_null(geometry); }
