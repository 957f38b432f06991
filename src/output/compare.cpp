#include "output/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "core/error.h"
#include "output/compare_logs.h"
#include "output/decode.h"
#include "output/file.h"
#include "output/manifest.h"
#include "output/sink.h"

namespace weir {

namespace {

namespace fs = std::filesystem;

enum class Kind { picture, movie, folder };

Kind kind_of(const fs::path& path) {
  if (fs::is_directory(path)) return Kind::folder;
  if (!fs::exists(path)) throw OutputError(fmt::format("cannot compare {}: it is not there", path.string()));
  if (path.extension() == ".png") return Kind::picture;
  if (path.extension() == ".mp4") return Kind::movie;
  throw OutputError(fmt::format("cannot compare {}: neither .png, .mp4 nor a run folder", path.string()));
}

bool worse(const PictureDifference& a, const PictureDifference& b) {
  return std::pair(a.fraction_above, a.max) > std::pair(b.fraction_above, b.max);
}

std::string sizes(int width_a, int height_a, int width_b, int height_b) {
  return fmt::format("{} x {} against {} x {} pixels", width_a, height_a, width_b, height_b);
}

class Comparison {
 public:
  explicit Comparison(const ComparisonOptions& options) : options_(options) {}

  void pictures(const std::string& name, const fs::path& a, const fs::path& b) {
    const Image image_a = read_png(a);
    const Image image_b = read_png(b);
    if (image_a.width != image_b.width || image_a.height != image_b.height) {
      add(name, false, sizes(image_a.width, image_a.height, image_b.width, image_b.height));
      return;
    }
    const PictureDifference difference = difference_of(image_a, image_b, options_.max);
    show(difference, image_a, image_b);
    ComparisonItem& item = add(name, difference.fraction_above <= options_.fraction, described(difference));
    item.pixels = difference;
  }

  void movies(const std::string& name, const fs::path& a, const fs::path& b) {
    const std::unique_ptr<MovieReader> reader_a = make_movie_reader(a);
    const std::unique_ptr<MovieReader> reader_b = make_movie_reader(b);
    const MovieFacts before_a = reader_a->facts();
    const MovieFacts before_b = reader_b->facts();
    if (before_a.width != before_b.width || before_a.height != before_b.height) {
      add(name, false, sizes(before_a.width, before_a.height, before_b.width, before_b.height));
      return;
    }
    Image image_a;
    Image image_b;
    std::optional<PictureDifference> worst;
    std::int64_t worst_frame = 0;
    std::optional<std::int64_t> first_apart;
    std::int64_t frame = 0;
    bool more_a = reader_a->next(&image_a);
    bool more_b = reader_b->next(&image_b);
    for (; more_a && more_b; ++frame, more_a = reader_a->next(&image_a), more_b = reader_b->next(&image_b)) {
      const PictureDifference difference = difference_of(image_a, image_b, options_.max);
      show(difference, image_a, image_b);
      if (!first_apart && difference.fraction_above > options_.fraction) first_apart = frame;
      if (worst && !worse(difference, *worst)) continue;
      worst = difference;
      worst_frame = frame;
    }
    while (more_a) more_a = reader_a->next(nullptr);
    while (more_b) more_b = reader_b->next(nullptr);
    const MovieFacts facts_a = reader_a->facts();
    const MovieFacts facts_b = reader_b->facts();
    std::string text = fmt::format("{} frames", facts_a.frames);
    if (facts_a.frames != facts_b.frames) text = fmt::format("{} against {} frames", facts_a.frames, facts_b.frames);
    if (facts_a.frame_rate != facts_b.frame_rate) {
      text += fmt::format(", {} against {} frames a second", facts_a.frame_rate, facts_b.frame_rate);
    }
    if (first_apart) text += fmt::format(", apart from frame {} on", *first_apart);
    if (worst) text += fmt::format("; frame {} most: {}", worst_frame, described(*worst));
    const bool same = !first_apart && facts_a.frames == facts_b.frames && facts_a.frame_rate == facts_b.frame_rate;
    ComparisonItem& item = add(name, same, text);
    item.pixels = worst;
    item.first_frame_apart = first_apart;
  }

  void folders(const fs::path& a, const fs::path& b) {
    std::map<std::string, fs::path> found_a = pictures_in(a);
    std::map<std::string, fs::path> found_b = pictures_in(b);
    std::set<std::string> names;
    for (const auto& [name, path] : found_a) names.insert(name);
    for (const auto& [name, path] : found_b) names.insert(name);
    for (const std::string& name : names) {
      if (!found_a.contains(name) || !found_b.contains(name)) {
        add(name, false, fmt::format("only in {}", (found_a.contains(name) ? a : b).string()));
      } else if (found_a[name].extension() == ".png") {
        pictures(name, found_a[name], found_b[name]);
      } else {
        movies(name, found_a[name], found_b[name]);
      }
    }
    // A tolerance for pixels covers the state behind them: hash and log are then reported, but decide nothing.
    const bool exact = names.empty() || (options_.max == 0 && options_.fraction == 0);
    state_hashes(a, b, exact);
    logs(a, b, exact);
    if (result_.items.empty()) {
      throw OutputError(fmt::format("cannot compare {} and {}: neither holds a run", a.string(), b.string()));
    }
  }

