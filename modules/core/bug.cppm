// SPDX-License-Identifier: Apache-2.0
// A broken invariant of abut itself.
export module abut.core.bug;
import abut.core.standard;

export namespace abut {

class Bug : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] void report_bug(const char* condition, const char* file, int line) {
  throw Bug(std::string(file) + ":" + std::to_string(line) + ": " + condition);
}

}  // namespace abut
