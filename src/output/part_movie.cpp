#include "output/part_movie.h"

#include <fmt/format.h>

#include <cstring>

#include "core/error.h"
#include "output/encoder.h"

namespace weir::av {

namespace {

constexpr int buffer_bytes = 64 * 1024;

// More than an index takes but for its texts; and of a picture: its size, its place, and that it is a key frame.
constexpr std::int64_t index_bytes = 4096;
constexpr std::int64_t index_bytes_a_picture = 32;

std::int64_t bytes_of_texts(const AVDictionary* metadata) {
  std::int64_t bytes = 0;
  const AVDictionaryEntry* text = nullptr;
  while ((text = av_dict_get(metadata, "", text, AV_DICT_IGNORE_SUFFIX)) != nullptr)
    bytes += static_cast<std::int64_t>(std::strlen(text->value));
  return bytes;
}

int collect(void* pending, std::uint8_t* bytes, int count) {
  static_cast<std::string*>(pending)->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
  return count;
}

}  // namespace

void PartMovie::Close::operator()(AVFormatContext* format) const {
  if (format->pb != nullptr) av_freep(&format->pb->buffer);
  avio_context_free(&format->pb);
  avformat_free_context(format);
}

PartMovie::PartMovie(std::filesystem::path file, const AVCodecContext& encoder, const MovieText& text)
    : file_(std::move(file)), time_base_(encoder.time_base), fps_(encoder.framerate.num) {
  const std::string doing = "begin " + file_.path().string();
  AVFormatContext* created = nullptr;
  require(avformat_alloc_output_context2(&created, nullptr, "mp4", nullptr), doing);
  format_.reset(created);
  format_->flags |= AVFMT_FLAG_BITEXACT;  // neither the time of day nor libav's version
  auto* buffer = static_cast<std::uint8_t*>(require(av_malloc(buffer_bytes), doing));
  format_->pb = require(avio_alloc_context(buffer, buffer_bytes, 1, &pending_, nullptr, collect, nullptr), doing);
  AVStream* stream = require(avformat_new_stream(format_.get(), nullptr), doing);
  require(avcodec_parameters_from_context(stream->codecpar, &encoder), doing);
  stream->time_base = encoder.time_base;
  stream->avg_frame_rate = encoder.framerate;
  av_dict_set(&format_->metadata, "title", text.title.c_str(), 0);
  av_dict_set(&format_->metadata, "comment", text.comment.c_str(), 0);
  AVDictionary* options = nullptr;
  av_dict_set(&options, "movflags", "frag_custom+empty_moov+default_base_moof+skip_trailer", 0);
  const int code = avformat_write_header(format_.get(), &options);
  av_dict_free(&options);
  require(code, doing);
  flush();
}

void PartMovie::add(AVPacket& packet) {
  packet.duration = 1;  // in the encoder's base; the last picture of a fragment has no successor to give it
  packet.stream_index = 0;
  av_packet_rescale_ts(&packet, time_base_, format_->streams[0]->time_base);
  require(av_write_frame(format_.get(), &packet), "write " + file_.path().string());
  // Ended here and not by libav, which waits for the next key frame: a kill finds less unwritten.
  const std::int64_t in_second = ++packets_ % fps_;
  if (in_second == 0 || in_second == fragment_frames(fps_)) end_fragment();
}

void PartMovie::close() {
  end_fragment();
  require(av_write_trailer(format_.get()), "close " + file_.path().string());
  flush();
  file_.close();
}

void PartMovie::end_fragment() {
  require(av_write_frame(format_.get(), nullptr), "write " + file_.path().string());
  flush();
}

void PartMovie::flush() {
  avio_flush(format_->pb);
  if (broken_) throw OutputError(fmt::format("cannot write {}: it broke off earlier", file_.path().string()));
  broken_ = true;
  file_.append(pending_);
  pending_.clear();  // its memory stays, for fresh memory costs a page fault every few kilobytes
  broken_ = false;
}

namespace {

struct CloseOutput {
  void operator()(AVFormatContext* format) const {
    avio_closep(&format->pb);
    avformat_free_context(format);
  }
};

void copy_movie(const std::filesystem::path& from, const std::filesystem::path& to, const AVCodecContext& encoder,
                std::int64_t pictures) {
  const std::string reading = "read " + from.string();
  const std::string writing = "write " + to.string();
  const Input input = open_container(from);
  AVFormatContext* created = nullptr;
  require(avformat_alloc_output_context2(&created, nullptr, "mp4", url_of(to).c_str()), writing);
  const std::unique_ptr<AVFormatContext, CloseOutput> output(created);
  output->flags |= AVFMT_FLAG_BITEXACT;
  require(avio_open(&output->pb, output->url, AVIO_FLAG_WRITE), writing);
  const AVStream* source = input->streams[0];
  AVStream* target = require(avformat_new_stream(output.get(), nullptr), writing);
  // The container names the codec, and has its headers in the form that it needs them; not all it needs of the pictures.
  require(avcodec_parameters_copy(target->codecpar, source->codecpar), writing);
  target->codecpar->width = encoder.width;
  target->codecpar->height = encoder.height;
  target->codecpar->sample_aspect_ratio = target->sample_aspect_ratio = encoder.sample_aspect_ratio;
  target->time_base = source->time_base;
  target->avg_frame_rate = encoder.framerate;
  require(av_dict_copy(&output->metadata, input->metadata, 0), writing);
  AVDictionary* options = nullptr;
  // Room for the index in front of the pictures; libav's own way there writes all pictures a second time.
  const std::int64_t index = index_bytes + index_bytes_a_picture * pictures + bytes_of_texts(output->metadata);
  av_dict_set_int(&options, "moov_size", index, 0);
  const int header = avformat_write_header(output.get(), &options);
  av_dict_free(&options);
  require(header, writing);
  const Packet packet(require(av_packet_alloc(), writing));
  int code = 0;
  while ((code = av_read_frame(input.get(), packet.get())) >= 0) {
    av_packet_rescale_ts(packet.get(), source->time_base, target->time_base);
    packet->pos = -1;
    require(av_write_frame(output.get(), packet.get()), writing);
    av_packet_unref(packet.get());  // the next read would not, and the whole movie would stay in memory
  }
  if (code != AVERROR_EOF) require(code, reading);
  require(av_write_trailer(output.get()), writing);
  avio_flush(output->pb);
  require(output->pb->error, writing);
  require(avio_closep(&output->pb), writing);
}

}  // namespace

void remux_faststart(const std::filesystem::path& from, const std::filesystem::path& to, const AVCodecContext& encoder,
                     std::int64_t pictures) {
  const std::filesystem::path temporary = temporary_of(to);
  try {
    copy_movie(from, temporary, encoder, pictures);
    std::filesystem::rename(temporary, to);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

}  // namespace weir::av
