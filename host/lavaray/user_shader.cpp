#include "lavaray/user_shader.hpp"

#include <algorithm>
#include <utility>

namespace lavaray {
namespace {

bool haveCommon(const UserShader::Files& a, const UserShader::Files& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

}  // namespace

UserShader::UserShader(std::filesystem::path folder) : folder_(std::move(folder)) {
  if (!folder_.empty()) compiler_.emplace();
}

bool UserShader::compile(const Files& changed, bool forFewPrimitives, std::vector<std::string>& warnings) {
  if (!compiler_) return false;
  forFewPrimitives_ = forFewPrimitives;
  Compiled& other = compiled_[!forFewPrimitives];
  if (haveCommon(changed, other.files)) other = {};
  Compiled& mine = compiled_[forFewPrimitives];
  if (!mine.spirv.empty() && !haveCommon(changed, mine.files)) return false;
  try {
    CompiledShader compiled = compiler_->compile(folder_, forFewPrimitives);
    warnings.insert(warnings.end(), compiled.warnings.begin(), compiled.warnings.end());
    mine = {std::move(compiled.spirv), std::move(compiled.files)};
  } catch (const ShaderError& error) {
    mine.files = error.files();
    throw;
  }
  return true;
}

}  // namespace lavaray
