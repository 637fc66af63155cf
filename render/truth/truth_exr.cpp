#include "render/truth/truth_exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <bit>
#include <cstdint>
#include <list>

namespace pomona {

namespace {

/// OpenEXR writes where it likes, tables at the beginning last.
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

/// Channels of floats, one value a pixel.
class FloatChannels {
 public:
  FloatChannels(int width, int height)
      : header_(width, height), width_(width), pixels_(static_cast<std::size_t>(width) * height) {
    header_.compression() = Imf::ZIP_COMPRESSION;
  }

  Imf::Header& header() { return header_; }

  /// \param value of a pixel, by its number.
  template <typename Value>
  void add(const std::string& name, const Value& value) {
    std::vector<float>& values = values_.emplace_back();
    values.reserve(pixels_);
    for (std::size_t i = 0; i < pixels_; ++i) values.push_back(value(i));
    header_.channels().insert(name, Imf::Channel(Imf::FLOAT));
    buffer_.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                    sizeof(float) * static_cast<std::size_t>(width_)));
  }

  std::string written() const {
    BytesInMemory bytes;
    {
      Imf::OutputFile file(bytes, header_, 0);  // 0: no threads of OpenEXR's own
      file.setFrameBuffer(buffer_);
      file.writePixels(header_.dataWindow().max.y + 1);
    }
    return std::move(bytes).bytes();
  }

 private:
  Imf::Header header_;
  int width_;
  std::size_t pixels_;
  std::list<std::vector<float>> values_;  // where the buffer's slices point
  Imf::FrameBuffer buffer_;
};

void add_cryptomatte(const Cryptomatte& matte, FloatChannels& channels) {
  std::vector<float> hash{0};
  for (const std::string& name : matte.names) hash.push_back(std::bit_cast<float>(cryptomatte_hash(name)));
  const auto entry = [&](std::size_t pixel, int rank) {
    if (rank >= matte.ranks) return std::pair<std::uint16_t, float>(0, 0.0f);
    return matte.coverage[pixel * static_cast<std::size_t>(matte.ranks) + static_cast<std::size_t>(rank)];
  };
  // Two ranks a layer: R and G are hash and share of the one, B and A of the other.
  for (int rank = 0; rank < matte.ranks; rank += 2) {
    const std::string layer = matte.name + (rank < 20 ? "0" : "") + std::to_string(rank / 2);
    channels.add(layer + ".R", [&](std::size_t i) { return hash[entry(i, rank).first]; });
    channels.add(layer + ".G", [&](std::size_t i) { return entry(i, rank).second; });
    channels.add(layer + ".B", [&](std::size_t i) { return hash[entry(i, rank + 1).first]; });
    channels.add(layer + ".A", [&](std::size_t i) { return entry(i, rank + 1).second; });
  }
  for (const auto& [key, value] : matte.metadata()) channels.header().insert(key, Imf::StringAttribute(value));
}

}  // namespace

std::string write_truth_exr(const TruthLayers& layers, std::span<const TruthPicture> amodal,
                            std::span<const Cryptomatte> mattes, const std::string& made_by) {
  FloatChannels channels(layers.width, layers.height);
  const auto add_numbers = [&](const std::string& name, const std::vector<std::uint16_t>& numbers) {
    channels.add(name, [&](std::size_t i) { return static_cast<float>(numbers[i]); });
  };
  add_numbers("Instance.X", layers.instance);
  add_numbers("Fruit.X", layers.fruit);
  add_numbers("Part.X", layers.part);
  channels.add("Section.X", [&](std::size_t i) { return static_cast<float>(layers.section[i]); });
  channels.add("Depth.Z", [&](std::size_t i) { return layers.depth[i]; });
  for (int k = 0; k < 3; ++k)
    channels.add(std::string("Normal.") + "XYZ"[k], [&](std::size_t i) { return layers.normal[i][k]; });
  for (std::size_t n = 0; n < amodal.size(); ++n)
    add_numbers("Amodal" + std::to_string(n + 1) + ".X", amodal[n].image.values);
  for (const Cryptomatte& matte : mattes) add_cryptomatte(matte, channels);
  channels.header().insert("software", Imf::StringAttribute(made_by));
  return channels.written();
}

}  // namespace pomona
