// SPDX-License-Identifier: Apache-2.0
// Which geometries are near what matters and which are far from it: near ones may be treated with more care.
export module abut.scene.rest.focus;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// Two tags that a universe changes by distance from centres. Between the two distances a tag stays as it is, so that
// what trembles at one of them changes nothing.
struct Focus {
  std::uint32_t near_tag = 0, far_tag = 1;
  Real near_distance = 0;  // nearer than that to any centre: near
  Real far_distance = 0;   // farther than that from all of them: far; not below near_distance

  friend constexpr bool operator==(const Focus&, const Focus&) = default;
};

// A focus with its centres, relative to the origin of compact boxes.
class FocusCentres {
 public:
  // Answers whether anything is other than before. Allocates when there are more centres than ever before.
  bool set(const Focus& focus, std::span<const Vec3> centres, const Vec3& origin);

  [[nodiscard]] inline const Focus& focus() const [[clang::lifetimebound]] { return focus_; }
  [[nodiscard]] inline std::size_t size() const { return centres_.size(); }
  [[nodiscard]] inline bool concerns(std::uint32_t tag) const {
    return tag == focus_.near_tag || tag == focus_.far_tag;
  }
  // Of a box whose tag is one of the two. O(centres).
  [[nodiscard]] std::uint32_t tag_of(const CompactAabb& box, std::uint32_t tag) const;
  [[nodiscard]] inline std::size_t bytes() const { return centres_.capacity() * sizeof(Vec3); }

  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    archive(self.focus_, self.centres_);
    if constexpr (Archive::is_reading) {
      archive.require(self.is_whole(), "the focus is none");
    }
  }

 private:
  [[nodiscard]] bool is_whole() const;

  Focus focus_;
  std::vector<Vec3> centres_;
};

// The first value of a focus that is not one that it may have.
[[nodiscard]] Fault check_focus(const Focus& focus);

}  // namespace abut
