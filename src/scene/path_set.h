// Paths of keys ("fluid.volumes.0"), to be asked whether one of them is, contains or lies in another.
#pragma once

#include <set>
#include <string>

namespace weir {

class PathSet {
 public:
  void add(const std::string& path) { paths_.insert(path); }

  bool touches(const std::string& path) const {
    if (paths_.contains(path)) return true;
    for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', dot + 1)) {
      if (paths_.contains(path.substr(0, dot))) return true;
    }
    const auto below = paths_.lower_bound(path + ".");
    return below != paths_.end() && below->starts_with(path + ".");
  }

 private:
  std::set<std::string> paths_;
};

}  // namespace weir
