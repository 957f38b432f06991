// The movie while it is being written: fragments that are complete on disk, one after the other.
#pragma once

#include <filesystem>
#include <string>

#include "output/av.h"
#include "output/file.h"

namespace weir::av {

struct MovieText {  // shown by players and ffprobe
  std::string title;
  std::string comment;
};

class PartMovie {
 public:
  PartMovie(std::filesystem::path file, const AVCodecContext& encoder, const MovieText& text);
  PartMovie(const PartMovie&) = delete;  // libav holds its address
  PartMovie& operator=(const PartMovie&) = delete;
  ~PartMovie() = default;

  void add(AVPacket& packet);              // times in the encoder's base; throws OutputError
  void close();                            // makes all packets readable; throws OutputError
  bool broken() const { return broken_; }  // the disk refused a fragment: those after it would leave a gap

 private:
  struct Close {
    void operator()(AVFormatContext* format) const;
  };
  void end_fragment();
  void flush();

  GrowingFile file_;
  std::string pending_;  // written by libav since the last flush
  std::unique_ptr<AVFormatContext, Close> format_;
  AVRational time_base_;
  int fps_;
  std::int64_t packets_ = 0;
  bool broken_ = false;
};

// `from`, the file of a PartMovie with so many packets of this encoder, becomes `to` with one index in front of the pictures.
// Throws OutputError; then `to` is as it was.
void remux_faststart(const std::filesystem::path& from, const std::filesystem::path& to, const AVCodecContext& encoder,
                     std::int64_t pictures);

}  // namespace weir::av
