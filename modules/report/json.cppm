// SPDX-License-Identifier: Apache-2.0
// Text of JSON, written from the outside in.
export module abut.report.json;
import abut.core;
import abut.core.standard;

export namespace abut {

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

}  // namespace abut
