// SPDX-License-Identifier: MIT
#pragma once
// What `trace` found, as a table, CSV or JSON; and what it amounts to.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace trace {

struct row {
    std::string scene;
    std::uint32_t triangles = 0;
    std::string structure, rays;
    double mrays = 0;               ///< million rays a second, one thread
    double wrong = 0;               ///< answers, of all rays that were traced
    std::uint64_t traced = 0;       ///< rays
    std::uint64_t checked = 0;      ///< of them, against brute force
    double nodes = 0, offers = 0;   ///< looked at for a ray; 0 where it is not told
    double bytes_per_triangle = 0;
    double build_ms = 0;
    unsigned threads = 1;           ///< of the build
};

/// Cost against the number of triangles, for one structure and one scene: y = a + b log2 N, by least squares.
struct fit {
    std::string scene, structure;
    double a = 0, b = 0;
    double r2 = 0;     ///< 1 - the share of the variance that the line leaves
    double power = 0;  ///< the exponent of N in y = c N^power, by least squares of the logarithms
};

/// The node visits of a ray, for each structure that was measured at three sizes or more.
[[nodiscard]] inline std::vector<fit> fits(const std::vector<row>& rows, const std::string& rays) {
    std::map<std::pair<std::string, std::string>, std::map<std::uint32_t, double>> visits;
    for (const row& r : rows)
        if (r.rays == rays && r.nodes + r.offers > 0) visits[{r.scene, r.structure}][r.triangles] = r.nodes > 0 ? r.nodes : r.offers;
    const auto line = [](const std::vector<std::pair<double, double>>& points) {
        double sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
        const auto n = static_cast<double>(points.size());
        for (const auto& [x, y] : points) sx += x, sy += y, sxx += x * x, sxy += x * y, syy += y * y;
        const double vx = sxx - sx * sx / n, vy = syy - sy * sy / n, vxy = sxy - sx * sy / n;
        const double slope = vxy / vx;
        struct {
            double a, b, r2;
        } result{sy / n - slope * sx / n, slope, vy > 0 ? vxy * vxy / (vx * vy) : 1};
        return result;
    };
    std::vector<fit> all;
    for (const auto& [of, by_size] : visits) {
        if (by_size.size() < 3) continue;
        std::vector<std::pair<double, double>> semilog, loglog;
        for (const auto& [n, y] : by_size) semilog.push_back({std::log2(n), y}), loglog.push_back({std::log2(n), std::log2(y)});
        const auto l = line(semilog);
        all.push_back({of.first, of.second, l.a, l.b, l.r2, line(loglog).b});
    }
    return all;
}

/// How a structure compares with `embree`, for one kind of rays: the geometric mean over all scenes, and the worst of them.
struct summary {
    std::string structure, rays;
    double mean = 0, worst = 0;
    std::string worst_scene;
};

[[nodiscard]] inline std::vector<summary> summaries(const std::vector<row>& rows) {
    const auto key = [](const row& r) { return r.scene + " " + std::to_string(r.triangles); };
    std::map<std::pair<std::string, std::string>, double> base;  // of scene and rays
    for (const row& r : rows)
        if (r.structure == "embree") base[{key(r), r.rays}] = r.mrays;
    std::map<std::pair<std::string, std::string>, std::map<std::string, double>> ratios;  // of structure and rays: by scene
    for (const row& r : rows)
        if (const auto b = base.find({key(r), r.rays}); b != base.end()) ratios[{r.structure, r.rays}][key(r)] = r.mrays / b->second;
    std::vector<summary> all;
    for (const auto& [of, by_scene] : ratios) {
        summary s{of.first, of.second, 0, 1e300, ""};
        for (const auto& [scene, ratio] : by_scene) {
            s.mean += std::log(ratio) / static_cast<double>(by_scene.size());
            if (ratio < s.worst) s.worst = ratio, s.worst_scene = scene;
        }
        s.mean = std::exp(s.mean);
        all.push_back(s);
    }
    return all;
}

