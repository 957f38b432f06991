// How much two pictures, movies or run folders differ, and whether that is more than allowed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "frame/image.h"

namespace weir {

struct ComparisonOptions {
  int max = 0;                       // a pixel differs if any channel is off by more than this many 1/255
  double fraction = 0;               // of the pixels of a picture that may differ
  std::filesystem::path difference;  // where the picture of the differences goes; empty: nowhere
};

// Of one pair of pictures of the same size; channels R, G, B, A in 1/255.
struct PictureDifference {
  int max = 0;
  double mean = 0;
  double psnr = 0;            // dB, over all channels; infinite if equal
  double fraction_above = 0;  // of the pixels, that differ by more than options.max
};

// One part of the comparison: a picture, a movie, the state hash, the log.
struct ComparisonItem {
  std::string name;                               // "dam_break.mp4", "frames/frame_00012.png", "state_hash"
  bool same = false;                              // within tolerance
  std::string text;                               // why not, or how close
  std::optional<PictureDifference> pixels;        // of a movie: of its worst frame
  std::optional<std::int64_t> first_frame_apart;  // of a movie
};

struct ComparisonResult {
  bool same = false;  // every item is
  std::vector<ComparisonItem> items;
  std::filesystem::path difference;  // written, of the worst picture; empty: not asked for or nothing to show
  std::string text() const;          // a line per item
  std::string json() const;          // the same as JSON
};

// Two PNGs, two movies or two run folders. A file that one side lacks, or of another size, is a difference. Throws
// OutputError for files that cannot be read, and if the two are of different kinds.
ComparisonResult compare(const std::filesystem::path& a, const std::filesystem::path& b,
                         const ComparisonOptions& options);

PictureDifference difference_of(const Image& a, const Image& b, int max);  // sizes must be equal
// The difference, bright on black: the absolute difference of each colour, amplified so that the largest is white.
Image difference_picture(const Image& a, const Image& b);

}  // namespace weir
