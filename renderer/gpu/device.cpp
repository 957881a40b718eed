#include "renderer/gpu/device.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstring>

#include "renderer/gpu/errors.h"

namespace plume::gpu {
namespace {

template <class Features>
struct FeatureName {
  const char* name;
  vk::Bool32 Features::*member;
};

#define PLUME_FEATURE(Struct, member) \
  FeatureName<vk::Struct> {           \
#member, &vk::Struct::member      \
  }

// Everything Plume cannot do without. A method that can use more asks Device for it and says so when it is
// missing.
constexpr FeatureName<vk::PhysicalDeviceFeatures> kCoreFeatures[] = {
    PLUME_FEATURE(PhysicalDeviceFeatures, fragmentStoresAndAtomics),
    // Of quads that reach over the picture's border, fragments outside are run too and read beside what is
    // kept for each pixel.
    PLUME_FEATURE(PhysicalDeviceFeatures, robustBufferAccess),
    PLUME_FEATURE(PhysicalDeviceFeatures, independentBlend),
    PLUME_FEATURE(PhysicalDeviceFeatures, dualSrcBlend),
    PLUME_FEATURE(PhysicalDeviceFeatures, occlusionQueryPrecise),
    PLUME_FEATURE(PhysicalDeviceFeatures, drawIndirectFirstInstance),
    PLUME_FEATURE(PhysicalDeviceFeatures, shaderStorageImageExtendedFormats),
};
constexpr FeatureName<vk::PhysicalDeviceVulkan12Features> kVulkan12Features[] = {
    PLUME_FEATURE(PhysicalDeviceVulkan12Features, bufferDeviceAddress),
    PLUME_FEATURE(PhysicalDeviceVulkan12Features, scalarBlockLayout),
    PLUME_FEATURE(PhysicalDeviceVulkan12Features, hostQueryReset),
    PLUME_FEATURE(PhysicalDeviceVulkan12Features, shaderOutputLayer),
};
// Used where they are there; methods that need them say so.
constexpr FeatureName<vk::PhysicalDeviceFeatures> kOptionalCoreFeatures[] = {
    PLUME_FEATURE(PhysicalDeviceFeatures, shaderInt64),
};
constexpr FeatureName<vk::PhysicalDeviceVulkan12Features> kOptionalVulkan12Features[] = {
    PLUME_FEATURE(PhysicalDeviceVulkan12Features, shaderBufferInt64Atomics),
};
constexpr FeatureName<vk::PhysicalDeviceShaderAtomicFloatFeaturesEXT> kFloatAtomicFeatures[] = {
    PLUME_FEATURE(PhysicalDeviceShaderAtomicFloatFeaturesEXT, shaderBufferFloat32AtomicAdd),
};
constexpr FeatureName<vk::PhysicalDeviceFragmentShaderInterlockFeaturesEXT> kInterlockFeatures[] = {
    PLUME_FEATURE(PhysicalDeviceFragmentShaderInterlockFeaturesEXT, fragmentShaderPixelInterlock),
};
constexpr FeatureName<vk::PhysicalDeviceVulkan13Features> kVulkan13Features[] = {
    PLUME_FEATURE(PhysicalDeviceVulkan13Features, dynamicRendering),
    PLUME_FEATURE(PhysicalDeviceVulkan13Features, synchronization2),
    PLUME_FEATURE(PhysicalDeviceVulkan13Features, maintenance4),
};
constexpr const char* kExtensions[] = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
constexpr const char* kOptionalExtensions[] = {VK_EXT_SHADER_ATOMIC_FLOAT_EXTENSION_NAME,
                                               VK_EXT_FRAGMENT_SHADER_INTERLOCK_EXTENSION_NAME};
struct LeastLimit {
  const char* name;
  uint32_t vk::PhysicalDeviceLimits::*member;
  uint32_t least;
};
#define PLUME_LIMIT(member, least)                    \
  LeastLimit {                                        \
#member, &vk::PhysicalDeviceLimits::member, least \
  }
constexpr LeastLimit kLimits[] = {
    PLUME_LIMIT(maxColorAttachments, 8),
    PLUME_LIMIT(maxPushConstantsSize, 128),
    PLUME_LIMIT(maxComputeSharedMemorySize, 16384),
    PLUME_LIMIT(maxComputeWorkGroupInvocations, 256),
    PLUME_LIMIT(maxStorageBufferRange, 1u << 27),
    PLUME_LIMIT(maxImageDimension3D, 256),
};
constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

/// N of "KIND@N"; 0 for other faults, and where names are counted.
uint64_t counted(const std::string& fault, std::string_view kind) {
  const size_t at = kind.size() + 1;
  if (fault.size() <= at || !fault.starts_with(kind) || fault[at - 1] != '@') return 0;
  uint64_t count = 0;
  const auto [end, error] = std::from_chars(fault.data() + at, fault.data() + fault.size(), count);
  return error == std::errc() && end == fault.data() + fault.size() ? count : 0;
}

bool takes_away(const std::string& fault, std::string_view name) {
  return fault == fmt::format("missing@{}", name);
}

/// Switches on in `wanted` what `table` lists; names in `missing` what the device does not offer (or a test
/// takes away).
template <class Features, size_t N>
void request(const FeatureName<Features> (&table)[N], const Features& offered, const std::string& fault,
             Features& wanted, std::vector<std::string>& missing) {
  for (const auto& feature : table) {
    if (!(offered.*feature.member) || takes_away(fault, feature.name))
      missing.push_back(fmt::format("feature {}", feature.name));
    else
      wanted.*feature.member = VK_TRUE;
  }
}

/// The same for what an extension brings, all of it or nothing: whether the device has it.
template <class Features, size_t N>
bool request_extension(const vk::raii::PhysicalDevice& physical, const std::string& fault,
                       const FeatureName<Features> (&table)[N], Features& wanted) {
  const auto offered = physical.getFeatures2<vk::PhysicalDeviceFeatures2, Features>();
  std::vector<std::string> without;
  request(table, offered.template get<Features>(), fault, wanted, without);
  return without.empty();
}

std::string version_text(uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

DeviceInfo describe(const vk::raii::PhysicalDevice& physical) {
  const auto chain =
      physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
  const auto& properties = chain.get<vk::PhysicalDeviceProperties2>().properties;
  const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
  return {.name = properties.deviceName.data(),
          .driver = fmt::format("{} {}", driver.driverName.data(), driver.driverInfo.data()),
          .api = version_text(properties.apiVersion),
          .is_cpu = properties.deviceType == vk::PhysicalDeviceType::eCpu};
}

int preference(const vk::raii::PhysicalDevice& physical) {
  switch (physical.getProperties().deviceType) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
      return 3;
    case vk::PhysicalDeviceType::eIntegratedGpu:
      return 2;
    case vk::PhysicalDeviceType::eVirtualGpu:
      return 1;
    default:
      return 0;
  }
}

std::optional<uint32_t> graphics_family(const vk::raii::PhysicalDevice& physical) {
  const auto families = physical.getQueueFamilyProperties();
  const auto needed = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
  for (uint32_t i = 0; i < families.size(); ++i)
    if ((families[i].queueFlags & needed) == needed && families[i].timestampValidBits > 0) return i;
  return std::nullopt;
}

bool contains(std::string_view text, std::string_view part) {
  const auto same = [](char a, char b) { return std::tolower(a) == std::tolower(b); };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

}  // namespace

Device::Device(const DeviceOptions& options) : options_(options) {
  create_instance();
  choose_physical();
  create_device();
}

Device::~Device() {
  // A lost device cannot be waited for, and nothing is left to do about it here.
  if (*device_) static_cast<void>(device_.getDispatcher()->vkDeviceWaitIdle(static_cast<VkDevice>(*device_)));
}

void Device::create_instance() try {
  std::vector<const char*> layers, extensions = options_.instance_extensions;
  for (const auto& extension : context_.enumerateInstanceExtensionProperties())
    has_debug_utils_ |= std::string_view(extension.extensionName) == VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  if (has_debug_utils_) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  if (options_.validate) {
    bool found = false;
    for (const auto& layer : context_.enumerateInstanceLayerProperties())
      found |= std::string_view(layer.layerName) == kValidationLayer;
    if (!found)
      throw NoUsableDevice(
          fmt::format("validation was asked for, but {} is not installed; install the package "
                      "vulkan-validationlayers or run without --validate",
                      kValidationLayer));
    layers.push_back(kValidationLayer);
  }

  constexpr vk::ValidationFeatureEnableEXT kSynchronization =
      vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
  const vk::ValidationFeaturesEXT validation{.enabledValidationFeatureCount = 1,
                                             .pEnabledValidationFeatures = &kSynchronization};
  const vk::ApplicationInfo application{.pApplicationName = "plume", .apiVersion = VK_API_VERSION_1_3};
  const bool synchronization = options_.validate && options_.synchronization_validation;
  instance_ = vk::raii::Instance(context_,
                                 vk::InstanceCreateInfo{.pNext = synchronization ? &validation : nullptr,
                                                        .pApplicationInfo = &application,
                                                        .enabledLayerCount = uint32_t(layers.size()),
                                                        .ppEnabledLayerNames = layers.data(),
                                                        .enabledExtensionCount = uint32_t(extensions.size()),
                                                        .ppEnabledExtensionNames = extensions.data()});
  if (!options_.validate || !has_debug_utils_) return;

  using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
  using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
  // Headers of Vulkan disagree on whether C's types or C++'s come here.
  const auto collect = [](auto, auto, const auto* data, void* user) -> vk::Bool32 {
    // One shader serves settings that keep more of its outputs and fewer: what has no attachment is dropped
    // (Vulkan 1.3, 15.5, Fragment Output Interface). Newer layers (1.4.309) warn of it.
    if (data->pMessageIdName &&
        std::string_view(data->pMessageIdName).starts_with("Undefined-Value-ShaderOutputNotConsumed"))
      return VK_FALSE;
    auto& log = *static_cast<MessageLog*>(user);
    std::lock_guard lock(log.mutex);
    log.messages.emplace_back(data->pMessage);
    return VK_FALSE;
  };
  messenger_ = instance_.createDebugUtilsMessengerEXT(
      {.messageSeverity = Severity::eWarning | Severity::eError,
       // Performance hints are left out: they ask for the layouts that resources.h decided against.
       .messageType = Type::eValidation,
       .pfnUserCallback = collect,
       .pUserData = log_.get()});
} catch (const vk::SystemError& error) {
  throw NoUsableDevice(fmt::format(
      "Vulkan does not start: {}; install a driver, such as the package mesa-vulkan-drivers", error.what()));
}

void Device::choose_physical() {
  std::vector<vk::raii::PhysicalDevice> found;
  try {
    found = instance_.enumeratePhysicalDevices();
  } catch (const vk::SystemError&) {  // some loaders report "no driver" this way
  }
  if (found.empty())
    throw NoUsableDevice(
        "no Vulkan device was found; install a driver, such as the package mesa-vulkan-drivers");

  std::vector<std::string> names;
  for (const auto& physical : found) names.push_back(describe(physical).name);
  int chosen = -1;
  if (options_.select.empty()) {
    for (int i = 0; i < int(found.size()); ++i)
      if (chosen < 0 || preference(found[size_t(i)]) > preference(found[size_t(chosen)])) chosen = i;
  } else {
    for (int i = 0; i < int(found.size()); ++i)
      if (options_.select == std::to_string(i) || (chosen < 0 && contains(names[size_t(i)], options_.select)))
        chosen = i;
  }
  if (chosen < 0)
    throw NoUsableDevice(
        fmt::format("no device matches '{}'; this machine has: {}", options_.select, fmt::join(names, ", ")));
  physical_ = std::move(found[size_t(chosen)]);
  info_ = describe(physical_);
  limits_ = physical_.getProperties().limits;
}

void Device::create_device() {
  std::vector<std::string> missing;
  const auto offered = physical_.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features,
                                              vk::PhysicalDeviceVulkan13Features>();
  vk::PhysicalDeviceVulkan13Features features13;
  vk::PhysicalDeviceVulkan12Features features12{.pNext = &features13};
  vk::PhysicalDeviceFeatures2 features{.pNext = &features12};
  if (physical_.getProperties().apiVersion < VK_API_VERSION_1_3)
    missing.push_back(fmt::format("Vulkan 1.3 (it has {})", info_.api));
  request(kCoreFeatures, offered.get<vk::PhysicalDeviceFeatures2>().features, options_.fault,
          features.features, missing);
  request(kVulkan12Features, offered.get<vk::PhysicalDeviceVulkan12Features>(), options_.fault, features12,
          missing);
  request(kVulkan13Features, offered.get<vk::PhysicalDeviceVulkan13Features>(), options_.fault, features13,
          missing);

  std::vector<const char*> extensions = options_.device_extensions;
  extensions.insert(extensions.end(), std::begin(kExtensions), std::end(kExtensions));
  const auto offered_extensions = physical_.enumerateDeviceExtensionProperties();
  const auto is_offered = [&](std::string_view name) {
    return !takes_away(options_.fault, name) && std::ranges::any_of(offered_extensions, [&](const auto& e) {
      return std::string_view(e.extensionName) == name;
    });
  };
  for (const char* wanted : extensions)
    if (!is_offered(wanted)) missing.push_back(fmt::format("extension {}", wanted));

  std::vector<std::string> without;
  request(kOptionalCoreFeatures, offered.get<vk::PhysicalDeviceFeatures2>().features, options_.fault,
          features.features, without);
  request(kOptionalVulkan12Features, offered.get<vk::PhysicalDeviceVulkan12Features>(), options_.fault,
          features12, without);
  has_int64_atomics_ = without.empty();
  vk::PhysicalDeviceShaderAtomicFloatFeaturesEXT float_atomics;
  vk::PhysicalDeviceFragmentShaderInterlockFeaturesEXT interlock;
  const auto with_extension = [&](const char* extension, const auto& table, auto& wanted) {
    if (!is_offered(extension) || !request_extension(physical_, options_.fault, table, wanted)) return false;
    extensions.push_back(extension);
    wanted.pNext = std::exchange(features13.pNext, &wanted);
    return true;
  };
  has_float_atomics_ =
      with_extension(VK_EXT_SHADER_ATOMIC_FLOAT_EXTENSION_NAME, kFloatAtomicFeatures, float_atomics);
  has_fragment_interlock_ =
      with_extension(VK_EXT_FRAGMENT_SHADER_INTERLOCK_EXTENSION_NAME, kInterlockFeatures, interlock);

  for (const auto& [name, member, least] : kLimits)
    if (const uint32_t has = takes_away(options_.fault, name) ? 0 : limits_.*member; has < least)
      missing.push_back(fmt::format("limit {} of {} (it has {})", name, least, has));
  const auto family = graphics_family(physical_);
  if (!family) missing.emplace_back("a queue with graphics, compute and timestamps");
  if (!missing.empty())
    throw NoUsableDevice(fmt::format("device '{}' misses: {}", info_.name, fmt::join(missing, "; ")));

  queue_family_ = *family;
  const float priority = 1.0f;
  const vk::DeviceQueueCreateInfo queue{
      .queueFamilyIndex = queue_family_, .queueCount = 1, .pQueuePriorities = &priority};
  device_ =
      vk::raii::Device(physical_, vk::DeviceCreateInfo{.pNext = &features,
                                                       .queueCreateInfoCount = 1,
                                                       .pQueueCreateInfos = &queue,
                                                       .enabledExtensionCount = uint32_t(extensions.size()),
                                                       .ppEnabledExtensionNames = extensions.data()});
  queue_ = device_.getQueue(queue_family_, 0);
  pool_ = device_.createCommandPool(
      {.flags = vk::CommandPoolCreateFlagBits::eTransient, .queueFamilyIndex = queue_family_});
  memory_.init(physical_, device_, options_.memory_limit_bytes);
  memory_.refuse(counted(options_.fault, "no_room"));
}

vk::raii::CommandBuffer Device::new_commands() {
  return std::move(device_.allocateCommandBuffers(
      {.commandPool = *pool_, .level = vk::CommandBufferLevel::ePrimary, .commandBufferCount = 1})[0]);
}

void Device::immediate(const std::function<void(const vk::raii::CommandBuffer&)>& record) {
  const auto commands = new_commands();
  commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
  record(commands);
  commands.end();
  try {
    submit_and_wait(commands);
  } catch (const DeviceFailure& failure) {
    throw DeviceFailure(fmt::format("{}; the last pass was '{}'", failure.what(), last_pass_));
  }
}

void Device::submit_and_wait(const vk::raii::CommandBuffer& commands) try {
  if (++submissions_ == counted(options_.fault, "device_lost"))
    throw DeviceFailure(fmt::format("the device was lost (injected at submission {})", submissions_));
  const vk::raii::Fence fence = device_.createFence({});
  const vk::CommandBufferSubmitInfo buffer{.commandBuffer = *commands};
  queue_.submit2(vk::SubmitInfo2{.commandBufferInfoCount = 1, .pCommandBufferInfos = &buffer}, *fence);
  if (device_.waitForFences(*fence, VK_TRUE, UINT64_MAX) != vk::Result::eSuccess)
    throw DeviceFailure("the device did not finish its work");
} catch (const vk::DeviceLostError&) {
  throw DeviceFailure("the device was lost");
} catch (const vk::SystemError& error) {
  throw DeviceFailure(fmt::format("the device failed: {}", error.what()));
}

void Device::label_object(vk::ObjectType type, uint64_t handle, std::string_view text) const {
  if (!has_debug_utils_) return;
  const std::string name(text);
  device_.setDebugUtilsObjectNameEXT(
      {.objectType = type, .objectHandle = handle, .pObjectName = name.c_str()});
}

std::vector<std::string> Device::validation_messages() const {
  std::lock_guard lock(log_->mutex);
  return log_->messages;
}

std::vector<DeviceNeed> device_needs() {
  std::vector<DeviceNeed> needs;
  const auto add = [&](const auto& table, bool required) {
    for (const auto& entry : table) needs.push_back({entry.name, required});
  };
  add(kCoreFeatures, true);
  add(kVulkan12Features, true);
  add(kVulkan13Features, true);
  add(kLimits, true);
  for (const char* extension : kExtensions) needs.push_back({extension, true});
  add(kOptionalCoreFeatures, false);
  add(kOptionalVulkan12Features, false);
  add(kFloatAtomicFeatures, false);
  add(kInterlockFeatures, false);
  for (const char* extension : kOptionalExtensions) needs.push_back({extension, false});
  return needs;
}

std::vector<DeviceInfo> list_devices() {
  std::vector<DeviceInfo> result;
  try {
    vk::raii::Context context;
    const vk::ApplicationInfo application{.pApplicationName = "plume", .apiVersion = VK_API_VERSION_1_3};
    const vk::raii::Instance instance(context, vk::InstanceCreateInfo{.pApplicationInfo = &application});
    for (const auto& physical : instance.enumeratePhysicalDevices()) result.push_back(describe(physical));
  } catch (
      const std::exception&) {  // no loader, no driver: the list is empty, which is what the caller asked
  }
  return result;
}

}  // namespace plume::gpu
