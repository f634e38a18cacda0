// SPDX-License-Identifier: Apache-2.0
// Tags of geometries that follow a focus.
export module abut.scene.rest.focus_tags;
import abut.core.standard;
import abut.math;
import abut.scene.rest.focus;
import abut.scene.state.places;
import abut.scene.state.space;

export namespace abut {

class FocusTags {
 public:
  void set(const Focus& focus, std::span<const Vec3> centres, const Vec3& origin) {
    const bool is_other = centres_.set(focus, centres, origin);
    has_moved_ = has_moved_ || is_other || !is_on_;
    is_on_ = true;
  }
  void end() { is_on_ = false; }
  [[nodiscard]] bool is_on() const { return is_on_; }
  [[nodiscard]] const FocusCentres& centres() const [[clang::lifetimebound]] { return centres_; }

  // Notes happened_to_tag of the places whose tag is another one now. While the centres stay, only what is fresh can
  // have come nearer or gone farther.
  void follow(std::span<const std::uint32_t> fresh, const Space& space, Places& places);
  // Those places, and the end of that stage.
  [[nodiscard]] bool has_switched() const { return !switched_.empty(); }
  void forget_switched(Places& places);

  [[nodiscard]] std::size_t bytes() const { return centres_.bytes() + switched_.capacity() * sizeof(std::uint32_t); }

  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    archive(self.centres_, self.is_on_, self.has_moved_);
  }

 private:
  void follow(std::uint32_t at, const Space& space, Places& places);

  FocusCentres centres_;
  bool is_on_ = false;
  bool has_moved_ = false;  // since the last detection
  std::vector<std::uint32_t> switched_;
};

}  // namespace abut
