// Words for choices in a file. Reserved choices that are not built are listed too, so that they are refused by name.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "scene/scene.h"

namespace weir {

template <class E>
struct Name {
  E value;
  std::string_view text;
};
template <std::size_t N>
using Later = std::array<std::string_view, N>;

// Names<E>::built and Names<E>::later for every enumeration of the scene.
template <class E>
struct Names;

template <>
struct Names<ViscosityModel> {
  static constexpr std::array<Name<ViscosityModel>, 5> built{{{ViscosityModel::none, "none"},
                                                              {ViscosityModel::morris, "morris"},
                                                              {ViscosityModel::monaghan, "monaghan"},
                                                              {ViscosityModel::artificial, "artificial"},
                                                              {ViscosityModel::hinsch2024, "hinsch2024"}}};
  static constexpr Later<1> later{"mueller2003"};
};
template <>
struct Names<SurfaceTensionModel> {
  static constexpr std::array<Name<SurfaceTensionModel>, 2> built{
      {{SurfaceTensionModel::none, "none"}, {SurfaceTensionModel::hinsch2024, "hinsch2024"}}};
  static constexpr Later<0> later{};
};
template <>
struct Names<Side> {
  static constexpr std::array<Name<Side>, 6> built{{{Side::left, "left"},
                                                    {Side::right, "right"},
                                                    {Side::bottom, "bottom"},
                                                    {Side::top, "top"},
                                                    {Side::front, "front"},
                                                    {Side::back, "back"}}};
  static constexpr Later<0> later{};
};
template <>
struct Names<Axis> {
  static constexpr std::array<Name<Axis>, 3> built{{{Axis::x, "x"}, {Axis::y, "y"}, {Axis::z, "z"}}};
  static constexpr Later<0> later{};
};
template <>
struct Names<Flank> {
  static constexpr std::array<Name<Flank>, 2> built{{{Flank::left, "left"}, {Flank::right, "right"}}};
  static constexpr Later<0> later{};
};
template <>
struct Names<Face> {
  static constexpr std::array<Name<Face>, 2> built{{{Face::inside, "inside"}, {Face::outside, "outside"}}};
  static constexpr Later<0> later{};
};
template <>
struct Names<Method> {
  static constexpr std::array<Name<Method>, 2> built{{{Method::wcsph, "wcsph"}, {Method::delta_sph, "delta_sph"}}};
  static constexpr Later<3> later{"iisph", "dfsph", "pcisph"};
};
template <>
struct Names<KernelName> {
  static constexpr std::array<Name<KernelName>, 3> built{{{KernelName::cubic_spline, "cubic_spline"},
                                                          {KernelName::wendland_c2, "wendland_c2"},
                                                          {KernelName::wendland_c4, "wendland_c4"}}};
  static constexpr Later<0> later{};
};
template <>
struct Names<NegativePressure> {
  static constexpr std::array<Name<NegativePressure>, 2> built{
      {{NegativePressure::clamp, "clamp"}, {NegativePressure::keep, "keep"}}};
  static constexpr Later<0> later{};
};
template <>
struct Names<WallSlip> {
  static constexpr std::array<Name<WallSlip>, 2> built{
      {{WallSlip::no_slip, "no_slip"}, {WallSlip::free_slip, "free_slip"}}};
  static constexpr Later<0> later{};
};
template <>
struct Names<StartPressure> {
  static constexpr std::array<Name<StartPressure>, 2> built{
      {{StartPressure::none, "none"}, {StartPressure::hydrostatic, "hydrostatic"}}};
  static constexpr Later<0> later{};
};
template <>
struct Names<WallPressure> {
  static constexpr std::array<Name<WallPressure>, 2> built{
      {{WallPressure::mirrored, "mirrored"}, {WallPressure::extrapolated, "extrapolated"}}};
  static constexpr Later<0> later{};
};
// Those that can colour.
template <>
struct Names<Quantity> {
  static constexpr std::size_t count = static_cast<std::size_t>(
      std::count_if(quantities.begin(), quantities.end(), [](const QuantityFacts& facts) { return facts.colours(); }));
  static constexpr std::array<Name<Quantity>, count> built = [] {
    std::array<Name<Quantity>, count> names{};
    auto next = names.begin();
    for (const QuantityFacts& facts : quantities) {
      if (facts.colours()) *next++ = {facts.quantity, facts.name};
    }
    return names;
  }();
  static constexpr Later<0> later{};
};
template <>
struct Names<ParticleField> {
  static constexpr auto built = [] {
    std::array<Name<ParticleField>, quantities.size()> names{};
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = {field_of(quantities[i].quantity), quantities[i].name};
    return names;
  }();
  static constexpr Later<0> later{};
};
template <>
struct Names<ColormapName> {
  static constexpr std::array<Name<ColormapName>, 5> built{{{ColormapName::viridis, "viridis"},
                                                            {ColormapName::cividis, "cividis"},
                                                            {ColormapName::magma, "magma"},
                                                            {ColormapName::turbo, "turbo"},
                                                            {ColormapName::coolwarm, "coolwarm"}}};
  static constexpr Later<0> later{};
};
template <>
struct Names<OverlayItem> {
  static constexpr std::array<Name<OverlayItem>, 5> built{{{OverlayItem::title, "title"},
                                                           {OverlayItem::time, "time"},
                                                           {OverlayItem::colorbar, "colorbar"},
                                                           {OverlayItem::scalebar, "scalebar"},
                                                           {OverlayItem::cfl, "cfl"}}};
  static constexpr Later<0> later{};
};
template <>
struct Names<Theme> {
  static constexpr std::array<Name<Theme>, 2> built{{{Theme::light, "light"}, {Theme::dark, "dark"}}};
  static constexpr Later<0> later{};
};

template <class E>
constexpr std::string_view name_of(E value) {
  for (const Name<E>& name : Names<E>::built) {
    if (name.value == value) return name.text;
  }
  return "?";
}

}  // namespace weir
