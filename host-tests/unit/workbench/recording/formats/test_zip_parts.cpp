#include <gtest/gtest.h>

#include "workbench/recording/formats/zip_parts.hpp"
#include "workbench/recording/input_error.hpp"
#include "workbench/recording/stopped.hpp"
#include "workbench/recording/text_file.hpp"

namespace workbench {
namespace {

class Names : public XmlPart {
 public:
  void open(std::string_view name, const Attributes& attributes) override {
    if (name == "sheet") found.emplace_back(attributes["name"]);
    if (name == "sheet") found.emplace_back(attributes.prefixed("id"));
  }
  std::vector<std::string> found;
};

TEST(ZipParts, HandTheElementsOfAPart) {
  const std::string path = STICKBAND_EXPORTS "/workbook-two-sheets.xlsx";
  const std::string bytes = read_text_file(path, std::size_t{1} << 20);
  const ZipParts archive(bytes, path);
  EXPECT_TRUE(archive.has("XL/Workbook.xml"));
  EXPECT_FALSE(archive.has("content.xml"));
  Names names;
  archive.read("content.xml", names);
  archive.read("xl/workbook.xml", names);
  EXPECT_EQ(names.found, (std::vector<std::string>{"Monday", "rId1", "Tuesday", "rId2"}));
}

TEST(ZipParts, EndWhereAStopIsAskedFor) {
  const std::string path = STICKBAND_EXPORTS "/workbook-two-sheets.xlsx";
  const std::string bytes = read_text_file(path, std::size_t{1} << 20);
  std::stop_source stop;
  const ZipParts archive(bytes, path, stop.get_token());
  stop.request_stop();
  Names names;
  EXPECT_THROW(archive.read("xl/workbook.xml", names), Stopped);
}

TEST(ZipParts, RefuseWhatIsNoArchive) {
  const std::string file = "f";
  EXPECT_THROW(ZipParts("PK\x03\x04", file), InputError);
}

}  // namespace
}  // namespace workbench
