# Sources of tests, without their _test.cpp. Those that take longest, so that they start first:
set(tests_longest_first app/gui/project app/cli/readme app/cli/report app/cli/hidden_cause app/gui/main_window app/gui/inspection app/gui/language
    core/selftest/long_hard_case app/slurm/slurm app/gui/screens app/cli/run app/cli/accuracy app/gui/survey app/gui/evidence app/gui/random_walk
    packages/install app/gui/new_case app/cli/map app/gui/figure_drop app/gui/costs app/slurm/window/cluster app/gui/view_detail app/gui/accuracy
    app/cli/evidence_report app/gui/ensemble app/gui/effects_and_health app/cli/figure app/gui/closing app/cli/page app/cli/page_look)
# of the folders of `./run test quick`, those that it leaves out because they take long;
set(tests_beyond_quick core/selftest/long_hard_case)
# of the command line, those that it takes as a smoke test;
set(tests_of_smoke app/cli/help app/cli/inspect app/cli/health)
# those that run as three entries side by side.
set(tests_in_parts core/selftest/long_hard_case app/gui/project app/cli/report app/gui/main_window app/gui/inspection app/gui/language)
foreach(name ${tests_longest_first} ${tests_beyond_quick} ${tests_of_smoke} ${tests_in_parts})
    if(NOT EXISTS ${CMAKE_CURRENT_LIST_DIR}/${name}_test.cpp)
        message(FATAL_ERROR "tests/plan.cmake names tests/${name}_test.cpp, which is not there")
    endif()
endforeach()
