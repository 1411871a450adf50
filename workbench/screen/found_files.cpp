#include "workbench/screen/found_files.hpp"

#include <glob.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string_view>

#include "workbench/recording/letters.hpp"
#include "workbench/recording/listed.hpp"
#include "workbench/recording/tag_file.hpp"

namespace workbench {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestList = 4;  // lists that name lists

constexpr std::array<std::string_view, 9> kEndings = {
    ".csv", ".txt", ".tsv", ".tab", ".asc", ".dat", ".lvm", ".xlsx", ".ods"};

bool is_recording_name(const fs::path& path) {
  const std::string ending = lower_case(path.extension().string());
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

bool is_hidden(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.size() > 1 && name[0] == '.';
}

class Finder {
 public:
  void add(const std::string& path, int depth) {
    std::error_code error;
    if (path.size() > 1 && path[0] == '@' && !fs::exists(path, error)) {
      add_list(path.substr(1), depth);
    } else if (fs::is_directory(path, error)) {
      add_folder(path);
    } else if (fs::exists(path, error)) {
      found.files.push_back(path);
    } else if (path.find_first_of("*?[") != std::string::npos) {
      add_pattern(path, depth);
    } else {
      problem(path, "expected a file or folder, found none; check the path");
    }
  }

  FoundFiles found;

 private:
  void problem(const std::string& path, std::string what) {
    found.problems.push_back({path, std::move(what)});
  }

  void add_folder(const std::string& path) {
    const std::size_t before = found.files.size();
    const std::size_t passed_over = found.passed_over.size();
    std::error_code error;
    fs::recursive_directory_iterator at(
        path, fs::directory_options::skip_permission_denied, error);
    if (error) {
      problem(path, "expected a folder that can be read, found '" + error.message() +
                        "'; check its permissions");
      return;
    }
    for (const fs::recursive_directory_iterator end; at != end; at.increment(error)) {
      if (error) break;
      std::error_code ignored;
      if (is_hidden(at->path())) {
        if (at->is_directory(ignored)) at.disable_recursion_pending();
      } else if (at->is_regular_file(ignored)) {
        (is_recording_name(at->path()) ? found.files : found.passed_over)
            .push_back(at->path().string());
      }
    }
    if (found.files.size() == before) no_recordings(path, passed_over);
  }

  // `passed_over`: how many files were before those of the folder.
  void no_recordings(const std::string& path, std::size_t passed_over) {
    std::string endings;
    for (const std::string_view ending : kEndings) {
      endings += (endings.empty() ? "*" : ", *") + std::string(ending);
    }
    const auto first =
        found.passed_over.begin() + static_cast<std::ptrdiff_t>(passed_over);
    std::vector<std::string> others(first, found.passed_over.end());
    std::ranges::sort(others);
    found.passed_over.erase(first, found.passed_over.end());
    problem(path, "expected recordings (" + endings + ") below this folder, found " +
                      (others.empty() ? "none" : "only " + names_of_some(others)) +
                      "; export the loops as one of these, or name a table whose name "
                      "ends otherwise itself");
  }

  void add_pattern(const std::string& pattern, int depth) {
    glob_t matches{};
    if (glob(pattern.c_str(), 0, nullptr, &matches) == 0) {
      for (std::size_t i = 0; i < matches.gl_pathc; ++i) {
        const std::string match = matches.gl_pathv[i];
        std::error_code error;
        if (fs::exists(match, error)) {
          add(match, depth);
        } else {
          problem(match, "expected a file, found a link to none; mend or remove it");
        }
      }
    } else {
      problem(pattern, "expected files that fit this pattern, found none");
    }
    globfree(&matches);
  }

  void add_list(const std::string& path, int depth) {
    std::ifstream list(path);
    if (!list || depth >= kDeepestList) {
      problem('@' + path, list ? "lists that name lists that name lists: too deep"
                               : "expected a list of paths, found no file " + path);
      return;
    }
    const fs::path folder = fs::path(path).parent_path();
    for (std::string line; std::getline(list, line);) {
      while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) {
        line.pop_back();
      }
      if (line.empty() || line[0] == '#') continue;
      const bool is_list = line[0] == '@';
      const fs::path named = line.substr(is_list ? 1 : 0);
      const std::string full = named.is_absolute() || folder.empty()
                                   ? named.string()
                                   : (folder / named).string();
      add((is_list ? "@" : "") + full, depth + 1);
    }
  }
};

}  // namespace

FoundFiles find_files(const std::vector<std::string>& paths) {
  Finder finder;
  for (const std::string& path : paths) finder.add(path, 0);
  for (auto* files : {&finder.found.files, &finder.found.passed_over}) {
    for (std::string& file : *files) file = fs::path(file).lexically_normal().string();
    std::ranges::sort(*files);
    files->erase(std::unique(files->begin(), files->end()), files->end());
  }
  // One that is named itself is read.
  std::erase_if(finder.found.passed_over, [&finder](const std::string& file) {
    return std::ranges::binary_search(finder.found.files, file);
  });
  return std::move(finder.found);
}

std::string names_of_some(const std::vector<std::string>& files) {
  return first_listed(files, {.things = 8}, ", ", [](const std::string& file) {
    return fs::path(file).filename().string();
  });
}

bool is_date_like(const std::string& name) {
  static const std::regex date(
      R"((week|woche|kw|day|tag|month|monat|part|teil|run|w|q)?[-_ .]*\d{1,4}([-_ .]\d{1,4}){0,5})"
      R"(|\d{6,14}|\d{8}[-_t]\d{2,6})"
      R"(|(jan|feb|mar|mär|apr|may|mai|jun|jul|aug|sep|oct|okt|nov|dec|dez)[a-z]*[-_ .]*\d{2,4})"
      R"(|\d{2,4}[-_ .]*(jan|feb|mar|mär|apr|may|mai|jun|jul|aug|sep|oct|okt|nov|dec|dez)[a-z]*)");
  return std::regex_match(lower_case(name), date);
}

int running_number(const std::string& path) {
  const std::string name = fs::path(path).stem().string();
  const std::string base = undated_name(path);
  const std::string rest = name.substr(base.size());
  if (rest.size() < 2 || rest.size() > 3) return 0;
  return std::atoi(rest.c_str() + 1);
}

}  // namespace workbench
