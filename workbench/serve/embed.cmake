# Writes files as a C++ source that defines a function of a header:
# cmake -DFOLDER=assets -DNAMES=a;b -DHEADER=x.hpp -DFUNCTION=x -DOUTPUT=x.cpp -P embed.cmake
set(arrays "")
set(table "")
set(index 0)
foreach(name IN LISTS NAMES)
  file(READ "${FOLDER}/${name}" hex HEX)
  string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${hex}")
  string(REGEX REPLACE "([^\n]+)\n?" "  \"\\1\"\n" bytes "${bytes}")
  string(APPEND arrays "constexpr char kFile${index}[] =\n${bytes}  \"\";\n")
  string(APPEND table
         "    EmbeddedFile{\"${name}\", {kFile${index}, sizeof kFile${index} - 1}},\n")
  math(EXPR index "${index} + 1")
endforeach()
file(WRITE "${OUTPUT}"
"#include <array>

#include \"${HEADER}\"

namespace workbench {
namespace {
${arrays}constexpr std::array kFiles = {
${table}};
}  // namespace
std::span<const EmbeddedFile> ${FUNCTION}() { return kFiles; }
}  // namespace workbench
")
