// SPDX-License-Identifier: Apache-2.0
// A file that gets its name when it is complete, so that a failure leaves nothing that looks like a result.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace cli {

class OutputFile {
 public:
  /// "-" is the standard output. What exists and is no regular file, such as a pipe, is written to directly.
  explicit OutputFile(const std::string& path);
  OutputFile(OutputFile&&) = default;
  OutputFile& operator=(OutputFile&&) = delete;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Throws BadOutput with the reason of the system when it cannot be written.
  void write(std::string_view text);

  /// Writes what is held back and gives the file its name.
  void finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
  };

  [[noreturn]] void fail(const char* what) const;

  std::string shown_;
  std::filesystem::path target_;
  std::filesystem::path partial_;           // empty where the target is written to directly
  std::unique_ptr<std::FILE, Close> file_;  // none for the standard output
};

/// Writes a whole text to the standard output.
void print(std::string_view text);

}  // namespace cli
