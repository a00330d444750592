# What `cmake --install` puts where. Components: runtime (programs), development (libraries), python (module).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# Programs, and what they look for relative to themselves.
install(TARGETS rubble rubble-cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
install(DIRECTORY resources/samples DESTINATION ${CMAKE_INSTALL_DATADIR}/rubble COMPONENT runtime
    FILES_MATCHING PATTERN "*.exo" PATTERN "*.rubble" PATTERN "*.png" PATTERN "*.asc" PATTERN "*.md")
install(DIRECTORY resources/validation DESTINATION ${CMAKE_INSTALL_DATADIR}/rubble COMPONENT runtime)
install(FILES resources/abaqus/odb_to_fil.py DESTINATION ${CMAKE_INSTALL_DATADIR}/rubble COMPONENT runtime)
install(FILES README.md LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)

# The desktop: entry, MIME types of cases and runs, icon, AppStream.
install(FILES resources/desktop/org.rubble.Rubble.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT runtime)
install(FILES resources/desktop/org.rubble.Rubble.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT runtime)
install(FILES resources/desktop/org.rubble.Rubble.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT runtime)
set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable)
install(FILES resources/desktop/org.rubble.Rubble.svg DESTINATION ${icons}/apps COMPONENT runtime)
install(FILES resources/desktop/application-x-rubble-case.svg DESTINATION ${icons}/mimetypes COMPONENT runtime)

# Man pages and completion are what the programs say of themselves.
set(pages ${CMAKE_BINARY_DIR}/pages)
add_custom_command(OUTPUT ${pages}/rubble-cli.1 ${pages}/rubble-cli.bash ${pages}/rubble.1 ${pages}/rubble.bash
    COMMAND ${CMAKE_COMMAND} -E make_directory ${pages}
    COMMAND rubble-cli --man-page > ${pages}/rubble-cli.1
    COMMAND rubble-cli --completion > ${pages}/rubble-cli.bash
    COMMAND rubble --man-page > ${pages}/rubble.1
    COMMAND rubble --completion > ${pages}/rubble.bash
    DEPENDS rubble rubble-cli VERBATIM)
add_custom_target(rubble_pages ALL DEPENDS ${pages}/rubble-cli.1)
install(FILES ${pages}/rubble-cli.1 ${pages}/rubble.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT runtime)
set(completions ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${pages}/rubble-cli.bash DESTINATION ${completions} RENAME rubble-cli COMPONENT runtime)
install(FILES ${pages}/rubble.bash DESTINATION ${completions} RENAME rubble COMPONENT runtime)

# The libraries: Rubble::core and Rubble::io.
foreach(library core io)
    string(SUBSTRING ${library} 0 1 initial)
    string(TOUPPER ${initial} initial)
    string(SUBSTRING ${library} 1 -1 rest)
    set_target_properties(rubble_${library} PROPERTIES EXPORT_NAME ${library})
    target_include_directories(rubble_${library} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/rubble>)
    install(TARGETS rubble_${library} EXPORT Rubble${initial}${rest} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
    install(EXPORT Rubble${initial}${rest} NAMESPACE Rubble:: FILE Rubble${initial}${rest}Targets.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Rubble COMPONENT development)
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/public_headers.cmake)
foreach(header ${RUBBLE_PUBLIC_HEADERS})
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rubble/${folder} COMPONENT development)
endforeach()
configure_package_config_file(cmake/RubbleConfig.cmake.in ${CMAKE_BINARY_DIR}/cmake/RubbleConfig.cmake
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Rubble)
# Before 1.0 a minor version may change what a program was built against.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/cmake/RubbleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/cmake/RubbleConfig.cmake ${CMAKE_BINARY_DIR}/cmake/RubbleConfigVersion.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Rubble COMPONENT development)
install(DIRECTORY resources/examples/library DESTINATION ${CMAKE_INSTALL_DATADIR}/rubble/examples COMPONENT development)
