#include "shader_compiler/shader_compiler.hpp"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <algorithm>
#include <charconv>
#include <spirv-tools/libspirv.hpp>

#include "base/text_location.hpp"
#include "shader_compiler/compiler_log.hpp"
#include "shader_compiler/exact_spirv.hpp"
#include "shader_compiler/shader_interface.hpp"
#include "shader_compiler/shader_sources.hpp"

// The initializers of glslang's static objects, which the program's start-up would have called (see
// CMakeLists.txt). The linker derives these two names from the section's, and leaves them null where there is
// none.
using Initializer = void (*)();
extern "C" {
[[gnu::weak, gnu::visibility("hidden")]] extern const Initializer __start_lavaray_glslang_start[];
[[gnu::weak, gnu::visibility("hidden")]] extern const Initializer __stop_lavaray_glslang_start[];
}

namespace lavaray {
namespace {

constexpr const char* kSource = "render.comp";
constexpr const char* kInterface = "interface.h";
constexpr const char* kOtherInterface =
    "differs from the interface that the program was built with: build the program anew to change it";

// As glslangValidator has them for a source without #version.
constexpr int kDefaultVersion = 100;
constexpr auto kMessages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);

// The compiler's tables, made by the first compilation and freed at the end of the process.
class CompilerProcess {
 public:
  static void ensure() { static const CompilerProcess process; }
  CompilerProcess(const CompilerProcess&) = delete;
  CompilerProcess& operator=(const CompilerProcess&) = delete;

 private:
  CompilerProcess() {
    for (const Initializer* start = __start_lavaray_glslang_start; start != __stop_lavaray_glslang_start;
         ++start)
      (*start)();
    glslang::InitializeProcess();
  }
  ~CompilerProcess() { glslang::FinalizeProcess(); }
};

// The compiler knows a source by its number: unlike a path, that has no quote or colon, which would spoil the
// log.
std::string sourceName(std::size_t source) {
  return "#" + std::to_string(source);
}

class Includer : public glslang::TShader::Includer {
 public:
  explicit Includer(ShaderSources& sources) : sources_(sources) {}

  IncludeResult* includeLocal(const char* header, const char* /*includer*/, std::size_t depth) override {
    const std::size_t number = sources_.include(header, depth);
    if (number >= sources_.sources().size()) {
      failure_ = sources_.includeFailure();
      return nullptr;
    }
    const std::string& text = sources_.sources()[number].text;
    return new IncludeResult(sourceName(number), text.data(), text.size(), nullptr);
  }

  // Called for `#include <...>`, and where includeLocal found nothing.
  IncludeResult* includeSystem(const char* /*header*/, const char* /*includer*/,
                               std::size_t /*depth*/) override {
    message_ = failure_.empty() ? "allowed are includes in double quotes" : std::exchange(failure_, {});
    return new IncludeResult("", message_.data(), message_.size(), nullptr);
  }

  void releaseInclude(IncludeResult* result) override { delete result; }

 private:
  ShaderSources& sources_;
  std::string failure_;
  std::string message_;  // that the compiler reads from
};

// One run of the compiler over the sources. The program is destroyed before the shader, whose memory it uses.
class Compilation {
 public:
  Compilation(ShaderSources& sources, bool forFewPrimitives) : includer_(sources) {
    const ShaderSource& source = sources.sources().front();
    text_ = source.text.data();
    length_ = static_cast<int>(source.text.size());
    name_ = nameText_.c_str();
    shader_.setStringsWithLengthsAndNames(&text_, &length_, &name_, 1);
    if (forFewPrimitives) shader_.setPreamble("#define LAVARAY_FEW_PRIMITIVES 1\n");
    shader_.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 100);
    shader_.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
    shader_.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
  }

  bool parse() { return shader_.parse(GetDefaultResources(), kDefaultVersion, false, kMessages, includer_); }
  bool link() {
    program_.addShader(&shader_);
    return program_.link(kMessages) && program_.mapIO();
  }
  std::string preprocess() {
    std::string text;
    shader_.preprocess(GetDefaultResources(), kDefaultVersion, ENoProfile, false, false, kMessages, &text,
                       includer_);
    return text;
  }
  std::string log() { return std::string(shader_.getInfoLog()) + "\n" + program_.getInfoLog(); }

  // A word-for-word translation of the shader, as glslangValidator makes without options.
  std::vector<std::uint32_t> generate() {
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    std::vector<std::uint32_t> spirv;
    glslang::GlslangToSpv(*program_.getIntermediate(EShLangCompute), spirv, &options);
    return spirv;
  }

 private:
  Includer includer_;
  std::string nameText_ = sourceName(0);
  const char* text_;
  int length_;
  const char* name_;
  glslang::TShader shader_{EShLangCompute};
  glslang::TProgram program_;
};

// What is wrong, in the user's terms: with files and lines in place of the compiler's names.
class Complaints {
 public:
  Complaints(ShaderSources& sources, bool forFewPrimitives)
      : sources_(sources), forFewPrimitives_(forFewPrimitives) {}

