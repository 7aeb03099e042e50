#include "System.h"

#include "InputError.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

namespace antinode
{
void requireWholeOutput()
{
    errno = 0;
    const auto isFlushed = std::fflush (stdout) == 0 && std::cout.flush().good();

    if (! isFlushed || std::ferror (stdout) != 0)
        throw InputError ("standard output",
                          "cannot be written" + (errno != 0 ? std::string (": ") + std::strerror (errno) : ""));
}
} // namespace antinode
