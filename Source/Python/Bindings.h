#pragma once

#include <pybind11/pybind11.h>

namespace antinode
{
/** The parts of the module `_antinode`: each binds its values and functions. [any] with the GIL */
void bindDocuments (pybind11::module_&);
void bindModes (pybind11::module_&);
void bindDesign (pybind11::module_&);
void bindRender (pybind11::module_&);
void bindPerform (pybind11::module_&);
void bindIdentify (pybind11::module_&);
void bindMeasure (pybind11::module_&);
void bindPlace (pybind11::module_&);
void bindSweep (pybind11::module_&);
void bindMap (pybind11::module_&);
void bindTolerance (pybind11::module_&);
void bindTradeoff (pybind11::module_&);
void bindExcite (pybind11::module_&);
void bindFrf (pybind11::module_&);
void bindRetune (pybind11::module_&);
void bindImport (pybind11::module_&);
void bindLearn (pybind11::module_&);
void bindFollow (pybind11::module_&);
void bindSensors (pybind11::module_&);
} // namespace antinode
