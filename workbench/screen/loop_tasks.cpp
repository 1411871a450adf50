#include "workbench/screen/loop_tasks.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "workbench/recording/input_error.hpp"
#include "workbench/screen/found_files.hpp"

namespace workbench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kWholeFile = PartOfLoop::kWholeFile;

// The files of one signal each of one folder.
struct TagsOfFolder {
  std::vector<NamedSignal> tags;
  std::map<std::string, std::size_t> index_of;
  std::vector<std::vector<std::size_t>> files;  // by tag

  void add(std::size_t file, const std::string& tag) {
    const auto [at, is_new] = index_of.try_emplace(tag, tags.size());
    if (is_new) {
      tags.push_back({column_name(tag), tags.size() + 1, 1, true});
      files.emplace_back();
    }
    files[at->second].push_back(file);
  }
};

class TaskMaker {
 public:
  TaskMaker(const std::vector<ExportFile>& files,
            const std::map<std::size_t, std::string>& broken, const PairRules& pairs,
            bool pool)
      : files_(files), broken_(broken), pairs_(pairs), pool_(pool) {}

  LoopTasks make() {
    find_first_parts();
    for (std::size_t i = 0; i < files_.size(); ++i) take(i);
    for (const auto& [folder, tags] : tags_) take_tags(folder, tags);
    miss_listed();
    tell_names_apart();
    return std::move(out_);
  }

 private:
  // A number makes parts of one loop only where there is a first one.
  void find_first_parts() {
    for (const ExportFile& file : files_) {
      if (running_number(file.path) == 1) {
        first_parts_.insert({folder_of(file.path, pool_), file.loop});
      }
    }
  }

  void take(std::size_t i) {
    const ExportFile& file = files_[i];
    for (const std::string& tag : file.unpaired) {
      out_.unpaired.push_back(file.path + ": " + tag);
    }
    for (const std::string& text : file.doubts) doubt(text, {file.path});
    if (!file.tag.empty()) {
      tags_[folder_of(file.path, pool_)].add(i, file.tag);
    } else if (file.kind == ExportFile::Kind::kSingle) {
      add(i, kWholeFile, name_of(file));
    } else {
      for (std::size_t k = 0; k < file.loops.size(); ++k) {
        LoopTask* task = add(i, k, file.loops[k].name);
        if (task == nullptr) continue;
        task->u_tag = file.loops[k].u_tag;
        task->y_tag = file.loops[k].y_tag;
      }
    }
  }

  [[nodiscard]] std::string name_of(const ExportFile& file) const {
    const bool alone = running_number(file.path) > 1 &&
                       !first_parts_.contains({folder_of(file.path, pool_), file.loop});
    return file.named_by_file && (alone || !pool_) ? fs::path(file.path).stem().string()
                                                   : file.loop;
  }

  // The task where it is new.
  LoopTask* add(std::size_t file, std::size_t loop, const std::string& name) {
    if (broken_.contains(file)) return nullptr;
    std::string folder = folder_of(files_[file].path, pool_);
    if (!pool_) folder += std::to_string(file);
    const auto [at, is_new] = known_.try_emplace({folder, name}, out_.tasks.size());
    if (is_new) out_.tasks.push_back({name, {}, {}, {}});
    const std::vector<PartOfLoop>& parts = out_.tasks[at->second].parts;
    const bool twice = std::ranges::any_of(
        parts, [file](const PartOfLoop& part) { return part.file == file; });
    if (twice) {
      out_.errors.push_back(
          failed(name, {files_[file].path},
                 "expected one u and one y of " + name + " in " + files_[file].path +
                     ", found more; give each pair a name of its own in a list of "
                     "--pairs"));
      return nullptr;
    }
    out_.tasks[at->second].parts.push_back({file, loop, {}});
    return is_new ? &out_.tasks.back() : nullptr;
  }

  void doubt(const std::string& text, std::vector<std::string> paths) {
    out_.errors.push_back(failed(text.substr(0, text.find(':')), std::move(paths),
                                 "expected one u and one y of each tag, found " + text +
                                     "; name the pair with --pairs"));
  }

  [[nodiscard]] std::vector<std::string> paths_of(
      const std::vector<std::size_t>& files) const {
    std::vector<std::string> out;
    for (const std::size_t file : files) out.push_back(files_[file].path);
    return out;
  }

