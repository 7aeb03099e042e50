#include "Bindings.h"
#include "Errors.h"

PYBIND11_MODULE (_antinode, module)
{
    module.doc() = "The compiled part of the package antinode.";
    module.attr ("version") = ANTINODE_VERSION;
    antinode::registerErrors (module);
    antinode::bindDocuments (module);
    antinode::bindModes (module);
    antinode::bindDesign (module);
    antinode::bindRender (module);
    antinode::bindPerform (module);
    antinode::bindIdentify (module);
    antinode::bindExcite (module);
    antinode::bindMeasure (module);
    antinode::bindPlace (module);
    antinode::bindSweep (module);
    antinode::bindMap (module);
    antinode::bindTolerance (module);
    antinode::bindTradeoff (module);
    antinode::bindFollow (module);
    antinode::bindFrf (module);
    antinode::bindRetune (module);
    antinode::bindImport (module);
    antinode::bindLearn (module);
    antinode::bindSensors (module);
}
