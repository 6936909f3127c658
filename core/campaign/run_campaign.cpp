#include "core/campaign/run_campaign.hpp"

#include "core/base/error.hpp"
#include "core/campaign/child_process.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/messages.hpp"
#include "core/io/progress.hpp"
#include "core/run/failure.hpp"
#include "core/run/memory_there.hpp"
#include "core/run/output_folder.hpp"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fstream>
#include <list>
#include <sstream>
#include <thread>

namespace riedel {

namespace {

namespace fs = std::filesystem;

/// The last error among a run's messages, without the program's name; empty if there is none.
std::string last_error(const std::string& messages) {
  constexpr std::string_view mark = "riedel: error: ";
  const std::size_t at = messages.rfind(mark);
  if (at == std::string::npos) return "";
  const std::size_t start = at + mark.size();
  return messages.substr(start, messages.find('\n', start) - start);
}

std::string ending_text(int ending) {
  if (ending < 0) return "ended by signal " + std::to_string(-ending) + " (" + strsignal(-ending) + ")";
  return "ended with exit code " + std::to_string(ending) + " without a result";
}

/// A column's number in the last complete row of a table that is being written; 0 if there is none.
double last_of(const fs::path& history, const std::string& column) {
  constexpr std::streamoff tail = 1024; // some rows
  std::ifstream file(history, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  if (!file || size <= 0) return 0.0;
  file.seekg(0);
  std::string head, line, whole;
  std::getline(file, head);
  std::size_t place = 0; // index of the column
  std::istringstream names(head);
  for (std::string name; std::getline(names, name, ',') && name != column;) ++place;
  file.seekg(std::max(static_cast<std::streamoff>(file.tellg()), size - tail));
  while (std::getline(file, line) && !file.eof()) whole = line;
  std::istringstream cells(whole);
  std::string cell;
  for (std::size_t i = 0; i <= place; ++i)
    if (!std::getline(cells, cell, ',')) return 0.0;
  return std::strtod(cell.c_str(), nullptr);
}

/// One of the running runs.
struct Worker {
  Worker(const PlannedRun& its_run, fs::path its_folder, fs::path its_curve, std::string strain,
         const std::vector<std::string>& words)
      : run(its_run),
        folder(std::move(its_folder)),
        curve(std::move(its_curve)),
        column(std::move(strain)),
        process(words) {}

  const PlannedRun& run;
  fs::path folder, curve;
  std::string column; ///< of the strain in the curve
  ChildProcess process;
  bool told_to_stop = false;

  /// At most 99 %, since files are still to be written after the last step.
  [[nodiscard]] double share_done() const {
    const double share = run.final_strain > 0.0 ? std::abs(last_of(curve, column)) / run.final_strain : 0.0;
    return share > 0.0 ? std::min(share, 0.99) : 0.0; // also if it is NaN
  }
};

class Campaign {
public:
  Campaign(const Plan& plan, const fs::path& folder, const CampaignOptions& how)
      : kind_(*plan.kind), folder_(folder), how_(how) {
    for (const std::size_t i : longest_first(plan))
      if (is_open(plan.runs[i])) waiting_.push_back(&plan.runs[i]);
    for (const PlannedRun* run : waiting_) all_work_ += run->work;
    runs_ = waiting_.size();
    at_once_ = std::clamp(std::min(runs_, that_fit()), std::size_t{1}, static_cast<std::size_t>(how.threads));
    threads_each_ = how.threads / static_cast<int>(at_once_);
  }

  void run_campaign() {
    constexpr auto between_looks = std::chrono::milliseconds(20);
    constexpr int looks_between_reports = 10;
    Progress progress(how_.command);
    for (int round = 0; !waiting_.empty() || !workers_.empty(); ++round) {
      if (how_.stop()) stop_all();
      while (!waiting_.empty() && workers_.size() < at_once_) start_next();
      if (round % looks_between_reports == 0) report(progress);
      std::this_thread::sleep_for(between_looks);
      std::erase_if(workers_, [&](Worker& worker) { return has_ended(worker); });
    }
    if (runs_ > 0) report(progress);
  }

private:
  [[nodiscard]] bool is_open(const PlannedRun& run) const {
    const RunResult result = result_of(kind_, run, folder_);
    if (result.status == RunStatus::failed) return lacked_means(result.reason);
    return result.status != RunStatus::done;
  }

  /// Number of runs that fit into the machine's memory at the same time.
  [[nodiscard]] std::size_t that_fit() const {
    double maximum = 0.0;
    for (const PlannedRun* run : waiting_) maximum = std::max(maximum, run->memory);
    const double fit = memory_there().bytes / std::max(maximum, 1.0);
    return fit < static_cast<double>(runs_) ? static_cast<std::size_t>(fit) : runs_;
  }

  void start_next() {
    const PlannedRun& run = *waiting_.front();
    waiting_.erase(waiting_.begin());
    const fs::path folder = folder_ / run.name, given = folder / "case.toml";
    if (!make_ready(folder, run)) return;
    const CaseFile its_case = run.given();
    std::vector<std::string> words = kind_.cases.words(its_case);
    for (const std::string& word : {given.string(), std::string("--out"), folder.string(), std::string("--force"),
                                    std::string("--threads"), "1-" + std::to_string(threads_each_)})
      words.push_back(word);
    workers_.emplace_back(run, folder, folder / kind_.curve_file, kind_.axes(its_case).x, words);
  }

  /// Leaves the case and no summary in the folder: a run that has one counts as finished.
  /// @return false if another process writes there
  [[nodiscard]] bool make_ready(const fs::path& folder, const PlannedRun& run) const {
    try {
      if (fs::is_symlink(folder)) throw RunError(folder.string() + ": is a symbolic link, which runs do not follow");
      fs::create_directories(folder);
      const FolderLock lock(folder, how_.command);
      remove_file(folder / "summary.json");
      write_atomically(folder / "case.toml", run.case_text);
      return true;
    } catch (const fs::filesystem_error& error) {
      throw RunError(folder.string() + ": cannot be prepared: " + error.code().message());
    } catch (const InputError& refusal) {
      if (std::string_view(refusal.what()).find(FolderLock::refusal) == std::string_view::npos) throw;
      print_warning(refusal.what());
      return false;
    }
  }

  bool has_ended(Worker& worker) {
    if (worker.process.running()) return false;
    done_work_ += worker.run.work;
    const std::string error = last_error(worker.process.messages());
    if (error.find(FolderLock::refusal) != std::string::npos) { // another process is running it
      print_warning(error);
      return true;
    }
    if (worker.process.ending() != 0 && lacked_space(error)) {
      remove_file(worker.folder / "summary.json"); // so that it runs again
      throw RunError(worker.folder.string() + ": " + error +
                     "; the campaign stops here: finished runs are kept, and it continues when started again");
    }
    if (!worker.told_to_stop && !fs::exists(worker.folder / "summary.json"))
      write_failed_summary(kind_, worker.folder, error.empty() ? ending_text(worker.process.ending()) : error);
    return true;
  }

  void stop_all() {
    waiting_.clear();
    for (Worker& worker : workers_)
      if (!std::exchange(worker.told_to_stop, true)) worker.process.send(SIGTERM);
  }

  void report(Progress& progress) const {
    double work = done_work_;
    std::string names;
    for (const Worker& worker : workers_) {
      work += worker.run.work * worker.share_done();
      names += (names.empty() ? ", now " : "; ") + worker.run.label;
    }
    const std::size_t ended = runs_ - waiting_.size() - workers_.size();
    progress.update(work / all_work_, std::to_string(ended) + " of " + std::to_string(runs_) + " runs" + names);
  }

  const RunKind& kind_;
  const fs::path& folder_;
  const CampaignOptions& how_;
  std::vector<const PlannedRun*> waiting_;
  std::list<Worker> workers_;
  std::size_t runs_ = 0, at_once_ = 1;
  int threads_each_ = 1;
  double all_work_ = 0.0, done_work_ = 0.0;
};

} // namespace

void run_campaign(const Plan& plan, const fs::path& folder, const CampaignOptions& how) {
  Campaign(plan, folder, how).run_campaign();
}

} // namespace riedel
