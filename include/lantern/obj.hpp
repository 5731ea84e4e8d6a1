// SPDX-License-Identifier: MIT
#pragma once
// Meshes from Wavefront OBJ files. The only header that needs tinyobjloader: link lantern::obj.

#include <lantern/load.hpp>
#include <lantern/mesh.hpp>
#include <lantern/validate.hpp>

#include <glm/vec3.hpp>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lantern {

namespace obj {

[[noreturn]] inline void fail(std::size_t line, const std::string& problem) {
    throw std::runtime_error("obj: line " + std::to_string(line) + ": " + problem);
}

/// The words of a line; a comment has none.
[[nodiscard]] inline std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (;;) {
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin == std::string_view::npos || line[begin] == '#') return words;
        line.remove_prefix(begin);
        words.push_back(line.substr(0, line.find_first_of(" \t")));
        line.remove_prefix(words.back().size());
    }
}

/// Whether the whole word is one number, which is not infinite, nor NaN, nor beyond its type.
template <class Number>
[[nodiscard]] bool is_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} && end == word.data() + word.size() && std::isfinite(static_cast<double>(value));
}

[[nodiscard]] inline bool is_corner(std::string_view word) {
    for (int i = 0; i < 3; ++i) {  // vertex/texture/normal, the first of which must be there
        const std::size_t slash = word.find('/');
        const std::string_view index = word.substr(0, slash);
        if (!(is_number<std::int32_t>(index) || (i > 0 && index.empty()))) return false;
        if (slash == std::string_view::npos) return true;
        word.remove_prefix(slash + 1);
    }
    return false;
}

struct checked {
    std::string text;                ///< points, normals and faces, and nothing else
    std::vector<std::size_t> faces;  ///< on which line of the file each one stands
};

/// tinyobjloader takes what it cannot read for zero, so each number is looked at before.
[[nodiscard]] inline checked check(std::string_view text) {
    checked result;
    for (std::size_t line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const auto words = words_of(text.substr(0, end));
        text.remove_prefix(std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size()));
        if (words.empty()) continue;
        const bool is_face = words[0] == "f";
        if (!is_face && words[0] != "v" && words[0] != "vn") continue;
        if (words.size() < 4) fail(line, std::string(is_face ? "a face" : "a vector") + " needs three of them, at least");
        if (is_face) result.faces.push_back(line);
        for (std::size_t i = 1; i < words.size(); ++i)
            if (!(is_face ? is_corner(words[i]) : is_number<float>(words[i])))
                fail(line, "\"" + byte_reader::printable(std::string(words[i].substr(0, 32))) + "\" is no " +
                               (is_face ? "corner of a face" : "finite number"));
        for (const std::string_view word : words) (result.text += word) += ' ';
        result.text += '\n';
    }
    return result;
}

/// What tinyobjloader calls back for, put together to a mesh.
class collector {
public:
    explicit collector(std::vector<std::size_t> lines) : lines_(std::move(lines)) {}

    void vertex(glm::vec3 v) { points_.push_back(v); }
    void normal(glm::vec3 n) { directions_.push_back(n); }

    /// A polygon becomes a fan of triangles around its first corner.
    void face(const tinyobj::index_t* corners, int count) {
        const std::size_t line = lines_.at(face_++);
        std::vector<std::uint32_t> at;
        for (int i = 0; i < count; ++i)
            at.push_back(corner(index(corners[i].vertex_index, points_.size(), "vertex", line),
                                corners[i].normal_index == 0
                                    ? none
                                    : index(corners[i].normal_index, directions_.size(), "normal", line)));
        for (std::size_t i = 2; i < at.size(); ++i) triangles_.push_back({at[0], at[i - 1], at[i]});
    }

    [[nodiscard]] mesh result() const {
        std::vector<glm::vec3> vertices, normals;
        bool smooth = false;
        for (const auto& [v, n] : corners_) {
            vertices.push_back(points_[v]);
            normals.push_back(n == none ? glm::vec3(0) : directions_[n]);
            smooth = smooth || n != none;
        }
        return mesh(std::move(vertices), triangles_, smooth ? std::move(normals) : std::vector<glm::vec3>{});
    }

private:
    static constexpr std::uint32_t none = 0xffffffff;

    // In the file the first is 1, and the last before the face -1.
    static std::uint32_t index(int given, std::size_t size, const char* what, std::size_t line) {
        const auto there = static_cast<std::int64_t>(size), i = given > 0 ? given - std::int64_t{1} : there + given;
        if (given == 0 || i < 0 || i >= there)
            fail(line, std::string(what) + " " + std::to_string(given) + " is asked for, but there are " + std::to_string(there));
        return static_cast<std::uint32_t>(i);
    }

    // A vertex of the mesh is a pair of point and normal; the same pair is the same vertex.
    std::uint32_t corner(std::uint32_t vertex, std::uint32_t normal) {
        const auto next = static_cast<std::uint32_t>(corners_.size());
        const auto [known, is_new] = known_.try_emplace({vertex, normal}, next);
        if (is_new) corners_.emplace_back(vertex, normal);
        return known->second;
    }

    std::vector<std::size_t> lines_;
    std::size_t face_ = 0;
    std::vector<glm::vec3> points_, directions_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> corners_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known_;
    std::vector<glm::uvec3> triangles_;
};

}  // namespace obj

/// All faces of all groups, with their normals where they have some; materials and texture coordinates are passed over.
/// Polygons must be convex. Throws std::runtime_error naming the line and the problem: a number that is none or not
/// finite, an index of nothing, no faces.
[[nodiscard]] inline mesh read_obj(std::istream& in) {
    const std::string text(std::istreambuf_iterator<char>(in), {});
    obj::checked file = obj::check(text);
    if (file.faces.empty()) throw std::runtime_error("obj: there are no faces in it");
    obj::collector all(std::move(file.faces));
    tinyobj::callback_t on;
    on.vertex_cb = [](void* to, float x, float y, float z, float) { static_cast<obj::collector*>(to)->vertex({x, y, z}); };
    on.normal_cb = [](void* to, float x, float y, float z) { static_cast<obj::collector*>(to)->normal({x, y, z}); };
    on.index_cb = [](void* to, tinyobj::index_t* corners, int n) { static_cast<obj::collector*>(to)->face(corners, n); };
    std::istringstream lines(file.text);
    std::string problem;
    if (!tinyobj::LoadObjWithCallback(lines, on, &all, nullptr, nullptr, &problem))
        throw std::runtime_error("obj: " + problem);
    return all.result();
}

[[nodiscard]] inline mesh read_obj(const std::filesystem::path& path) {
    return load(path, [](std::istream& in) { return read_obj(in); });
}

}  // namespace lantern
