// Where the files of a pack define names, and which files they include: asked only when something
// does not compile, so nothing is read before.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/pack/shader_pack.h>

namespace orris {

/// An #include line.
struct IncludeLine {
  int line = 0;
  std::string target;
};

/// Safe to use from several threads.
class DefinitionIndex {
 public:
  explicit DefinitionIndex(const ShaderPack& pack) : pack_(pack) {}

  /// Definitions of `name` at file scope: macros, functions, structs, constants, declarations; in
  /// the order of the files. Also in files that nothing includes.
  const std::vector<SourceLocation>& definitionsOf(const std::string& name);
  /// #include lines of a file, by line.
  const std::vector<IncludeLine>& includesOf(const std::string& file);
  /// The #include lines of all files that name `file`, by file.
  const std::vector<SourceLocation>& includersOf(const std::string& file);
  /// All shader texts of the pack.
  const std::map<std::string, FileLines>& files();
  /// Does `file` include `target`, itself or through others?
  bool reaches(const std::string& file, const std::string& target);

 private:
  void load();
  void readAll();

  const ShaderPack& pack_;
  std::once_flag once_;
  std::map<std::string, FileLines> files_;
  std::map<std::string, std::vector<IncludeLine>> includes_;
  std::map<std::string, std::vector<SourceLocation>> includers_;
  std::mutex mutex_;
  std::map<std::string, std::vector<SourceLocation>> found_;
};

}  // namespace orris
