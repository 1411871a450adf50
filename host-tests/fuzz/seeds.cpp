#include "seeds.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace fuzz {
namespace {

constexpr int kRows = 40;

template <class... Values>
void append(std::string& text, const char* format, Values... values) {
  std::array<char, 200> line;
  const int length = std::snprintf(line.data(), line.size(), format, values...);
  text.append(line.data(), static_cast<std::size_t>(length));
}

double op(int k) {
  return 50 + 10 * std::sin(0.3 * k);
}
double pv(int k) {
  return 20 + 5 * std::sin(0.3 * k - 1);
}

std::string comma_file(const char* line_end, int missing_from, int missing_to) {
  std::string text = std::string("t,u,y,sp,x,note") + line_end;
  for (int k = 0; k < kRows; ++k) {
    if (k >= missing_from && k < missing_to) continue;
    append(text, "%.2f,%.3f,%.3f,20,%.2f,\"a, b\"%s", 0.5 * k, op(k), pv(k), op(k - 1),
           line_end);
  }
  return text;
}

std::string semicolon_file() {
  std::string text = "\xEF\xBB\xBFT;OP;PV\r\n";
  for (int k = 0; k < kRows; ++k)
    append(text, "%d;%d,%03d;%d,5\r\n", k, k % 50, k * 13, k);
  return text + "\r\n;;\r\n";
}

std::string tab_file() {
  std::string text = "\"pv\"\t\"op\"\t\"t\"\n";
  for (int k = 0; k < kRows; ++k) {
    append(text, "%.4g\t %.4e \t%.3f\n", pv(k), op(k), k / 3.0);
  }
  return text;
}

std::string irregular_file() {
  std::string text = "t,u,y\r";
  double t = 1.7e9;
  for (int k = 0; k < kRows; ++k) {
    t += k % 7 == 3 ? 1.6 : 1.0;
    append(text, "%.6f,%g,%s\r", t, op(k), k % 5 == 0 ? "" : "3.25");
    if (k % 11 == 5) append(text, "%.6f,1,\r", t);
  }
  return text;
}

// Exports: wide with preamble, units and gaps; long; in pairs; newest first with loads.
std::string wide_export() {
  std::string text = "Trend;Area 1\r\n\r\nZeit;FIC-1/OP [%];FIC-1/PV;Q\r\n;%;m3/h;\r\n";
  for (int k = 0; k < kRows; ++k) {
    append(text, "%02d.05.2026 23:59:%02d,500;%d,25;", 13 + (k + 20) / 60, (k + 20) % 60,
           k);
    append(text, k % 9 == 4 ? "Bad Input;0\r\n" : "1.%03d,5;192\r\n", 100 + k);
  }
  return text + "(40 rows)\r\n";
}

std::string long_export() {
  std::string text = "tag,time,value,status\n";
  for (int k = 0; k < kRows; ++k) {
    append(text, "FIC1.OP,2026-05-03T10:00:%02d.25Z,%.3f,Good\n", k, op(k));
    append(text, "FIC1.PV,2026-05-03T10:00:%02d.75Z,%.3f,%s\n", k, pv(k),
           k == 7 ? "Bad" : "Good");
    if (k % 5 == 0) append(text, "TI2.PV,2026-05-03T10:00:%02dZ,%d,Good\n", k, k);
  }
  return text;
}

std::string paired_export() {
  std::string text = "A.OP Time|A.OP|A.PV Time|A.PV\n";
  for (int k = 0; k < kRows; ++k) {
    append(text, "03-May-26 10:00:%02d|%.2f|5/3/2026 10:00:%02d AM|%.2f\n", k, op(k), k,
           pv(k));
  }
  return text;
}

std::string turned_export() {
  std::string text =
      "id,date,time,A.OUT.CV %,A.PV.CV GPM,TE-1 \xB0"
      "C\n";
  for (int k = kRows; k > 0; --k) {
    append(text, "%d,13/05/26,10:%02d:00,%.2f,%.2f,%d\n", k, k, op(k), pv(k), k);
  }
  return text;
}

std::string plant_dbc(const char* line_end) {
  const std::array<const char*, 17> lines = {
      "VERSION \"1\"",
      "NS_ :",
      "\tCM_",
      "\tSIG_VALTYPE_",
      "\tSG_MUL_VAL_",
      "BS_:",
      "BU_: A B // nodes",
      "BO_ 399 M: 8 A",
      " SG_ U : 7|16@0+ (0.01,0) [0|100] \"%\" B",
      " SG_ P M : 16|8@1+ (1,0) [0|0] \"\" B",
      " SG_ X m1 : 32|32@1- (1,0) [0|0] \"%\" B",
      "BO_ 2566852608 N: 4 A",
      " SG_ Y : 0|16@1- (0.1,-40) [-1E3|1E3] \"\xC2\xB0\" B",
      " SG_ P : 16|16@1+ (0.1,0) [0|0] \"\" B",
      "CM_ SG_ 399 U \"two\nlines\";",
      "SIG_VALTYPE_ 399 X : 1;",
      "SG_MUL_VAL_ 399 X P 1-1;"};
  std::string text;
  for (const char* line : lines) text += std::string(line) + line_end;
  return text;
}

std::string log(const char* line_end, int step_y_ms, int missing_from, int missing_to,
                int end_ms = 20'000) {
  std::string text;
  for (int ms = 0; ms < end_ms; ms += 100) {
    const int k = ms / 500;
    if (ms % 500 == 0 && (k < missing_from || k >= missing_to)) {
      const int raw = static_cast<int>(100 * op(k));
      append(text, "(1436509052.%03d713) vcan0 18F#%04X010000002040%s", ms % 1000, raw,
             line_end);
      text.replace(text.rfind('(') + 1, 10, std::to_string(1436509052 + ms / 1000));
    }
    if (ms % step_y_ms == 0) {
      const int raw = static_cast<int>(10 * (pv(k) + 40));
      append(text, "(%d.%03d000) vcan0 18FF1000#%02X%02XC800%s", 1436509052 + ms / 1000,
             ms % 1000, raw % 256, raw / 256, line_end);
    }
    if (ms % 2000 == 0) {
      append(text, "(%d.%03d900) vcan0 7FF##1AABB%s", 1436509052 + ms / 1000, ms % 1000,
             line_end);
    }
  }
  return text;
}

}  // namespace

