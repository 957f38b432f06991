// Choice of the device, and its failures. Each failure runs in a process of its own: EGL reads its environment once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "core/error.h"
#include "render/device_trials.h"
#include "render/test_scene.h"

namespace weir::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Device, SoftwareIsLlvmpipe) {
  const Still still = dam_break();
  const auto renderer = make_renderer(still.scene, still.static_scene, {"software"});
  EXPECT_THAT(renderer->gl_renderer(), HasSubstr("llvmpipe"));
}

TEST(Device, TheListDescribesEachDevice) {
  const std::vector<DeviceTrial> devices = list_devices();
  ASSERT_FALSE(devices.empty());
  const auto software = std::find_if(devices.begin(), devices.end(),
                                     [](const DeviceTrial& trial) { return trial.name == "software device"; });
  ASSERT_NE(software, devices.end());
  EXPECT_TRUE(software->usable);
  EXPECT_THAT(software->detail, AllOf(HasSubstr("llvmpipe"), HasSubstr("OpenGL 4.5")));
}

TEST(Device, CanBeChosenByItsNumberInTheList) {
  const std::vector<DeviceTrial> devices = list_devices();
  const Still still = blank(1);
  for (std::size_t k = 0; k < devices.size(); ++k) {
    if (!devices[k].usable) continue;
    const auto renderer = make_renderer(still.scene, still.static_scene, {std::to_string(k)});
    EXPECT_THAT(devices[k].detail, HasSubstr(renderer->gl_renderer()));
  }
}

TEST(Device, NumbersBeyondTheListAreRefusedWithTheList) {
  const Still still = blank(1);
  try {
    make_renderer(still.scene, still.static_scene, {"77"});
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("device \"77\""), HasSubstr("software device: not tried")));
  }
}

TEST(Device, UnknownNamesAreAUsageError) {
  const Still still = blank(1);
  for (const char* name : {"gpu", "-1", "0x1", "1 "})
    EXPECT_THROW(make_renderer(still.scene, still.static_scene, {name}), UsageError) << name;
}

TEST(Device, TheRequestComesBeforeTheEnvironment) {
  EXPECT_EQ(device_choice("3").device, "3");
  EXPECT_EQ(device_choice("").device, "software");  // WEIR_GL_DEVICE, which the tests set
}

// In a new process: sets a variable, makes a renderer, and prints the error to stderr.
[[noreturn]] void ask_with(const char* variable, const char* value, const char* device) {
  setenv(variable, value, 1);
  const Still still = blank(1);
  try {
    std::cerr << make_renderer(still.scene, still.static_scene, {device})->gl_renderer() << '\n';
    std::_Exit(0);
  } catch (const DeviceError& error) {
    std::cerr << error.what() << '\n';
    std::_Exit(4);
  }
}

class DeviceFailure : public testing::Test {
 protected:
  // The child starts the program again, so that no library has been loaded yet.
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(DeviceFailure, WithoutAnyDriverIsADeviceError) {
  for (const char* device : {"auto", "software"})
    EXPECT_EXIT(ask_with("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json", device), testing::ExitedWithCode(4),
                AllOf(HasSubstr("no usable OpenGL 4.5"), HasSubstr("EGL"), HasSubstr("install libegl1")));
}

TEST_F(DeviceFailure, OfADriverThatIsTooOldNamesCallAndError) {
  for (const char* device : {"auto", "software", "0"})
    EXPECT_EXIT(
        ask_with("MESA_GL_VERSION_OVERRIDE", "3.3", device), testing::ExitedWithCode(4),
        AllOf(HasSubstr("eglCreateContext failed with EGL_BAD_MATCH"), HasSubstr("no OpenGL 4.5 core profile")));
}

TEST_F(DeviceFailure, OfTheSoftwareDeviceWhenItIsAnotherRenderer) {
  EXPECT_EXIT(ask_with("GALLIUM_DRIVER", "softpipe", "software"), testing::ExitedWithCode(4),
              AnyOf(HasSubstr("not Mesa's llvmpipe"), HasSubstr("eglCreateContext failed")));
}

TEST(Device, APictureBeyondTheDriverIsADeviceError) {
  Still still = blank(1);
  still.scene.render.size = {1000000, 2};
  try {
    make_renderer(still.scene, still.static_scene, {"software"});
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(), HasSubstr("1000000 x 2"));
  }
}

TEST(DeviceTrials, NameTheErrorOfEgl) {
  EXPECT_EQ(egl_error_name(0x3001), "EGL_NOT_INITIALIZED");  // EGL 1.5, table 3.1
  EXPECT_EQ(egl_error_name(0x3009), "EGL_BAD_MATCH");
  EXPECT_EQ(egl_error_name(0x300E), "EGL_CONTEXT_LOST");
  EXPECT_EQ(egl_error_name(0x1234), "EGL error 0x1234");
}

TEST(DeviceTrials, AMissingLibraryIsDetectedBeforeItsUse) {
  std::string problem;
  EXPECT_TRUE(library_is_there({"libnothing-of-the-kind.so.7", "libc.so.6"}, problem));
  EXPECT_FALSE(library_is_there({"libnothing-of-the-kind.so.7"}, problem));
  EXPECT_THAT(problem, HasSubstr("libnothing-of-the-kind.so.7"));
}

TEST(DeviceTrials, AreAllInTheError) {
  const std::string text = no_device_text("auto", {{"device /dev/dri/renderD128", false, "because of this"},
                                                   {"Mesa without surface", false, "because of that"}});
  EXPECT_THAT(text, AllOf(HasSubstr("0: device /dev/dri/renderD128: because of this"),
                          HasSubstr("1: Mesa without surface: because of that"), HasSubstr("libgl1-mesa-dri")));
}

}  // namespace
}  // namespace weir::test
