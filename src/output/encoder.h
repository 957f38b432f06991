// The encoders of this machine, and the options that set quality, speed and profile of each.
#pragma once

#include <string>
#include <vector>

#include "output/av.h"
#include "scene/scene.h"

namespace weir::av {

struct EncoderSettings {
  int width = 0;
  int height = 0;
  int fps = 0;
  Movie movie;
};

// Opens the encoder that the settings name, or for "auto" the first that opens of libx264, libopenh264, the hardware
// ones and mpeg4. Key frames come every second, B-frames never: decoding order is showing order, from time 0, in every
// player. Throws OutputError listing the encoders tried and those built in.
Codec open_encoder(const EncoderSettings& settings);

// Those that open on this machine.
std::vector<std::string> usable_encoders();

// Pictures put in but not yet taken out may be at most this many, so that they and the unflushed fragment together
// last no longer than a second. Fragments are flushed every `fragment_frames`.
int fragment_frames(int fps);
int allowed_delay(int fps);

}  // namespace weir::av
