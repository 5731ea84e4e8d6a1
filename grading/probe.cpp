// SPDX-License-Identifier: MIT
// What a program can do where workers run: probe PROCESSES BYTES PID SECRET... tries, and tells as JSON what holds. It does
// nothing that would hurt where nothing holds.

#include <net/if.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

extern char** environ;

namespace {

bool no_network() {
    bool none = true;
    if (struct if_nameindex* all = if_nameindex()) {
        for (const struct if_nameindex* one = all; one->if_index != 0; ++one)
            if (std::strncmp(one->if_name, "lo", 2) != 0) none = false;
        if_freenameindex(all);
    }
    return none;
}

bool out_of_reach(char** paths) {
    for (; *paths; ++paths) {
        struct stat seen;
        if (stat(*paths, &seen) == 0) return false;
    }
    return true;
}

bool nothing_to_write_to() {
    for (const char* path : {"/lantern-probe", "/tmp/lantern-probe", "/var/tmp/lantern-probe", "/dev/shm/lantern-probe", "/usr/lib/lantern-probe"}) {
        const int file = open(path, O_CREAT | O_WRONLY, 0600);
        if (file < 0) continue;
        close(file);
        unlink(path);
        return false;
    }
    return true;
}

bool no_environment() {
    for (char** each = environ; *each; ++each)
        if (std::strncmp(*each, "PATH=", 5) != 0 && std::strncmp(*each, "LC_ALL=", 7) != 0 && std::strncmp(*each, "PWD=", 4) != 0) return false;
    return true;
}

bool no_descriptors() {
    for (int i = 3; i < 64; ++i)
        if (fcntl(i, F_GETFD) != -1) return false;
    return true;
}

/// As many as may be, and some more; they only wait, and end again.
bool limit_of_processes(int most) {
    std::vector<pid_t> children;
    bool stopped = false;
    for (int i = 0; i < most + 16 && !stopped; ++i) {
        const pid_t child = fork();
        if (child == 0) {
            pause();
            _exit(0);
        }
        if (child < 0) stopped = true;
        else children.push_back(child);
    }
    for (const pid_t child : children) kill(child, SIGKILL);
    for (const pid_t child : children) waitpid(child, nullptr, 0);
    return stopped;
}

bool limit_of_memory(std::size_t most) {
    void* all = mmap(nullptr, 2 * most, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (all == MAP_FAILED) return true;
    munmap(all, 2 * most);
    return false;
}

const char* word(bool holds) { return holds ? "true" : "false"; }

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) return 2;
    std::printf("{\"no network\": %s, \"tests and solutions out of reach\": %s, \"nothing to write to\": %s, \"no environment\": %s, ",
                word(no_network()), word(out_of_reach(argv + 4)), word(nothing_to_write_to()), word(no_environment()));
    std::printf("\"no descriptors\": %s, \"an unprivileged user\": %s, \"other processes out of reach\": %s, ", word(no_descriptors()),
                word(getuid() != 0 && geteuid() != 0), word(kill(std::atoi(argv[3]), 0) != 0));
    std::fflush(stdout);
    std::printf("\"a limit of processes\": %s, \"a limit of memory\": %s}\n", word(limit_of_processes(std::atoi(argv[1]))),
                word(limit_of_memory(std::strtoull(argv[2], nullptr, 10))));
}
