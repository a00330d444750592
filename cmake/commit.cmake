# cmake -D SOURCE=FOLDER -D OUT=HEADER -P commit.cmake: names the commit of the sources in a header, which is touched only where it changes.
# What is not committed is said; outside of a checkout the commit is empty.
cmake_minimum_required(VERSION 3.25)
set(commit "")
execute_process(COMMAND git -C ${SOURCE} rev-parse HEAD RESULT_VARIABLE failed OUTPUT_VARIABLE head ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT failed)
    execute_process(COMMAND git -C ${SOURCE} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes ERROR_QUIET)
    set(commit "${head}")
    if(changes)
        string(APPEND commit ", with changes that are not committed")
    endif()
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "#define RUBBLE_COMMIT \"@commit@\"\n" @ONLY)
