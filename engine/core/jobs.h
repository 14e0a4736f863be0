// Workers: threads that take the most urgent job first. A job makes plain data; it may not throw and may not touch GL.
#pragma once
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "engine/core/check.h"

namespace luftpost::core {
/// A pool of threads over one ordered queue. submit, cancel and help may be called from any thread.
/// With 0 workers nothing runs until someone calls help() or finish(). The destructor drops what has not begun and waits for what has.
class Jobs {
public:
    /// Names a job that has not begun. Order is (priority, order of submission).
    using Ticket = std::pair<double, std::uint64_t>;

    explicit Jobs(int workers) {
        CHECK(workers >= 0, "{} workers", workers);
        for (int i = 0; i < workers; ++i) threads_.emplace_back([this] { work(); });
    }
    ~Jobs() {
        {
            std::lock_guard const lock{mutex_};
            stopping_ = true;
            queue_.clear();
        }
        wake_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }
    Jobs(Jobs const&) = delete;
    Jobs& operator=(Jobs const&) = delete;

    /// Queues `run`. A smaller priority runs sooner; equal ones in the order they came.
    Ticket submit(double priority, std::function<void()> run) {
        std::unique_lock lock{mutex_};
        Ticket const ticket{priority, next_++};
        queue_.emplace(ticket, std::move(run));
        lock.unlock();
        wake_.notify_one();
        return ticket;
    }

    /// True when the job had not begun: it never will.
    bool cancel(Ticket ticket) {
        std::lock_guard const lock{mutex_};
        return queue_.erase(ticket) > 0;
    }

    /// Runs the most urgent job on the calling thread. False when none waits.
    bool help() {
        std::unique_lock lock{mutex_};
        if (queue_.empty()) return false;
        runFirst(lock);
        return true;
    }

    /// Helps until nothing waits and nothing runs.
    void finish() {
        while (help()) {
        }
        std::unique_lock lock{mutex_};
        idle_.wait(lock, [this] { return queue_.empty() && running_ == 0; });
    }

    int workers() const { return static_cast<int>(threads_.size()); }

private:
    void work() {
        std::unique_lock lock{mutex_};
        while (true) {
            wake_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
            if (stopping_) return;
            runFirst(lock);
        }
    }

    void runFirst(std::unique_lock<std::mutex>& lock) {
        auto const run = std::move(queue_.begin()->second);
        queue_.erase(queue_.begin());
        ++running_;
        lock.unlock();
        run();
        lock.lock();
        --running_;
        if (running_ == 0 && queue_.empty()) idle_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable wake_, idle_;
    std::map<Ticket, std::function<void()>> queue_;
    std::vector<std::thread> threads_;
    std::uint64_t next_ = 0;
    int running_ = 0;
    bool stopping_ = false;
};
}  // namespace luftpost::core
