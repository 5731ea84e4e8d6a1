// SPDX-License-Identifier: MIT
// The judge: starts a fresh worker for every test case, asks it, and gives it no more time than it may have. What the worker does
// wrong is the running test's failure, written down before anything is thrown.

#include "judge.hpp"

#include "channel.hpp"

#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch.hpp>

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/interfaces/catch_interfaces_reporter.hpp>
#include <catch2/internal/catch_assertion_handler.hpp>
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
using listener_base = Catch::EventListenerBase;
#else
using listener_base = Catch::TestEventListenerBase;
#endif

#include <lantern/todo.hpp>

#include <fcntl.h>
#include <signal.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <new>
#include <optional>

namespace contract::judge {

namespace {

using clock = channel::clock;
using std::chrono::duration_cast;
using std::chrono::milliseconds;

/// A limit in seconds, from the environment where it says another.
milliseconds limit(const char* variable, double otherwise) {
    const char* said = std::getenv(variable);
    return milliseconds(long(1000 * (said ? std::atof(said) : otherwise)));
}

/// The command that starts a worker: LANTERN_WORKER names a file that holds its words, each ended by a zero byte.
std::vector<std::string> command() {
    const char* path = std::getenv("LANTERN_WORKER");
    std::ifstream file(path ? path : "", std::ios::binary);
    std::vector<std::string> words;
    for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
    return words;
}

/// 200 characters at most, all of them printable.
std::string printable(std::string_view text) {
    std::string shown(text.substr(0, 200));
    std::replace_if(shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return shown;
}

/// The running test fails, at the line of the suite that asked.
void record_failure(const std::string& what, location caller) {
    Catch::AssertionHandler handler(Catch::StringRef("FAIL"), Catch::SourceLineInfo(caller.file, caller.line), Catch::StringRef(),
                                    Catch::ResultDisposition::ContinueOnFailure);
    handler.handleMessage(Catch::ResultWas::ExplicitFailure, std::string(what));
    handler.complete();
}

[[noreturn]] void throw_again(wire::thrown type, const std::string& text) {
    using wire::thrown;
    struct other_exception : std::exception {
        std::string text;
        explicit other_exception(std::string t) : text(std::move(t)) {}
        [[nodiscard]] const char* what() const noexcept override { return text.c_str(); }
    };
    switch (type) {
        case thrown::unfinished: throw lantern::unfinished(text);
        case thrown::bad_alloc: throw std::bad_alloc();
        case thrown::bad_optional_access: throw std::bad_optional_access();
        case thrown::bad_variant_access: throw std::bad_variant_access();
        case thrown::bad_function_call: throw std::bad_function_call();
        case thrown::logic_error: throw std::logic_error(text);
        case thrown::invalid_argument: throw std::invalid_argument(text);
        case thrown::domain_error: throw std::domain_error(text);
        case thrown::length_error: throw std::length_error(text);
        case thrown::out_of_range: throw std::out_of_range(text);
        case thrown::runtime_error: throw std::runtime_error(text);
        case thrown::range_error: throw std::range_error(text);
        case thrown::overflow_error: throw std::overflow_error(text);
        case thrown::underflow_error: throw std::underflow_error(text);
        case thrown::exception: throw other_exception(text);
        case thrown::other: break;
    }
    struct no_exception {};
    throw no_exception{};
}

class worker_process {
public:
    std::string ask(std::string_view function, std::uint32_t index, std::string_view arguments, const std::vector<callback>& callbacks,
                    location caller) {
        if (!loss_.empty()) throw lost{loss_};
        const clock::time_point asked = clock::now();
        const bool outermost = depth_ == 0;
        if (outermost) until_ = asked + std::min(call_limit_, case_limit_ - spent_);
        const struct nesting {
            worker_process& self;
            clock::time_point since;
            ~nesting() {
                if (--self.depth_ == 0) self.spent_ += duration_cast<milliseconds>(clock::now() - since);
            }
        } nested{*this, asked};
        ++depth_;
        try {
            if (pid_ < 0) start();
            if (channel_.has_news()) throw disconnected{disconnected::reason::violation, "spoke before it was asked, or ended"};
            return converse(index, arguments, callbacks);
        } catch (const disconnected& end) {
            std::string what = end.what;
            if (end.why == disconnected::reason::too_late) what += spent_ + call_limit_ > case_limit_ ? " (30 s a test)" : " (10 s a call)";
            lose(function, what, caller);
        } catch (const wire::violation& broken) {
            lose(function, "called back with " + broken.what, caller);
        }
    }

    [[noreturn]] void lose(std::string_view function, const std::string& what, location caller) {
        const int status = end();
        loss_ = "the code under test " + what + how_it_ended(status) + ", in " + std::string(function);
        record_failure(loss_, caller);
        throw lost{loss_};
    }

    void next_case() {
        end();
        loss_.clear();
        spent_ = milliseconds(0);
        depth_ = 0;
    }

    /// Ends the worker and all that it started. Its status, if it had ended by itself.
    int end() {
        if (pid_ < 0) return 0;
        int status = 0;
        // Its socket closes some moments before its sandbox is gone.
        bool by_itself = false;
        for (int i = 0; i < 20 && channel_.has_news() && !by_itself; ++i) {
            by_itself = waitpid(pid_, &status, WNOHANG) == pid_;
            if (!by_itself) usleep(1000);
        }
        if (!by_itself) {
            kill(pid_, SIGKILL);
            while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {}
            status = 0;
        }
        close(socket_);
        reap();
        pid_ = -1;
        return status;
    }

private:
    /// Waits until all that stood below the worker's first process is gone, which the system ends now.
    static void reap() {
        for (int i = 0; i < 500; ++i) {
            const pid_t gone = waitpid(-1, nullptr, WNOHANG);
            if (gone < 0 && errno == ECHILD) return;
            if (gone == 0) usleep(200);
        }
    }

    std::string converse(std::uint32_t index, std::string_view arguments, const std::vector<callback>& callbacks) {
        const std::uint64_t serial = ++serial_;
        wire::encoder question;
        wire::write(question, index);
        question.raw(arguments.data(), arguments.size());
        channel_.send(wire::kind::question, serial, question.bytes(), until_);
        for (;;) {
            channel::message next = channel_.receive(until_);
            if (next.serial != serial) throw disconnected{disconnected::reason::violation, "answered another question"};
            wire::decoder in(next.bytes);
            switch (next.what) {
                case wire::kind::answer: return std::move(next.bytes);
                case wire::kind::exception: {
                    const auto type = in.number<std::uint8_t>();
                    const std::string text = printable(wire::read<std::string>(in));
                    throw_again(wire::thrown(type), text);
                }
                case wire::kind::callback: reply(in, callbacks, serial); break;
                default: throw disconnected{disconnected::reason::violation, "sent what is no answer"};
            }
        }
    }

    void reply(wire::decoder& in, const std::vector<callback>& callbacks, std::uint64_t serial) {
        const auto which = in.number<std::uint32_t>();
        if (which >= callbacks.size() || depth_ > wire::deepest_value) throw wire::violation{"what it was not given"};
        wire::encoder result;
        try {
            callbacks[which](in, result);
        } catch (const wire::violation&) {
            throw;
        } catch (...) {  // the suite's own exception, on its way to Catch2; the next question goes to a fresh worker
            end();
            throw;
        }
        channel_.send(wire::kind::reply, serial, result.bytes(), until_);
    }

    void start() {
        const std::vector<std::string> words = command();
        if (words.empty()) throw disconnected{disconnected::reason::closed, "is nowhere: LANTERN_WORKER names no command"};
        int ends[2];
        if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) throw disconnected{disconnected::reason::closed, "could not be started"};
        fcntl(ends[0], F_SETFD, FD_CLOEXEC);
        std::vector<char*> argv;
        for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
        argv.push_back(nullptr);
#ifdef __linux__
        prctl(PR_SET_PDEATHSIG, SIGKILL);      // when the grader is killed, so are we, and the worker with us
        prctl(PR_SET_CHILD_SUBREAPER, 1);  // what the worker leaves behind is ours to clear away
#endif
        rlimit files{};
        getrlimit(RLIMIT_NOFILE, &files);
        const int most = int(std::min<rlim_t>(files.rlim_cur, 4096));
        pid_ = fork();
        if (pid_ == 0) {
            const int nothing = open("/dev/null", O_RDWR);
            for (int i = 0; i < 3; ++i) dup2(nothing, i);
            dup2(ends[1], 3);
            for (int i = 4; i < most; ++i) close(i);
            char* const no_environment[] = {nullptr};
            execve(argv[0], argv.data(), no_environment);
            _exit(127);
        }
        close(ends[1]);
        if (pid_ < 0) {
            close(ends[0]);
            throw disconnected{disconnected::reason::closed, "could not be started"};
        }
        socket_ = ends[0];
        channel_ = channel(socket_);
    }

    static std::string how_it_ended(int status) {
        if (status == 0) return "";
        const int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
        switch (code) {  // bwrap reports a signal as a shell does
            case 0: return "";
            case 128 + SIGABRT: return " (aborted)";
            case 128 + SIGFPE: return " (arithmetic error, such as a division of integers by 0)";
            case 128 + SIGKILL: return " (killed, perhaps for want of memory)";
            case 128 + SIGSEGV: return " (memory that is not yours: an index out of range?)";
            case 128 + SIGXCPU: return " (too much time)";
            default: return code > 128 ? " (signal " + std::to_string(code - 128) + ")" : " (exit status " + std::to_string(code) + ")";
        }
    }

    const milliseconds call_limit_ = limit("LANTERN_CALL_SECONDS", 10), case_limit_ = limit("LANTERN_CASE_SECONDS", 30);
    pid_t pid_ = -1;
    int socket_ = -1;
    channel channel_;
    std::uint64_t serial_ = 0;
    std::string loss_;  // why the running test has no worker any more
    int depth_ = 0;     // questions within callbacks
    milliseconds spent_{0};
    clock::time_point until_;
};

worker_process& the_worker() {
    static worker_process one;
    return one;
}

class fresh_worker_for_each_case : public listener_base {
public:
    using listener_base::listener_base;
    void testCaseStarting(const Catch::TestCaseInfo& info) override {
        listener_base::testCaseStarting(info);
        the_worker().next_case();
    }
    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        the_worker().next_case();
        listener_base::testCaseEnded(stats);
    }
};

}  // namespace

std::string ask(std::string_view function, std::uint32_t index, std::string_view arguments, const std::vector<callback>& callbacks,
                location caller) {
    return the_worker().ask(function, index, arguments, callbacks, caller);
}

void lose(std::string_view function, const std::string& what, location caller) { the_worker().lose(function, what, caller); }

}  // namespace contract::judge

using contract::judge::fresh_worker_for_each_case;
CATCH_REGISTER_LISTENER(fresh_worker_for_each_case)

CATCH_TRANSLATE_EXCEPTION(const contract::judge::lost& loss) { return loss.what; }
