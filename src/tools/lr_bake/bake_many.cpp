#include "tools/lr_bake/bake_many.h"

#include "baker/bake_progress.h"
#include "baker/file_io.h"
#include "baker/hold_signals.h"
#include "baker/printable_text.h"
#include "tools/lr_bake/memory_budget.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

namespace lr::baker {
namespace {

std::string stem_of(const std::string& path_utf8) {
    const std::u8string stem = to_path(path_utf8).stem().u8string();
    return {stem.begin(), stem.end()};
}

std::string in_folder(const std::string& folder, const std::string& file) {
    return folder.empty() || folder.back() == '/' ? folder + file : folder + "/" + file;
}

class Batch {
public:
    Batch(const std::vector<BakeJob>& jobs, const BatchLimits& limits, const BatchEvents& events)
        : jobs_(jobs), events_(events), budget_(limits.memory), parts_(jobs.size()), outcomes_(jobs.size()),
          ready_(jobs.size()) {
        // Workers inherit the blocked signals, which then reach the calling thread; it blocks them while it writes files.
        const SignalsHeld held;
        const std::size_t wanted = std::clamp<std::size_t>(limits.threads, 1, std::max<std::size_t>(jobs.size(), 1));
        solver_threads_ = std::max(1U, std::thread::hardware_concurrency() / static_cast<unsigned>(wanted));
        threads_.reserve(wanted);
        try {
            while (threads_.size() < wanted) threads_.emplace_back([this] { work(); });
        } catch (const std::system_error&) { // no more threads are allowed; the present ones do the work
        }
    }
    ~Batch() {
        next_ = jobs_.size(); // after an exception, workers take no more jobs
        for (std::thread& t : threads_) t.join();
    }
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;

    std::size_t run() {
        if (threads_.empty()) work();
        for (std::size_t finished = 0; finished < jobs_.size(); ++finished) {
            const std::size_t i = wait();
            write_outputs(jobs_[i], outcomes_[i]);
            outcomes_[i].files = {};
            failed_ += outcomes_[i].state == BakeOutcome::State::failed;
            ready_[i] = true;
            for (; next_shown_ < jobs_.size() && ready_[next_shown_]; ++next_shown_) {
                if (events_.done) events_.done(jobs_[next_shown_], outcomes_[next_shown_]);
                outcomes_[next_shown_] = {};
            }
        }
        return failed_;
    }

private:
    std::size_t wait() {
        std::unique_lock lock(mutex_);
        while (made_.empty()) {
            changed_.wait_for(lock, std::chrono::milliseconds(200));
            if (!events_.progress) continue;
            double finished = 0.0;
            for (const std::atomic<double>& part : parts_) finished += part.load(std::memory_order_relaxed);
            lock.unlock();
            events_.progress(finished);
            lock.lock();
        }
        const std::size_t i = made_.front();
        made_.pop_front();
        return i;
    }

    void work() {
        for (std::size_t i = next_.fetch_add(1); i < jobs_.size(); i = next_.fetch_add(1)) {
            make(i);
            parts_[i] = 1.0;
            const std::lock_guard lock(mutex_);
            made_.push_back(i);
            changed_.notify_one();
        }
    }

    void make(std::size_t i) {
        uint64_t reserved = 0;
        BakeHooks hooks;
        hooks.threads = solver_threads_;
        hooks.before_solve = [&](std::size_t faces) {
            budget_.acquire(solve_memory(faces));
            reserved = solve_memory(faces);
        };
        const auto progress = [&](const char* phase, double fraction) {
            parts_[i] = std::min(overall_progress(phase, fraction), 0.99);
            // Later phases need little memory, so waiting jobs can start.
            if (reserved > 0 && fraction >= 1.0 && std::strcmp(phase, "added mass") == 0)
                budget_.release(std::exchange(reserved, 0));
        };
        try {
            outcomes_[i] = make_outputs(jobs_[i], progress, hooks);
        } catch (const std::bad_alloc&) {
            outcomes_[i].state = BakeOutcome::State::failed;
            outcomes_[i].faults.push_back({FaultId::mesh_too_many_faces, Severity::error, "memory",
                                           "The bake does not fit into memory.", "Use fewer --jobs."});
        }
        if (reserved > 0) budget_.release(reserved);
    }