inline void print_table(const std::vector<row>& rows) {
    std::string scene;
    std::printf("One thread traces. Wrong: answers that brute force in double precision contradicts, of so many traced and so many checked.\n"
                "Nodes and offers: volumes and surfaces looked at for a ray. Bytes: of a triangle. Build: ms, with so many threads.\n");
    for (const row& r : rows) {
        if (const std::string here = r.scene + ", " + std::to_string(r.triangles) + " triangles"; here != scene)
            std::printf("\n%s\n%-10s%-16s%9s%8s%9s%9s%8s%8s%8s%9s%3s\n", (scene = here).c_str(), "rays", "structure", "Mrays/s", "wrong", "traced",
                        "checked", "nodes", "offers", "bytes", "build", "");
        std::printf("%-10s%-16s%9.3f%8.0f%9llu%9llu%8.1f%8.1f%8.1f%9.1f%3u\n", r.rays.c_str(), r.structure.c_str(), r.mrays, r.wrong,
                    static_cast<unsigned long long>(r.traced), static_cast<unsigned long long>(r.checked), r.nodes, r.offers,
                    r.bytes_per_triangle, r.build_ms, r.threads);
    }
    if (const auto all = summaries(rows); !all.empty()) {
        std::printf("\nSpeed as a multiple of Embree's default mode: geometric mean over the scenes, and the worst\n");
        for (const summary& s : all)
            std::printf("%-10s%-16s%7.3f%9.3f  %s\n", s.rays.c_str(), s.structure.c_str(), s.mean, s.worst, s.worst_scene.c_str());
    }
    if (const auto all = fits(rows, "primary"); !all.empty()) {
        std::printf("\nNodes a primary ray looks at: a + b log2 N, the share of the variance that this explains; and as a power of N\n");
        for (const fit& f : all)
            std::printf("%-10s%-16s%9.2f %+8.3f log2 N%9.4f    N^%.3f\n", f.scene.c_str(), f.structure.c_str(), f.a, f.b, f.r2, f.power);
    }
}

inline void print_csv(const std::vector<row>& rows) {
    std::printf("scene,triangles,structure,rays,mrays,wrong,traced,checked,nodes,offers,bytes_per_triangle,build_ms,threads\n");
    for (const row& r : rows)
        std::printf("%s,%u,%s,%s,%.6g,%.0f,%llu,%llu,%.3f,%.3f,%.2f,%.3f,%u\n", r.scene.c_str(), r.triangles, r.structure.c_str(), r.rays.c_str(),
                    r.mrays, r.wrong, static_cast<unsigned long long>(r.traced), static_cast<unsigned long long>(r.checked), r.nodes, r.offers,
                    r.bytes_per_triangle, r.build_ms, r.threads);
}

inline void print_json(const std::vector<row>& rows, std::FILE* to = stdout) {
    const char* comma = "";
    const auto begin = [&](const char* name) { std::fprintf(to, "%s\"%s\":[", comma, name), comma = ""; };
    const auto next = [&] { std::fprintf(to, "%s\n", comma), comma = ","; };
    std::fputs("{", to);
    begin("rows");
    for (const row& r : rows) {
        next();
        std::fprintf(to, "{\"scene\":\"%s\",\"structure\":\"%s\",\"rays\":\"%s\",\"mrays\":%.6g,\"wrong\":%.0f,\"bytes_per_triangle\":%.2f,"
                    "\"build_ms\":%.3f,\"threads\":%u,\"triangles\":%u,\"traced\":%llu,\"checked\":%llu,\"nodes\":%.3f,\"offers\":%.3f}",
                    r.scene.c_str(), r.structure.c_str(), r.rays.c_str(), r.mrays, r.wrong, r.bytes_per_triangle, r.build_ms, r.threads,
                    r.triangles, static_cast<unsigned long long>(r.traced), static_cast<unsigned long long>(r.checked), r.nodes, r.offers);
    }
    std::fputs("]", to);
    comma = ",";
    begin("summary");
    for (const summary& s : summaries(rows)) {
        next();
        std::fprintf(to, "{\"structure\":\"%s\",\"rays\":\"%s\",\"mean\":%.4f,\"worst\":%.4f,\"worst_scene\":\"%s\"}", s.structure.c_str(),
                    s.rays.c_str(), s.mean, s.worst, s.worst_scene.c_str());
    }
    std::fputs("]", to);
    comma = ",";
    begin("fits");
    for (const fit& f : fits(rows, "primary")) {
        next();
        std::fprintf(to, "{\"scene\":\"%s\",\"structure\":\"%s\",\"a\":%.4f,\"b\":%.4f,\"r2\":%.5f,\"power\":%.4f}", f.scene.c_str(),
                    f.structure.c_str(), f.a, f.b, f.r2, f.power);
    }
    std::fputs("]}\n", to);
}

/// The same into a file: the whole of it, or nothing.
inline void save_json(const std::vector<row>& rows, const std::string& path) {
    const std::string beside = path + ".part";
    std::FILE* const file = std::fopen(beside.c_str(), "w");
    if (file == nullptr) throw std::runtime_error(path + ": cannot be written");
    print_json(rows, file);
    const bool good = std::ferror(file) == 0;
    if (std::fclose(file) != 0 || !good || std::rename(beside.c_str(), path.c_str()) != 0) {
        std::remove(beside.c_str());
        throw std::runtime_error(path + ": could not be written to the end");
    }
}

}  // namespace trace
