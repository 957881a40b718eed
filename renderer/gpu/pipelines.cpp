#include "renderer/gpu/pipelines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>

#include "renderer/gpu/errors.h"

namespace plume::gpu {
namespace {

vk::PipelineColorBlendAttachmentState blend_state(Blend blend) {
  using F = vk::BlendFactor;
  vk::PipelineColorBlendAttachmentState state{
      .blendEnable = blend != Blend::kReplace,
      .srcColorBlendFactor = F::eOne,
      .srcAlphaBlendFactor = F::eOne,
      .colorWriteMask = vk::ColorComponentFlagBits::eR | vk::ColorComponentFlagBits::eG |
                        vk::ColorComponentFlagBits::eB | vk::ColorComponentFlagBits::eA};
  const auto factors = [&](F source, F destination) {
    state.srcColorBlendFactor = state.srcAlphaBlendFactor = source;
    state.dstColorBlendFactor = state.dstAlphaBlendFactor = destination;
  };
  switch (blend) {
    case Blend::kReplace:
      break;
    case Blend::kAdd:
      factors(F::eOne, F::eOne);
      break;
    case Blend::kMultiply:
      factors(F::eZero, F::eSrcColor);
      break;
    case Blend::kAddMultiplyAlpha:
      factors(F::eOne, F::eOne);
      state.srcAlphaBlendFactor = F::eZero;
      state.dstAlphaBlendFactor = F::eSrcAlpha;
      break;
    case Blend::kOverDual:  // premultiplied colour plus RGB transmission of what lies behind, in the second
                            // output
      factors(F::eOne, F::eSrc1Color);
      state.dstAlphaBlendFactor = F::eSrc1Alpha;
      break;
  }
  return state;
}

vk::CompareOp compare_op(DepthUse depth) {
  switch (depth) {
    case DepthUse::kTestBehind:
      return vk::CompareOp::eLessOrEqual;
    case DepthUse::kWrite:
      return vk::CompareOp::eAlways;
    default:
      return vk::CompareOp::eGreaterOrEqual;
  }
}

vk::raii::ShaderModule make_module(Device& device, const std::vector<uint32_t>& words) {
  return device.vk().createShaderModule({.codeSize = words.size() * 4, .pCode = words.data()});
}

vk::raii::Sampler make_sampler(Device& device, vk::Filter filter) {
  return device.vk().createSampler({.magFilter = filter,
                                    .minFilter = filter,
                                    .addressModeU = vk::SamplerAddressMode::eClampToEdge,
                                    .addressModeV = vk::SamplerAddressMode::eClampToEdge,
                                    .addressModeW = vk::SamplerAddressMode::eClampToEdge});
}

struct Specialisation {
  explicit Specialisation(const Constants& constants) {
    for (uint32_t i = 0; i < constants.size(); ++i)
      entries.push_back({.constantID = i, .offset = i * 4, .size = 4});
    info = {.mapEntryCount = uint32_t(entries.size()),
            .pMapEntries = entries.data(),
            .dataSize = constants.size() * 4,
            .pData = constants.data()};
  }
  Specialisation(const Specialisation&) = delete;
  std::vector<vk::SpecializationMapEntry> entries;
  vk::SpecializationInfo info;
};

}  // namespace

Pipelines::Pipelines(Device& device, const Shaders& shaders, std::span<const uint8_t> kept, size_t most)
    : device_(device),
      shaders_(shaders),
      cache_(device, kept),
      linear_(make_sampler(device, vk::Filter::eLinear)),
      nearest_(make_sampler(device, vk::Filter::eNearest)),
      most_(most) {}

vk::Sampler Pipelines::sampler_for(vk::Format format) const {
  const bool filterable = format != vk::Format::eD32Sfloat && format != vk::Format::eR32Sfloat;
  return filterable ? *linear_ : *nearest_;
}

const Pipeline& Pipelines::find_or_make(std::string key, const std::string& shader,
                                        std::function<Pipeline()> make) {
  ++asked_;
  if (const auto known = pipelines_.find(key); known != pipelines_.end()) {
    known->second.last_asked = asked_;
    return *known->second.pipeline;
  }
  if (listener_) listener_({.what = shader, .done = 0, .total = 0});
  auto pipeline = std::make_unique<Pipeline>(make());
  ++made_;
  return *pipelines_.emplace(std::move(key), Entry{std::move(make), std::move(pipeline), asked_})
              .first->second.pipeline;
}

void Pipelines::keep_only(size_t most) {
  assert(uses_ == 0);
  while (pipelines_.size() > most)
    pipelines_.erase(
        std::ranges::min_element(pipelines_, {}, [](const auto& known) { return known.second.last_asked; }));
}

const Pipeline& Pipelines::compute(const std::string& shader, const Constants& constants) {
  return find_or_make(fmt::format("{} {}", shader, fmt::join(constants, ",")), shader,
                      [this, shader, constants] { return make_compute(shader, constants); });
}

const Pipeline& Pipelines::graphics(const GraphicsDesc& desc) {
  std::string key = fmt::format("{} {} {} {} {} {}", desc.vertex, desc.fragment, int(desc.depth),
                                int(desc.strip), desc.samples, fmt::join(desc.constants, ","));
  for (const Target& target : desc.targets)
    key += fmt::format(" {}:{}", int(target.format), int(target.blend));
  return find_or_make(std::move(key), desc.fragment.empty() ? desc.vertex : desc.fragment,
                      [this, desc] { return make_graphics(desc); });
}

void Pipelines::reload() {
  std::map<std::string, std::unique_ptr<Pipeline>> fresh;
  for (const auto& [key, entry] : pipelines_) fresh[key] = std::make_unique<Pipeline>(entry.make());
  for (auto& [key, pipeline] : fresh) pipelines_[key].pipeline = std::move(pipeline);
}

Pipeline Pipelines::start(const std::string& name, std::span<const std::vector<uint32_t>> modules,
                          vk::PipelineBindPoint bind_point) {
  Pipeline result{.name = name, .bindings = {}, .bind_point = bind_point};
  for (const auto& words : modules)
    for (const ShaderBinding& binding : reflect(words)) {
      const auto same = std::find_if(result.bindings.begin(), result.bindings.end(),
                                     [&](const auto& b) { return b.binding == binding.binding; });
      if (same == result.bindings.end())
        result.bindings.push_back(binding);
      else if (same->name != binding.name || same->type != binding.type)
        throw ShaderError(fmt::format("{}: binding {} is {} in one stage and {} in the other", name,
                                      binding.binding, same->name, binding.name));
    }
  std::vector<vk::DescriptorSetLayoutBinding> layout;
  for (const ShaderBinding& binding : result.bindings)
    layout.push_back({.binding = binding.binding,
                      .descriptorType = binding.type,
                      .descriptorCount = 1,
                      .stageFlags = vk::ShaderStageFlagBits::eAll});
  result.set_layout = device_.vk().createDescriptorSetLayout(
      {.flags = vk::DescriptorSetLayoutCreateFlagBits::ePushDescriptorKHR,
       .bindingCount = uint32_t(layout.size()),
       .pBindings = layout.data()});
  // 128 bytes, the size every device has: no module needs to say how much of it is its own.
  const vk::PushConstantRange push{.stageFlags = vk::ShaderStageFlagBits::eAll, .size = 128};
  result.layout = device_.vk().createPipelineLayout({.setLayoutCount = 1,
                                                     .pSetLayouts = &*result.set_layout,
                                                     .pushConstantRangeCount = 1,
                                                     .pPushConstantRanges = &push});
  return result;
}

Pipeline Pipelines::make_compute(const std::string& shader, const Constants& constants) {
  const auto words = shaders_.load(shader);
  Pipeline result = start(shader, std::span(&words, 1), vk::PipelineBindPoint::eCompute);
  const auto module = make_module(device_, words);
  const Specialisation specialisation(constants);
  result.pipeline =
      device_.vk().createComputePipeline(cache_.vk(), {.stage = {.stage = vk::ShaderStageFlagBits::eCompute,
                                                                 .module = *module,
                                                                 .pName = "main",
                                                                 .pSpecializationInfo = &specialisation.info},
                                                       .layout = *result.layout});
  device_.label(result.pipeline, shader);
  return result;
}

Pipeline Pipelines::make_graphics(const GraphicsDesc& desc) {
  std::vector<std::vector<uint32_t>> words{shaders_.load(desc.vertex)};
  if (!desc.fragment.empty()) words.push_back(shaders_.load(desc.fragment));
  const std::string name = desc.vertex + " + " + desc.fragment;
  Pipeline result = start(name, words, vk::PipelineBindPoint::eGraphics);
  constexpr vk::ShaderStageFlagBits kStages[] = {vk::ShaderStageFlagBits::eVertex,
                                                 vk::ShaderStageFlagBits::eFragment};
  const Specialisation specialisation(desc.constants);
  std::vector<vk::raii::ShaderModule> modules;
  std::vector<vk::PipelineShaderStageCreateInfo> stages;
  for (size_t i = 0; i < words.size(); ++i) {
    modules.push_back(make_module(device_, words[i]));
    stages.push_back({.stage = kStages[i],
                      .module = *modules[i],
                      .pName = "main",
                      .pSpecializationInfo = &specialisation.info});
  }
  const vk::PipelineVertexInputStateCreateInfo no_vertex_buffers;
  const vk::PipelineInputAssemblyStateCreateInfo assembly{
      .topology = desc.strip ? vk::PrimitiveTopology::eTriangleStrip : vk::PrimitiveTopology::eTriangleList};
  const vk::PipelineViewportStateCreateInfo viewport{.viewportCount = 1, .scissorCount = 1};
  const vk::PipelineRasterizationStateCreateInfo raster{.cullMode = vk::CullModeFlagBits::eNone,
                                                        .lineWidth = 1.0f};
  const vk::PipelineMultisampleStateCreateInfo multisample{.rasterizationSamples =
                                                               vk::SampleCountFlagBits(desc.samples)};
  const vk::PipelineDepthStencilStateCreateInfo depth{
      .depthTestEnable = desc.depth != DepthUse::kNone,
      .depthWriteEnable = desc.depth == DepthUse::kTestAndWrite || desc.depth == DepthUse::kWrite,
      .depthCompareOp = compare_op(desc.depth)};
  std::vector<vk::PipelineColorBlendAttachmentState> blends;
  std::vector<vk::Format> formats;
  for (const Target& target : desc.targets) {
    blends.push_back(blend_state(target.blend));
    formats.push_back(target.format);
  }
  // None is said as one of no format: after a pipeline of no attachments lavapipe of Mesa 25.0 blends all
  // targets of later ones as the first of them, to the end of the submission.
  if (formats.empty()) {
    formats.push_back(vk::Format::eUndefined);
    blends.emplace_back();
  }
  const vk::PipelineColorBlendStateCreateInfo blend{.attachmentCount = uint32_t(blends.size()),
                                                    .pAttachments = blends.data()};
  const vk::DynamicState dynamic_states[] = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
  const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = 2, .pDynamicStates = dynamic_states};
  const vk::PipelineRenderingCreateInfo rendering{.colorAttachmentCount = uint32_t(formats.size()),
                                                  .pColorAttachmentFormats = formats.data(),
                                                  .depthAttachmentFormat = desc.depth == DepthUse::kNone
                                                                               ? vk::Format::eUndefined
                                                                               : vk::Format::eD32Sfloat};
  result.pipeline = device_.vk().createGraphicsPipeline(cache_.vk(), {.pNext = &rendering,
                                                                      .stageCount = uint32_t(stages.size()),
                                                                      .pStages = stages.data(),
                                                                      .pVertexInputState = &no_vertex_buffers,
                                                                      .pInputAssemblyState = &assembly,
                                                                      .pViewportState = &viewport,
                                                                      .pRasterizationState = &raster,
                                                                      .pMultisampleState = &multisample,
                                                                      .pDepthStencilState = &depth,
                                                                      .pColorBlendState = &blend,
                                                                      .pDynamicState = &dynamic,
                                                                      .layout = *result.layout});
  device_.label(result.pipeline, name);
  return result;
}

}  // namespace plume::gpu
