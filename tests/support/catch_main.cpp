// SPDX-License-Identifier: MIT
// The tests' main function. Catch2 3 brings its own.

#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

/// A suite without tests, or a selection that matches none, is an error, as it is in Catch2 3; version 2 would end with 0.
int main(int argc, char** argv) {
    Catch::Session session;
    const int misused = session.applyCommandLine(argc, argv);
    if (misused != 0) return misused;
    Catch::ConfigData& wish = session.configData();
    wish.warnings = static_cast<Catch::WarnAbout::What>(wish.warnings | Catch::WarnAbout::NoTests);
    const int failed = session.run();
    if (failed != 0 || wish.showHelp || !Catch::getAllTestCasesSorted(session.config()).empty()) return failed;
    Catch::cerr() << "there are no tests\n";
    return 2;
}
#endif
