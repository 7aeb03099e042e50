# Libraries of others: by the CMake file or the pkg-config file of their packages, in the versions that the build allows. ANTINODE_NAME_DIR
# names a folder of one's own for each.
find_package (Threads REQUIRED)
find_package (PkgConfig REQUIRED)

# antinode_check_version (NAME VERSION FROM BELOW): ends where the version is another. BELOW may be empty. Files of packages accept a range of
# versions only within one major version, or exactly their own: so the range is checked here.
function (antinode_check_version name version from below)
    if (version VERSION_LESS from OR (below AND version VERSION_GREATER_EQUAL below))
        set (allowed "${from} and later")
        if (below)
            set (allowed "${from} and later, below ${below}")
        endif()
        message (FATAL_ERROR "${name} is version ${version}; allowed: ${allowed}.")
    endif()
    set_property (GLOBAL APPEND PROPERTY ANTINODE_VERSIONS "${name} ${version}")
endfunction()

# antinode_find (NAME FROM [BELOW]): a package by its CMake file. A macro, because those files set variables for their caller.
macro (antinode_find name from)
    string (TOUPPER ${name} antinode_name)
    set (ANTINODE_${antinode_name}_DIR "" CACHE PATH "The folder of the CMake file of ${name}; empty: where CMake looks by itself")
    if (ANTINODE_${antinode_name}_DIR)
        set (${name}_DIR ${ANTINODE_${antinode_name}_DIR})
    endif()
    find_package (${name} CONFIG QUIET)
    if (NOT ${name}_FOUND)
        message (FATAL_ERROR "${name} from version ${from} on was not found; -DANTINODE_${antinode_name}_DIR=FOLDER names the folder of its CMake file.")
    endif()
    antinode_check_version (${name} ${${name}_VERSION} ${from} "${ARGN}")
endmacro()

# antinode_find_by_pkg_config (NAME MODULES...): a library by its pkg-config files, as PkgConfig::NAME; NAME_LIBRARIES and the like.
macro (antinode_find_by_pkg_config name)
    set (ANTINODE_${name}_DIR "" CACHE PATH "The folder of the pkg-config file of ${name}; empty: where pkg-config looks by itself")
    set (antinode_path "$ENV{PKG_CONFIG_PATH}")
    if (ANTINODE_${name}_DIR AND CMAKE_HOST_WIN32)
        set (ENV{PKG_CONFIG_PATH} "${ANTINODE_${name}_DIR};${antinode_path}")
    elseif (ANTINODE_${name}_DIR)
        set (ENV{PKG_CONFIG_PATH} "${ANTINODE_${name}_DIR}:${antinode_path}")
    endif()
    pkg_check_modules (${name} REQUIRED IMPORTED_TARGET ${ARGN})
    set (ENV{PKG_CONFIG_PATH} "${antinode_path}")
endmacro()

antinode_find (Eigen3 3.4)
antinode_find (nlohmann_json 3.11 4)
antinode_find_by_pkg_config (XXHASH libxxhash)
antinode_find_by_pkg_config (ZLIB zlib)
antinode_find_by_pkg_config (EXPAT expat)

# Highway's own build installs no CMake file in all versions.
set (ANTINODE_HWY_DIR "" CACHE PATH "The folder of the CMake file of Highway; empty: where CMake and pkg-config look by themselves")
if (ANTINODE_HWY_DIR)
    set (hwy_DIR ${ANTINODE_HWY_DIR})
endif()
find_package (hwy 1.0 CONFIG QUIET)
if (NOT TARGET hwy::hwy)
    antinode_find_by_pkg_config (HIGHWAY libhwy>=1.0)
    add_library (hwy::hwy ALIAS PkgConfig::HIGHWAY)
endif()
set_property (GLOBAL APPEND PROPERTY ANTINODE_VERSIONS "Highway ${hwy_VERSION}${HIGHWAY_VERSION}")

if (ANTINODE_WITH_JUCE)
    antinode_find (CLI11 2.1 3)
    antinode_find_by_pkg_config (CAIRO cairo cairo-ft cairo-pdf cairo-svg)
    if (MINGW) # Static libraries name the libraries that they need only for pkg-config --static.
        target_link_libraries (PkgConfig::CAIRO INTERFACE ${CAIRO_STATIC_LDFLAGS})
    endif()
endif()

if (ANTINODE_TESTS)
    antinode_find (Catch2 2.13 4)
endif()
