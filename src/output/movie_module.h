// The functions of the module weir_movie. Exceptions pass through.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "output/decode.h"
#include "output/sink.h"

extern "C" {
void weir_open_movie(const std::filesystem::path& folder, const weir::Scene& scene, const weir::Provenance& provenance,
                     std::unique_ptr<weir::MovieSink>& sink);
void weir_list_encoders(std::vector<std::string>& names);
void weir_read_movie(const std::filesystem::path& file, std::unique_ptr<weir::MovieReader>& reader);
}
