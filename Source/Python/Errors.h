#pragma once

#include <pybind11/pybind11.h>

namespace antinode
{
/** Lets errors reach Python as the exceptions of the package's module `errors`, with the sentence of the command line.
    [any] with the GIL */
void registerErrors (pybind11::module_&);
} // namespace antinode
