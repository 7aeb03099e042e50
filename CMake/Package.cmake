# What `cpack` makes for Scripts/pack: the Debian packages.
set (CPACK_PACKAGE_NAME antinode)
set (CPACK_PACKAGE_VENDOR Antinode)
set (CPACK_PACKAGE_CONTACT "Antinode <antinode@antinode.example>")
set (CPACK_PACKAGE_HOMEPAGE_URL "https://antinode.example")
set (CPACK_PACKAGE_DESCRIPTION_SUMMARY "surface haptics by modal superimposition")
set (standalone_text "")
if (TARGET antinode_standalone)
    set (standalone_text "
The standalone program antinode-standalone plays them by MIDI and touch input
through an audio interface.")
endif()
set (CPACK_PACKAGE_DESCRIPTION "\
Antinode drives a plate or beam that carries piezoelectric ceramics. It
computes the voltage of each ceramic so that a target velocity field appears
at a chosen place, at a chosen instant, with a chosen strength.
.
The package contains the program antinode, which designs, renders and scores
such foci, and instruments for VST3 and LV2 hosts, with one channel per
ceramic.${standalone_text}")
set (CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set (CPACK_RESOURCE_FILE_README ${PROJECT_SOURCE_DIR}/README.md)
set (CPACK_PACKAGE_FILE_NAME antinode-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
set (CPACK_GENERATOR DEB)
set (CPACK_STRIP_FILES ON)
set (CPACK_PACKAGING_INSTALL_PREFIX /usr)
set (CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
     OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set (CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set (CPACK_DEBIAN_PACKAGE_RELEASE 1)
set (CPACK_DEBIAN_PACKAGE_SECTION sound)
set (CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set (CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set (CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# JUCE opens these when it needs them, so dpkg-shlibdeps does not see them.
set (CPACK_DEBIAN_PACKAGE_RECOMMENDS
     "libx11-6, libxext6, libxcursor1, libxinerama1, libxrandr2, libxrender1")
set (CPACK_DEBIAN_PACKAGE_SUGGESTS "libjack-jackd2-0 | libjack0, ardour, jalv")
# python3-antinode stands alone: its compiled part has all that the program has.
if (TARGET antinode_python)
    set (CPACK_DEB_COMPONENT_INSTALL ON)
    set (CPACK_COMPONENTS_GROUPING IGNORE)
    set (CPACK_COMPONENTS_ALL Unspecified python)
    set (CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME antinode)
    set (CPACK_DEBIAN_UNSPECIFIED_FILE_NAME DEB-DEFAULT)
    set (CPACK_DEBIAN_UNSPECIFIED_DESCRIPTION ${CPACK_PACKAGE_DESCRIPTION})
    set (CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-antinode)
    set (CPACK_DEBIAN_PYTHON_FILE_NAME DEB-DEFAULT)
    set (CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    math (EXPR next "${Python_VERSION_MINOR} + 1")
    set (CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
    set (CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib, python3-scipy")
    set (CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "antinode, python3-liblo, python3-questplus, python3-tqdm")
    set (CPACK_DEBIAN_PYTHON_DESCRIPTION "\
Functions on values for what the program antinode does, as a package for
Python: modes of plates and beams with piezoelectric ceramics, voltages that
focus the vibration at a chosen place and instant, a model of the plate that
plays them, identification from measurements.")
endif()
include (CPack)
