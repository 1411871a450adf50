#include "workbench/screen/page.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "ident/verdict/judge.hpp"
#include "wire/sha256.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/report/page_style.hpp"
#include "workbench/serve/embedded.hpp"

namespace workbench {
namespace {

using Json = nlohmann::ordered_json;

std::string file_of(std::string_view name) {
  for (const EmbeddedFile& file : screen_files()) {
    if (file.name == name) return std::string(file.content);
  }
  throw std::logic_error("no file " + std::string(name));
}

void replace(std::string& text, std::string_view mark, const std::string& by) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) throw std::logic_error("no " + std::string(mark));
  text.replace(at, mark.size(), by);
}

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = std::uint32_t{bytes[i]} << 16;
    if (i + 1 < bytes.size()) word |= std::uint32_t{bytes[i + 1]} << 8;
    if (i + 2 < bytes.size()) word |= bytes[i + 2];
    for (int shift = 18; shift >= 0; shift -= 6) out += kDigits[word >> shift & 63];
  }
  if (bytes.size() % 3 >= 1) out[out.size() - 1] = '=';
  if (bytes.size() % 3 == 1) out[out.size() - 2] = '=';
  return out;
}

std::string hash_of(std::string_view text) {
  wire::Sha256 hash;
  hash.add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  return "'sha256-" + base64(hash.digest()) + '\'';
}

// Four digits are what a list shows.
Json rounded(double value, bool known = true) {
  if (!known || !std::isfinite(value)) return nullptr;
  return std::strtod(number(value, 4).c_str(), nullptr);
}

Json band(const ident::Estimate<double>& e) {
  if (!e.known) return nullptr;
  return {rounded(e.value), rounded(e.low), rounded(e.high)};
}

// Sentences that many loops share stand once.
class Shared {
 public:
  int index(const std::string& text) {
    const auto [at, is_new] = known_.try_emplace(text, static_cast<int>(known_.size()));
    if (is_new) all_.push_back(text);
    return at->second;
  }
  [[nodiscard]] const Json& all() const { return all_; }

 private:
  std::map<std::string, int> known_;
  Json all_ = Json::array();
};

Json row_of(const ScreenedLoop& loop, Shared& texts) {
  Json files = Json::array();
  for (const std::string& file : loop.files) files.push_back(texts.index(file));
  Json trend = Json::array();
  for (const Stretch& s : loop.trend) {
    trend.push_back({s.name, s.verdict, rounded(s.nats), rounded(s.stick_band),
                     rounded(s.oscillating)});
  }
  Json notes = Json::array();
  for (const std::string& note : loop.notes) notes.push_back(texts.index(note));
  return {loop.loop,
          texts.index(loop.verdict),
          rounded(loop.cost),
          band(loop.stick_band.ascending),
          band(loop.stick_band.descending),
          loop.unit,
          rounded(loop.span > 0 ? 100 * loop.detectable_band / loop.span : 0,
                  loop.detectable_band > 0 && loop.span > 0),
          rounded(loop.nats, loop.error.empty()),
          rounded(loop.period_s, loop.period_s > 0),
          rounded(loop.oscillating_share),
          loop.group,
          loop.leads ? 1 : 0,
          rounded(loop.lag_s, loop.group > 0),
          texts.index(loop.reason),
          texts.index(loop.cause),
          files,
          trend,
          notes,
          loop.samples,
          rounded(loop.sample_period_s),
          loop.from,
          loop.picture_u,
          loop.picture_y,
          loop.error,
          loop.u_tag,
          loop.y_tag};
}

}  // namespace

std::string page_data(const Screening& screening) {
  Shared texts;
  Json rows = Json::array();
  for (const ScreenedLoop& loop : screening.loops) rows.push_back(row_of(loop, texts));
  const Json data{{"complete", screening.complete},
                  {"left_out", screening.left_out},
                  {"unpaired", screening.unpaired},
                  {"nats", {ident::kNoNats, ident::kAgreedNats, ident::kAloneNats}},
                  {"texts", texts.all()},
                  {"rows", rows}};
  std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  // Nothing inside may look like the end of the script.
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

std::string screen_page(const Screening& screening) {
  const std::string style = std::string(kPalette) + file_of("page.css");
  const std::string script = file_of("page.js");
  std::string page = file_of("page.html");
  replace(page, "{{policy}}",
          "default-src 'none'; style-src " + hash_of(style) + "; script-src " +
              hash_of(script) + "; base-uri 'none'; form-action 'none'");
  replace(page, "{{style}}", style);
  replace(page, "{{script}}", script);
  replace(page, "{{data}}", page_data(screening));
  return page;
}

}  // namespace workbench