  void take_tags(const std::string& folder, const TagsOfFolder& of) {
    const TagPairs pairs = pair_tags(of.tags, pairs_);
    for (const TagLoop& loop : pairs.loops) {
      std::vector<std::size_t> files;
      for (const std::optional<std::size_t> tag :
           {std::optional(loop.u), std::optional(loop.y), loop.sp, loop.x}) {
        if (tag) files.insert(files.end(), of.files[*tag].begin(), of.files[*tag].end());
      }
      const std::string name = loop.name.empty()
                                   ? fs::path(folder).parent_path().filename().string()
                                   : loop.name;
      PartOfLoop part{files.front(), kWholeFile, {}};
      part.beside.assign(files.begin() + 1, files.end());
      out_.tasks.push_back(
          {name, of.tags[loop.u].name.text, of.tags[loop.y].name.text, {part}});
    }
    for (const std::string& text : pairs.doubts) doubt(text, {folder});
    for (const std::size_t i : pairs.unpaired) {
      out_.errors.push_back(
          failed(of.tags[i].name.text, paths_of(of.files[i]),
                 file_name_of(of, i) +
                     ": expected u and y of a loop, each in a file of its own, "
                     "found only " +
                     workbench::quoted(of.tags[i].name.text) +
                     "; put the file of the other one beside it, or name the pair with "
                     "--pairs"));
    }
  }

  [[nodiscard]] std::string file_name_of(const TagsOfFolder& of, std::size_t tag) const {
    return fs::path(files_[of.files[tag].front()].path).filename().string();
  }

  // Loops of the list that no file holds.
  void miss_listed() {
    std::set<std::string> found;
    for (const LoopTask& task : out_.tasks) found.insert(task.name);
    for (const ScreenedLoop& error : out_.errors) found.insert(error.loop);
    for (const auto& [loop, tags] : pairs_.list) {
      if (found.contains(loop) || !broken_.empty()) continue;
      out_.errors.push_back(failed(loop, {},
                                   "expected the tags " + workbench::quoted(tags.u) +
                                       " and " + workbench::quoted(tags.y) +
                                       " in one file, or a file of each in one folder, "
                                       "found neither; check the list of --pairs"));
    }
  }

  void tell_names_apart() {
    std::map<std::string, int> names;
    for (const LoopTask& task : out_.tasks) ++names[task.name];
    for (LoopTask& task : out_.tasks) {
      if (names[task.name] < 2) continue;
      const PartOfLoop& part = task.parts.front();
      const fs::path path = files_[part.file].path;
      task.name =
          part.loop == kWholeFile && pool_
              ? (path.parent_path().filename() / task.name).string()
              : (path.parent_path().filename() / path.stem() / task.name).string();
    }
  }

  const std::vector<ExportFile>& files_;
  const std::map<std::size_t, std::string>& broken_;
  const PairRules& pairs_;
  const bool pool_;
  std::set<std::pair<std::string, std::string>> first_parts_;
  std::map<std::pair<std::string, std::string>, std::size_t> known_;
  std::map<std::string, TagsOfFolder> tags_;  // by folder
  LoopTasks out_;
};

}  // namespace

LoopTasks make_tasks(const std::vector<ExportFile>& files,
                     const std::map<std::size_t, std::string>& broken,
                     const PairRules& pairs, bool pool) {
  return TaskMaker(files, broken, pairs, pool).make();
}

std::string folder_of(const std::string& path, bool pool) {
  std::string out;
  for (const fs::path& part : fs::path(path).parent_path()) {
    if (pool && is_date_like(part.string())) continue;
    out += part.string() + (part == "/" ? "" : "/");
  }
  return out;
}

ScreenedLoop failed(const std::string& name, std::vector<std::string> files,
                    const std::string& why) {
  ScreenedLoop loop;
  loop.loop = name;
  loop.files = std::move(files);
  loop.error = why;
  return loop;
}

std::string key_of(const LoopTask& task, const std::vector<ExportFile>& files,
                   const ReadOptions& read) {
  std::string key;
  const auto add_file = [&key, &files](std::size_t i) {
    key += '|' + files[i].path + '|' + std::to_string(files[i].bytes) + '|' +
           std::to_string(files[i].modified);
  };
  for (const PartOfLoop& part : task.parts) {
    const ExportFile& file = files[part.file];
    add_file(part.file);
    for (const std::size_t beside : part.beside) add_file(beside);
    key += '|' + (task.u_tag.empty() ? file.names.u + file.names.y
                                     : task.u_tag + ' ' + task.y_tag);
  }
  if (read.ts) key += "|ts " + std::to_string(*read.ts);
  if (!read.names.time.empty()) key += "|time " + read.names.time;
  if (read.date_order) {
    key += "|order " + std::to_string(static_cast<int>(*read.date_order));
  }
  if (read.decimal) key += std::string("|decimal ") + *read.decimal;
  return key;
}

}  // namespace workbench
