# antinode_embed_files (TARGET NAMESPACE FILES...): a static library with one function,
#   std::span<const antinode::EmbeddedFile> NAMESPACE::files();
# The bytes are assembled with .incbin: no generated megabytes of source, and a changed file rebuilds only this.
function (antinode_embed_files target nameSpace)
    set (directory ${CMAKE_CURRENT_BINARY_DIR}/${target})
    set (assembly "    .section .rodata\n")
    set (underscore "") # What a C compiler of macOS puts before each name.
    if (WIN32)
        set (assembly "    .section .rdata,\"dr\"\n")
    elseif (APPLE)
        set (assembly "    .section __TEXT,__const\n")
        set (underscore _)
    endif()
    set (declarations "")
    set (entries "")
    set (index 0)
    foreach (file IN LISTS ARGN)
        get_filename_component (absolute ${file} ABSOLUTE)
        file (RELATIVE_PATH name ${CMAKE_CURRENT_SOURCE_DIR} ${absolute})
        if (IS_ABSOLUTE ${file} AND NOT file MATCHES "^${CMAKE_CURRENT_SOURCE_DIR}/")
            get_filename_component (name ${file} NAME)
        endif()
        set (symbol ${target}_${index})
        string (APPEND assembly
            "    .globl ${underscore}${symbol}_begin\n${underscore}${symbol}_begin:\n    .incbin \"${absolute}\"\n"
            "    .globl ${underscore}${symbol}_end\n${underscore}${symbol}_end:\n    .byte 0\n")
        string (APPEND declarations "extern const char ${symbol}_begin[], ${symbol}_end[];\n")
        string (APPEND entries "    { \"${name}\", ${symbol}_begin, ${symbol}_end },\n")
        list (APPEND inputs ${absolute})
        math (EXPR index "${index} + 1")
    endforeach()
    if (NOT WIN32 AND NOT APPLE)
        string (APPEND assembly "    .section .note.GNU-stack,\"\",%progbits\n")
    endif()
    file (CONFIGURE OUTPUT ${directory}/data.S CONTENT "${assembly}" @ONLY)
    file (CONFIGURE OUTPUT ${directory}/files.cpp CONTENT
"#include <antinode_base/WholeFile.h>
extern \"C\"
{
${declarations}}
namespace ${nameSpace}
{
std::span<const antinode::EmbeddedFile> files();
std::span<const antinode::EmbeddedFile> files()
{
    static const antinode::EmbeddedFile all[] = {
${entries}    };
    return all;
}
} // namespace ${nameSpace}
" @ONLY)
    file (CONFIGURE OUTPUT ${directory}/${target}.h CONTENT
"#pragma once
#include <antinode_base/WholeFile.h>
namespace ${nameSpace}
{
/** All files of this set, in the order of the build script. [any] */
std::span<const antinode::EmbeddedFile> files();
} // namespace ${nameSpace}
" @ONLY)
    add_library (${target} STATIC ${directory}/data.S ${directory}/files.cpp)
    set_source_files_properties (${directory}/data.S PROPERTIES OBJECT_DEPENDS "${inputs}")
    target_include_directories (${target} PUBLIC ${directory})
    target_link_libraries (${target} PUBLIC antinode_base)
endfunction()
