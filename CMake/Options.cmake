# One interface target that every target of ours links: the warnings, the sanitizers, the language level.
add_library (antinode_options INTERFACE)
target_compile_features (antinode_options INTERFACE cxx_std_20)
target_compile_options (antinode_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow=local -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual -Werror
    # g++ 12 reports overlapping copies in std::string operator+ where there are none (its bug 105329), as three different warnings.
    -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)

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
