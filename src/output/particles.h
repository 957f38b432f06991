// Particle files for ParaView: one of VTK's XML files of points for each instant, and the collection that names them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "frame/snapshot.h"

namespace weir {

inline constexpr const char* particle_collection_name = "particles.pvd";
std::string particle_file_name(std::int64_t number);  // "particles_00000.vtp"

// The fluid of a snapshot as the content of a .vtp file: positions in the scene's coordinates, in double precision where
// the snapshot's are exact, and its fields under their names, in SI units. Vectors have three components in 2D too.
std::string particle_file(const Snapshot& snapshot);

// Each file is whole, and so is the collection, which names those that are there, whenever this process ends. Throws
// OutputError.
class ParticleWriter {
 public:
  explicit ParticleWriter(std::filesystem::path folder);
  void write(const Snapshot& snapshot);

 private:
  void write_collection() const;

  std::filesystem::path folder_;
  std::int64_t count_ = 0;
  std::string entries_;  // of the collection
};

}  // namespace weir
