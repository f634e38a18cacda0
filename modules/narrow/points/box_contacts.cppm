// SPDX-License-Identifier: Apache-2.0
// The region in which the faces of two boxes meet, all corners at once. Both faces are projected along the contact
// normal onto the plane of the face of a. That one is a rectangle there, and the other one a parallelogram. Their
// common region has corners of two kinds: a corner of one face in the other, and a crossing of two edges: 24
// candidates, four to a vector register.
//
// Only a region whose corners are beyond doubt is found. A corner of one face may lie on an edge of the other within
// rounding. Then clip_faces cuts edge by edge, and its answers agree with each other.
export module abut.narrow.points.box_contacts;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.points.lane_contact;

export namespace abut {

// The features of a face of a box, numbered as the shape numbers them: itself, its four corners, its edges at the lower
// and at the upper end of its first axis and of its second.
using BoxFaceFeatures = std::array<Feature, 9>;

inline constexpr std::size_t candidate_count = 24;
struct BoxRegion {
  std::uint32_t corners;  // which of the candidates are corners, a bit for each
  // On the face of a, at base + along_first * first + along_second * second, in the frame of a.
  Lanes base, first, second;
  std::array<Real, candidate_count> along_first, along_second;
  std::array<Real, candidate_count> distance;  // from there along the normal to the face of b
  BoxFaceFeatures of_a, of_b;
};

// The part within the margin of the region under the normal along which two boxes are `separation` apart: one of half
// extents `half_a` and one of `half_b` placed by ab. False where there is doubt. `size`: of the coordinates.
[[nodiscard]] bool clip_boxes(const Vec3& half_a, const Vec3& half_b, const Pose& ab, const Vec3& normal,
                              Real separation, Real margin, Real size, BoxRegion& out);

// What a candidate is on each side.
struct CandidateFeatures {
  std::uint8_t of_a, of_b;
};
inline constexpr std::array<CandidateFeatures, candidate_count> candidate_features{{
    {0, 1}, {0, 2}, {0, 3}, {0, 4},  // corners of b
    {1, 0}, {2, 0}, {3, 0}, {4, 0},  // corners of a
    {5, 7}, {6, 7}, {6, 8}, {5, 8},  // edges across the first axis of a and across the second one of b
    {5, 5}, {6, 5}, {6, 6}, {5, 6},  // and so on
    {7, 7}, {8, 7}, {8, 8}, {7, 8}, {7, 5}, {8, 5}, {8, 6}, {7, 6},
}};

// Hands over a contact for each corner of a region of two boxes that are rounded off by their radii.
template <class Append>
[[gnu::always_inline]] inline void contacts_of_region(const BoxRegion& region, const Vec3& normal, Real radius_a,
                                                      Real radius_b, Append&& append) {
  for (std::uint32_t left = region.corners; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    const Lanes on_a = multiply_add(region.second, all_lanes(region.along_second[i]),
                                    multiply_add(region.first, all_lanes(region.along_first[i]), region.base));
    const Lanes point_a = multiply_add(lanes_of(normal), all_lanes(radius_a), on_a);
    const Lanes point_b = multiply_add(lanes_of(normal), all_lanes(region.distance[i] - radius_b), on_a);
    const Feature feature_a = region.of_a[candidate_features[i].of_a],
                  feature_b = region.of_b[candidate_features[i].of_b];
    append(LaneContact{point_a, point_b, lanes_of(normal), region.distance[i] - (radius_a + radius_b), feature_a,
                       feature_b, contact_id(feature_a, feature_b)});
  }
}

}  // namespace abut
