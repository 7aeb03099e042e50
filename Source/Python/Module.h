#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace antinode
{
struct DesignedFocus;
struct PictureStyle;

/** The parts of the module `_antinode`: each binds its values and functions. [any] with the GIL */
void bindDocuments (pybind11::module_&);
void bindModes (pybind11::module_&);
void bindDesign (pybind11::module_&);
void bindPerform (pybind11::module_&);
void bindMap (pybind11::module_&);
void bindCompared (pybind11::module_&);
void bindSweep (pybind11::module_&);
void bindBench (pybind11::module_&);
void bindLearning (pybind11::module_&);

/** A velocity field of a design by the closed form, as PNG. [worker] */
std::string designPicture (const DesignedFocus&, const PictureStyle&);

/** Lets errors reach Python as the exceptions of the package's module `errors`, with the sentence of the command line.
    [any] with the GIL */
void registerErrors (pybind11::module_&);
} // namespace antinode
