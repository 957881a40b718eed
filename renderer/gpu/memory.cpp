#include "renderer/gpu/memory.h"

#include <fmt/format.h>

#include "renderer/gpu/errors.h"

namespace plume::gpu {

Allocation& Allocation::operator=(Allocation&& other) noexcept {
  if (this == &other) return *this;
  release();
  account_ = std::exchange(other.account_, nullptr);
  owner_ = std::move(other.owner_);
  bytes_ = std::exchange(other.bytes_, 0);
  memory_ = std::move(other.memory_);
  return *this;
}

void Allocation::release() {
  if (!account_) return;
  account_->total_ -= bytes_;
  auto entry = account_->by_owner_.find(owner_);
  entry->second -= bytes_;
  if (entry->second == 0) account_->by_owner_.erase(entry);
  account_ = nullptr;
  memory_ = nullptr;
}

void Memory::init(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device,
                  uint64_t limit_bytes) {
  properties_ = physical.getMemoryProperties();
  device_ = &device;
  limit_ = limit_bytes;
}

uint32_t Memory::type_index(uint32_t allowed, bool host_visible) const {
  using Flag = vk::MemoryPropertyFlagBits;
  const vk::MemoryPropertyFlags needed =
      host_visible ? Flag::eHostVisible | Flag::eHostCoherent : vk::MemoryPropertyFlags{};
  const vk::MemoryPropertyFlags liked = host_visible ? Flag::eHostCached : Flag::eDeviceLocal;
  int best = -1;
  for (uint32_t i = 0; i < properties_.memoryTypeCount; ++i) {
    const auto flags = properties_.memoryTypes[i].propertyFlags;
    if (!(allowed & (1u << i)) || (flags & needed) != needed) continue;
    if (flags & liked) return i;
    if (best < 0) best = int(i);
  }
  if (best < 0) throw DeviceFailure("the device has no memory type that fits the resource");
  return uint32_t(best);
}

Allocation Memory::allocate(const vk::MemoryRequirements& needs, bool host_visible, bool device_address,
                            std::string_view owner, std::string_view label) {
  if (limit_ && total_ + needs.size > limit_)
    throw DeviceFailure(
        fmt::format("out of device memory: {}.{} needs {} bytes, {} of the limit of {} are in use", owner,
                    label, needs.size, total_, limit_));
  if (refused_ > 0 && --refused_ == 0)
    throw DeviceFailure(fmt::format("out of device memory: {}.{} needs {} bytes, {} are in use (injected)",
                                    owner, label, needs.size, total_));
  const vk::MemoryAllocateFlagsInfo flags{.flags = vk::MemoryAllocateFlagBits::eDeviceAddress};
  Allocation result;
  try {
    result.memory_ =
        device_->allocateMemory({.pNext = device_address ? &flags : nullptr,
                                 .allocationSize = needs.size,
                                 .memoryTypeIndex = type_index(needs.memoryTypeBits, host_visible)});
  } catch (const vk::SystemError& error) {
    throw DeviceFailure(fmt::format("out of device memory: {}.{} needs {} bytes, {} are in use ({})", owner,
                                    label, needs.size, total_, error.what()));
  }
  result.account_ = this;
  result.owner_ = owner;
  result.bytes_ = needs.size;
  total_ += needs.size;
  by_owner_[result.owner_] += needs.size;
  return result;
}

uint64_t Memory::owner_bytes(const std::string& owner) const {
  const auto entry = by_owner_.find(owner);
  return entry == by_owner_.end() ? 0 : entry->second;
}

}  // namespace plume::gpu
