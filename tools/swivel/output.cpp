#include "output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "failure.hpp"

namespace swivel::command {

namespace {

// The temporary file that a signal has to remove. A signal handler may look at nothing else.
std::atomic<const char*> pending_file{nullptr};
static_assert(std::atomic<const char*>::is_always_lock_free);

extern "C" void remove_pending_file(int signal_number) {
    if (const char* const path = pending_file.load()) unlink(path);
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number);
}

void watch(int signal_number) noexcept {
    if (std::signal(signal_number, remove_pending_file) == SIG_IGN) std::signal(signal_number, SIG_IGN);
}

}  // namespace

output::output(const std::string& path) : name_(path == "-" ? "<stdout>" : path), target_(path) {
    if (path == "-") {
        file_ = stdout;
        return;
    }
    if (path.empty()) throw bad_data("the name of the output file is empty");

    follow_links();
    struct stat about {};
    const bool exists = stat(target_.c_str(), &about) == 0;
    if (exists && S_ISDIR(about.st_mode)) fail("write the file", EISDIR);
    if (exists && !S_ISREG(about.st_mode)) {
        file_ = std::fopen(target_.c_str(), "wb");
        if (!file_) fail("open the file", errno);
        return;
    }
    // Renaming would replace a file that may not be written to.
    if (exists && access(target_.c_str(), W_OK) != 0) fail("write the file", errno);
    open_temporary();
    if (exists && fchown(fileno(file_), about.st_uid, about.st_gid) != 0) {
        // Only root gives files away.
    }
    // After the owner, whose change takes bits of the mode away. mkstemp lets nobody but the owner in.
    const mode_t mask = umask(0);
    umask(mask);
    const mode_t mode = exists ? about.st_mode & 07777 : 0666 & ~mask;
    if (fchmod(fileno(file_), mode) != 0) {
        // The file system has no modes of its own, and the file is as it will be.
    }
}

void output::follow_links() {
    namespace fs = std::filesystem;
    constexpr int most = 40;
    std::error_code ignored;
    fs::path target = target_;
    for (int links = 0; fs::is_symlink(fs::symlink_status(target, ignored)); ++links) {
        if (links == most) fail("write the file", ELOOP);
        target = target.parent_path() / fs::read_symlink(target, ignored);
    }
    target_ = target.string();
}

void output::open_temporary() {
    const std::filesystem::path target(target_);
    // A name has 255 bytes at most.
    const std::string whose = target.filename().string().substr(0, 200);
    std::string pattern = (target.parent_path() / ("." + whose + ".swivel-XXXXXX")).string();
    const int descriptor = mkstemp(pattern.data());
    if (descriptor < 0) fail("create a temporary file in the same folder", errno);
    temporary_ = pattern;
    pending_file.store(temporary_.c_str());
    // All that end a program and may be caught; batch systems send XCPU and USR1 before they kill.
    for (const int signal_number :
         {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT, SIGALRM, SIGUSR1, SIGUSR2, SIGXCPU, SIGVTALRM, SIGPROF})
        watch(signal_number);
    file_ = fdopen(descriptor, "wb");
    if (file_) return;
    const int reason = errno;
    close(descriptor);
    pending_file.store(nullptr);
    unlink(temporary_.c_str());
    fail("open the file", reason);
}

output::~output() {
    if (file_ && file_ != stdout) std::fclose(file_);
    if (temporary_.empty()) return;
    unlink(temporary_.c_str());
    pending_file.store(nullptr);
}

void output::fail(std::string_view doing, int error_number) const {
    if (error_number == EPIPE) throw closed_pipe();
    throw bad_data(name_ + ": cannot " + std::string(doing) + ": " +
                   std::generic_category().message(error_number));
}

bool output::is_terminal() const noexcept { return isatty(fileno(file_)) != 0; }

void output::write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail("write the file", errno);
}

void output::flush() {
    if (std::fflush(file_) != 0) fail("write the file", errno);
}

void output::commit() {
    flush();
    if (file_ == stdout) return;
    // After a crash of the system there is the old file or the new one, and not an empty one.
    if (!temporary_.empty() && fsync(fileno(file_)) != 0 && errno != EINVAL && errno != ENOTSUP)
        fail("write the file", errno);
    std::FILE* const file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0) fail("write the file", errno);
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail("replace the file", errno);
    pending_file.store(nullptr);
    temporary_.clear();
}

void require_other_file(const std::string& read, const std::string& written) {
    struct stat in {
    }, out{};
    const bool read_is_there = read == "-" ? fstat(STDIN_FILENO, &in) == 0 : stat(read.c_str(), &in) == 0;
    if (!read_is_there || written == "-" || stat(written.c_str(), &out) != 0) return;
    if (S_ISREG(in.st_mode) && in.st_dev == out.st_dev && in.st_ino == out.st_ino)
        throw bad_usage("--out: " + written + " is the file that is read, expected another one");
}

void prepare_standard_streams() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    for (int descriptor = 0; descriptor < 3; ++descriptor) {
        if (fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
        // Opened for the wrong direction, so that using it fails as on a closed one.
        const int opened = open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);
        if (opened != descriptor && opened >= 0) close(opened);
    }
}

}  // namespace swivel::command
