// SPDX-License-Identifier: MIT
#pragma once
// A folder of one's own for the files of a test, gone when the test ends.

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

class scratch_folder {
public:
    scratch_folder() {
        for (int i = 0;; ++i) {  // create_directory says whether it was this call that made it
            path_ = std::filesystem::temp_directory_path() / ("lantern-test-" + std::to_string(i));
            if (create_directory(path_)) return;
        }
    }
    scratch_folder(const scratch_folder&) = delete;
    scratch_folder& operator=(const scratch_folder&) = delete;
    ~scratch_folder() {
        std::error_code ignored;
        remove_all(path_, ignored);
    }

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// How many files and folders are in it, at any depth.
    [[nodiscard]] std::ptrdiff_t entries() const {
        return std::distance(std::filesystem::recursive_directory_iterator(path_), {});
    }

private:
    std::filesystem::path path_;
};

[[nodiscard]] inline std::string text_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void put_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}
