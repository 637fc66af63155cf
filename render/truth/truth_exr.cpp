#include "render/truth/truth_exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <list>
#include <utility>

namespace pomona {

namespace {

/// OpenEXR writes at any position, and tables at the beginning last.
class BytesInMemory : public Imf::OStream {
 public:
  BytesInMemory() : Imf::OStream("memory") {}
  void write(const char c[], int n) override {
    const auto count = static_cast<std::size_t>(n);
    if (bytes_.size() < place_ + count) bytes_.resize(place_ + count);
    bytes_.replace(place_, count, c, count);
    place_ += count;
  }
  std::uint64_t tellp() override { return place_; }
  void seekp(std::uint64_t place) override { place_ = static_cast<std::size_t>(place); }

  std::string bytes() && { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::size_t place_ = 0;
};

/// Channels of floats, one value per pixel. They are computed a few rows at a time, because a large heap has hundreds
/// of channels.
class FloatChannels {
 public:
  FloatChannels(int width, int height) : header_(width, height), width_(width), height_(height) {
    header_.compression() = Imf::ZIP_COMPRESSION;
  }

  Imf::Header& header() { return header_; }

  /// \param value of a pixel, by its index. What it refers to must exist until written().
  template <typename Value>
  void add(const std::string& name, const Value& value) {
    add_rows(name, [value, width = width_](int top, int bottom) {
      std::vector<float> values;
      const std::size_t end = static_cast<std::size_t>(bottom + 1) * width;
      for (std::size_t i = static_cast<std::size_t>(top) * width; i < end; ++i) values.push_back(value(i));
      return values;
    });
  }

  /// \param rows of the picture, both included.
  void add_rows(const std::string& name, std::function<std::vector<float>(int top, int bottom)> rows) {
    header_.channels().insert(name, Imf::Channel(Imf::FLOAT));
    channels_.emplace_back(name, std::move(rows));
  }

  std::string written() const {
    BytesInMemory bytes;
    {
      Imf::OutputFile file(bytes, header_, 0);  // 0: no threads of OpenEXR's own
      constexpr int at_once = 16;               // the number of rows that ZIP packs together
      for (int top = 0; top < height_; top += at_once) write_rows(file, top, std::min(top + at_once, height_) - 1);
    }
    return std::move(bytes).bytes();
  }

 private:
  void write_rows(Imf::OutputFile& file, int top, int bottom) const {
    std::list<std::vector<float>> values;  // memory of the buffer's slices
    Imf::FrameBuffer buffer;
    const std::size_t row = sizeof(float) * static_cast<std::size_t>(width_);
    const Imath::Box2i window({0, top}, {width_ - 1, bottom});
    for (const auto& [name, rows] : channels_) {
      float* const first = values.emplace_back(rows(top, bottom)).data();
      buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(float), row));
    }
    file.setFrameBuffer(buffer);
    file.writePixels(bottom - top + 1);
  }

  Imf::Header header_;
  int width_, height_;
  std::vector<std::pair<std::string, std::function<std::vector<float>(int top, int bottom)>>> channels_;
};

void add_cryptomatte(const Cryptomatte& matte, FloatChannels& channels) {
  std::vector<float> hash{0};
  for (const std::string& name : matte.names) hash.push_back(std::bit_cast<float>(cryptomatte_hash(name)));
  const auto entry = [&matte](std::size_t pixel, int rank) {
    if (rank >= matte.ranks) return std::pair<std::uint16_t, float>(0, 0.0f);
    return matte.coverage[pixel * static_cast<std::size_t>(matte.ranks) + static_cast<std::size_t>(rank)];
  };
  // Two ranks per layer: R and G are hash and share of the first, B and A of the second.
  for (int rank = 0; rank < matte.ranks; rank += 2) {
    const std::string layer = matte.name + (rank < 20 ? "0" : "") + std::to_string(rank / 2);
    channels.add(layer + ".R", [=](std::size_t i) { return hash[entry(i, rank).first]; });
    channels.add(layer + ".G", [=](std::size_t i) { return entry(i, rank).second; });
    channels.add(layer + ".B", [=](std::size_t i) { return hash[entry(i, rank + 1).first]; });
    channels.add(layer + ".A", [=](std::size_t i) { return entry(i, rank + 1).second; });
  }
  for (const auto& [key, value] : matte.metadata()) channels.header().insert(key, Imf::StringAttribute(value));
}

}  // namespace

std::string write_truth_exr(const TruthLayers& layers, std::span<const Mask> amodal,
                            std::span<const Cryptomatte> mattes, const std::string& made_by) {
  FloatChannels channels(layers.width, layers.height);
  const auto add_numbers = [&](const std::string& name, const std::vector<std::uint16_t>& numbers) {
    channels.add(name, [&numbers](std::size_t i) { return static_cast<float>(numbers[i]); });
  };
  add_numbers("Instance.X", layers.instance);
  add_numbers("Fruit.X", layers.fruit);
  add_numbers("Part.X", layers.part);
  if (shows_organs(layers)) add_numbers("Organ.X", layers.organ);
  channels.add("Section.X", [&](std::size_t i) { return static_cast<float>(layers.section[i]); });
  channels.add("Depth.Z", [&](std::size_t i) { return layers.depth[i]; });
  for (int k = 0; k < 3; ++k)
    channels.add(std::string("Normal.") + "XYZ"[k], [&layers, k](std::size_t i) { return layers.normal[i][k]; });
  for (std::size_t n = 0; n < amodal_pictures(amodal.size()); ++n) {
    channels.add_rows("Amodal" + std::to_string(n + 1) + ".X", [&layers, amodal, n](int top, int bottom) {
      const std::vector<std::uint16_t> rows = amodal_rows(amodal, n, layers.width, top, bottom);
      return std::vector<float>(rows.begin(), rows.end());
    });
  }
  for (const Cryptomatte& matte : mattes) add_cryptomatte(matte, channels);
  channels.header().insert("software", Imf::StringAttribute(made_by));
  return channels.written();
}

}  // namespace pomona
