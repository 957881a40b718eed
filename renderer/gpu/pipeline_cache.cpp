#include "renderer/gpu/pipeline_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace plume::gpu {
namespace {

/// As it lies in the file; written and read by the same kind of machine, which the driver's id sees to.
struct Head {
  std::array<char, 8> magic{'P', 'L', 'U', 'M', 'E', 'P', 'C', '1'};
  uint32_t vendor, device, driver;
  std::array<uint8_t, VK_UUID_SIZE> uuid;
  uint32_t unused = 0;
  uint64_t length, hash;
};
static_assert(sizeof(Head) == 56, "no bytes between the members");

uint64_t fnv1a(std::span<const uint8_t> bytes) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
  return hash;
}

Head head_of(const Device& device, std::span<const uint8_t> data) {
  const vk::PhysicalDeviceProperties properties = device.physical().getProperties();
  Head head{.vendor = properties.vendorID,
            .device = properties.deviceID,
            .driver = properties.driverVersion,
            .length = data.size(),
            .hash = fnv1a(data)};
  std::ranges::copy(properties.pipelineCacheUUID, head.uuid.begin());
  return head;
}

/// What is wrong with the bytes; empty: they are whole and of this driver.
std::string complaint(const Device& device, std::span<const uint8_t> kept) {
  Head head;
  if (kept.size() < sizeof head) return "it is cut short";
  std::memcpy(&head, kept.data(), sizeof head);
  const auto data = kept.subspan(sizeof head);
  const Head right = head_of(device, data);
  if (head.magic != right.magic) return "it is no file of pipelines of this version";
  if (head.vendor != right.vendor || head.device != right.device || head.driver != right.driver ||
      head.uuid != right.uuid)
    return "it is another driver's";
  if (head.length != right.length) return "it is cut short or has grown";
  if (head.hash != right.hash || head.unused != right.unused) return "it is damaged";
  return "";
}

}  // namespace

PipelineCache::PipelineCache(Device& device, std::span<const uint8_t> kept) : device_(device) {
  if (!kept.empty()) refused_ = complaint(device, kept);
  if (!kept.empty() && refused_.empty()) try {
      const auto data = kept.subspan(sizeof(Head));
      cache_ = device.vk().createPipelineCache({.initialDataSize = data.size(), .pInitialData = data.data()});
    } catch (const vk::SystemError& error) {
      refused_ = fmt::format("the driver does not take it: {}", error.what());
    }
  if (!*cache_) cache_ = device.vk().createPipelineCache({});
  device.label(cache_, "pipelines");
}

std::vector<uint8_t> PipelineCache::bytes() const {
  const std::vector<uint8_t> data = cache_.getData();
  const Head head = head_of(device_, data);
  std::vector<uint8_t> bytes(sizeof head + data.size());
  std::memcpy(bytes.data(), &head, sizeof head);
  std::ranges::copy(data, bytes.begin() + sizeof head);
  return bytes;
}

std::string PipelineCache::file_name(const Device& device) {
  const Head head = head_of(device, {});
  std::string name = fmt::format("pipelines-{:04x}-{:04x}-{:08x}-", head.vendor, head.device, head.driver);
  for (const uint8_t byte : head.uuid) name += fmt::format("{:02x}", byte);
  return name + ".bin";
}

}  // namespace plume::gpu
