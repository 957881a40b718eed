#include "sandbox/report/pictures.h"

#include <webp/encode.h>

#include <algorithm>
#include <map>
#include <new>
#include <set>
#include <tuple>

#include "sandbox/measure/image_io.h"
#include "sandbox/measure/small_picture.h"

namespace plume {
namespace {

constexpr int kLeastWidth = 160;  // pixels: with fewer, smoke is no longer to be judged
constexpr float kQuality = 80;    // of 100

std::string base64(const std::vector<uint8_t>& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = std::min<size_t>(3, bytes.size() - i);
    uint32_t word = 0;
    for (size_t k = 0; k < 3; ++k) word = word << 8 | (k < left ? bytes[i + k] : 0u);
    for (size_t k = 0; k < 4; ++k) out += k <= left ? kDigits[(word >> (18 - 6 * k)) & 63] : '=';
  }
  return out;
}

uint64_t base64_size(uint64_t bytes) {
  return (bytes + 2) / 3 * 4;
}

std::vector<uint8_t> webp_bytes(const DisplayImage& image) {
  uint8_t* encoded = nullptr;
  const size_t size = WebPEncodeRGB(image.pixels.front().data(), image.width, image.height, 3 * image.width,
                                    kQuality, &encoded);
  if (size == 0) throw std::bad_alloc();  // a picture of this size fails for nothing else
  std::vector<uint8_t> bytes(encoded, encoded + size);
  WebPFree(encoded);
  return bytes;
}

std::vector<uint8_t> divided(const std::filesystem::path& file, int divisor) {
  if (divisor == 1) return read_file(file);
  const DisplayImage whole = read_png(file);
  return webp_bytes(
      small_picture(whole, {std::max(1, whole.width / divisor), std::max(1, whole.height / divisor)}));
}

PagePictures divided(const std::filesystem::path& folder, const std::vector<std::string>& files,
                     int divisor) {
  PagePictures pictures{.all = {}, .divisor = divisor};
  for (const std::string& file : files)
    pictures.all.push_back({.file = file, .base64 = base64(divided(folder / file, divisor))});
  return pictures;
}

}  // namespace

uint64_t PagePictures::bytes() const {
  uint64_t sum = 0;
  for (const PagePicture& picture : all) sum += picture.base64.size();
  return sum;
}

std::vector<std::string> picture_files(const Results& results) {
  using Moment = std::tuple<std::string, uint32_t, uint32_t, uint32_t, uint32_t, uint32_t>;
  std::map<Moment, size_t> met;
  std::multimap<size_t, const FrameResult*> in_turn;
  for (const FrameResult& f : results.frames)
    in_turn.insert({met[{f.scene, f.tick, f.shot, f.width, f.height, f.seed}]++, &f});
  std::vector<std::string> files;
  std::set<std::string> known{""};
  for (const auto member : {&FrameResult::image, &FrameResult::error_map})
    for (const auto& [turn, frame] : in_turn)
      if (known.insert(frame->*member).second) files.push_back(frame->*member);
  return files;
}

PagePictures page_pictures(const std::filesystem::path& folder, const std::vector<std::string>& files,
                           uint64_t most_bytes) {
  static_assert(sizeof(DisplayImage{}.pixels[0]) == 3);
  std::vector<std::string> present;  // --resume may keep frames whose pictures are gone
  for (const std::string& file : files)
    if (std::filesystem::exists(folder / file)) present.push_back(file);
  if (present.empty()) return {};

  const int width = read_png(folder / present.front()).width;
  uint64_t whole = 0;
  for (const std::string& file : present) whole += base64_size(std::filesystem::file_size(folder / file));
  // Bytes hardly shrink faster than pixels do: divisors before this one need not be tried.
  int divisor = 1;
  while (whole / uint64_t(divisor * divisor) > most_bytes && width / (2 * divisor) >= kLeastWidth)
    divisor *= 2;

  PagePictures pictures = divided(folder, present, divisor);
  while (pictures.bytes() > most_bytes && width / (2 * divisor) >= kLeastWidth)
    pictures = divided(folder, present, divisor *= 2);
  uint64_t sum = 0;
  for (PagePicture& picture : pictures.all)
    if (sum + picture.base64.size() <= most_bytes) {
      sum += picture.base64.size();
    } else {
      picture.base64.clear();
      ++pictures.left_out;
    }
  return pictures;
}

}  // namespace plume
