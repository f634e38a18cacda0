// SPDX-License-Identifier: Apache-2.0
// What a contact does, by name: kinds, and the rules that choose among them.
module;

#include <abut/response.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

export module abut.response:rules;
import :source;

export namespace abut::response {

enum class Response : unsigned char { friction, penalty, augmented, stick, slide, none, custom };

// The law of a contact, of a kind that the caller has added; whether it counts.
using CustomLaw = std::function<abut_status(const abut_contact&, const abut_vec3& velocity, double dt,
                                            abut_contact_law&, bool& counts)>;

struct Kind {
  std::string name;
  Response response;
  CustomLaw law;
};

// All numbers of a contact.
struct Terms {
  abut_contact_material material{};
  double break_force = 0;  // 0: never
  double epsilon = 1e-2;
};

// The shortest digits that give the same bits, in any locale.
[[nodiscard]] std::string text_of(double value);

// Why something is refused.
struct Refusal {
  abut_status status;
  std::string message;
};

// Numbers that a rule gives: indices of a table of names.
class Parameters {
 public:
  // Of a text such as "mu=0.5&k=1e4".
  [[nodiscard]] std::optional<Refusal> read(std::string_view text);
  void apply(Terms& terms) const;
  // Whether a number of that name is given.
  [[nodiscard]] bool has(std::string_view name) const;
  [[nodiscard]] std::string text() const;

 private:
  std::vector<std::pair<std::size_t, double>> given_;
};

struct [[gsl::Pointer]] Choice {
  std::uint32_t kind = 0;
  const Parameters* parameters = nullptr;         // none where null
  std::optional<std::uint32_t> rule;              // that chose
  std::optional<abut_geometry_id> of_a_geometry;  // whose own kind counts
};

class Rules {
 public:
  Rules();

  [[nodiscard]] const std::vector<Kind>& kinds() const { return kinds_; }
  // A kind that came without its law gets it.
  [[nodiscard]] std::optional<Refusal> add_kind(std::string_view name, CustomLaw law);
  // The first kind of the caller that lacks its law.
  [[nodiscard]] const Kind* without_law() const;
  [[nodiscard]] std::optional<Refusal> add(const abut_response_side& a, const abut_response_side& b,
                                           std::string_view kind, std::string_view parameters, std::uint32_t& number);
  [[nodiscard]] std::optional<Refusal> set_parameters(std::uint32_t rule, std::string_view parameters);
  [[nodiscard]] std::optional<Refusal> set_geometry(abut_geometry_id geometry, std::string_view kind,
                                                    std::string_view parameters);
  void clear_geometry(abut_geometry_id geometry) { own_.erase(key_of(geometry)); }
  void clear() { rules_.clear(); }
  void set_variable(std::string_view name, std::string_view value) { variables_[std::string(name)] = value; }

  // Of geometries that touch; materials are those of their children. O(rules).
  [[nodiscard]] Choice choose(const GeometryFacts& a, const GeometryFacts& b) const;
  [[nodiscard]] std::string explain(const Choice& choice, const Terms& terms) const;

  // Of bytes: whether such a rule, or such a kind of a geometry, may be. Kinds are numbers; the text holds no
  // variables.
  [[nodiscard]] bool restore(const abut_response_side& a, const abut_response_side& b, std::uint32_t kind,
                             std::string_view text);
  [[nodiscard]] bool restore(abut_geometry_id geometry, std::uint32_t kind, std::string_view text);

  struct Rule {
    abut_response_side a, b;
    std::uint32_t kind;
    Parameters parameters;
  };
  struct Own {
    std::uint32_t kind;
    Parameters parameters;
  };
  using Key = std::pair<std::uint32_t, std::uint32_t>;  // slot and generation
  [[nodiscard]] const std::vector<Rule>& rules() const { return rules_; }
  [[nodiscard]] const std::map<Key, Own>& of_geometries() const { return own_; }
  [[nodiscard]] const std::map<std::string, std::string>& variables() const { return variables_; }

 private:
  [[nodiscard]] static Key key_of(abut_geometry_id geometry) { return {geometry.slot, geometry.generation}; }
  [[nodiscard]] std::optional<Refusal> read(std::string_view kind, std::string_view text, std::uint32_t& number,
                                            Parameters& parameters) const;
  [[nodiscard]] std::optional<Refusal> replaced(std::string_view text, std::string& out) const;

  std::vector<Kind> kinds_;
  std::vector<Rule> rules_;
  std::map<Key, Own> own_;
  std::map<std::string, std::string> variables_;
};

}  // namespace abut::response
