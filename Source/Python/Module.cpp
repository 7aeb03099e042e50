#include "Bindings.h"
#include "Errors.h"
#include "ResultClass.h"

PYBIND11_MODULE (_antinode, module)
{
    module.doc() = "The compiled part of the package antinode.";
    module.attr ("version") = ANTINODE_VERSION;
    antinode::registerErrors (module);
    antinode::bindDocuments (module);
    antinode::bindModes (module);
    antinode::bindDesign (module);
    antinode::bindPerform (module);
    antinode::bindMap (module);
    antinode::bindSweep (module);
    antinode::bindBench (module);
    antinode::bindLearning (module);
    module.def ("_stubs", &antinode::keptStubs);
}
