// Owners of libav's objects, its error numbers as exceptions, its messages kept for their text.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/imgutils.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <filesystem>
#include <memory>
#include <string>

namespace weir::av {

struct Release {
  void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};
struct CloseInput {
  void operator()(AVFormatContext* format) const { avformat_close_input(&format); }
};
using Codec = std::unique_ptr<AVCodecContext, Release>;
using Frame = std::unique_ptr<AVFrame, Release>;
using Packet = std::unique_ptr<AVPacket, Release>;
using Input = std::unique_ptr<AVFormatContext, CloseInput>;
using Scaler = std::unique_ptr<SwsContext, Release>;

// Keeps libav's messages for take_messages() from now on, away from stderr. Further calls change nothing.
void keep_messages();
// libav's messages since the last call, in brackets with a leading space; empty if none.
std::string take_messages();
std::string text_of(int error);  // libav's name of an error

// Throws OutputError "cannot <doing>: <text> (<libav's messages>)" if `code` is negative; else returns it.
int require(int code, const std::string& doing);
// The same for a function that returns null when memory is out.
template <class T>
T* require(T* pointer, const std::string& doing) {
  if (pointer == nullptr) require(AVERROR(ENOMEM), doing);
  return pointer;
}

// A file by its headers alone. Throws OutputError.
Input open_container(const std::filesystem::path& file);
// Also by its first pictures, which are decoded for it. Throws OutputError.
Input open_input(const std::filesystem::path& file);
// A file's name as a URL, so that libav takes no part of it for a protocol.
std::string url_of(const std::filesystem::path& file);

// From YUV to full-range RGBA, by a movie's tags. Defaults are those of H.264: samples of chroma beside the left edge of
// their pixels.
struct YuvKind {
  AVPixelFormat format = AV_PIX_FMT_YUV420P;
  AVColorSpace matrix = AVCOL_SPC_BT709;
  AVColorRange range = AVCOL_RANGE_MPEG;
  AVChromaLocation chroma = AVCHROMA_LOC_LEFT;
};
Scaler rgba_scaler(int width, int height, const YuvKind& yuv);

}  // namespace weir::av
