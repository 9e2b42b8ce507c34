#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <system_error>
#include <utility>

namespace swivel::command {

namespace {

using namespace std::chrono_literals;

std::string bar(std::uint64_t done, std::uint64_t total, std::chrono::seconds elapsed) {
    if (total == 0) return std::to_string(elapsed.count()) + " s";
    constexpr std::size_t width = 30;
    const double part = std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
    const auto filled = static_cast<std::size_t>(part * static_cast<double>(width));
    std::string text = "[";
    text.append(filled, '#').append(width - filled, '.').append("] ");
    return text + std::to_string(static_cast<int>(part * 100)) + " %";
}

}  // namespace

progress::progress(std::string label, std::uint64_t total, bool wanted)
    : label_(std::move(label)), total_(total) {
    if (!wanted || isatty(STDERR_FILENO) == 0) return;
    try {
        painter_ = std::thread([this] { paint_until_finished(); });
    } catch (const std::system_error&) {
        // No thread to be had: the work goes on without a bar.
    }
}

progress::~progress() {
    if (!painter_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        finished_ = true;
    }
    wake_.notify_one();
    painter_.join();
}

void progress::paint_until_finished() {
    const auto begin = std::chrono::steady_clock::now();
    std::unique_lock lock(mutex_);
    auto pause = 1000ms;
    bool painted = false;
    while (!wake_.wait_for(lock, pause, [this] { return finished_; })) {
        const auto elapsed =
            std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - begin);
        const std::string line =
            "\r" + label_ + " " + bar(done_.load(std::memory_order_relaxed), total_, elapsed);
        std::fputs(line.c_str(), stderr);
        std::fflush(stderr);
        painted = true;
        pause = 100ms;
    }
    if (painted) std::fputs("\r\033[K", stderr);
}

}  // namespace swivel::command
