#include "sandbox/window/overlay.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_vulkan.h>

#include <algorithm>
#include <cmath>

#include "renderer/gpu/errors.h"

namespace plume {
namespace {

constexpr float kTextPixels = 13;  // what ImGui's font is drawn for

void check(VkResult result) {
  if (result < 0)
    throw gpu::DeviceFailure(
        fmt::format("the overlay: the device failed: {}", vk::to_string(vk::Result(result))));
}

/// ImGui 1.86 knows no dynamic rendering.
vk::raii::RenderPass make_render_pass(const gpu::Device& device, vk::Format format) {
  const vk::AttachmentDescription image{.format = format,
                                        .samples = vk::SampleCountFlagBits::e1,
                                        .loadOp = vk::AttachmentLoadOp::eLoad,
                                        .storeOp = vk::AttachmentStoreOp::eStore,
                                        .stencilLoadOp = vk::AttachmentLoadOp::eDontCare,
                                        .stencilStoreOp = vk::AttachmentStoreOp::eDontCare,
                                        .initialLayout = vk::ImageLayout::eColorAttachmentOptimal,
                                        .finalLayout = vk::ImageLayout::ePresentSrcKHR};
  const vk::AttachmentReference color{.attachment = 0, .layout = vk::ImageLayout::eColorAttachmentOptimal};
  const vk::SubpassDescription subpass{.pipelineBindPoint = vk::PipelineBindPoint::eGraphics,
                                       .colorAttachmentCount = 1,
                                       .pColorAttachments = &color};
  auto render_pass = device.vk().createRenderPass(
      {.attachmentCount = 1, .pAttachments = &image, .subpassCount = 1, .pSubpasses = &subpass});
  device.label(render_pass, "window.overlay");
  return render_pass;
}

vk::raii::DescriptorPool make_descriptors(const gpu::Device& device) {
  const vk::DescriptorPoolSize fonts{.type = vk::DescriptorType::eCombinedImageSampler, .descriptorCount = 1};
  auto pool = device.vk().createDescriptorPool({.flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                                .maxSets = 1,
                                                .poolSizeCount = 1,
                                                .pPoolSizes = &fonts});
  device.label(pool, "window.overlay");
  return pool;
}

}  // namespace

Overlay::Context::Context() {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
}
Overlay::Context::~Context() {
  ImGui::DestroyContext();
}

Overlay::WindowBackend::WindowBackend(const GlfwWindow& window) {
  ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
}
Overlay::WindowBackend::~WindowBackend() {
  ImGui_ImplGlfw_Shutdown();
}

Overlay::VulkanBackend::VulkanBackend(gpu::Device& device, vk::RenderPass render_pass)
    : descriptors(make_descriptors(device)) {
  ImGui_ImplVulkan_InitInfo info{
      .Instance = static_cast<VkInstance>(*device.instance()),
      .PhysicalDevice = static_cast<VkPhysicalDevice>(*device.physical()),
      .Device = static_cast<VkDevice>(*device.vk()),
      .QueueFamily = device.queue_family(),
      .Queue = static_cast<VkQueue>(*device.queue()),
      .DescriptorPool = static_cast<VkDescriptorPool>(*descriptors),
      .MinImageCount = 2,  // of its vertex buffers; one would do, since frames are waited for
      .ImageCount = 2,
      .MSAASamples = VK_SAMPLE_COUNT_1_BIT,
      .CheckVkResultFn = check};
  ImGui_ImplVulkan_Init(&info, static_cast<VkRenderPass>(render_pass));
  device.immediate([](const vk::raii::CommandBuffer& commands) {
    ImGui_ImplVulkan_CreateFontsTexture(static_cast<VkCommandBuffer>(*commands));
  });
  ImGui_ImplVulkan_DestroyFontUploadObjects();
}
Overlay::VulkanBackend::~VulkanBackend() {
  ImGui_ImplVulkan_Shutdown();
}

Overlay::Overlay(gpu::Device& device, const GlfwWindow& window, vk::Format format)
    : device_(device),
      window_(window),
      render_pass_(make_render_pass(device, format)),
      window_backend_(window) {}

void Overlay::fit_text(float scale, float pixel_ratio, PresetGallery& gallery) {
  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
  style.Colors[ImGuiCol_WindowBg].w = 0.8f;
  style.Colors[ImGuiCol_PopupBg].w = 1.0f;  // pictures and questions stand over other words
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
  ImFontConfig font;
  font.SizePixels = std::round(kTextPixels * scale * pixel_ratio);
  font.OversampleH = font.OversampleV = 1;
  font.PixelSnapH = true;
  ImGuiIO& io = ImGui::GetIO();
  vulkan_backend_.reset();
  io.Fonts->Clear();
  io.Fonts->AddFontDefault(&font);
  gallery.reserve(*io.Fonts);
  io.Fonts->Build();
  gallery.paint(*io.Fonts);
  io.FontGlobalScale = 1 / pixel_ratio;
  vulkan_backend_.emplace(device_, *render_pass_);
  text_scale_ = scale;
  pixel_ratio_ = pixel_ratio;
}

/// ImGui 1.86 is told which keys are down, not which were pressed: a tap between two frames would be lost.
void Overlay::take_keys(std::span<const KeyPress> pressed) {
  ImGuiIO& io = ImGui::GetIO();
  const auto down = [&](Key key) -> bool& { return io.KeysDown[size_t(key)]; };
  for (const Key key : tapped_) down(key) = window_.holds(key);
  tapped_.clear();
  for (const KeyPress& press : pressed) {
    if (size_t(press.key) >= std::size(io.KeysDown)) continue;  // GLFW knows no name of it
    if (!down(press.key)) tapped_.push_back(press.key);
    down(press.key) = true;
    if (press.key == Key::kEscape) io.NavInputs[ImGuiNavInput_Cancel] = 1.0f;
  }
}

void Overlay::begin(float text_scale, float pixel_ratio, std::span<const KeyPress> pressed,
                    PresetGallery& gallery) {
  if (text_scale != text_scale_ || pixel_ratio != pixel_ratio_ || gallery.wants_texture())
    fit_text(text_scale, pixel_ratio, gallery);
  // A key that closes a list must not do what it does otherwise, too. Questions are answered elsewhere.
  list_is_open_ = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  take_keys(pressed);
  ImGui::NewFrame();
}

void Overlay::end() {
  ImGui::Render();
}

bool Overlay::takes_pointer() const {
  return ImGui::GetIO().WantCaptureMouse;
}
bool Overlay::takes_keys() const {
  return ImGui::GetIO().WantTextInput || list_is_open_;
}

void Overlay::record(const vk::raii::CommandBuffer& commands, const WindowImage& image) {
  // The window may have shrunk since the panels were described, and nothing may be drawn beyond the image.
  ImDrawData& panels = *ImGui::GetDrawData();
  panels.DisplaySize.x =
      std::min(panels.DisplaySize.x, float(image.extent.width) / panels.FramebufferScale.x);
  panels.DisplaySize.y =
      std::min(panels.DisplaySize.y, float(image.extent.height) / panels.FramebufferScale.y);
  framebuffer_ = device_.vk().createFramebuffer({.renderPass = *render_pass_,
                                                 .attachmentCount = 1,
                                                 .pAttachments = &image.view,
                                                 .width = image.extent.width,
                                                 .height = image.extent.height,
                                                 .layers = 1});
  device_.label(framebuffer_, "window.overlay");
  commands.beginRenderPass(
      {.renderPass = *render_pass_, .framebuffer = *framebuffer_, .renderArea = {.extent = image.extent}},
      vk::SubpassContents::eInline);
  ImGui_ImplVulkan_RenderDrawData(&panels, static_cast<VkCommandBuffer>(*commands));
  commands.endRenderPass();
}

}  // namespace plume
