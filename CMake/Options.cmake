# One interface target that every target of ours links: the warnings, the sanitizers, the language level.
add_library (antinode_options INTERFACE)
target_compile_features (antinode_options INTERFACE cxx_std_20)
# clang's -Wshadow also reports names of a namespace, which g++'s -Wshadow=local does not. g++ 12 reports overlapping copies in std::string operator+ where there are none (its bug 105329), as three
# different warnings.
set (shadow "")
set (false_alarms "")
if (CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    set (shadow -Wshadow=local)
    set (false_alarms -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
endif()
if (MINGW)
    list (APPEND false_alarms -Wno-format) # It takes printf for Microsoft's, which knows no %zu; the calls are checked elsewhere.
endif()
target_compile_options (antinode_options INTERFACE
    -Wall -Wextra -Wpedantic ${shadow} -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual -Werror ${false_alarms})

# g++ writes what ccache needs to cache files that use a precompiled header.
if (CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options (antinode_options INTERFACE -fpch-preprocess -Winvalid-pch)
endif()

# Sanitizers and coverage go to every target, JUCE included: mixed builds give false reports.
if (ANTINODE_SANITIZERS)
    add_compile_options (-fsanitize=${ANTINODE_SANITIZERS} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options (-fsanitize=${ANTINODE_SANITIZERS})
    # g++ 12 reports false maybe-uninitialized warnings inside Eigen when it also instruments for sanitizers.
    target_compile_options (antinode_options INTERFACE -Wno-maybe-uninitialized)
endif()
if (ANTINODE_COVERAGE)
    add_compile_options (--coverage)
    add_link_options (--coverage)
endif()
