#include "workbench/serve/languages.hpp"

#include <map>

#include "workbench/serve/embedded.hpp"

namespace workbench {
namespace {

constexpr std::string_view kFolder = "texts/";
constexpr std::string_view kSuffix = ".js";

// "de" of texts/de.js and texts/de-model.js; empty for other files.
std::string_view code_of(std::string_view name) {
  if (!name.starts_with(kFolder) || !name.ends_with(kSuffix)) return {};
  name.remove_prefix(kFolder.size());
  name.remove_suffix(kSuffix.size());
  return name.substr(0, name.find('-'));
}

std::map<std::string, Texts, std::less<>> read_tables() {
  std::map<std::string, Texts, std::less<>> out;
  for (const EmbeddedFile& file : embedded_files()) {
    const std::string_view code = code_of(file.name);
    if (!code.empty()) out[std::string(code)].take(file.content);
  }
  return out;
}

const std::map<std::string, Texts, std::less<>>& tables() {
  static const std::map<std::string, Texts, std::less<>> kTables = read_tables();
  return kTables;
}

std::string write_script() {
  std::string imports;
  std::string names;
  for (const auto& [code, texts] : tables()) {
    imports += "import " + code + " from './" + code + ".js';\n";
    names += (names.empty() ? "" : ", ") + code;
  }
  return imports + "export default {" + names + "};\n";
}

}  // namespace

const std::vector<std::string>& languages() {
  static const std::vector<std::string> kCodes = [] {
    std::vector<std::string> out = {"en"};
    for (const auto& [code, texts] : tables()) out.push_back(code);
    return out;
  }();
  return kCodes;
}

const Texts& texts_of(std::string_view language) {
  static const Texts kEnglish;
  const auto found = tables().find(language);
  return found == tables().end() ? kEnglish : found->second;
}

std::string_view all_texts_script() {
  static const std::string kScript = write_script();
  return kScript;
}

}  // namespace workbench
