# cpack -G DEB: rubble (programs and the Python module) and librubble-dev (libraries). Dependencies on shared libraries are read from
# the programs.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rubble)
set(CPACK_PACKAGE_VENDOR "The Rubble authors")
set(CPACK_PACKAGE_CONTACT "The Rubble authors <rubble@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME rubble)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_RUNTIME_GROUP runtime)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
    "Reads the finished FE result of a collapse, turns deactivated elements into rigid fragments, simulates where they go and shows both
 views on one timeline. With the command line rubble-cli.")
# Xvfb draws figures where there is no display; the fonts are those of captions and of Chinese.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "xvfb, xauth, libgl1-mesa-dri, fonts-dejavu-core, fonts-wqy-microhei, qt6-translations-l10n")
# Buttons without words show signs of this theme.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "breeze-icon-theme")
if(RUBBLE_PYTHON)
    set(CPACK_COMPONENTS_ALL runtime python development)
    set(CPACK_COMPONENT_PYTHON_GROUP runtime)
    # Built for one version of Python, as its file name says. What the module's own folder found is not known here.
    find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
    string(APPEND CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS
        ", python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), python3-numpy")
    math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
    string(APPEND CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS ", python3 (<< ${Python3_VERSION_MAJOR}.${next_python})")
endif()

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME librubble-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
    "Libraries of Rubble for programs of one's own: find_package(Rubble) gives Rubble::core (fragments, clusters, simulation, analysis)
 and Rubble::io (readers of FE results, case and run files, exports).")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libbullet-dev, libxxhash-dev, cmake (>= 3.25), pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS
    "libvtk9-dev, libhdf5-dev, libexodusii-dev, libgdal-dev, libdeflate-dev, libheif-dev, liblz4-dev, liblzma-dev, libmedc-dev, libminizip-dev, libproj-dev, libpugixml-dev, libssl-dev, zlib1g-dev, qt6-base-dev")
include(CPack)
