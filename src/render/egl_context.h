// An OpenGL 4.5 core context without window system or surface; rendering is to framebuffer objects.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/renderer.h"

namespace weir {

class EglContext {
 public:
  // The first usable device of the choice. Throws DeviceError naming every device tried.
  static std::unique_ptr<EglContext> open(const DeviceChoice& choice);

  // Trials of every device, in the order of "auto".
  static std::vector<DeviceTrial> try_all();

  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current() const;
  const std::string& gl_renderer() const { return gl_renderer_; }
  bool is_processor() const;  // a software device

 private:
  struct Candidate;
  static std::vector<Candidate> candidates(std::vector<DeviceTrial>& trials);
  static std::unique_ptr<EglContext> try_candidate(const Candidate& candidate, DeviceTrial& trial);
  EglContext(void* display, void* context) : display_(display), context_(context) {}

  void* display_;
  void* context_;
  std::string gl_renderer_;
};

}  // namespace weir
