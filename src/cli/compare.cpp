#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "cli/commands.h"
#include "cli/difference.h"
#include "output/decode.h"
#include "output/sink.h"
#include "run/queue.h"
#include "run/text_file.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::string a;
  std::string b;
  int tolerance = 0;
  double fraction = 0;
  std::string difference;
};

// Frames of one movie, decoded on a thread of its own, so that two movies can be walked side by side.
class MovieFrames {
 public:
  explicit MovieFrames(const fs::path& file) {
    for (int i = 0; i < 2; ++i) free_.push(Image{});
    thread_ = std::thread([this, file] {
      try {
        decode_movie(file, [this](std::int64_t, const Image& image) {
          std::optional<Image> buffer = free_.pop();
          if (!buffer) return;  // nobody looks any more
          *buffer = image;
          frames_.push(std::move(*buffer));
        });
      } catch (...) {
        error_ = std::current_exception();
      }
      frames_.close();
    });
  }
  ~MovieFrames() {
    free_.close();
    thread_.join();
  }
  MovieFrames(const MovieFrames&) = delete;
  MovieFrames& operator=(const MovieFrames&) = delete;

  // None after the last frame. Throws OutputError if the movie cannot be decoded.
  std::optional<Image> next() {
    std::optional<Image> image = frames_.pop();
    if (!image && error_) std::rethrow_exception(error_);
    return image;
  }
  void recycle(Image image) { free_.push(std::move(image)); }

 private:
  Queue<Image> free_;
  Queue<Image> frames_;
  std::exception_ptr error_;
  std::thread thread_;
};

void compare_movies(const fs::path& a, const fs::path& b, Comparison& comparison) {
  MovieFrames frames_a(a);
  MovieFrames frames_b(b);
  for (std::int64_t frame = 0;; ++frame) {
    std::optional<Image> image_a = frames_a.next();
    std::optional<Image> image_b = frames_b.next();
    if (!image_a && !image_b) return;
    if (!image_a || !image_b) {
      comparison.add_missing(
          fmt::format("{} ends after {} frames, the other goes on", (image_a ? b : a).string(), frame));
      return;
    }
    comparison.add(fmt::format("frame {} of {}", frame, a.filename().string()), *image_a, *image_b);
    frames_a.recycle(std::move(*image_a));
    frames_b.recycle(std::move(*image_b));
  }
}

std::set<std::string> pngs_in(const fs::path& folder) {
  std::set<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".png") names.insert(entry.path().filename().string());
  }
  return names;
}

void compare_png_folders(const fs::path& a, const fs::path& b, Comparison& comparison) {
  const std::set<std::string> names_a = pngs_in(a);
  std::set<std::string> names = pngs_in(b);
  const std::set<std::string> names_b = names;
  names.insert(names_a.begin(), names_a.end());
  for (const std::string& name : names) {
    if (!names_a.contains(name) || !names_b.contains(name)) {
      comparison.add_missing(fmt::format("{} is in {} only", name, (names_a.contains(name) ? a : b).string()));
    } else {
      comparison.add((a.filename() / name).string(), read_png(a / name), read_png(b / name));
    }
  }
}

nlohmann::json read_manifest(const fs::path& folder) {
  const fs::path file = folder / "manifest.json";
  nlohmann::json json = nlohmann::json::parse(read_text_file(file), nullptr, false);
  if (!json.is_object()) throw UsageError(fmt::format("{} is not a run folder: no {}", folder.string(), file.string()));
  return json;
}

void compare_runs(const fs::path& a, const fs::path& b, Comparison& comparison) {
  const nlohmann::json manifest_a = read_manifest(a);
  const nlohmann::json manifest_b = read_manifest(b);
  for (const std::string key : {"scene_sha256", "state_hash", "steps", "simulated_time_s"}) {
    const std::string value_a = manifest_a.value(key, nlohmann::json()).dump();
    const std::string value_b = manifest_b.value(key, nlohmann::json()).dump();
    fmt::print("{}: {}\n", key, value_a == value_b ? "same" : fmt::format("{} against {}", value_a, value_b));
  }
  compare_png_folders(a / "frames", b / "frames", comparison);
  compare_png_folders(a / "stills", b / "stills", comparison);
  const nlohmann::json movie_a = manifest_a.value("movie", nlohmann::json());
  const nlohmann::json movie_b = manifest_b.value("movie", nlohmann::json());
  if (movie_a.is_string() && movie_b.is_string()) {
    compare_movies(a / movie_a.get<std::string>(), b / movie_b.get<std::string>(), comparison);
  } else if (movie_a.is_string() || movie_b.is_string()) {
    comparison.add_missing(fmt::format("only {} has a movie", (movie_a.is_string() ? a : b).string()));
  }
  // Runs without pictures are the same if their particles are.
  if (comparison.pictures() == 0 && manifest_a.value("state_hash", "") != manifest_b.value("state_hash", "")) {
    comparison.add_missing("the particles differ");
  }
}

ExitCode compare(const Options& options) {
  const fs::path a = options.a;
  const fs::path b = options.b;
  for (const fs::path& path : {a, b}) {
    if (!fs::exists(path)) throw UsageError(fmt::format("{}: no such file or folder", path.string()));
  }
  Comparison comparison(options.tolerance, options.fraction, !options.difference.empty());
  const auto both = [&a, &b](const auto& holds) { return holds(a) && holds(b); };
  try {
    if (both([](const fs::path& path) { return fs::is_directory(path); })) {
      compare_runs(a, b, comparison);
    } else if (both([](const fs::path& path) { return path.extension() == ".png"; })) {
      comparison.add(a.filename().string(), read_png(a), read_png(b));
    } else if (both([](const fs::path& path) { return path.extension() == ".mp4"; })) {
      compare_movies(a, b, comparison);
    } else {
      throw UsageError(
          fmt::format("{} and {}: give two .png files, two .mp4 files or two run folders", options.a, options.b));
    }
  } catch (const OutputError& error) {  // here that is a file that cannot be decoded
    throw UsageError(error.what());
  }
  fmt::print("{}{}\n", comparison.facts(), comparison.same() ? "same" : "different");
  if (!options.difference.empty()) {
    if (comparison.picture().rgba.empty()) {
      throw UsageError("--difference: there is no pair of pictures of equal size to show the difference of");
    }
    write_png(options.difference, comparison.picture(), false, {"", WEIR_VERSION}, 0);
  }
  return comparison.same() ? ExitCode::done : ExitCode::internal;
}

}  // namespace

void add_compare(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("compare", "Compare two images, movies or run folders");
  const auto options = std::make_shared<Options>();
  command->add_option("a", options->a, "A .png, an .mp4 or a run folder")->type_name("A")->required();
  command->add_option("b", options->b, "Another of the same kind")->type_name("B")->required();
  command
      ->add_option("--tolerance", options->tolerance,
                   "Largest difference of a colour channel that does not count, 0 to 255; default: 0")
      ->type_name("N")
      ->check(CLI::Range(0, 255));
  command
      ->add_option("--fraction", options->fraction,
                   "Fraction of the pixels of a picture that may differ by more, 0 to 1; default: 0")
      ->type_name("F")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--difference", options->difference, "Write the largest difference as a picture")
      ->type_name("FILE.png");
  command->footer("Exit 0: the same within the tolerance. Exit 1: different.");
  command->callback([&action, options] { action = [options] { return compare(*options); }; });
}

}  // namespace weir
