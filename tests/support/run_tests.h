#pragma once

namespace rubble {

/// Whether what is long by nature runs whole: thousand-trial statistics, long walks, full columns, sweeps of causes. It does under
/// `./run test all`, which sets RUBBLE_TESTS=all; else it runs small, with the same criteria. Tests whose names begin with Whole
/// run there only.
bool wholeTests();

/// One of two sizes of a test.
template <class T>
T sizedTo(T everyDay, T whole) {
    return wholeTests() ? whole : everyDay;
}

/// Whether the address sanitizer watches, under which statistics take forty times as long. It looks for faults of memory, for which
/// a few trials do; what the trials show is judged without it.
bool sanitizedTests();

/// One of three sizes of a test of statistics.
template <class T>
T sizedTo(T sanitized, T everyDay, T whole) {
    return sanitizedTests() ? sanitized : sizedTo(everyDay, whole);
}

/// Runs the tests of this program, or with --file=PATH those of one source file, and returns the exit status of main(). A filter of
/// GoogleTest's own (--gtest_filter) overrules both the file and the size.
int runTests(int argc, char** argv);

}  // namespace rubble
