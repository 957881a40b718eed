#include "sandbox/measure/decode_exr.h"

#include <openexr.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace plume {
namespace {

constexpr std::array<uint8_t, 4> kMagic{0x76, 0x2f, 0x31, 0x01};
constexpr int kPart = 0;
constexpr std::string_view kChannels = "RGB";

/// The bytes, and the first thing that the library found wrong in them.
class File {
 public:
  explicit File(std::span<const uint8_t> bytes) : bytes_(bytes) {
    exr_context_initializer_t setup = EXR_DEFAULT_CONTEXT_INITIALIZER;
    setup.user_data = this;
    setup.size_fn = [](exr_const_context_t, void* self) {
      return static_cast<int64_t>(static_cast<File*>(self)->bytes_.size());
    };
    setup.read_fn = [](exr_const_context_t, void* self, void* to, uint64_t count, uint64_t from,
                       exr_stream_error_func_ptr_t) {
      const std::span<const uint8_t> all = static_cast<File*>(self)->bytes_;
      const std::span<const uint8_t> got = all.subspan(std::min<uint64_t>(from, all.size()));
      const size_t length = std::min<uint64_t>(count, got.size());
      std::memcpy(to, got.data(), length);
      return static_cast<int64_t>(length);
    };
    setup.error_handler_fn = [](exr_const_context_t context, exr_result_t, const char* message) {
      void* self = nullptr;
      if (exr_get_user_data(context, &self) != EXR_ERR_SUCCESS || !self) return;
      std::string& fault = static_cast<File*>(self)->fault_;
      if (fault.empty()) fault = message;  // the others follow from it
    };
    setup.max_image_width = setup.max_image_height = kMaxImageSide;
    setup.max_tile_width = setup.max_tile_height = kMaxTileSide;
    const exr_result_t result = exr_start_read(&context_, "memory", &setup);
    if (result != EXR_ERR_SUCCESS) exr_finish(&context_);
    require(result);
  }
  ~File() { exr_finish(&context_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  exr_const_context_t context() const { return context_; }
  void require(exr_result_t result) const {
    if (result == EXR_ERR_SUCCESS) return;
    throw std::runtime_error(fault_.empty() ? exr_get_default_error_message(result) : fault_);
  }

 private:
  std::span<const uint8_t> bytes_;
  std::string fault_;
  exr_context_t context_ = nullptr;
};

/// Unpacks one block of lines, or one tile, after the other.
class Decoder {
 public:
  explicit Decoder(const File& file) : file_(file) {}
  ~Decoder() {
    if (initialized_) exr_decoding_destroy(file_.context(), &pipeline_);
  }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  /// Its first pixel goes to `first`, in lines of `width` pixels.
  void decode(const exr_chunk_info_t& chunk, glm::vec3* first, int width) {
    const bool is_first = !initialized_;
    file_.require(is_first ? exr_decoding_initialize(file_.context(), kPart, &chunk, &pipeline_)
                           : exr_decoding_update(file_.context(), kPart, &chunk, &pipeline_));
    initialized_ = true;
    for (int i = 0; i < pipeline_.channel_count; ++i) {
      exr_coding_channel_info_t& channel = pipeline_.channels[i];
      const std::string_view name = channel.channel_name;
      channel.decode_to_ptr = nullptr;
      if (name.size() != 1 || kChannels.find(name) == kChannels.npos) continue;
      channel.decode_to_ptr = reinterpret_cast<uint8_t*>(&(*first)[static_cast<int>(kChannels.find(name))]);
      channel.user_data_type = EXR_PIXEL_FLOAT;
      channel.user_bytes_per_element = sizeof(float);
      channel.user_pixel_stride = sizeof(glm::vec3);
      channel.user_line_stride = width * static_cast<int>(sizeof(glm::vec3));
    }
    if (is_first) file_.require(exr_decoding_choose_default_routines(file_.context(), kPart, &pipeline_));
    file_.require(exr_decoding_run(file_.context(), kPart, &pipeline_));
  }

 private:
  const File& file_;
  exr_decode_pipeline_t pipeline_ = EXR_DECODE_PIPELINE_INITIALIZER;
  bool initialized_ = false;
};

void require_channels(const File& file) {
  const exr_attr_chlist_t* list = nullptr;
  file.require(exr_get_channels(file.context(), kPart, &list));
  const std::span<const exr_attr_chlist_entry_t> channels(list->entries, size_t(list->num_channels));
  for (const char name : kChannels) {
    const auto channel = std::ranges::find_if(channels, [&](const exr_attr_chlist_entry_t& entry) {
      return std::string_view(entry.name.str, size_t(entry.name.length)) == std::string_view(&name, 1);
    });
    if (channel == channels.end())
      throw std::runtime_error(std::string("no channel ") + name + "; R, G and B are needed");
    if (channel->x_sampling != 1 || channel->y_sampling != 1)
      throw std::runtime_error(std::string("channel ") + name + " is subsampled; it must be full size");
  }
}

// Grown as pixels arrive: a small file that claims a huge size must run out of data, not us out of memory.
void grow(Image& image, int lines) {
  image.pixels.resize(static_cast<size_t>(std::min(lines, image.height)) * image.width);
}

void decode_lines(const File& file, int first_line, Image& image) {
  int lines = 0;
  file.require(exr_get_scanlines_per_chunk(file.context(), kPart, &lines));
  Decoder decoder(file);
  for (int y = 0; y < image.height; y += lines) {
    exr_chunk_info_t chunk{};
    file.require(exr_read_scanline_chunk_info(file.context(), kPart, first_line + y, &chunk));
    grow(image, y + lines);
    decoder.decode(chunk, &image.pixels[static_cast<size_t>(y) * image.width], image.width);
  }
}

void decode_tiles(const File& file, Image& image) {
  int width = 0, height = 0;
  file.require(exr_get_tile_sizes(file.context(), kPart, 0, 0, &width, &height));
  Decoder decoder(file);
  for (int y = 0; y < image.height; y += height)
    for (int x = 0; x < image.width; x += width) {
      exr_chunk_info_t chunk{};
      file.require(exr_read_tile_chunk_info(file.context(), kPart, x / width, y / height, 0, 0, &chunk));
      grow(image, y + height);
      decoder.decode(chunk, &image.pixels[static_cast<size_t>(y) * image.width + x], image.width);
    }
}

}  // namespace

Image decode_exr(std::span<const uint8_t> bytes) {
  if (bytes.size() < kMagic.size() || !std::ranges::equal(bytes.first(kMagic.size()), kMagic))
    throw std::runtime_error("not an EXR file");
  const File file(bytes);
  exr_storage_t storage{};
  file.require(exr_get_storage(file.context(), kPart, &storage));
  if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED)
    throw std::runtime_error("a deep image, with many values a pixel; a flat one is needed");
  require_channels(file);
  exr_attr_box2i_t window{};
  file.require(exr_get_data_window(file.context(), kPart, &window));
  const int64_t width = int64_t{window.max.x} - window.min.x + 1;
  const int64_t height = int64_t{window.max.y} - window.min.y + 1;
  if (width < 1 || height < 1) throw std::runtime_error("the image has no pixels");
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  if (storage == EXR_STORAGE_TILED)
    decode_tiles(file, image);
  else
    decode_lines(file, window.min.y, image);
  return image;
}

}  // namespace plume
