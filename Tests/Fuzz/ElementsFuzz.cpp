#include "Fuzz.h"

#include <antinode_import/ImportedDevice.h>

/** Results of finite elements. */
void antinode::test::fuzz (std::string_view bytes)
{
    findTouchedSurface (mergedResults ({ readElementResults (bytes, "file") }), {});
}
