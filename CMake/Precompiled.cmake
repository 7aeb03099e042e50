# Precompiled headers, one set per family of targets: to read the headers of Eigen, JUCE, JSON and Catch2 was most of the cost of compiling.
# Docs/Design/build.md.
option (ANTINODE_PRECOMPILED "Use precompiled headers" ON)
# Several files of a target are compiled as one, so that what they all instantiate is compiled once. Scripts/check compiles each alone.
option (ANTINODE_UNITY "Compile several files of a target together" ON)

set (ANTINODE_PRECOMPILED_Core Eigen3::Eigen)
set (ANTINODE_PRECOMPILED_Documents Eigen3::Eigen nlohmann_json::nlohmann_json)
set (ANTINODE_PRECOMPILED_CommandLine ${ANTINODE_PRECOMPILED_Documents} CLI11::CLI11)
set (ANTINODE_PRECOMPILED_Juce Eigen3::Eigen antinode_juce)
set (ANTINODE_PRECOMPILED_CoreTests ${ANTINODE_PRECOMPILED_Documents} Catch2::Catch2)
set (ANTINODE_PRECOMPILED_JuceTests ${ANTINODE_PRECOMPILED_CoreTests} antinode_juce)

# antinode_precompile (TARGET FAMILY): the target reads CMake/Precompiled/FAMILY.h as compiled once for all of its family, and its files are
# compiled together, eight at a time.
function (antinode_precompile target family)
    set_target_properties (${target} PROPERTIES UNITY_BUILD ${ANTINODE_UNITY} UNITY_BUILD_BATCH_SIZE 8)

    if (NOT ANTINODE_PRECOMPILED)
        return()
    endif()

    set (owner antinode_precompiled_${family})

    if (NOT TARGET ${owner})
        set (source ${CMAKE_BINARY_DIR}/precompiled/${family}.cpp)
        file (CONFIGURE OUTPUT ${source} CONTENT "// Owns the precompiled header of its family.\n")
        add_library (${owner} OBJECT ${source})
        target_precompile_headers (${owner} PRIVATE ${PROJECT_SOURCE_DIR}/CMake/Precompiled/${family}.h)
        target_link_libraries (${owner} PRIVATE ${ANTINODE_PRECOMPILED_${family}} antinode_options)
    endif()

    target_precompile_headers (${target} REUSE_FROM ${owner})
    target_link_libraries (${target} PRIVATE Eigen3::Eigen)
    get_target_property (type ${target} TYPE)
    if (type STREQUAL EXECUTABLE)
        target_compile_options (${target} PRIVATE -fPIC) # as the owner is compiled; by itself it would be -fPIE
    endif()
endfunction()