std::vector<std::string> csv_seeds() {
  return {
      "2026-03-04T06:00:01Z level=info say=\"a b\" op=4.5 pv=6.1\n"
      "2026-03-04T06:00:02Z level=info say=\"a b\" op=4.6 pv=6.2\n"
      "[2026-03-04T06:00:03Z] level=info say=\"a b\" op=4.7 pv=6.3\n",
      "-[ RECORD 1 ]-+---\nt  | 0\nop | 1\npv | 2\n"
      "-[ RECORD 2 ]-+---\nt  | 1\nop | 2\npv | 3\n",
      comma_file("\n", 99, 99),
      comma_file("\r\n", 10, 13),
      semicolon_file(),
      tab_file(),
      irregular_file(),
      "u\n1\n2\n3\n",
      wide_export(),
      long_export(),
      paired_export(),
      turned_export(),
      "t,u,y\n1780000000000,1,2\n1780000000500,2,3\n1780000001000,3,4\n"};
}

std::vector<std::string> dbc_seeds() {
  return {plant_dbc("\n"), plant_dbc("\r\n")};
}

std::vector<std::string> candump_seeds() {
  return {plant_dbc("\n") + log("\n", 500, 99, 99),
          plant_dbc("\n") + log("\n", 1000, 9, 12),
          plant_dbc("\r\n") + log("\r\n", 100, 99, 99),
          plant_dbc("\n") + log("\n", 500, 99, 99, 4'000)};
}

std::vector<std::string> frames_seeds() {
  const std::string slcan =
      "t18F8FFFE010000007F00\nT18FF10002AABB\nr18F8\nt18F2AABB1234\n";
  const std::string candump =
      "(1436509052.249713) vcan0 18F#2A366C2BBA\n(0.1) can0 18FF1000#11223344 R\n"
      "(1.0) can0 18F#R4\n(1.0) can0 20000004#0000000000000000\n"
      "(1.0) can0 18F##1AABB\n(2.000000001) can0 18F#000000000000F07F\n";
  const std::string fd = "(1.0) can0 18F##1" + std::string(124, 'A') +
                         "3412\n(1.0) can0 18F  [12] "
                         "00 11 22 33 44 55 66 77 88 99 AA BB\n(1.0) can0 18FF1000##3\n";
  const std::string last16("\xF0\x10\x18\x04\x00\x08\x00\x00", 8);
  const std::string intel16("\x00\x10\x18\x00\x00\x08\x00\x00", 8);
  const std::string motorola("\x07\x0C\x01\x01\x07\x04\x01\x00", 8);
  const std::string page("\x10\x10\x98\x02\x00\x08\x00\x2A", 8);
  const std::string float32("\x00\x20\x02\x00\x00\x08\x00\x00", 8);
  const std::string float64("\x00\x40\x04\x00\x00\x08\x00\x00", 8);
  return {intel16 + candump, motorola + slcan,  page + candump,
          float32 + slcan,   float64 + candump, last16 + fd};
}

const std::vector<std::string_view>& words() {
  static const std::vector<std::string_view> kWords = {"t",
                                                       "u",
                                                       "y",
                                                       "sp",
                                                       "x",
                                                       "OP",
                                                       "PV",
                                                       "MV",
                                                       "POS",
                                                       ",",
                                                       ";",
                                                       "\t",
                                                       "\n",
                                                       "\r",
                                                       "\r\n",
                                                       "\"",
                                                       "\"\"",
                                                       " ",
                                                       ".",
                                                       "-",
                                                       "+",
                                                       "e",
                                                       "0",
                                                       "1",
                                                       "9",
                                                       "nan",
                                                       "inf",
                                                       "-inf",
                                                       "1e308",
                                                       "-1e308",
                                                       "1e-308",
                                                       "1e999",
                                                       "1e17",
                                                       "1e-17",
                                                       "4294967296",
                                                       "18446744073709551616",
                                                       "0.1",
                                                       "1,5",
                                                       "\xEF\xBB\xBF",
                                                       "\xFF\xFE",
                                                       "Bad",
                                                       "No Data",
                                                       "#N/A",
                                                       "2026-05-03",
                                                       "03/04/26",
                                                       "13.05.2026",
                                                       "25-Oct-26",
                                                       "10:00:00",
                                                       " 2:30:00 PM",
                                                       "+02:00",
                                                       "46145.5",
                                                       "1780000000000",
                                                       "Time",
                                                       "tag",
                                                       "value",
                                                       "Quality",
                                                       "FIC1.",
                                                       "[%]",
                                                       "1.234,5",
                                                       "sep=;\n",
                                                       "BO_ 1 M: 8 X\n",
                                                       "SG_ ",
                                                       "SIG_VALTYPE_ ",
                                                       "SG_MUL_VAL_ ",
                                                       " : 0|64@1+ (1,0) [0|0] \"\"",
                                                       " : 7|64@0- (0.5,1) [1|2] \"\"",
                                                       " m1 ",
                                                       " M ",
                                                       " m0M ",
                                                       "//",
                                                       "(",
                                                       ")",
                                                       "#",
                                                       "##",
                                                       "#R",
                                                       "_9",
                                                       "can0 ",
                                                       "(1436509060.000000) ",
                                                       "20000004#",
                                                       "18F#FFFF010000000000",
                                                       "18F#0000010000C07F",
                                                       "M.U"};
  return kWords;
}

}  // namespace fuzz
