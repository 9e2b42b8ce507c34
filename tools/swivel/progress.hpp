#ifndef SWIVEL_COMMAND_PROGRESS_HPP
#define SWIVEL_COMMAND_PROGRESS_HPP

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

namespace swivel::command {

// A bar on standard error while it lives, if that is a terminal and the work takes more than a second. With
// an unknown total (0) it shows the seconds instead. It is gone from the terminal before the destructor
// returns.
class progress {
public:
    // `wanted` is false where the results go to the same terminal.
    progress(std::string label, std::uint64_t total, bool wanted = true);
    progress(const progress&) = delete;
    progress& operator=(const progress&) = delete;
    ~progress();

    void reached(std::uint64_t done) noexcept { done_.store(done, std::memory_order_relaxed); }

private:
    void paint_until_finished();

    std::string label_;
    std::uint64_t total_;
    std::atomic<std::uint64_t> done_{0};
    std::mutex mutex_;
    std::condition_variable wake_;
    bool finished_ = false;
    std::thread painter_;
};

}  // namespace swivel::command

#endif
