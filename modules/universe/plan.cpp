module abut.universe.plan;
import abut.core;
import abut.core.standard;
import abut.universe.focus;
import abut.universe.options;

namespace abut {
namespace {

std::string line_of(const Plan::Stage& stage) {
  std::string line = "  " + std::string(stage.name);
  line.resize(16, ' ');
  const std::string spent = to_text(std::round(10 * stage.microseconds) / 10) + " us";
  line.append(spent.size() < 12 ? 12 - spent.size() : 0, ' ');
  return line + spent + "  " + stage.what + "\n";
}

// Objects and lists of JSON (RFC 8259). Names and texts come from here and hold no control characters.
class Json {
 public:
  void open(char bracket) {
    separate();
    text_ += bracket;
    is_first_ = true;
  }
  void close(char bracket) {
    text_ += bracket;
    is_first_ = false;
  }
  void name(std::string_view name) {
    separate();
    quote(name);
    text_ += ": ";
    is_first_ = true;
  }
  void value(std::string_view text) {
    separate();
    quote(text);
  }
  void value(std::uint64_t number) {
    separate();
    text_ += to_text(number);
  }
  void value(double number) {
    separate();
    text_ += to_text(number);
  }
  template <class Value>
  void member(std::string_view its_name, const Value& its_value) {
    name(its_name);
    value(its_value);
  }
  [[nodiscard]] std::string text() && { return std::move(text_) + "\n"; }

 private:
  void separate() { text_ += std::exchange(is_first_, false) ? "" : ", "; }
  void quote(std::string_view text) {
    text_ += '"';
    for (const char letter : text) {
      text_ += letter == '"' || letter == '\\' ? std::string{'\\', letter} : std::string{letter};
    }
    text_ += '"';
  }

  std::string text_;
  bool is_first_ = true;
};

void write_counts(Json& json, const StepStats& stats) {
  const std::pair<std::string_view, std::uint64_t> counts[] = {
      {"parts", stats.parts},
      {"geometries", stats.geometries},
      {"parked", stats.parked},
      {"moved", stats.moved},
      {"candidate_pairs", stats.candidate_pairs},
      {"filtered_pairs", stats.filtered_pairs},
      {"examined_pairs", stats.examined_pairs},
      {"kept_pairs", stats.kept_pairs},
      {"unsupported_pairs", stats.unsupported_pairs},
      {"touching_pairs", stats.touching_pairs},
      {"contacts", stats.contacts},
      {"events", stats.events},
      {"bytes", stats.bytes},
      {"asleep", stats.asleep},
  };
  json.name("counts");
  json.open('{');
  for (const auto& [name, count] : counts) {
    json.member(name, count);
  }
  json.close('}');
}

void write_focus(Json& json, const Plan::FocusCounts& counts) {
  json.name("focus");
  json.open('{');
  json.member("centres", counts.centres);
  json.member("near_tag", std::uint64_t{counts.focus.near_tag});
  json.member("far_tag", std::uint64_t{counts.focus.far_tag});
  json.member("near_distance", counts.focus.near_distance);
  json.member("far_distance", counts.focus.far_distance);
  json.member("near", counts.near);
  json.member("far", counts.far);
  json.close('}');
}

}  // namespace

std::string count_of(std::uint64_t count, std::string_view noun) {
  std::string text = to_text(count) + " " + std::string(noun);
  if (count == 1) {
    return text;
  }
  if (!noun.ends_with('y')) {
    return text + "s";
  }
  text.pop_back();
  return text + "ies";
}

std::string to_text(const Plan& plan) {
  const StepStats& stats = plan.stats;
  const std::string asleep = stats.asleep > 0 ? " (" + to_text(stats.asleep) + " asleep)" : "";
  std::string text = "universe: " + count_of(stats.parts, "part") + asleep + ", " + count_of(stats.geometries, "geometry") + ", " +
                     count_of(stats.bytes, "byte") + "\nstages of the last step\n";
  for (const Plan::Stage& stage : plan.stages) {
    text += line_of(stage);
  }
  text += "broad phase: " + std::string(plan.broadphase) + ", " + std::string(plan.broadphase_reason) + "\n";
  text += "threads: " + to_text(std::uint64_t{plan.threads}) + "\ntolerance: ";
  text += plan.is_margin ? "margin, a separation below the sum of both is reported"
                         : "dead band, an overlap beyond the sum of both is reported";
  if (plan.focus) {
    const Focus& focus = plan.focus->focus;
    text += "\nfocus: " + count_of(plan.focus->centres, "centre") + "; " + count_of(plan.focus->near, "geometry") + " near (tag " +
            to_text(std::uint64_t{focus.near_tag}) + ", within " + to_text(focus.near_distance) + "), " + to_text(plan.focus->far) +
            " far (tag " + to_text(std::uint64_t{focus.far_tag}) + ", beyond " + to_text(focus.far_distance) + ")";
  }
  text += "\npairs of kinds\n";
  for (const Plan::KindPair& its : plan.kinds) {
    text += "  " + std::string(its.kind_a) + " - " + std::string(its.kind_b) + ": " + count_of(its.candidates, "candidate") + ", " +
            to_text(its.examined) + " examined, " + to_text(its.touching) + " touching, " + count_of(its.contacts, "contact") + "; " +
            std::string(its.algorithm) + " (" + std::string(its.reason) + ")\n";
  }
  text += "left out\n";
  for (const Plan::LeftOut& its : plan.left_out) {
    text += "  " + its.name + ": " + its.why + "\n";
  }
  return text;
}

std::string to_json(const Plan& plan) {
  Json json;
  json.open('{');
  write_counts(json, plan.stats);
  json.name("stages");
  json.open('[');
  for (const Plan::Stage& stage : plan.stages) {
    json.open('{');
    json.member("name", stage.name);
    json.member("microseconds", stage.microseconds);
    json.member("what", std::string_view(stage.what));
    json.close('}');
  }
  json.close(']');
  json.name("broadphase");
  json.open('{');
  json.member("algorithm", plan.broadphase);
  json.member("reason", plan.broadphase_reason);
  json.close('}');
  json.member("tolerance_mode", std::string_view(plan.is_margin ? "margin" : "dead_band"));
  json.member("max_contacts", std::uint64_t{plan.max_contacts});
  json.member("threads", std::uint64_t{plan.threads});
  json.member("rules", plan.rules);
  json.member("policies", plan.policies);
  if (plan.focus) {
    write_focus(json, *plan.focus);
  }
  json.name("pairs_of_kinds");
  json.open('[');
  for (const Plan::KindPair& its : plan.kinds) {
    json.open('{');
    json.member("a", its.kind_a);
    json.member("b", its.kind_b);
    json.member("candidates", its.candidates);
    json.member("examined", its.examined);
    json.member("touching", its.touching);
    json.member("contacts", its.contacts);
    json.member("algorithm", its.algorithm);
    json.member("reason", its.reason);
    json.close('}');
  }
  json.close(']');
  json.name("left_out");
  json.open('[');
  for (const Plan::LeftOut& its : plan.left_out) {
    json.open('{');
    json.member("name", std::string_view(its.name));
    json.member("why", std::string_view(its.why));
    json.close('}');
  }
  json.close(']');
  json.close('}');
  return std::move(json).text();
}

}  // namespace abut