  void add(const std::string& line) {
    if (std::ranges::find(lines_, line) == lines_.end()) lines_.push_back(line);
  }
  void addAll(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) add(line);
  }
  void add(const Misfit& misfit) { add(located(findDeclaration(misfit.word), misfit.message)); }
  void add(const CompilerMessage& message) {
    PreprocessedLocation location{message.source, message.line};
    if (location.source.empty() && !message.function.empty())
      location = findDeclaration(message.function + "(");
    add(located(location, message.text));
  }
  [[nodiscard]] std::string located(const PreprocessedLocation& location, const std::string& message) const {
    for (std::size_t i = 0; i < sources_.sources().size(); ++i) {
      if (location.source == sourceName(i))
        return messageAt({sources_.sources()[i].path, location.line}, message);
    }
    // The source's own #line, or none.
    const std::filesystem::path file =
        location.source.empty() ? sources_.sources()[0].path : std::filesystem::path(location.source);
    return messageAt({file, location.line}, message);
  }

  void throwIfAny() const {
    if (lines_.empty()) return;
    std::string message;
    for (const std::string& line : lines_) message += (message.empty() ? "" : "\n") + line;
    throw ShaderError(message, sources_.files());
  }

 private:
  PreprocessedLocation findDeclaration(const std::string& word) {
    if (word.empty()) return {{}, 1};
    if (!preprocessed_) preprocessed_ = Compilation(sources_, forFewPrimitives_).preprocess();
    return findWord(*preprocessed_, word);
  }

  ShaderSources& sources_;
  bool forFewPrimitives_;
  std::vector<std::string> lines_;
  std::optional<std::string> preprocessed_;
};

// Why a driver need not accept this SPIR-V, which most drivers do not check; empty where it must.
std::string validate(const std::vector<std::uint32_t>& spirv) {
  std::string reason = "no reason given";
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_2);
  tools.SetMessageConsumer(
      [&](spv_message_level_t /*level*/, const char* /*source*/, const spv_position_t& /*position*/,
          const char* text) { reason = std::string(text).substr(0, std::string_view(text).find('\n')); });
  return tools.Validate(spirv) ? std::string() : reason;
}

CompiledShader compile(ShaderSources& sources, bool forFewPrimitives) {
  prepareCompiler();
  Complaints complaints(sources, forFewPrimitives);
  complaints.addAll(sources.complaints());
  complaints.throwIfAny();

  Compilation compilation(sources, forFewPrimitives);
  const bool isParsed = compilation.parse();
  // Checked before the compiler's messages, which may merely follow from this.
  for (const ShaderSource& source : sources.sources()) {
    if (source.path.filename() != kInterface) continue;
    if (const auto line = firstDifference(source.text))
      complaints.add(messageAt({source.path, *line}, kOtherInterface));
  }
  complaints.throwIfAny();
  complaints.addAll(sources.complaints());
  complaints.throwIfAny();

  const bool isLinked = isParsed && compilation.link();
  std::vector<std::string> warnings;
  for (const CompilerMessage& message : readCompilerLog(compilation.log())) {
    if (!message.isError) {
      warnings.push_back(complaints.located({message.source, message.line}, message.text));
      continue;
    }
    complaints.add(message);
    // The parser stops at its first error, and what it says after that follows from it.
    if (!isParsed) break;
  }
  complaints.throwIfAny();
  if (!isLinked) complaints.add(complaints.located({}, "does not compile, and the compiler gives no reason"));
  complaints.throwIfAny();

  const std::vector<std::uint32_t> written = compilation.generate();
  std::vector<std::uint32_t> spirv = finishShader(written);
  if (const std::string reason = validate(spirv); !reason.empty())
    complaints.add(complaints.located({}, "the compiler makes SPIR-V of it that is not valid: " + reason));
  complaints.throwIfAny();
  for (const Misfit& misfit : findMisfits(written, spirv)) complaints.add(misfit);
  complaints.throwIfAny();
  return {std::move(spirv), sources.files(), std::move(warnings)};
}

// Where the first line of a message about one of the files points to.
std::pair<std::string, std::size_t> locationIn(std::string_view message,
                                               const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files) {
    const std::string name = printable(file.native());
    if (!message.starts_with(name + ":")) continue;
    const std::string_view rest = message.substr(name.size() + 1);
    std::size_t line = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), line);
    const bool isLine = error == std::errc() && end != rest.data() + rest.size() && *end == ':';
    return {name, isLine ? line : 0};
  }
  return {};
}

}  // namespace

ShaderError::ShaderError(const std::string& message, std::vector<std::filesystem::path> files)
    : ShaderError(message, locationIn(message, files), std::move(files)) {}

void prepareCompiler() {
  CompilerProcess::ensure();
}

CompiledShader compileRenderShader(const std::filesystem::path& directory, bool forFewPrimitives,
                                   const OnShaderFile& onFile) {
  ShaderSources sources(directory, onFile);
  sources.add(kSource);
  sources.add(kInterface);
  return compile(sources, forFewPrimitives);
}

CompiledShader compileOwnShader(const std::filesystem::path& file, const OnShaderFile& onFile) {
  constexpr bool kOffersBuiltIn = true;
  ShaderSources sources(file.parent_path(), onFile, kOffersBuiltIn);
  sources.add(file.filename().string());
  return compile(sources, false);
}

}  // namespace lavaray
