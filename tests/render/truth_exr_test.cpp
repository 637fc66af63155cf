// Ground truth as OpenEXR, read by OpenEXR.
#include "render/truth/truth_exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <bit>
#include <fstream>
#include <map>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "render/truth/amodal_masks.h"
#include "render/truth/ground_truth.h"
#include "tests/base/temporary_folder.h"
#include "tests/render/painted_shapes.h"

namespace pomona {
namespace {

using nlohmann::json;

constexpr int width = 160, height = 120;

struct ReadExr {
  std::map<std::string, std::vector<float>> channel;
  std::map<std::string, std::string> text;  ///< the header's text entries
};

ReadExr read_exr(const std::string& bytes) {
  const TemporaryFolder folder;
  const std::string path = folder / "truth.exr";
  std::ofstream(path, std::ios::binary) << bytes;
  Imf::InputFile file(path.c_str(), 0);
  EXPECT_EQ(file.header().dataWindow().max.x, width - 1);
  EXPECT_EQ(file.header().dataWindow().max.y, height - 1);

  ReadExr exr;
  Imf::FrameBuffer buffer;
  for (auto c = file.header().channels().begin(); c != file.header().channels().end(); ++c) {
    EXPECT_EQ(c.channel().type, Imf::FLOAT);
    std::vector<float>& values = exr.channel[c.name()];
    values.resize(width * height);
    buffer.insert(c.name(),
                  Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float), sizeof(float) * width));
  }
  file.setFrameBuffer(buffer);
  file.readPixels(0, height - 1);
  for (auto a = file.header().begin(); a != file.header().end(); ++a) {
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
      exr.text[a.name()] = text->value();
  }
  return exr;
}

Scene hiding_balls() {
  Scene scene = testing::still_life();
  scene.ground = false;
  return scene;
}

ReadExr truth_of(const Scene& scene) {
  const std::vector<TruthFile> files = ground_truth(
      scene, {.width = width, .height = height, .file_name = "x.png", .made_by = "pomona", .format = TruthFormat::exr});
  EXPECT_EQ(files.size(), 2u);
  EXPECT_EQ(files.at(0).name, "truth.exr");
  EXPECT_EQ(files.at(1).name, "annotations.json");
  return read_exr(files.at(0).bytes);
}

TEST(TruthExr, HoldsTheLayersAsTheyAre) {
  const Scene scene = hiding_balls();
  const ReadExr exr = truth_of(scene);
  const TruthLayers layers = truth_layers(scene, truth_naming(scene), width, height);
  const std::vector<Mask> amodal = amodal_masks(scene, width, height);
  for (std::size_t i = 0; i < layers.instance.size(); ++i) {
    ASSERT_EQ(exr.channel.at("Instance.X")[i], layers.instance[i]);
    ASSERT_EQ(exr.channel.at("Fruit.X")[i], layers.fruit[i]);
    ASSERT_EQ(exr.channel.at("Part.X")[i], layers.part[i]);
    ASSERT_EQ(exr.channel.at("Section.X")[i], layers.section[i]);
    ASSERT_EQ(exr.channel.at("Depth.Z")[i], layers.depth[i]);
    for (int k = 0; k < 3; ++k) ASSERT_EQ(exr.channel.at(std::string("Normal.") + "XYZ"[k])[i], layers.normal[i][k]);
    for (std::size_t n = 0; n < amodal.size(); ++n) {
      const bool bit = (static_cast<int>(exr.channel.at("Amodal1.X")[i]) >> n & 1) != 0;
      ASSERT_EQ(bit, amodal[n].at(static_cast<int>(i % width), static_cast<int>(i / width)));
    }
  }
}

/// The id of a kind's entries in the header.
std::string key_of(const ReadExr& exr, const std::string& kind) {
  for (const auto& [key, value] : exr.text) {
    if (key.starts_with("cryptomatte/") && key.ends_with("/name") && value == kind)
      return key.substr(0, key.size() - 4);
  }
  ADD_FAILURE() << "no " << kind;
  return {};
}

/// Like a compositor: names by the manifest, shares of pixels from the ranks.
TEST(TruthExr, HasCryptomattesThatTellWhatCoversPixels) {
  const Scene scene = hiding_balls();
  const ReadExr exr = truth_of(scene);
  const TruthNaming names = truth_naming(scene);
  const TruthLayers samples = truth_layers(scene, names, 2 * width, 2 * height);
  for (const std::string kind : {"CryptoObject", "CryptoAsset", "CryptoMaterial"}) {
    const std::string key = key_of(exr, kind);
    EXPECT_EQ(exr.text.at(key + "hash"), "MurmurHash3_32");
    EXPECT_EQ(exr.text.at(key + "conversion"), "uint32_to_float32");
  }
  const json manifest = json::parse(exr.text.at(key_of(exr, "CryptoObject") + "manifest"));
  ASSERT_EQ(manifest.size(), scene.instances.size());
  int mixed = 0;
  for (std::size_t n = 0; n < scene.instances.size(); ++n) {
    const std::uint32_t hash =
        static_cast<std::uint32_t>(std::stoul(manifest.at(scene.instances[n].name).get<std::string>(), nullptr, 16));
    EXPECT_EQ(hash, cryptomatte_hash(scene.instances[n].name));
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        float share = 0;
        for (const char* layer : {"CryptoObject00", "CryptoObject01"}) {
          for (const char* rank : {".R.G", ".B.A"}) {
            const std::string name = layer;
            const std::size_t i = static_cast<std::size_t>(y) * width + x;
            const float id = exr.channel.at(name + std::string(rank, 2))[i];
            if (std::bit_cast<std::uint32_t>(id) == hash) share += exr.channel.at(name + std::string(rank + 2, 2))[i];
          }
        }
        int covered = 0;
        for (int k = 0; k < 4; ++k)
          covered += samples.instance[samples.pixel(2 * x + k % 2, 2 * y + k / 2)] == n + 1 ? 1 : 0;
        ASSERT_EQ(share, 0.25f * static_cast<float>(covered));
        mixed += covered == 1 || covered == 2 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(mixed, 50);
}

TEST(Cryptomatte, HashesAsItsSpecificationSays) {
  EXPECT_EQ(cryptomatte_hash("hello"), 0x248bfa47u);  // MurmurHash3_x86_32, seed 0
  EXPECT_EQ(cryptomatte_hash(""), 0x00800000u);       // 0 is no ordinary float: its exponent's last bit is flipped
}

TEST(Cryptomatte, RanksTheLargestShareFirst) {
  // One pixel of four samples: 7 twice, 3 and 5 once.
  const Cryptomatte matte = cryptomatte("CryptoObject", {"a", "b", "c", "d", "e", "f", "g"}, {5, 7, 7, 3}, 1, 1, 2);
  using Rank = std::pair<std::uint16_t, float>;
  EXPECT_THAT(matte.coverage, ::testing::ElementsAre(Rank(7, 0.5f), Rank(3, 0.25f), Rank(5, 0.25f), Rank(0, 0.0f)));
}

TEST(TruthExr, IsTheSameEveryTime) {
  const Scene scene = hiding_balls();
  TruthOptions options;
  options.width = 40, options.height = 30;
  options.format = TruthFormat::exr;
  EXPECT_EQ(ground_truth(scene, options).at(0).bytes, ground_truth(scene, options).at(0).bytes);
}

}  // namespace
}  // namespace pomona
