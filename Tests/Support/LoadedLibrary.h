#pragma once

namespace antinode::test
{
/** Loads a library, which stays loaded to the end of the program. @throws std::runtime_error */
void* loadLibrary (const char* path);

/** The address of a function of a loaded library. @throws std::runtime_error  it has none of this name */
void* symbolOf (void* library, const char* name);
} // namespace antinode::test
