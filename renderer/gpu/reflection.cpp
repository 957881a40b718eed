#include "renderer/gpu/reflection.h"

#include <map>
#include <optional>

#include "renderer/gpu/errors.h"

namespace plume::gpu {
namespace {

// The few opcodes and enumerants that name descriptors (SPIR-V 1.6, section 3).
enum Op : uint32_t {
  kOpName = 5,
  kOpTypeImage = 25,
  kOpTypeSampledImage = 27,
  kOpTypeStruct = 30,
  kOpTypePointer = 32,
  kOpVariable = 59,
  kOpDecorate = 71
};
enum StorageClass : uint32_t { kUniformConstant = 0, kUniform = 2, kStorageBuffer = 12 };
constexpr uint32_t kDecorationBinding = 33, kMagic = 0x07230203, kSampledStorage = 2;

struct Variable {
  uint32_t id, type, storage;
};

}  // namespace

std::vector<ShaderBinding> reflect(std::span<const uint32_t> words) {
  if (words.size() < 5 || words[0] != kMagic) throw ShaderError("not a SPIR-V module");
  std::map<uint32_t, std::string> names;
  std::map<uint32_t, uint32_t> bindings, pointees, image_usage;
  std::map<uint32_t, Op> kinds;
  std::vector<Variable> variables;

  for (size_t i = 5; i < words.size();) {
    const uint32_t count = words[i] >> 16, opcode = words[i] & 0xffff;
    if (count == 0 || i + count > words.size())
      throw ShaderError("a SPIR-V module ends inside an instruction");
    const auto operand = [&](uint32_t n) { return words[i + n]; };
    switch (opcode) {
      case kOpName:
        names[operand(1)] = reinterpret_cast<const char*>(&words[i + 2]);
        break;
      case kOpDecorate:
        if (operand(2) == kDecorationBinding) bindings[operand(1)] = operand(3);
        break;
      case kOpTypeImage:
        image_usage[operand(1)] = operand(7);
        [[fallthrough]];
      case kOpTypeSampledImage:
      case kOpTypeStruct:
        kinds[operand(1)] = Op(opcode);
        break;
      case kOpTypePointer:
        pointees[operand(1)] = operand(3);
        break;
      case kOpVariable:
        variables.push_back({operand(2), operand(1), operand(3)});
        break;
      default:
        break;
    }
    i += count;
  }

  std::vector<ShaderBinding> result;
  for (const Variable& variable : variables) {
    if (!bindings.contains(variable.id)) continue;
    const uint32_t type = pointees.at(variable.type);
    std::optional<vk::DescriptorType> descriptor;
    if (variable.storage == kStorageBuffer) descriptor = vk::DescriptorType::eStorageBuffer;
    if (variable.storage == kUniform) descriptor = vk::DescriptorType::eUniformBuffer;
    if (variable.storage == kUniformConstant && kinds[type] == kOpTypeSampledImage)
      descriptor = vk::DescriptorType::eCombinedImageSampler;
    if (variable.storage == kUniformConstant && kinds[type] == kOpTypeImage &&
        image_usage[type] == kSampledStorage)
      descriptor = vk::DescriptorType::eStorageImage;
    if (!descriptor) throw ShaderError("a descriptor of an unsupported kind: " + names[variable.id]);
    const bool is_block = variable.storage != kUniformConstant;
    result.push_back({is_block ? names[type] : names[variable.id], bindings[variable.id], *descriptor});
  }
  return result;
}

}  // namespace plume::gpu
