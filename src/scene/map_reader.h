// The visitor that reads a map of the document into a struct, by the field table.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/leaves.h"

namespace weir {

// The keys of a struct whose description has only fields.
class KeyCollector {
 public:
  template <class T>
  static std::vector<std::string_view> of() {
    KeyCollector collector;
    T value{};
    describe(collector, value);
    return collector.keys_;
  }
  template <class T>
  void field(std::string_view key, T&&, const Spec&) {
    keys_.push_back(key);
  }

 private:
  std::vector<std::string_view> keys_;
};

class MapReader {
 public:
  // `dimension` 0: not known. A node that is no map is complained about, and reads as an empty one.
  MapReader(std::vector<Mistake>& mistakes, const Node& node, std::string path, int dimension);

  template <class T>
  void field(std::string_view key, T&& value, const Spec& spec) {
    if (const Node* node = find(key)) {
      leaf(key).read(*node, std::forward<T>(value), spec);
    } else if (spec.required) {
      missing(key);
    }
  }

  template <class Describer>
  void group(std::string_view key, std::string_view, Describer describer) {
    static const Node absent = [] {
      Node node;
      node.kind = Node::Kind::map;
      return node;
    }();
    const Node* node = find(key);
    MapReader sub(mistakes_, node != nullptr ? *node : absent, joined(path_, key), dimension_);
    if (node == nullptr) {
      sub.at_ = at_;  // keys missing in it are missing here
      sub.quiet_ = quiet_;
    }
    describer(sub);
    sub.finish();
  }

  template <class T>
  void list(std::string_view key, std::vector<T>& values, const Spec& spec) {
    const Node* node = find(key);
    if (node == nullptr) {
      if (spec.required) missing(key);
      return;
    }
    if (node->kind != Node::Kind::list) {
      return leaf(key).complain(*node, fmt::format("expects a list, got {}", content(*node)));
    }
    if (node->children.size() < static_cast<std::size_t>(spec.least)) {
      return leaf(key).complain(*node, fmt::format("needs at least {}, got {}", spec.least, node->children.size()));
    }
    values.clear();
    for (std::size_t i = 0; i < node->children.size(); ++i) {
      T value{};
      MapReader sub(mistakes_, node->children[i], joined(joined(path_, key), fmt::format("{}", i)), dimension_);
      describe(sub, value);
      sub.finish();
      values.push_back(std::move(value));
    }
  }

  template <class Variant, class More, class... T>
  void one_of(Variant& value, More more, const Named<T>&... alternatives) {
    std::vector<std::string_view> names;
    const auto offer = [&](const auto& alternative) {
      if (fits(alternative.dimension)) names.push_back(alternative.key);
    };
    (offer(alternatives), ...);
    std::string_view taken;
    (try_alternative(value, more, alternatives, taken), ...);
    if (taken.empty() && !quiet_) {
      add(at_, path_,
          fmt::format("{}needs one of the keys {}", path_.empty() ? "" : path_ + " ", fmt::join(names, ", ")));
    }
  }

  template <class Variant, class... T>
  void one_field_of(Variant& value, const Leaf<T>&... leaves) {
    std::string_view taken;
    (try_leaf(value, leaves, taken), ...);
  }

  template <class Variant, class... Form>
  void forms(std::string_view key, Variant& value, std::string_view, const Form&... all) {
    const Node* node = find(key);
    if (node == nullptr) return;
    if (node->kind == Node::Kind::map) {
      read_best_map(*node, key, value, all...);
    } else if (!(try_word(*node, value, all) || ...)) {
      std::vector<std::string> expected;
      (add_expected(expected, all), ...);
      leaf(key).complain(*node, fmt::format("expects {}, got {}", fmt::join(expected, ", or "), content(*node)));
    }
  }

  template <class Variant, class... T>
  void by_dimension(Variant& value, const Map<T>&... maps) {
    const auto read = [&](auto* type, int dimension) {
      using Kind = std::remove_pointer_t<decltype(type)>;
      if (dimension_ != dimension) return;
      Kind kind{};
      describe(*this, kind);
      value = kind;
    };
    (read(static_cast<T*>(nullptr), maps.dimension), ...);
    const auto know = [&](const std::vector<std::string_view>& keys) {
      if (dimension_ == 0) known_.insert(known_.end(), keys.begin(), keys.end());
    };
    (know(KeyCollector::of<T>()), ...);
  }

  template <class T>
  void toggle(std::string_view key, std::optional<T>& value, std::string_view) {
    const Node* node = find(key);
    if (node == nullptr) return;
    if (node->kind == Node::Kind::map) {
      T read{};
      MapReader sub(mistakes_, *node, joined(path_, key), dimension_);
      describe(sub, read);
      sub.finish();
      value = read;
    } else if (node->kind == Node::Kind::scalar && !node->quoted && (node->text == "true" || node->text == "false")) {
      value = node->text == "true" ? std::optional<T>(T{}) : std::nullopt;
    } else {
      leaf(key).complain(*node, fmt::format("expects true, false or a map, got {}", content(*node)));
    }
  }

  template <class T>
  void option(std::string_view key, std::optional<T>& value, std::string_view) {
    const Node* node = find(key);
    if (node == nullptr) return;
    T read{};
    MapReader sub(mistakes_, *node, joined(path_, key), dimension_);
    describe(sub, read);
    sub.finish();
    value = read;
  }

