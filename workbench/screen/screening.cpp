#include "workbench/screen/screening.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <stop_token>
#include <thread>

#include "workbench/model/base/one_loop.hpp"
#include "workbench/model/base/work.hpp"
#include "workbench/recording/source.hpp"
#include "workbench/recording/stopped.hpp"
#include "workbench/screen/disjoint_sets.hpp"
#include "workbench/screen/found_files.hpp"
#include "workbench/screen/groups.hpp"
#include "workbench/screen/journal.hpp"
#include "workbench/screen/loop_tasks.hpp"
#include "workbench/screen/screen_advice.hpp"
#include "workbench/screen/screen_loop.hpp"
#include "workbench/screen/split_export.hpp"

namespace workbench {
namespace {

constexpr std::size_t kWholeFile = PartOfLoop::kWholeFile;

class Screener {
 public:
  Screener(const ScreeningOptions& options, const std::atomic<bool>& stop,
           std::function<void(const ScreeningProgress&)> watch)
      : options_(options),
        stop_(stop),
        watch_(std::move(watch)),
        journal_(options.journal),
        work_({options.threads > 0 ? options.threads : Work::cores()}),
        read_(options.read) {
    read_.stop = reading_.get_token();
  }

  ScreeningPlan plan(const std::vector<std::string>& paths) {
    ScreeningPlan out;
    out.problems = look(paths);
    DisjointSets together(files_.size());
    // Tags of a long table are not known yet: those of one folder stay together.
    std::map<std::string, std::size_t> long_of;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (files_[i].kind != ExportFile::Kind::kLong) continue;
      const std::string folder = folder_of(files_[i].path, options_.pool);
      together.join(long_of.try_emplace(folder, i).first->second, i);
    }
    make_tasks();
    std::vector<std::size_t> loops(files_.size(), 0);
    for (const LoopTask& task : tasks_) {
      const std::size_t first = task.parts.front().file;
      for (const PartOfLoop& part : task.parts) {
        together.join(first, part.file);
        for (const std::size_t beside : part.beside) together.join(first, beside);
      }
      ++loops[task.parts.front().file];
    }
    std::map<std::size_t, IndependentFiles> sets;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      IndependentFiles& set = sets[together.root(i)];
      set.files.push_back(files_[i].path);
      set.bytes += files_[i].bytes;
      set.loops += loops[i];
    }
    for (auto& [first, set] : sets) out.sets.push_back(std::move(set));
    return out;
  }

