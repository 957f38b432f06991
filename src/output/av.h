// libav's objects owned, its error numbers thrown, its messages kept for the error's text.
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

// From now on nothing of libav goes to stderr: its errors wait for said(). Once is enough, more does no harm.
void keep_messages();
// What libav said since the last call, in brackets with a leading space; empty if nothing.
std::string said();
std::string text_of(int error);  // libav's name of an error

// Throws OutputError "cannot <doing>: <text> (<what libav said>)" if `code` is negative; else returns it.
int require(int code, const std::string& doing);
// The same for a function that returns null when memory is out.
template <class T>
T* require(T* pointer, const std::string& doing) {
  if (pointer == nullptr) require(AVERROR(ENOMEM), doing);
  return pointer;
}

// What the file's own headers say of it. Throws OutputError.
Input open_container(const std::filesystem::path& file);
// And what its first pictures say, which takes decoding them. Throws OutputError.
Input open_input(const std::filesystem::path& file);
// A file's name that libav never takes for a protocol's, whatever it contains.
std::string url_of(const std::filesystem::path& file);

// From YUV to full-range RGBA, by the tags that a movie has. What it does not say is taken as in H.264: samples of chroma
// beside the left edge of their pixels.
struct YuvKind {
  AVPixelFormat format = AV_PIX_FMT_YUV420P;
  AVColorSpace matrix = AVCOL_SPC_BT709;
  AVColorRange range = AVCOL_RANGE_MPEG;
  AVChromaLocation chroma = AVCHROMA_LOC_LEFT;
};
Scaler rgba_scaler(int width, int height, const YuvKind& yuv);

}  // namespace weir::av