  void version(std::string_view key, int number);
  void not_built(std::string_view key, EmptyForm empty, std::string_view meaning);

  // Call last: keys that no field asked for.
  void finish();
  // Set if the document is of another format version; then no other mistake is reported.
  const std::optional<Mistake>& other_version() const { return other_version_; }

 private:
  const Node* find(std::string_view key) {
    known_.push_back(key);
    return map_ != nullptr ? child(*map_, key) : nullptr;
  }
  LeafReader leaf(std::string_view key) { return {mistakes_, joined(path_, key), dimension_}; }
  bool fits(int dimension) const { return dimension == 0 || dimension_ == 0 || dimension == dimension_; }
  void add(Position at, std::string path, std::string message) {
    mistakes_.push_back({at, std::move(path), std::move(message)});
  }
  void missing(std::string_view key);

  template <class Variant, class More, class T>
  void try_alternative(Variant& value, More more, const Named<T>& alternative, std::string_view& taken) {
    const Node* node = find(alternative.key);
    if (node == nullptr) return;
    const std::string path = joined(path_, alternative.key);
    if (!taken.empty()) {
      return add(node->at, path, fmt::format("{} stands beside {}; give one of them", path, joined(path_, taken)));
    }
    taken = alternative.key;
    if (!fits(alternative.dimension)) {
      return add(
          node->at, path,
          fmt::format("{} is for {}D scenes; this one has dimension {}", path, alternative.dimension, dimension_));
    }
    T kind{};
    MapReader sub(mistakes_, *node, path, dimension_);
    describe(sub, kind);
    more(sub);
    sub.finish();
    value = std::move(kind);
  }

  template <class Variant, class T>
  void try_leaf(Variant& value, const Leaf<T>& alternative, std::string_view& taken) {
    const Node* node = find(alternative.key);
    if (node == nullptr) return;
    const std::string path = joined(path_, alternative.key);
    if (!taken.empty()) {
      return add(node->at, path, fmt::format("{} stands beside {}; give one of them", path, joined(path_, taken)));
    }
    taken = alternative.key;
    T kind{};
    leaf(alternative.key).read(*node, kind.*alternative.member, alternative.spec);
    value = kind;
  }

  template <class Variant, class T>
  bool try_word(const Node& node, Variant& value, const Word<T>& form) {
    if (node.kind != Node::Kind::scalar || node.text != form.word) return false;
    value = T{};
    return true;
  }
  template <class Variant, class T>
  bool try_word(const Node&, Variant&, const Map<T>&) {
    return false;
  }
  template <class T>
  void add_expected(std::vector<std::string>& expected, const Word<T>& form) {
    expected.emplace_back(form.word);
  }
  template <class T>
  void add_expected(std::vector<std::string>& expected, const Map<T>& form) {
    if (fits(form.dimension)) expected.push_back(fmt::format("a map of {}", fmt::join(KeyCollector::of<T>(), ", ")));
  }

  // Of the maps that the value can be, the one that knows most of its keys.
  template <class Variant, class... Form>
  void read_best_map(const Node& node, std::string_view key, Variant& value, const Form&... all) {
    std::ptrdiff_t best = -1;
    std::vector<std::string_view> others;
    const auto rate = [&](const auto& form) { best = std::max(best, known_keys(node, form)); };
    (rate(all), ...);
    bool done = false;
    const auto collect = [&](const auto& form) { collect_keys(form, others); };
    (collect(all), ...);
    const auto read = [&](const auto& form) {
      if (done || known_keys(node, form) != best) return;
      done = true;
      read_map(node, key, value, form, others);
    };
    (read(all), ...);
  }
  template <class T>
  std::ptrdiff_t known_keys(const Node& node, const Map<T>& form) const {
    if (!fits(form.dimension)) return -2;
    const std::vector<std::string_view> keys = KeyCollector::of<T>();
    return std::count_if(keys.begin(), keys.end(), [&](std::string_view key) { return child(node, key) != nullptr; });
  }
  template <class T>
  std::ptrdiff_t known_keys(const Node&, const Word<T>&) const {
    return -2;
  }
  template <class T>
  void collect_keys(const Map<T>&, std::vector<std::string_view>& keys) const {
    for (const std::string_view key : KeyCollector::of<T>()) keys.push_back(key);
  }
  template <class T>
  void collect_keys(const Word<T>&, std::vector<std::string_view>&) const {}
  template <class Variant, class T>
  void read_map(const Node& node, std::string_view key, Variant& value, const Map<T>&,
                const std::vector<std::string_view>& others) {
    T kind{};
    MapReader sub(mistakes_, node, joined(path_, key), dimension_);
    sub.foreign_ = others;
    describe(sub, kind);
    sub.finish();
    value = kind;
  }
  template <class Variant, class T>
  void read_map(const Node&, std::string_view, Variant&, const Word<T>&, const std::vector<std::string_view>&) {}

  std::vector<Mistake>& mistakes_;
  const Node* map_;
  std::string path_;
  int dimension_;
  Position at_;
  bool quiet_ = false;                     // missing keys have been reported
  std::vector<std::string_view> known_;    // keys asked for
  std::vector<std::string_view> foreign_;  // keys of another form of this value
  std::optional<Mistake> other_version_;
};

}  // namespace weir
