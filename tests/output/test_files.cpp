#include <gmock/gmock.h>

#include "core/error.h"
#include "helpers.h"
#include "output/file.h"

namespace weir::testing {
namespace {

using ::testing::HasSubstr;

using File = FolderTest;

TEST_F(File, IsReplacedWhole) {
  write_file(folder / "a", "old");
  write_file(folder / "a", std::string("new\0\n", 5));
  EXPECT_EQ(read_file(folder / "a"), std::string("new\0\n", 5));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST_F(File, StaysAsItWasWhenTheDiskIsFull) {
  write_file(folder / "a", "old");
  std::string text;
  {
    const FileSizeLimit limit(100);
    text = error_text<OutputError>([&] { write_file(folder / "a", std::string(1000, 'x')); });
  }
  EXPECT_EQ(text, "cannot write " + (folder / "a").string() +
                      ": File too large (raise the limit, see ulimit -f, or choose another folder with -o)");
  EXPECT_EQ(read_file(folder / "a"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST_F(File, NamesThePathThatBlocksIt) {
  EXPECT_EQ(error_text<OutputError>([&] { write_file(folder / "no" / "a", ""); }),
            "cannot write " + (folder / "no" / "a").string() + ": No such file or directory");
  write_file(folder / "file", "");
  EXPECT_THAT(error_text<OutputError>([&] { write_file(folder / "file" / "a", ""); }), HasSubstr("Not a directory"));
  std::filesystem::create_directory(folder / "folder");
  EXPECT_THAT(error_text<OutputError>([&] { write_file(folder / "folder", ""); }), HasSubstr("Is a directory"));
  EXPECT_FALSE(std::filesystem::exists(folder / "folder.tmp"));
  EXPECT_EQ(error_text<OutputError>([&] { read_file(folder / "no"); }),
            "cannot read " + (folder / "no").string() + ": No such file or directory");
  EXPECT_THAT(error_text<OutputError>([&] { read_file(folder); }), HasSubstr("Is a directory"));
}

TEST_F(File, OnAFullDeviceIsReportedWithARemedy) {
  GrowingFile full("/dev/full");
  EXPECT_EQ(error_text<OutputError>([&] { full.append("x"); }),
            "cannot write /dev/full: No space left on device (free some space, or choose another folder with -o)");
}

TEST_F(File, GrowsByWholePieces) {
  GrowingFile file(folder / "a");
  file.append("12345");
  {
    const FileSizeLimit limit(8);
    EXPECT_THROW(file.append("67890"), OutputError);
  }
  EXPECT_EQ(read_file(folder / "a"), "12345");
  file.append("abc");
  file.close();
  EXPECT_EQ(read_file(folder / "a"), "12345abc");
}

}  // namespace
}  // namespace weir::testing
