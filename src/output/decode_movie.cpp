// Movies back to pictures, and the facts of the file.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <string>

#include "core/error.h"
#include "output/av.h"
#include "output/movie_module.h"

namespace weir::av {

namespace {

// Whether the index comes before the pictures, from the file's own boxes: length and type, 64-bit length if that is 1,
// up to the end of the file if it is 0.
bool index_comes_first(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const auto big_endian = [&in](int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | static_cast<std::uint8_t>(in.get());
    return value;
  };
  while (in) {
    const std::streamoff start = in.tellg();
    std::uint64_t length = big_endian(4);
    std::string type(4, '\0');
    in.read(type.data(), 4);
    if (type == "moov") return true;
    if (type == "mdat" || type == "moof") return false;
    if (length == 1) length = big_endian(8);
    if (length < 8) return false;
    in.seekg(start + static_cast<std::streamoff>(length));
  }
  return false;
}

std::string or_unknown(const char* name) { return name != nullptr ? name : "unknown"; }

class Decoder {
 public:
  explicit Decoder(const std::filesystem::path& file)
      : reading_("read " + file.string()), input_(open_input(file)), frame_(require(av_frame_alloc(), reading_)) {
    const AVCodec* codec = nullptr;
    stream_ =
        input_->streams[require(av_find_best_stream(input_.get(), AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0), reading_)];
    codec_.reset(require(avcodec_alloc_context3(codec), reading_));
    require(avcodec_parameters_to_context(codec_.get(), stream_->codecpar), reading_);
    codec_->thread_count = 2;
    require(avcodec_open2(codec_.get(), codec, nullptr), reading_);
  }

  // Calls take(frame, seconds) for every picture.
  template <class Take>
  void decode(const Take& take) {
    const Packet packet(require(av_packet_alloc(), reading_));
    int code = 0;
    while ((code = av_read_frame(input_.get(), packet.get())) >= 0) {
      if (packet->stream_index == stream_->index) {
        require(avcodec_send_packet(codec_.get(), packet.get()), reading_);
        receive(take);
      }
      av_packet_unref(packet.get());
    }
    if (code != AVERROR_EOF) require(code, reading_);
    require(avcodec_send_packet(codec_.get(), nullptr), reading_);
    receive(take);
  }

  MovieFacts facts() const {
    MovieFacts facts;
    facts.width = codec_->width;
    facts.height = codec_->height;
    facts.codec = or_unknown(avcodec_get_name(codec_->codec_id));
    facts.profile = or_unknown(avcodec_profile_name(codec_->codec_id, codec_->profile));
    facts.pixel_format = or_unknown(av_get_pix_fmt_name(codec_->pix_fmt));
    facts.color_space = or_unknown(av_color_space_name(codec_->colorspace));
    facts.color_primaries = or_unknown(av_color_primaries_name(codec_->color_primaries));
    facts.color_transfer = or_unknown(av_color_transfer_name(codec_->color_trc));
    facts.color_range = or_unknown(av_color_range_name(codec_->color_range));
    facts.frame_rate = av_q2d(stream_->avg_frame_rate);
    return facts;
  }

 private:
  template <class Take>
  void receive(const Take& take) {
    for (;;) {
      const int code = avcodec_receive_frame(codec_.get(), frame_.get());
      if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
      require(code, reading_);
      take(*frame_, static_cast<double>(frame_->best_effort_timestamp) * av_q2d(stream_->time_base));
    }
  }

  std::string reading_;
  Input input_;
  Frame frame_;
  Codec codec_;
  const AVStream* stream_ = nullptr;
};

Image picture(const AVFrame& frame, Scaler& scaler) {
  if (!scaler) {
    scaler = bt709_scaler(frame.width, frame.height, static_cast<AVPixelFormat>(frame.format), AV_PIX_FMT_RGBA);
  }
  Image image{.width = frame.width, .height = frame.height, .rgba = {}};
  image.rgba.resize(4 * static_cast<std::size_t>(frame.width) * frame.height);
  std::uint8_t* rows = image.rgba.data();
  const int stride = 4 * frame.width;
  require(sws_scale(scaler.get(), frame.data, frame.linesize, 0, frame.height, &rows, &stride), "convert colours");
  return image;
}

}  // namespace

}  // namespace weir::av

void weir_decode_movie(const std::filesystem::path& file,
                       const std::function<void(std::int64_t index, const weir::Image& image)>& each,
                       weir::MovieFacts& facts) {
  using namespace weir::av;
  keep_messages();
  Decoder decoder(file);
  weir::MovieFacts found;
  std::vector<double> times;
  Scaler scaler;
  decoder.decode([&](const AVFrame& frame, double time) {
    if (each) each(static_cast<std::int64_t>(times.size()), picture(frame, scaler));
    times.push_back(time);
  });
  found = decoder.facts();
  found.frames = static_cast<std::int64_t>(times.size());
  found.faststart = index_comes_first(file);
  if (!times.empty()) {
    found.first_time = times.front();
    found.last_time = times.back();
  }
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double error = std::abs(times[k] - static_cast<double>(k) / found.frame_rate);
    found.max_time_error = std::max(found.max_time_error, error);
  }
  said();  // a movie that was cut off makes the decoder talk
  facts = found;
}
