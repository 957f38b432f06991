// The movie sink: pictures to packets, to the part file, at the end to the movie. Entered by weir_open_movie.
#include <fmt/format.h>

#include <array>
#include <string>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "output/encoder.h"
#include "output/movie_module.h"
#include "output/part_movie.h"

namespace weir::av {

namespace {

std::filesystem::path part_file(const std::filesystem::path& folder, const Scene& scene) {
  return folder / (scene.name + ".part.mp4");
}

EncoderSettings settings_of(const Scene& scene) {
  return {.width = scene.render.size[0],
          .height = scene.render.size[1],
          .fps = scene.render.fps,
          .movie = scene.output.movie.value_or(Movie{})};
}

MovieText text_of(const Scene& scene, const Provenance& provenance) {
  return {.title = scene.title,
          .comment = fmt::format("weir {}, scene SHA-256 {}", provenance.version, provenance.scene_sha256)};
}

void copy_plane(const std::vector<std::uint8_t>& from, int width, int height, std::uint8_t* to, int stride) {
  av_image_copy_plane(to, stride, from.data(), width, width, height);
}

// The frame refers to this memory without owning it.
void lend_plane(const std::vector<std::uint8_t>& from, int width, int plane, AVFrame& frame) {
  auto* samples = const_cast<std::uint8_t*>(from.data());
  av_buffer_unref(&frame.buf[plane]);
  frame.buf[plane] = require(av_buffer_create(
                                 samples, from.size(), [](void*, std::uint8_t*) {}, nullptr, AV_BUFFER_FLAG_READONLY),
                             "hold a picture");
  frame.data[plane] = samples;
  frame.linesize[plane] = width;
}

class LibavSink final : public MovieSink {
 public:
  LibavSink(const std::filesystem::path& folder, const Scene& scene, const Provenance& provenance)
      : movie_(folder / (scene.name + ".mp4")),
        encoder_(open_encoder(settings_of(scene))),
        name_(encoder_->codec->name),
        part_(std::make_unique<PartMovie>(part_file(folder, scene), *encoder_, text_of(scene, provenance))),
        part_path_(part_file(folder, scene)),
        frame_(require(av_frame_alloc(), "hold a picture")),
        lends_(name_ == "libx264"),
        packet_(require(av_packet_alloc(), "hold a packet")) {
    frame_->width = encoder_->width;
    frame_->height = encoder_->height;
    frame_->format = encoder_->pix_fmt;
    if (!lends_) require(av_frame_get_buffer(frame_.get(), 0), "hold a picture");
  }

  ~LibavSink() override {
    try {
      if (part_ && !part_->broken()) close_part();
    } catch (const OutputError&) {
      // The pictures before stay readable, and the error that ended the sink's life is already being reported.
      part_.reset();
    }
  }
  LibavSink(const LibavSink&) = delete;
  LibavSink& operator=(const LibavSink&) = delete;

  void write(const MovieImage& image) override {
    if (image.width != encoder_->width || image.height != encoder_->height) {
      throw OutputError(fmt::format("cannot put a picture of {} x {} pixels into {}, which is {} x {}", image.width,
                                    image.height, movie_.string(), encoder_->width, encoder_->height));
    }
    if (lends_) {
      lend_plane(image.y, image.width, 0, *frame_);
      lend_plane(image.cb, image.width / 2, 1, *frame_);
      lend_plane(image.cr, image.width / 2, 2, *frame_);
    } else {
      require(av_frame_make_writable(frame_.get()), "hold a picture");
      copy_plane(image.y, image.width, image.height, frame_->data[0], frame_->linesize[0]);
      copy_plane(image.cb, image.width / 2, image.height / 2, frame_->data[1], frame_->linesize[1]);
      copy_plane(image.cr, image.width / 2, image.height / 2, frame_->data[2], frame_->linesize[2]);
    }
    frame_->pts = next_++;
    encode(frame_.get());
  }

  void finish() override {
    close_part();
    if (next_ == 0) return;
    remux_faststart(part_path_, movie_, *encoder_, next_);
    std::error_code ignored;  // a part file too many does no harm
    std::filesystem::remove(part_path_, ignored);
  }

  const std::string& encoder() const override { return name_; }

 private:
  // No picture: drains the encoder.
  void encode(const AVFrame* picture) {
    const std::string doing = "encode " + movie_.string();
    require(avcodec_send_frame(encoder_.get(), picture), doing);
    for (;;) {
      const int code = avcodec_receive_packet(encoder_.get(), packet_.get());
      if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
      require(code, doing);
      part_->add(*packet_);
    }
  }

  void close_part() {
    if (next_ > 0) encode(nullptr);
    part_->close();
    part_.reset();
    std::error_code ignored;
    if (next_ == 0) std::filesystem::remove(part_path_, ignored);
  }

  std::filesystem::path movie_;
  Codec encoder_;
  std::string name_;
  std::unique_ptr<PartMovie> part_;  // null once closed
  std::filesystem::path part_path_;
  Frame frame_;
  bool lends_;  // libx264 copies a frame before avcodec_send_frame() returns; other encoders may read it later
  Packet packet_;
  std::int64_t next_ = 0;  // number of the next picture
};

}  // namespace

}  // namespace weir::av

void weir_open_movie(const std::filesystem::path& folder, const weir::Scene& scene, const weir::Provenance& provenance,
                     std::unique_ptr<weir::MovieSink>& sink) {
  weir::av::keep_messages();
  sink = std::make_unique<weir::av::LibavSink>(folder, scene, provenance);
}

void weir_list_encoders(std::vector<std::string>& names) {
  weir::av::keep_messages();
  names = weir::av::usable_encoders();
}
