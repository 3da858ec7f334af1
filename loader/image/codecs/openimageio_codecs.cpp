#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <orris/image/codecs/image_codecs.h>

namespace orris {
namespace {

/// The first line of OpenImageIO's text; its further lines repeat the first.
std::string firstLine(std::string text) {
  if (const size_t end = text.find('\n'); end != std::string::npos) text.resize(end);
  return text.empty() ? "unknown reason" : text;
}

/// Values as stored: OpenImageIO otherwise multiplies colour by alpha when it reads.
OIIO::ImageSpec asStored() {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  return config;
}

class OiioReader : public PictureReader {
 public:
  bool openMemory(const std::string& bytes, const std::string& format, std::string& reason) {
    memory_ = std::make_unique<OIIO::Filesystem::IOMemReader>(bytes.data(), bytes.size());
    input_ = OIIO::ImageInput::create(format);
    OIIO::ImageSpec spec;
    const bool opened = input_ && input_->supports("ioproxy") &&
                        input_->set_ioproxy(memory_.get()) &&
                        input_->open("memory." + format, spec, asStored());
    return opened ? take(spec) : refuse(reason);
  }
  bool openFile(const std::string& path, std::string& reason) {
    const OIIO::ImageSpec config = asStored();
    input_ = OIIO::ImageInput::open(path, &config);
    return input_ ? take(input_->spec()) : refuse(reason);
  }
  std::optional<std::string> read(std::uint8_t* pixels) override {
    return read(OIIO::TypeDesc::UINT8, pixels);
  }
  std::optional<std::string> read(float* pixels) override {
    return read(OIIO::TypeDesc::FLOAT, pixels);
  }

 private:
  bool take(const OIIO::ImageSpec& spec) {
    width = spec.width;
    height = spec.height;
    depth = spec.depth;
    channels = spec.nchannels;
    return true;
  }
  bool refuse(std::string& reason) const {
    reason = firstLine(input_ ? input_->geterror() : OIIO::geterror());
    return false;
  }
  std::optional<std::string> read(OIIO::TypeDesc type, void* pixels) {
    if (input_->read_image(0, 0, 0, channels, type, pixels)) return std::nullopt;
    return firstLine(input_->geterror());
  }

  std::unique_ptr<OIIO::Filesystem::IOMemReader> memory_;  // outlives input_, which reads from it
  std::unique_ptr<OIIO::ImageInput> input_;
};

OIIO::ImageSpec specOf(const PictureToWrite& picture, const std::string& extension) {
  OIIO::ImageSpec spec(picture.width, picture.height, picture.channels,
                       picture.storeBytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  if (!picture.channelNames.empty()) {
    spec.channelnames = picture.channelNames;
    spec.alpha_channel = -1;
  }
  // The OpenEXR writer stamps the present time unless it is given one.
  if (extension != ".png") spec.attribute("DateTime", "1970:01:01 00:00:00");
  return spec;
}

std::unique_ptr<OIIO::ImageOutput> outputFor(const std::string& extension) {
  auto output = OIIO::ImageOutput::create(extension.empty() ? "" : extension.substr(1));
  if (!output) OIIO::geterror();  // else it prints the message when the process ends
  return output;
}

class OiioCodecs : public ImageCodecs {
 public:
  std::unique_ptr<PictureReader> open(const std::string& bytes, const std::string& format,
                                      std::string& reason) const override {
    auto reader = std::make_unique<OiioReader>();
    return reader->openMemory(bytes, format, reason) ? std::move(reader) : nullptr;
  }
  std::unique_ptr<PictureReader> open(const std::string& path, std::string& reason) const override {
    auto reader = std::make_unique<OiioReader>();
    return reader->openFile(path, reason) ? std::move(reader) : nullptr;
  }
  bool canWrite(const std::string& extension) const override {
    return outputFor(extension) != nullptr;
  }
  std::optional<std::string> write(const std::string& path, const std::string& extension,
                                   const PictureToWrite& picture) const override {
    const auto output = outputFor(extension);
    if (!output) return "no such format";
    const OIIO::TypeDesc type = picture.bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
    const void* pixels = picture.bytes ? static_cast<const void*>(picture.bytes) : picture.floats;
    if (output->open(path, specOf(picture, extension)) && output->write_image(type, pixels) &&
        output->close())
      return std::nullopt;
    return firstLine(output->geterror());
  }
};

}  // namespace
}  // namespace orris

extern "C" const orris::ImageCodecs* orrisImageCodecs() {
  static const orris::OiioCodecs codecs;
  return &codecs;
}
