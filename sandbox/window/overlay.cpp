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

/// ImGui 1.86 has no queue of its own, and its backend would ask the desktop for what is true now.
void feed(const WindowInput& input) {
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = input.pointer ? ImVec2(input.pointer->x, input.pointer->y) : ImVec2(-FLT_MAX, -FLT_MAX);
  for (size_t button = 0; button < kButtons; ++button) io.MouseDown[button] = input.held[button];
  io.MouseWheelH += input.wheel.x;
  io.MouseWheel += input.wheel.y;
  for (const KeyChanged& changed : input.key_changes)
    if (const int code = int(changed.press.key); code >= 0 && code < IM_ARRAYSIZE(io.KeysDown))
      io.KeysDown[code] = changed.down;
  const auto either = [&](Key left, Key right) { return io.KeysDown[int(left)] || io.KeysDown[int(right)]; };
  io.KeyShift = either(Key::kLeftShift, Key::kRightShift);
  io.KeyCtrl = either(Key::kLeftControl, Key::kRightControl);
  io.KeyAlt = either(Key::kLeftAlt, Key::kRightAlt);
  for (const KeyPress& press : input.keys)
    if (press.key == Key::kEscape) io.NavInputs[ImGuiNavInput_Cancel] = 1.0f;
  for (const uint32_t character : input.text) io.AddInputCharacter(character);
}

void draw(const Notice& notice, ImDrawList& list) {
  const float line = ImGui::GetFontSize();
  const ImVec2 text = ImGui::CalcTextSize(notice.text.c_str());
  const ImVec2 size{std::max(text.x, 22 * line) + 2 * line, 4 * line};
  const ImVec2 corner{notice.middle.x - 0.5f * size.x, notice.middle.y - 0.5f * size.y};
  const auto at = [&](float x, float y) { return ImVec2(corner.x + x, corner.y + y); };
  list.AddRectFilled(corner, at(size.x, size.y), IM_COL32(20, 20, 22, 235), 0.4f * line);
  list.AddText(at(line, 0.8f * line), IM_COL32(235, 235, 235, 255), notice.text.c_str());
  const float right = size.x - line, top = 2.4f * line, bottom = 3.0f * line;
  list.AddRectFilled(at(line, top), at(right, bottom), IM_COL32(60, 60, 64, 255));
  list.AddRectFilled(at(line, top), at(line + (right - line) * notice.share, bottom),
                     IM_COL32(150, 170, 210, 255));
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
  ImGui_ImplGlfw_InitForVulkan(window.handle(), false);  // input comes step by step
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

Overlay::Overlay(gpu::Device& device, const GlfwWindow* window, vk::Format format)
    : device_(device), render_pass_(make_render_pass(device, format)) {
  if (window) window_backend_.emplace(*window);
}

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

void Overlay::begin(float text_scale, float pixel_ratio, const WindowInput& input, PresetGallery& gallery) {
  if (text_scale != text_scale_ || pixel_ratio != pixel_ratio_ || gallery.wants_texture())
    fit_text(text_scale, pixel_ratio, gallery);
  // A key that closes a list must not do what it does otherwise, too. Questions are answered elsewhere.
  list_is_open_ = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  ImGui_ImplVulkan_NewFrame();
  if (window_backend_) ImGui_ImplGlfw_NewFrame();
  feed(input);
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

bool Overlay::is_whole() const {
  return ImGui::GetDrawData() != nullptr;
}

void Overlay::record(const vk::raii::CommandBuffer& commands, const WindowImage& image,
                     const Notice* notice) {
  ImDrawData panels = *ImGui::GetDrawData();
  ImDrawList over(ImGui::GetDrawListSharedData());
  std::vector<ImDrawList*> lists(panels.CmdLists, panels.CmdLists + panels.CmdListsCount);
  if (notice) {
    over._ResetForNewFrame();
    over.PushTextureID(ImGui::GetIO().Fonts->TexID);
    over.PushClipRectFullScreen();
    draw(*notice, over);
    lists.push_back(&over);
    panels.CmdLists = lists.data();
    panels.CmdListsCount = int(lists.size());
    panels.TotalVtxCount += over.VtxBuffer.Size;
    panels.TotalIdxCount += over.IdxBuffer.Size;
  }
  // The window may have shrunk since the panels were described, and nothing may be drawn beyond the image.
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
