// Movies back to pictures, and the facts of the file.
#include <fmt/format.h>

#include <algorithm>
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

class LibavReader final : public MovieReader {
 public:
  explicit LibavReader(const std::filesystem::path& file)
      : reading_("read " + file.string()),
        input_(open_input(file)),
        frame_(require(av_frame_alloc(), reading_)),
        packet_(require(av_packet_alloc(), reading_)) {
    const AVCodec* codec = nullptr;
    stream_ =
        input_->streams[require(av_find_best_stream(input_.get(), AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0), reading_)];
    codec_.reset(require(avcodec_alloc_context3(codec), reading_));
    require(avcodec_parameters_to_context(codec_.get(), stream_->codecpar), reading_);
    codec_->thread_count = 2;
    require(avcodec_open2(codec_.get(), codec, nullptr), reading_);
    facts_.faststart = index_comes_first(file);
    facts_.frame_rate = av_q2d(stream_->avg_frame_rate);
  }

  bool next(Image* image) override {
    int code = 0;
    while ((code = avcodec_receive_frame(codec_.get(), frame_.get())) == AVERROR(EAGAIN)) feed();
    take_messages();  // messages about a movie that was cut off; errors are in the returned code
    if (code == AVERROR_EOF) return false;
    require(code, reading_);
    if (image != nullptr) convert(*image);
    const double time = static_cast<double>(frame_->best_effort_timestamp) * av_q2d(stream_->time_base);
    const double due = static_cast<double>(facts_.frames) / facts_.frame_rate;
    if (facts_.frames == 0) facts_.first_time = time;
    facts_.last_time = time;
    facts_.max_time_error = std::max(facts_.max_time_error, std::abs(time - due));
    ++facts_.frames;
    return true;
  }

  MovieFacts facts() const override {
    MovieFacts facts = facts_;
    facts.width = codec_->width;
    facts.height = codec_->height;
    facts.codec = or_unknown(avcodec_get_name(codec_->codec_id));
    facts.profile = or_unknown(avcodec_profile_name(codec_->codec_id, codec_->profile));
    facts.pixel_format = or_unknown(av_get_pix_fmt_name(codec_->pix_fmt));
    facts.color_space = or_unknown(av_color_space_name(codec_->colorspace));
    facts.color_primaries = or_unknown(av_color_primaries_name(codec_->color_primaries));
    facts.color_transfer = or_unknown(av_color_transfer_name(codec_->color_trc));
    facts.color_range = or_unknown(av_color_range_name(codec_->color_range));
    return facts;
  }

 private:
  // The next packet of the stream goes in; at the end of the file, the decoder is drained.
  void feed() {
    int code = 0;
    while ((code = av_read_frame(input_.get(), packet_.get())) >= 0 && packet_->stream_index != stream_->index) {
      av_packet_unref(packet_.get());
    }
    if (code < 0 && code != AVERROR_EOF) require(code, reading_);
    const int sent = avcodec_send_packet(codec_.get(), code < 0 ? nullptr : packet_.get());
    av_packet_unref(packet_.get());
    require(sent, reading_);
  }

  void convert(Image& image) {
    if (image.width != frame_->width || image.height != frame_->height) {
      image = {.width = frame_->width, .height = frame_->height, .rgba = {}};
      image.rgba.resize(4 * static_cast<std::size_t>(image.width) * image.height);
    }
    if (!scaler_) {
      // By the movie's own tags, as every player does.
      scaler_ = rgba_scaler(frame_->width, frame_->height,
                            {.format = static_cast<AVPixelFormat>(frame_->format),
                             .matrix = frame_->colorspace,
                             .range = frame_->color_range,
                             .chroma = frame_->chroma_location});
    }
    std::uint8_t* rows = image.rgba.data();
    const int stride = 4 * image.width;
    require(sws_scale(scaler_.get(), frame_->data, frame_->linesize, 0, frame_->height, &rows, &stride),
            "convert colours");
  }

  std::string reading_;
  Input input_;
  Frame frame_;
  Packet packet_;
  Codec codec_;
  Scaler scaler_;
  const AVStream* stream_ = nullptr;
  MovieFacts facts_;
};

}  // namespace

}  // namespace weir::av

void weir_read_movie(const std::filesystem::path& file, std::unique_ptr<weir::MovieReader>& reader) {
  weir::av::keep_messages();
  reader = std::make_unique<weir::av::LibavReader>(file);
}