    const std::vector<BakeJob>& jobs_;
    const BatchEvents& events_;
    MemoryBudget budget_;
    std::atomic<std::size_t> next_{0};
    std::vector<std::atomic<double>> parts_; // of each job, finished
    std::vector<BakeOutcome> outcomes_;      // each written by one worker, read after its index is in made_
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::size_t> made_;
    std::vector<char> ready_; // until failed_: used only by the calling thread
    std::size_t next_shown_ = 0, failed_ = 0;
    unsigned solver_threads_ = 1; // for each job: jobs share the processors
    std::vector<std::thread> threads_;
};
} // namespace

std::optional<std::vector<BakeJob>> plan_batch(const std::vector<std::string>& inputs, const BakeOptions& options,
                                               const BatchFolders& folders, bool if_changed, std::string& clash) {
    std::vector<BakeJob> jobs;
    std::map<std::string, std::string> inputs_of; // by output
    for (const std::string& input : inputs) {
        BakeJob job;
        job.bake = options;
        job.bake.mesh_path = input;
        job.output = in_folder(folders.assets, stem_of(input) + ".lrb");
        if (!folders.reports.empty()) job.report = in_folder(folders.reports, stem_of(input) + ".json");
        if (!folders.previews.empty()) job.preview = in_folder(folders.previews, stem_of(input) + ".png");
        job.plots = folders.plots;
        job.plot_prefix = stem_of(input) + ".";
        job.if_changed = if_changed;
        const auto [other, fresh] = inputs_of.emplace(job.output, input);
        if (!fresh) {
            clash = "'" + other->second + "' and '" + input + "' both give '" + job.output + "': rename one";
            return {};
        }
        jobs.push_back(std::move(job));
    }
    return jobs;
}

std::vector<BakeJob> plan_islands(const std::vector<BakeJob>& jobs) {
    std::vector<BakeJob> all;
    const auto numbered = [](std::string path, std::size_t number) {
        const std::size_t slash = path.rfind('/'), dot = path.rfind('.');
        const bool has_ending = dot != std::string::npos && (slash == std::string::npos || dot > slash + 1) && dot > 0;
        return path.insert(has_ending ? dot : path.size(), "_" + std::to_string(number));
    };
    for (const BakeJob& job : jobs) {
        std::vector<uint8_t> bytes;
        Faults ignored;
        CardOptions card = *job.bake.card;
        card.width /= units_per_metre(job.bake.unit);
        const std::string& image = card.mask_path.empty() ? job.bake.mesh_path : card.mask_path;
        std::size_t pieces = 0;
        if (read_file(image, std::size_t{1} << 30, bytes, ignored))
            pieces = count_card_pieces(bytes.data(), bytes.size(), card, image, ignored);
        for (std::size_t i = 1; i <= pieces; ++i) {
            BakeJob one = job;
            one.bake.card->piece = i;
            one.bake.name = asset_name(job.bake) + "_" + std::to_string(i);
            one.output = numbered(job.output, i);
            if (!job.report.empty()) one.report = numbered(job.report, i);
            if (!job.preview.empty()) one.preview = numbered(job.preview, i);
            one.plot_prefix = job.plot_prefix + std::to_string(i) + ".";
            all.push_back(std::move(one));
        }
        if (pieces == 0) all.push_back(job);
    }
    return all;
}

bool read_list(const std::string& path, std::vector<std::string>& inputs, Faults& faults) {
    std::string text;
    if (path == "-") {
        text.assign(std::istreambuf_iterator<char>(std::cin), {});
    } else {
        std::vector<uint8_t> bytes;
        if (!read_file(path, std::size_t{1} << 28, bytes, faults)) return false;
        text.assign(bytes.begin(), bytes.end());
    }
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string line = text.substr(begin, end - begin);
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (!line.empty()) inputs.push_back(std::move(line));
        begin = end + 1;
    }
    return true;
}

std::size_t run_batch(const std::vector<BakeJob>& jobs, const BatchLimits& limits, const BatchEvents& events) {
    return Batch(jobs, limits, events).run();
}
} // namespace lr::baker
