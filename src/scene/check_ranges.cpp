// The visitor that compares the values of a scene with the ranges of the field table. A scene that was read has passed
// this already; one that was built in C++ has not.
#include <cmath>

#include "scene/checker.h"
#include "scene/describe.h"
#include "scene/document.h"
#include "scene/leaves.h"

namespace weir {

namespace {

class RangeVisitor {
 public:
  RangeVisitor(Checker& checker, std::string path) : checker_(checker), path_(std::move(path)) {}

  template <class T>
  void field(std::string_view key, T&& value, const Spec& spec) {
    check_value(joined(path_, key), value, spec);
  }
  template <class Describer>
  void group(std::string_view key, std::string_view, Describer describer) {
    RangeVisitor sub(checker_, joined(path_, key));
    describer(sub);
  }
  template <class T>
  void list(std::string_view key, std::vector<T>& values, const Spec& spec) {
    const std::string path = joined(path_, key);
    if (values.size() < static_cast<std::size_t>(spec.least))
      report(path, fmt::format("needs at least {}", spec.least));
    for (std::size_t i = 0; i < values.size(); ++i) {
      RangeVisitor sub(checker_, joined(path, fmt::format("{}", i)));
      describe(sub, values[i]);
    }
  }
  template <class Variant, class More, class... T>
  void one_of(Variant& value, More more, const Named<T>&... alternatives) {
    (visit_alternative(value, more, alternatives), ...);
  }
  template <class Variant, class... T>
  void one_field_of(Variant& value, const Leaf<T>&... leaves) {
    const auto visit = [&](const auto* kind, const auto& leaf) {
      if (kind != nullptr) check_value(joined(path_, leaf.key), kind->*leaf.member, leaf.spec);
    };
    (visit(std::get_if<T>(&value), leaves), ...);
  }
  template <class Variant, class... Form>
  void forms(std::string_view key, Variant& value, std::string_view, const Form&...) {
    std::visit([&](auto& kind) { visit_form(joined(path_, key), kind); }, value);
  }
  template <class Variant, class... T>
  void by_dimension(Variant& value, const Map<T>&...) {
    std::visit([&](auto& kind) { visit_form(path_, kind); }, value);
  }
  template <class T>
  void toggle(std::string_view key, std::optional<T>& value, std::string_view) {
    if (value) visit_form(joined(path_, key), *value);
  }
  template <class T>
  void option(std::string_view key, std::optional<T>& value, std::string_view) {
    if (value) visit_form(joined(path_, key), *value);
  }
  void version(std::string_view, int) {}
  void not_built(std::string_view, EmptyForm, std::string_view) {}

 private:
  template <class Variant, class More, class T>
  void visit_alternative(Variant& value, More more, const Named<T>& alternative) {
    T* kind = std::get_if<T>(&value);
    if (kind == nullptr || (alternative.dimension != 0 && alternative.dimension != checker_.scene.dimension)) return;
    RangeVisitor sub(checker_, joined(path_, alternative.key));
    describe(sub, *kind);
    more(sub);
  }
  template <class T>
  void visit_form(const std::string& path, T& kind) {
    if constexpr (!std::is_same_v<T, AutoView>) {
      RangeVisitor sub(checker_, path);
      describe(sub, kind);
    }
  }

  void report(const std::string& path, std::string message) {
    if (checker_.usable(path)) checker_.add(path, std::move(message));
  }
  void check_value(const std::string& path, double value, const Spec& spec) {
    const std::string wrong = range_mistake(value, spec);
    if (!wrong.empty()) report(path, wrong);
  }
  void check_value(const std::string& path, int value, const Spec& spec) {
    check_value(path, static_cast<double>(value), spec);
    if (value % spec.multiple != 0) report(path, fmt::format("must be a multiple of {}, got {}", spec.multiple, value));
  }
  void check_value(const std::string& path, const Vec3& value, const Spec& spec) {
    for (int axis = 0; axis < 3; ++axis) check_value(joined(path, fmt::format("{}", axis)), value[axis], spec);
  }
  void check_value(const std::string& path, const Spin& spin, const Spec& spec) { check_value(path, spin.value, spec); }
  void check_value(const std::string& path, const AutoRange& range, const Spec& spec) {
    check_value(path, range.value, spec);
  }
  template <class T>
  void check_value(const std::string& path, const OrWord<T>& value, const Spec& spec) {
    if (value.value != value.stands_for) check_value(path, value.value, spec);
  }
  template <class T>
  void check_value(const std::string& path, const std::optional<T>& value, const Spec& spec) {
    if (value) check_value(path, *value, spec);
  }
  template <class T, std::size_t N>
  void check_value(const std::string& path, const std::array<T, N>& values, const Spec& spec) {
    for (std::size_t i = 0; i < N; ++i) check_value(joined(path, fmt::format("{}", i)), values[i], spec);
  }
  template <class T>
  void check_value(const std::string& path, const std::vector<T>& values, const Spec& spec) {
    if (values.size() < static_cast<std::size_t>(spec.least)) {
      report(path, fmt::format("needs at least {}, got {}", spec.least, values.size()));
    }
    for (std::size_t i = 0; i < values.size(); ++i) check_value(joined(path, fmt::format("{}", i)), values[i], spec);
  }
  void check_value(const std::string& path, const FileName& name, const Spec&) {
    const std::string wrong = file_name_mistake(name.value);
    if (!wrong.empty()) report(path, wrong);
  }
  void check_value(const std::string&, bool, const Spec&) {}
  void check_value(const std::string&, const std::string&, const Spec&) {}
  template <class E>
  requires std::is_enum_v<E>
  void check_value(const std::string&, E, const Spec&) {}

  Checker& checker_;
  std::string path_;
};

}  // namespace

void check_ranges(Checker& checker) {
  Scene copy = checker.scene;  // the field table is written for scenes that can change
  RangeVisitor visitor(checker, "");
  describe(visitor, copy);
}

}  // namespace weir
