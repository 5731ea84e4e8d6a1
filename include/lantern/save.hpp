// SPDX-License-Identifier: MIT
#pragma once
// Writing a file whole or not at all.

#include <cerrno>
#include <concepts>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>

namespace lantern {

/// Throws std::runtime_error "cannot write WHERE: REASON".
[[noreturn]] inline void cannot_write(const std::string& where, std::error_code reason) {
    throw std::runtime_error("cannot write " + where + ": " + reason.message());
}

/// The system's reason for what failed last in this thread. Streams do not keep it, errno mostly does.
[[nodiscard]] inline std::error_code last_error() {
    return errno != 0 ? std::error_code(errno, std::generic_category()) : make_error_code(std::errc::io_error);
}

/// A file that appears under its name only when it is complete. It is written beside its place, so that the move there
/// stays within one file system and is atomic; unless committed it leaves nothing behind. Missing folders are created,
/// a symbolic link stays one, a replaced file keeps its permissions, and what is no regular file (a terminal, a pipe,
/// /dev/null) is written to, not replaced.
class pending_file {
public:
    explicit pending_file(const std::filesystem::path& path) : path_(path), target_(path) {
        using std::filesystem::file_type;
        std::error_code ignored;
        const auto there = status(path, ignored);
        if (there.type() == file_type::directory || (!path.empty() && !path.has_filename()))
            fail(make_error_code(std::errc::is_a_directory));
        if (exists(there) && there.type() != file_type::regular) {
            open(path);  // and no link followed by hand: /dev/stdout may lead to a pipe that has no name
            return;
        }
        for (int links = 0; is_symlink(symlink_status(target_, ignored)); ++links) {
            if (links == 40) fail(make_error_code(std::errc::too_many_symbolic_link_levels));
            target_ = target_.parent_path() / read_symlink(target_, ignored);
        }
        create_folder(target_.parent_path());
        claim_a_name_in(target_.parent_path());
        if (exists(there)) permissions(beside_, there.permissions(), ignored);
        open(beside_);
    }
    pending_file(const pending_file&) = delete;
    pending_file& operator=(const pending_file&) = delete;
    ~pending_file() {
        if (beside_.empty()) return;
        out_.close();
        std::error_code ignored;
        remove(beside_, ignored);
    }

    [[nodiscard]] std::ostream& stream() { return out_; }

    void commit() {
        out_.close();
        if (!out_) fail(last_error());
        if (beside_.empty()) return;
        std::error_code reason;
        rename(beside_, target_, reason);
        if (reason) fail(reason);
        beside_.clear();
    }

private:
    std::filesystem::path path_;    // as given: what messages name
    std::filesystem::path target_;  // where the symbolic links lead
    std::filesystem::path beside_;  // empty when writing to the path itself
    std::ofstream out_;

    [[noreturn]] void fail(std::error_code reason) const {
        std::error_code ignored;
        if (!beside_.empty()) remove(beside_, ignored);
        cannot_write(path_.string(), reason);
    }

    void create_folder(const std::filesystem::path& folder) const {
        std::error_code reason;
        if (!folder.empty() && !is_directory(folder, reason)) {
            create_directories(folder, reason);
            if (reason) fail(reason);
        }
    }

    // The mode "x" (C11) creates the file and fails when it exists: two programs never share a name.
    void claim_a_name_in(const std::filesystem::path& folder) {
        for (int i = 0; i < 1000; ++i) {
            const auto name = folder / (".lantern-" + std::to_string(i) + ".tmp");
            errno = 0;
            if (std::FILE* const file = std::fopen(name.string().c_str(), "wbx")) {
                std::fclose(file);
                beside_ = name;
                return;
            }
            if (errno != EEXIST) break;
        }
        fail(last_error());
    }

    void open(const std::filesystem::path& name) {
        errno = 0;
        out_.open(name, std::ios::binary);
        if (!out_) fail(last_error());
    }
};

/// Returns write(out), after calling finish().
template <std::invocable<std::ostream&> Write, std::invocable Finish>
auto write_then(std::ostream& out, Write&& write, Finish&& finish) {
    if constexpr (std::is_void_v<std::invoke_result_t<Write, std::ostream&>>) {
        write(out);
        finish();
    } else {
        const auto result = write(out);
        finish();
        return result;
    }
}

/// Calls write(std::ostream&) and returns its result. Throws std::runtime_error, naming the path and the system's
/// reason, when anything cannot be written; the path is then as it was before, also when `write` itself throws.
template <std::invocable<std::ostream&> Write>
auto save(const std::filesystem::path& path, Write&& write) {
    pending_file file(path);
    return write_then(file.stream(), write, [&] { file.commit(); });
}

/// The same to a stream, std::cout for one: flushed, and an error if it then is in a failed state.
template <std::invocable<std::ostream&> Write>
auto save(std::ostream& out, Write&& write) {
    errno = 0;
    return write_then(out, write, [&] {
        if (!out.flush()) cannot_write("to the stream", last_error());
    });
}

}  // namespace lantern
