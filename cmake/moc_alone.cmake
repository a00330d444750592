# moc reads a header with all that it includes, which takes a second or two for each, and writes the same as from the header alone: it
# looks for nothing in what ours include. So it is given no folders to look in.
#
# rubble_moc_alone(targets...)
function(rubble_moc_alone)
    get_target_property(configurations Qt6::moc IMPORTED_CONFIGURATIONS)
    foreach(property IMPORTED_LOCATION ${configurations})
        if(NOT property STREQUAL IMPORTED_LOCATION)
            string(PREPEND property IMPORTED_LOCATION_)
        endif()
        get_target_property(moc Qt6::moc ${property})
        if(moc)
            break()
        endif()
    endforeach()
    if(NOT moc)
        return()  # as CMake finds and calls it
    endif()
    set(script ${CMAKE_BINARY_DIR}/moc_alone.sh)
    file(CONFIGURE OUTPUT ${script} @ONLY CONTENT [=[#!/bin/sh
for word; do
    shift
    case $word in
        -I*) ;;
        *) set -- "$@" "$word" ;;
    esac
done
exec "@moc@" "$@"
]=])
    file(CHMOD ${script} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
    set_target_properties(${ARGN} PROPERTIES AUTOMOC_EXECUTABLE ${script})
endfunction()
