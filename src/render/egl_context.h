// An OpenGL 4.5 core context without window system and without surface: drawing goes to framebuffer objects alone.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/renderer.h"

namespace weir {

class EglContext {
 public:
  // The first device of the choice that works. Throws DeviceError with all that were tried.
  static std::unique_ptr<EglContext> open(const DeviceChoice& choice);

  // Every device, in the order in which "auto" tries them.
  static std::vector<DeviceTrial> try_all();

  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current() const;
  const std::string& gl_renderer() const { return gl_renderer_; }
  bool is_processor() const;  // nothing but the processor draws

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