  Screening run(const std::vector<std::string>& paths) {
    for (const PathProblem& problem : look(paths)) {
      errors_.push_back(failed(problem.path, {problem.path}, problem.what));
    }
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (files_[i].kind == ExportFile::Kind::kLong) split(i, {});
    }
    make_tasks();
    resume();
    split_wide();
    identify();
    collect();
    return std::move(out_);
  }

 private:
  using Phase = ScreeningProgress::Phase;

  void tell(Phase phase, std::uint64_t done, std::uint64_t all, const std::string& at) {
    if (watch_) watch_({phase, done, all, at});
  }

  [[nodiscard]] bool time_is_over() const {
    return options_.within_s > 0 && std::chrono::steady_clock::now() - begin_ >
                                        std::chrono::duration<double>(options_.within_s);
  }

  std::vector<PathProblem> look(const std::vector<std::string>& paths) {
    FoundFiles found = find_files(paths);
    files_.resize(found.files.size());
    std::mutex mutex;
    std::uint64_t done = 0;
    work_.for_each(files_.size(), [&](std::size_t i) {
      if (stop_) return;
      try {
        files_[i] = look_into(found.files[i], read_);
      } catch (const Stopped&) {
        return;
      }
      const std::lock_guard lock(mutex);
      tell(Phase::kLooking, ++done, files_.size(), {});
    });
    if (stop_) files_.clear();
    exports_.resize(files_.size());
    out_.passed_over = std::move(found.passed_over);
    return std::move(found.problems);
  }

  void split(std::size_t file, const std::vector<bool>& wanted) {
    if (stop_) return;
    const std::string& path = files_[file].path;
    try {
      auto made =
          std::make_unique<SplitExport>(files_[file], options_.read, options_.scratch);
      const bool whole = made->split(wanted, [&](std::uint64_t done, std::uint64_t all) {
        tell(Phase::kSplitting, done, all, path);
        return !stop_ && !(one_is_split_ && time_is_over());
      });
      if (!whole) {
        cut_off_ = true;
        return;
      }
      one_is_split_ = true;
      files_[file].loops = made->file().loops;
      files_[file].unpaired = made->file().unpaired;
      files_[file].doubts = made->file().doubts;
      exports_[file] = std::move(made);
      const ExportFile& taken = files_[file];
      if (taken.loops.empty() && taken.doubts.empty()) {
        errors_.push_back(failed(taken.loop, {path},
                                 "expected tags that make a loop, found none; name them "
                                 "with --pairs"));
      }
    } catch (const InputError& error) {
      broken_[file] = screen_advice(error.what(), path);
      errors_.push_back(failed(files_[file].loop, {path}, broken_[file]));
    }
  }

  void make_tasks() {
    LoopTasks made =
        workbench::make_tasks(files_, broken_, options_.read.pairs, options_.pool);
    tasks_ = std::move(made.tasks);
    out_.unpaired = std::move(made.unpaired);
    for (ScreenedLoop& error : made.errors) errors_.push_back(std::move(error));
    results_.resize(tasks_.size());
    broken_parts_.resize(tasks_.size());
  }

  [[nodiscard]] std::string key(const LoopTask& task) const {
    return key_of(task, files_, options_.read) + (options_.same_clock ? "|clock" : "");
  }

  void resume() {
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      results_[i] = journal_.find(key(tasks_[i]));
      if (!results_[i]) continue;
      ++out_.resumed;
      results_[i]->loop = tasks_[i].name;
    }
  }

  void split_wide() {
    std::vector<std::vector<bool>> wanted(files_.size());
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      if (results_[i]) continue;
      for (const PartOfLoop& part : tasks_[i].parts) {
        if (part.loop == kWholeFile) continue;
        wanted[part.file].resize(files_[part.file].loops.size(), false);
        wanted[part.file][part.loop] = true;
      }
    }
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (files_[i].kind != ExportFile::Kind::kWide || wanted[i].empty()) continue;
      split(i, wanted[i]);
    }
  }

  [[nodiscard]] Recording read(const LoopTask& task, const PartOfLoop& part) const {
    const ExportFile& file = files_[part.file];
    if (part.loop != kWholeFile) return exports_[part.file]->recording(part.loop);
    RecordingSource source;
    source.path = file.path;
    for (const std::size_t beside : part.beside) {
      source.beside.push_back(files_[beside].path);
    }
    static_cast<CsvOptions&>(source) = read_;
    source.names = file.names;
    source.names.time = read_.names.time;
    if (!part.beside.empty()) {
      source.names.u = task.u_tag;
      source.names.y = task.y_tag;
    }
    return read_recording(source);
  }

  void identify_one(std::size_t i) {
    const LoopTask& task = tasks_[i];
    std::vector<Recording> recordings;
    std::vector<std::string> clocks;
    std::vector<std::string> files;
    std::string first_error;
    bool whole = true;
    for (const PartOfLoop& part : task.parts) {
      const std::string& path = files_[part.file].path;
      if (const auto why = broken_.find(part.file); why != broken_.end()) {
        if (first_error.empty()) first_error = why->second;
        whole = false;
        continue;
      }
      try {
        recordings.push_back(read(task, part));
        clocks.push_back(options_.same_clock ? "-" : path);
        files.push_back(path);
        for (const std::size_t k : part.beside) files.push_back(files_[k].path);
      } catch (const std::bad_alloc&) {
        throw;
      } catch (const std::exception& error) {
        const std::string why = screen_advice(error.what(), path);
        if (first_error.empty()) first_error = why;
        whole = false;
        broken_parts_[i].push_back(failed(task.name, {path}, why));
      }
    }
    try {
      check_one_loop(recordings);
    } catch (const InputError& error) {
      recordings.clear();
      first_error = error.what();
    }
    ScreenedLoop loop;
    if (!recordings.empty()) {
      loop = screen_loop(std::move(recordings), clocks, [this] { return stop_.load(); });
      loop.loop = task.name;
      loop.files = std::move(files);
      loop.u_tag = task.u_tag;
      loop.y_tag = task.y_tag;
    } else {
      broken_parts_[i].clear();
      for (const PartOfLoop& part : task.parts) files.push_back(files_[part.file].path);
      loop = failed(task.name, std::move(files), first_error);
    }
    // What could not be read may be readable next time.
    if (whole && loop.error.empty()) {
      journal_.add(key(task), loop);
      one_is_journaled_ = true;
    }
    // As the journal gives it back: a screening that went on says what a whole one says.
    results_[i] = from_journal(journal_json(loop));
  }

  void identify() {
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      const bool read =
          std::ranges::all_of(tasks_[i].parts, [this](const PartOfLoop& part) {
            return part.loop == kWholeFile || exports_[part.file] != nullptr ||
                   broken_.contains(part.file);
          });
      if (!results_[i] && read) left.push_back(i);
    }
    std::mutex mutex;
    std::uint64_t done = 0;
    work_.for_each(left.size(), [&](std::size_t k) {
      if (stop_ || (one_is_journaled_ && time_is_over())) return;
      try {
        identify_one(left[k]);
      } catch (const Stopped&) {
        return;
      } catch (const std::bad_alloc&) {
        results_[left[k]] = failed(tasks_[left[k]].name, {}, "out of memory");
      }
      const std::lock_guard lock(mutex);
      tell(Phase::kIdentifying, ++done, left.size(), {});
    });
  }

  void collect() {
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      if (!results_[i]) {
        ++out_.left_out;
        continue;
      }
      rate(*results_[i]);
      if (results_[i]->error.empty()) ++out_.readable;
      out_.loops.push_back(std::move(*results_[i]));
      for (ScreenedLoop& broken : broken_parts_[i]) errors_.push_back(std::move(broken));
    }
    out_.complete = !stop_ && !cut_off_ && out_.left_out == 0;
    find_groups(out_.loops);
    note_zones(out_.loops);
    share_costs(out_.loops);
    for (ScreenedLoop& error : errors_) out_.loops.push_back(std::move(error));
    std::ranges::stable_sort(out_.loops,
                             [](const ScreenedLoop& a, const ScreenedLoop& b) {
                               const bool a_bad = !a.error.empty();
                               const bool b_bad = !b.error.empty();
                               if (a_bad != b_bad) return b_bad;
                               if (a.cost != b.cost) return a.cost > b.cost;
                               return a.loop < b.loop;
                             });
  }

  const ScreeningOptions& options_;
  const std::atomic<bool>& stop_;
  const std::function<void(const ScreeningProgress&)> watch_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Journal journal_;
  Work work_;
  std::stop_source reading_;
  ReadOptions read_;  // ends where `reading_` is asked to
  std::vector<ExportFile> files_;
  std::vector<std::unique_ptr<SplitExport>> exports_;
  std::map<std::size_t, std::string> broken_;  // files that could not be split, and why
  bool cut_off_ = false;                       // a table was not read to its end
  // One of each at least, or the same command again would never come to an end.
  bool one_is_split_ = false;
  std::atomic<bool> one_is_journaled_{false};
  std::vector<LoopTask> tasks_;
  std::vector<std::optional<ScreenedLoop>> results_;
  std::vector<std::vector<ScreenedLoop>> broken_parts_;
  std::vector<ScreenedLoop> errors_;
  Screening out_;
  // A signal may do no more than set `stop_`.
  std::jthread ends_reading_{[this](const std::stop_token& over) {
    constexpr std::chrono::milliseconds kAskedEvery{30};
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any asked;
    while (!over.stop_requested() && !stop_) {
      asked.wait_for(lock, over, kAskedEvery, [this] { return stop_.load(); });
    }
    reading_.request_stop();
  }};
};

}  // namespace

Screening screen(const std::vector<std::string>& paths, const ScreeningOptions& options,
                 const std::atomic<bool>& stop,
                 const std::function<void(const ScreeningProgress&)>& watch) {
  return Screener(options, stop, watch).run(paths);
}

ScreeningPlan plan_screening(const std::vector<std::string>& paths,
                             const ScreeningOptions& options) {
  const std::atomic<bool> never{false};
  return Screener(options, never, {}).plan(paths);
}

}  // namespace workbench
