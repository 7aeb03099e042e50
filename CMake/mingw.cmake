# Windows, 64 bit, by mingw-w64's g++ on Linux. Scripts/windows-libraries builds the libraries, `Scripts/package windows` all.
set (CMAKE_SYSTEM_NAME Windows)
set (CMAKE_SYSTEM_PROCESSOR x86_64)
set (CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set (CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set (CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

if (NOT DEFINED ANTINODE_MINGW_PREFIX)
    set (ANTINODE_MINGW_PREFIX $ENV{HOME}/.cache/antinode/mingw)
endif()
list (APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ANTINODE_MINGW_PREFIX)
set (CMAKE_FIND_ROOT_PATH ${ANTINODE_MINGW_PREFIX} /usr/x86_64-w64-mingw32)
set (CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set (CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set (CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set (CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set (ENV{PKG_CONFIG_LIBDIR} ${ANTINODE_MINGW_PREFIX}/lib/pkgconfig:/usr/x86_64-w64-mingw32/lib/pkgconfig)

# Headers beside the libraries; printf as the C standard has it, with %zu.
set (CMAKE_C_STANDARD_INCLUDE_DIRECTORIES ${ANTINODE_MINGW_PREFIX}/include)
set (CMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES ${ANTINODE_MINGW_PREFIX}/include)
set (CMAKE_CXX_FLAGS_INIT -D__USE_MINGW_ANSI_STDIO=1)

# A program that needs no other file; wine runs it for CTest and while building.
set (CMAKE_EXE_LINKER_FLAGS_INIT "-static -L${ANTINODE_MINGW_PREFIX}/lib")
set (CMAKE_MODULE_LINKER_FLAGS_INIT "-static -L${ANTINODE_MINGW_PREFIX}/lib")
set (CMAKE_CROSSCOMPILING_EMULATOR wine)
