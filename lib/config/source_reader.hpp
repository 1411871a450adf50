// Reads `u = { … }` and its like: where a value comes from.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "config/dbc_file.hpp"
#include "config/gateway.hpp"
#include "config/toml_reader.hpp"

namespace config {

class SourceReader {
 public:
  /// `folder`: paths are relative to it. `buses` outlive this object.
  SourceReader(std::string folder, const std::vector<Bus>& buses)
      : folder_(std::move(folder)), buses_(buses) {}

  /// Reads a source; complains of everything that is wrong with it.
  [[nodiscard]] Source read(const toml::table& table, const std::string& name,
                            Complaints& complaints);
  /// The bus of that name under `key`, or the only one where the key is absent.
  [[nodiscard]] std::size_t read_bus(TableReader& reader) const;

 private:
  void read_can(TableReader& reader, Source& source);
  void read_dbc_signal(TableReader& reader, Source& source);
  void read_inline_signal(TableReader& reader, Source& source);
  void read_j1939(TableReader& reader, Source& source);
  void read_canopen(TableReader& reader, Source& source);
  struct PdoSource {
    std::string object;
    int pdo = 1;
    std::string eds_path;
    std::vector<double> mapping;
  };
  [[nodiscard]] bool read_mapped(TableReader& reader, const PdoSource& source,
                                 wire::Signal& signal);
  void read_analog(TableReader& reader, Source& source);
  void read_modbus(TableReader& reader, Source& source);
  [[nodiscard]] DbcFile* dbc(TableReader& reader, const std::string& path);

  std::string folder_;
  const std::vector<Bus>& buses_;
  std::map<std::string, std::unique_ptr<DbcFile>> dbcs_;
};

/// The keys of a signal that is laid out inline.
void read_layout(TableReader& reader, wire::Signal& signal);
/// Of these scale, offset and unit; complains under `blamed` of what fits no frame.
void read_scale(TableReader& reader, wire::Signal& signal, std::string_view blamed);

/// Reads a whole file. False: `error` says why.
[[nodiscard]] bool read_text(const std::string& path, std::size_t max_bytes,
                             std::string& text, std::string& error);

/// `path`, relative to `folder` unless it starts with '/'.
[[nodiscard]] std::string joined(const std::string& folder, const std::string& path);

/// CAN identifier in hex, three digits or eight.
[[nodiscard]] std::string hex_id(std::uint32_t id, bool extended);

}  // namespace config
