# Sources of tests, without their _test.cpp. Those that take longest, so that they start first:
set(tests_longest_first)
# of the folders of `./run test quick`, those that it leaves out because they take long;
set(tests_beyond_quick)
# of the command line, those that it takes as a smoke test;
set(tests_of_smoke app/cli/help app/cli/inspect app/cli/run)
# those that run as three entries side by side.
set(tests_in_parts)
