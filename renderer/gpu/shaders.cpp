#include "renderer/gpu/shaders.h"

#include <fmt/format.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <fstream>
#include <memory>
#include <sstream>

#include "renderer/gpu/errors.h"

// Debian's glslang splits the default limits into a library of their own.
#include <glslang/Public/ResourceLimits.h>

namespace plume::gpu {
namespace {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ShaderError(fmt::format("cannot read the shader {}", path.string()));
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

EShLanguage stage_of(std::string_view name) {
  if (name.ends_with(".vert")) return EShLangVertex;
  if (name.ends_with(".frag")) return EShLangFragment;
  if (name.ends_with(".comp")) return EShLangCompute;
  throw ShaderError(fmt::format("the shader {} must end in .vert, .frag or .comp", name));
}

/// Includes are written as paths below shaders/, as the build's -I gives them.
class FolderIncluder : public glslang::TShader::Includer {
 public:
  explicit FolderIncluder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  IncludeResult* includeLocal(const char* name, const char*, size_t) override {
    std::ifstream probe(folder_ / name);
    if (!probe) return nullptr;
    auto* text = new std::string(read_text(folder_ / name));
    return new IncludeResult(name, text->data(), text->size(), text);
  }
  void releaseInclude(IncludeResult* result) override {
    if (!result) return;
    delete static_cast<std::string*>(result->userData);
    delete result;
  }

 private:
  std::filesystem::path folder_;
};

std::vector<uint32_t> compile(const std::filesystem::path& folder, std::string_view name) {
  static const bool initialised = glslang::InitializeProcess();
  if (!initialised) throw ShaderError("glslang does not start");
  const EShLanguage stage = stage_of(name);
  const std::string source = read_text(folder / name);
  const char* text = source.c_str();
  const std::string label(name);
  const char* label_text = label.c_str();
  const int length = int(source.size());

  glslang::TShader shader(stage);
  shader.setStringsWithLengthsAndNames(&text, &length, &label_text, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
  const auto rules = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
  FolderIncluder includer(folder);
  glslang::TProgram program;
  program.addShader(&shader);
  if (!shader.parse(GetDefaultResources(), 460, false, rules, includer) || !program.link(rules))
    throw ShaderError(
        fmt::format("{} does not compile:\n{}{}", name, shader.getInfoLog(), program.getInfoLog()));
  std::vector<uint32_t> words;
  glslang::GlslangToSpv(*program.getIntermediate(stage), words);
  return words;
}

}  // namespace

std::vector<uint32_t> Shaders::load(std::string_view name) const {
  if (!folder_.empty()) return compile(folder_, name);
  for (const EmbeddedShader& shader : embedded_shaders())
    if (shader.name == name) return {shader.words, shader.words + shader.count};
  throw ShaderError(fmt::format("there is no shader {}", name));
}

}  // namespace plume::gpu