  ComparisonResult result() {
    result_.same = std::ranges::all_of(result_.items, &ComparisonItem::same);
    if (worst_shown_ && !options_.difference.empty()) {
      write_png(options_.difference, difference_, false, {.scene_sha256 = {}, .version = WEIR_VERSION}, 0);
      result_.difference = options_.difference;
    }
    return std::move(result_);
  }

 private:
  ComparisonItem& add(const std::string& name, bool same, const std::string& text) {
    result_.items.push_back({.name = name, .same = same, .text = text, .pixels = {}, .first_frame_apart = {}});
    return result_.items.back();
  }

  std::string described(const PictureDifference& difference) const {
    if (difference.max == 0) return "the same pixels";
    return fmt::format("largest difference {}/255, mean {:.3g}/255, PSNR {:.1f} dB, {:.4g} % of the pixels over {}/255",
                       difference.max, difference.mean, difference.psnr, 100 * difference.fraction_above, options_.max);
  }

  // Keeps the picture of the worst pair.
  void show(const PictureDifference& difference, const Image& a, const Image& b) {
    if (options_.difference.empty() || difference.max == 0) return;
    if (worst_shown_ && !worse(difference, *worst_shown_)) return;
    worst_shown_ = difference;
    difference_ = difference_picture(a, b);
  }

  // PNGs and movies below a run folder by their names in it. A run has one movie, named after its scene: it is compared
  // whatever its name.
  static std::map<std::string, fs::path> pictures_in(const fs::path& folder) {
    std::map<std::string, fs::path> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      const fs::path& path = entry.path();
      if (path.extension() == ".png") found[path.lexically_relative(folder).string()] = path;
      if (path.extension() == ".mp4") found[path.stem().extension() == ".part" ? "part movie" : "movie"] = path;
    }
    return found;
  }

  void state_hashes(const fs::path& a, const fs::path& b, bool decides) {
    if (!both_hold(a, b, "manifest.json")) return;
    const std::string hash_a = read_manifest(a / "manifest.json").state_hash;
    const std::string hash_b = read_manifest(b / "manifest.json").state_hash;
    const bool same = hash_a == hash_b;
    add("state_hash", same || !decides, same ? "the same" : fmt::format("{} against {}", hash_a, hash_b));
  }

  void logs(const fs::path& a, const fs::path& b, bool decides) {
    if (!both_hold(a, b, "log.csv")) return;
    ComparisonItem item = compare_logs(read_file(a / "log.csv"), read_file(b / "log.csv"));
    item.same = item.same || !decides;
    result_.items.push_back(std::move(item));
  }

  // A file that one side lacks is a difference of its own.
  bool both_hold(const fs::path& a, const fs::path& b, const char* name) {
    const bool in_a = fs::exists(a / name);
    const bool in_b = fs::exists(b / name);
    if (in_a != in_b) add(name, false, fmt::format("only in {}", (in_a ? a : b).string()));
    return in_a && in_b;
  }

  const ComparisonOptions& options_;
  ComparisonResult result_;
  std::optional<PictureDifference> worst_shown_;
  Image difference_;
};

}  // namespace

ComparisonResult compare(const fs::path& a, const fs::path& b, const ComparisonOptions& options) {
  const Kind kind = kind_of(a);
  if (kind != kind_of(b)) {
    throw OutputError(fmt::format("cannot compare {} with {}: give two pictures, two movies or two run folders",
                                  a.string(), b.string()));
  }
  Comparison comparison(options);
  switch (kind) {
    case Kind::picture:
      comparison.pictures(a.filename().string(), a, b);
      break;
    case Kind::movie:
      comparison.movies(a.filename().string(), a, b);
      break;
    case Kind::folder:
      comparison.folders(a, b);
      break;
  }
  return comparison.result();
}

std::string ComparisonResult::text() const {
  std::string text;
  for (const ComparisonItem& item : items) {
    text += fmt::format("{} {}: {}\n", item.same ? "same     " : "DIFFERENT", item.name, item.text);
  }
  if (!difference.empty()) text += fmt::format("difference picture: {}\n", difference.string());
  return text;
}

std::string ComparisonResult::json() const {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const ComparisonItem& item : items) {
    Json entry{{"name", item.name}, {"same", item.same}, {"text", item.text}};
    if (item.pixels) {
      entry["max"] = item.pixels->max;
      entry["mean"] = item.pixels->mean;
      entry["psnr_db"] = item.pixels->psnr;  // null: infinite, the pixels are equal
      entry["fraction_above"] = item.pixels->fraction_above;
    }
    if (item.first_frame_apart) entry["first_frame_apart"] = *item.first_frame_apart;
    list.push_back(std::move(entry));
  }
  Json json{{"same", same}, {"items", std::move(list)}};
  if (!difference.empty()) json["difference"] = difference.string();
  return json.dump(2) + '\n';
}

}  // namespace weir
