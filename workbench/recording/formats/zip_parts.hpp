// The parts of an office document: XML in a zip archive.
#pragma once

#include <expat.h>

#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "workbench/recording/input_error.hpp"

struct zip;

namespace workbench {

/// An element's attributes, by their local names; "" for one that is not there.
class Attributes {
 public:
  explicit Attributes(const XML_Char** pairs) : pairs_(pairs) {}
  [[nodiscard]] std::string_view operator[](std::string_view name) const;
  /// Only with a prefix: r:id beside an id of the same element.
  [[nodiscard]] std::string_view prefixed(std::string_view name) const;

 private:
  const XML_Char** pairs_;
};

/// What takes the elements of a part, by their local names.
class XmlPart {
 public:
  XmlPart() = default;
  XmlPart(const XmlPart&) = delete;
  XmlPart& operator=(const XmlPart&) = delete;
  virtual ~XmlPart() = default;
  virtual void open(std::string_view name, const Attributes& attributes) = 0;
  virtual void close(std::string_view /*name*/) {}
  virtual void text(std::string_view /*piece*/) {}
  /// False: nothing more is wanted.
  [[nodiscard]] virtual bool goes_on() const { return true; }
};

/// A zip archive in memory; the bytes must outlive it.
class ZipParts {
 public:
  /// Throws InputError naming `file` where it is damaged.
  ZipParts(std::string_view bytes, const std::string& file, std::stop_token stop = {});

  /// Without regard to case.
  [[nodiscard]] bool has(const std::string& name) const;
  /// Hands the part to `to`; one that is not there has nothing in it. Throws InputError
  /// where it is damaged, and Stopped.
  void read(const std::string& name, XmlPart& to) const;
  /// What to throw where the document cannot be read, or is of another kind.
  [[nodiscard]] InputError refusal(const std::string& found) const;

 private:
  struct Discard {
    void operator()(zip* archive) const;
  };
  const std::string& file_;
  std::stop_token stop_;
  std::unique_ptr<zip, Discard> archive_;
};

}  // namespace workbench
