#include "workbench/recording/formats/zip_parts.hpp"

#include <zip.h>

#include <array>
#include <utility>

#include "workbench/recording/stopped.hpp"

namespace workbench {
namespace {

std::string_view local_name(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

}  // namespace

std::string_view Attributes::operator[](std::string_view name) const {
  for (const XML_Char** at = pairs_; *at != nullptr; at += 2) {
    if (local_name(*at) == name) return at[1];
  }
  return {};
}

std::string_view Attributes::prefixed(std::string_view name) const {
  for (const XML_Char** at = pairs_; *at != nullptr; at += 2) {
    const std::string_view whole = *at;
    if (local_name(whole) == name && whole.size() > name.size()) return at[1];
  }
  return {};
}

ZipParts::ZipParts(std::string_view bytes, const std::string& file, std::stop_token stop)
    : file_(file), stop_(std::move(stop)) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* opened =
      source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (opened == nullptr) {
    if (source != nullptr) zip_source_free(source);
    zip_error_fini(&error);
    throw refusal("an archive that ends early or is damaged");
  }
  zip_error_fini(&error);
  archive_.reset(opened);
}

InputError ZipParts::refusal(const std::string& found) const {
  return InputError(file_, 0, 0, "an Excel or OpenDocument workbook (xlsx, ods)", found,
                    "open it in Excel or LibreOffice and save the sheet as "
                    "\"CSV UTF-8\"");
}

void ZipParts::Discard::operator()(zip* archive) const {
  zip_discard(archive);
}

bool ZipParts::has(const std::string& name) const {
  return zip_name_locate(archive_.get(), name.c_str(), ZIP_FL_NOCASE) >= 0;
}

void ZipParts::read(const std::string& name, XmlPart& to) const {
  if (!has(name)) return;
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> from(
      zip_fopen(archive_.get(), name.c_str(), ZIP_FL_NOCASE), &zip_fclose);
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(
      XML_ParserCreate(nullptr), &XML_ParserFree);
  if (!from || !parser) throw refusal("an unreadable part " + name);
  XML_SetUserData(parser.get(), &to);
  XML_SetElementHandler(
      parser.get(),
      [](void* part, const XML_Char* element, const XML_Char** attributes) {
        static_cast<XmlPart*>(part)->open(local_name(element), Attributes(attributes));
      },
      [](void* part, const XML_Char* element) {
        static_cast<XmlPart*>(part)->close(local_name(element));
      });
  XML_SetCharacterDataHandler(
      parser.get(), [](void* part, const XML_Char* piece, int size) {
        static_cast<XmlPart*>(part)->text({piece, static_cast<std::size_t>(size)});
      });
  std::array<char, std::size_t{1} << 16> block{};
  while (to.goes_on()) {
    check_stop(stop_);
    const zip_int64_t got = zip_fread(from.get(), block.data(), block.size());
    const bool parsed =
        got >= 0 && XML_Parse(parser.get(), block.data(), static_cast<int>(got),
                              static_cast<int>(got == 0)) == XML_STATUS_OK;
    if (!parsed) throw refusal("a damaged part " + name);
    if (got == 0) return;
  }
}

}  // namespace workbench
