#include "output/av.h"

#include <fmt/format.h>

#include <array>
#include <cstdarg>
#include <mutex>
#include <utility>

#include "core/error.h"

namespace weir::av {

namespace {

std::mutex messages_mutex;  // encoders speak from their own threads
std::string messages;

void keep(void* source, int level, const char* format, va_list arguments) {
  if (level > AV_LOG_ERROR) return;
  std::array<char, 1024> line{};
  int at_start = 1;
  av_log_format_line2(source, level, format, arguments, line.data(), line.size(), &at_start);
  std::string text = line.data();
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  const std::lock_guard lock(messages_mutex);
  if (text.empty() || messages.size() > 2000) return;  // a broken file can say the same thing thousands of times
  messages += (messages.empty() ? "" : "; ") + text;
}

}  // namespace

void keep_messages() {
  static const bool once = (av_log_set_callback(keep), true);
  static_cast<void>(once);
}

std::string take_messages() {
  const std::lock_guard lock(messages_mutex);
  const std::string text = std::exchange(messages, {});
  return text.empty() ? text : fmt::format(" ({})", text);
}

std::string text_of(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(error, text.data(), text.size());
  return text.data();
}

int require(int code, const std::string& doing) {
  if (code < 0) throw OutputError(fmt::format("cannot {}: {}{}", doing, text_of(code), take_messages()));
  return code;
}

std::string url_of(const std::filesystem::path& file) { return "file:" + file.string(); }

Input open_container(const std::filesystem::path& file) {
  AVFormatContext* format = nullptr;
  require(avformat_open_input(&format, url_of(file).c_str(), nullptr, nullptr), "read " + file.string());
  return Input(format);
}

Input open_input(const std::filesystem::path& file) {
  Input input = open_container(file);
  require(avformat_find_stream_info(input.get(), nullptr), "read " + file.string());
  return input;
}

Scaler rgba_scaler(int width, int height, const YuvKind& yuv) {
  // Accurate rounding and chroma at full horizontal resolution: without them a flat colour is off by several steps.
  constexpr int quality = SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_FULL_CHR_H_INT | SWS_BITEXACT;
  const std::string doing = "convert colours";
  Scaler scaler(require(sws_alloc_context(), doing));
  const auto option = [&](const char* name, int value) {
    require(av_opt_set_int(scaler.get(), name, value, 0), doing);
  };
  option("srcw", width);
  option("srch", height);
  option("dstw", width);
  option("dsth", height);
  option("src_format", yuv.format);
  option("dst_format", AV_PIX_FMT_RGBA);
  option("sws_flags", quality);
  // In 1/256 of a pixel; without it libswscale takes the middle.
  if (yuv.format == AV_PIX_FMT_YUV420P && yuv.chroma != AVCHROMA_LOC_CENTER) option("src_h_chr_pos", 0);
  require(sws_init_context(scaler.get(), nullptr, nullptr), doing);
  const int* matrix = sws_getCoefficients(yuv.matrix);  // libswscale numbers them as libavutil does
  constexpr int unity = 1 << 16;
  require(
      sws_setColorspaceDetails(scaler.get(), matrix, yuv.range == AVCOL_RANGE_JPEG ? 1 : 0, matrix, 1, 0, unity, unity),
      doing);
  return scaler;
}

}  // namespace weir::av
