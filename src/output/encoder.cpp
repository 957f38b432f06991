#include "output/encoder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/error.h"

namespace weir::av {

namespace {

// Fixed, not taken from the machine: the bytes of a movie depend on the number of threads. The fastest presets encode more
// than a hundred pictures of 1080p a second on one thread, and more would take a third more of the processor.
int encoder_threads(const Movie& movie) { return movie.preset == "ultrafast" || movie.preset == "superfast" ? 1 : 4; }
constexpr int lookahead_frames = 10;
// The mean quantiser of the pictures that follow from others is that much above the rate factor: 0.5 to 7, more where more
// moves (seven scenes, 1080p).
constexpr int quantiser_above_rate_factor = 5;
constexpr std::array<std::string_view, 10> x264_presets = {"ultrafast", "superfast", "veryfast", "faster",   "fast",
                                                           "medium",    "slow",      "slower",   "veryslow", "placebo"};

bool takes_yuv420p(const AVCodec& codec) {
  for (const AVPixelFormat* format = codec.pix_fmts; format != nullptr && *format != AV_PIX_FMT_NONE; ++format) {
    if (*format == AV_PIX_FMT_YUV420P) return true;
  }
  return false;
}

// All that libav was built with and that take pictures from memory, the preferred ones first.
std::vector<std::string> known_encoders() {
  std::vector<std::string> names;
  for (const char* name : {"libx264", "libopenh264"}) {
    if (avcodec_find_encoder_by_name(name) != nullptr) names.emplace_back(name);
  }
  void* position = nullptr;
  while (const AVCodec* codec = av_codec_iterate(&position)) {
    const std::string_view name = codec->name;
    if (av_codec_is_encoder(codec) && codec->id == AV_CODEC_ID_H264 && name.starts_with("h264_") &&
        takes_yuv420p(*codec)) {
      names.emplace_back(name);
    }
  }
  if (avcodec_find_encoder_by_name("mpeg4") != nullptr) names.emplace_back("mpeg4");
  return names;
}

void set(AVCodecContext& codec, const char* option, const std::string& value) {
  require(av_opt_set(codec.priv_data, option, value.c_str(), 0),
          fmt::format("set {} of encoder {} to {}", option, codec.codec->name, value));
}

// For libopenh264 and the hardware encoders, which differ in their options and are on no test machine: unknown options
// stay at their defaults.
void ask(AVCodecContext& codec, const char* option, const std::string& value) {
  if (codec.priv_data != nullptr) av_opt_set(codec.priv_data, option, value.c_str(), 0);
}

// A preset chosen for one encoder must exist there; one given with `auto` is meant for libx264, as the default is.
void set_other_preset(AVCodecContext& codec, const Movie& movie) {
  if (movie.encoder == "auto" || movie.preset == Movie{}.preset) return;
  if (codec.priv_data == nullptr || av_opt_set(codec.priv_data, "preset", movie.preset.c_str(), 0) < 0) {
    throw OutputError(
        fmt::format("output.movie.preset: {} has no {}{}", codec.codec->name, movie.preset, take_messages()));
  }
}

void tune_x264(AVCodecContext& codec, const EncoderSettings& settings) {
  // Checked first: x264 itself would complain on stderr.
  if (std::ranges::find(x264_presets, settings.movie.preset) == x264_presets.end()) {
    throw OutputError(fmt::format("output.movie.preset: libx264 has no {}; there are {}", settings.movie.preset,
                                  fmt::join(x264_presets, ", ")));
  }
  set(codec, "preset", settings.movie.preset);
  // 0 would mean lossless, which profile High cannot express.
  const int quality = std::max(settings.movie.quality, 1);
  if (settings.movie.preset == "ultrafast") {
    // With neither look-ahead nor adaptive quantisers all that a rate factor does is to choose each picture's quantiser, and
    // the measuring for that is a fifth of the encoder's work.
    set(codec, "qp", fmt::format("{}", std::min(quality + quantiser_above_rate_factor, 51)));
  } else {
    set(codec, "crf", fmt::format("{}", quality));
  }
  set(codec, "sc_threshold", "0");  // no key frames but those a second apart
  // The profile that a stream is marked with follows from the tools it may use, and the fastest presets leave out the
  // one that makes it High. `profile` alone only forbids tools, it never switches them on.
  set(codec, "profile", "high");
  set(codec, "8x8dct", "1");
  // Pictures in hand: one for each further thread and one for x264's own look-ahead thread, then the look-ahead.
  const int room = allowed_delay(settings.fps);
  codec.thread_count = std::clamp(room - 1, 1, encoder_threads(settings.movie));
  codec.thread_type = FF_THREAD_FRAME;
  const int in_threads = codec.thread_count > 1 ? codec.thread_count : 0;
  set(codec, "rc-lookahead", fmt::format("{}", std::min(lookahead_frames, room - in_threads)));
}

void tune_mpeg4(AVCodecContext& codec, const EncoderSettings& settings) {
  // The quantiser that steps as wide as H.264's: 2 Q = 2^((QP - 4) / 6).
  const int quantiser = static_cast<int>(std::lround(std::exp2((settings.movie.quality - 4) / 6.0) / 2));
  codec.flags |= AV_CODEC_FLAG_QSCALE;
  codec.global_quality = FF_QP2LAMBDA * std::clamp(quantiser, 1, 31);
  set(codec, "sc_threshold", "1000000000");  // no key frames but those a second apart
  codec.thread_count = 1;                    // its threads are slices, which change the bytes
}

void tune_unseen(AVCodecContext& codec, const EncoderSettings& settings) {
  const int quality = std::clamp(settings.movie.quality, 1, 51);
  codec.qmin = codec.qmax = quality;
  ask(codec, "rc", "constqp");
  ask(codec, "qp", fmt::format("{}", quality));
  ask(codec, "profile", "high");
  ask(codec, "delay", "0");
  // For encoders that take rates alone: a tenth of a bit per pixel at 23, twice that for every 6 below.
  const double pixels_per_second = static_cast<double>(settings.width) * settings.height * settings.fps;
  codec.bit_rate = std::llround(pixels_per_second * 0.1 * std::exp2((23 - quality) / 6.0));
}

Codec open_named(const std::string& name, const EncoderSettings& settings) {
  const AVCodec* codec = avcodec_find_encoder_by_name(name.c_str());
  if (codec == nullptr) throw OutputError(fmt::format("libav was built without {}", name));
  Codec context(require(avcodec_alloc_context3(codec), "open encoder " + name));
  context->width = settings.width;
  context->height = settings.height;
  context->pix_fmt = AV_PIX_FMT_YUV420P;
  context->time_base = {1, settings.fps};
  context->framerate = {settings.fps, 1};
  context->sample_aspect_ratio = {1, 1};
  context->gop_size = settings.fps;
  context->max_b_frames = 0;
  context->colorspace = AVCOL_SPC_BT709;
  context->color_primaries = AVCOL_PRI_BT709;
  context->color_trc = AVCOL_TRC_BT709;
  context->color_range = AVCOL_RANGE_MPEG;
  context->chroma_sample_location = AVCHROMA_LOC_LEFT;
  context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT;
  context->strict_std_compliance = FF_COMPLIANCE_NORMAL;
  if (name == "libx264") {
    tune_x264(*context, settings);
  } else {
    set_other_preset(*context, settings.movie);
    name == "mpeg4" ? tune_mpeg4(*context, settings) : tune_unseen(*context, settings);
  }
  require(avcodec_open2(context.get(), codec, nullptr), "open encoder " + name);
  take_messages();  // warnings of a success must not show up in a later error
  return context;
}

}  // namespace

int fragment_frames(int fps) { return (fps + 1) / 2; }

int allowed_delay(int fps) { return fps - fragment_frames(fps); }

Codec open_encoder(const EncoderSettings& settings) {
  const std::vector<std::string> known = known_encoders();
  const std::string& wanted = settings.movie.encoder;
  if (wanted != "auto") {
    if (std::ranges::find(known, wanted) == known.end()) {
      throw OutputError(fmt::format("output.movie.encoder: there is no {} here; usable: auto, {}", wanted,
                                    fmt::join(usable_encoders(), ", ")));
    }
    return open_named(wanted, settings);
  }
  std::string tried;
  for (const std::string& name : known) {
    try {
      return open_named(name, settings);
    } catch (const OutputError& error) {
      tried += fmt::format("\n  {}", error.what());
    }
  }
  throw OutputError(fmt::format("no video encoder works here; install libav with libx264. Tried:{}",
                                tried.empty() ? " none, libav was built without any" : tried));
}

std::vector<std::string> usable_encoders() {
  std::vector<std::string> usable;
  for (const std::string& name : known_encoders()) {
    try {
      open_named(name, {.width = 640, .height = 360, .fps = 30, .movie = {}});
      usable.push_back(name);
    } catch (const OutputError&) {
      continue;  // compiled in, but its device or driver is missing
    }
  }
  return usable;
}

}  // namespace weir::av
