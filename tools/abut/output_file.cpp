// SPDX-License-Identifier: Apache-2.0
#include "output_file.hpp"

#include <cerrno>
#include <system_error>

#include "failures.hpp"

namespace cli {

OutputFile::OutputFile(const std::string& path) : shown_(path) {
  if (path == "-") {
    shown_ = "the standard output";
    return;
  }
  std::error_code none;
  const bool exists = std::filesystem::exists(path, none);
  target_ = exists ? std::filesystem::canonical(path, none) : std::filesystem::path(path);
  if (!exists || std::filesystem::is_regular_file(target_, none)) {
    partial_ = target_;
    partial_ += ".part";
  }
  file_.reset(std::fopen((partial_.empty() ? target_ : partial_).c_str(), "wb"));
  if (file_ == nullptr) {
    partial_.clear();
    fail("cannot write ");
  }
}

OutputFile::~OutputFile() {
  file_.reset();
  if (!partial_.empty()) {
    std::error_code ignored;
    std::filesystem::remove(partial_, ignored);
  }
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_ ? file_.get() : stdout) != text.size()) {
    fail("cannot write all of ");
  }
}

void OutputFile::finish() {
  if (std::fflush(file_ ? file_.get() : stdout) != 0 || (file_ && std::fclose(file_.release()) != 0)) {
    fail("cannot write all of ");
  }
  if (!partial_.empty()) {
    std::error_code error;
    std::filesystem::rename(partial_, target_, error);
    if (error) {
      throw BadOutput("cannot write " + shown_ + ": " + error.message());
    }
    partial_.clear();
  }
}

void OutputFile::fail(const char* what) const {
  throw BadOutput(what + shown_ + ": " + std::generic_category().message(errno));
}

void print(std::string_view text) {
  OutputFile out("-");
  out.write(text);
  out.finish();
}

}  // namespace cli
