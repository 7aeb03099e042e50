#include "SkinThresholds.h"

#include "SkinThresholdFile.h"
#include <antinode_base/InputError.h>
#include <antinode_base/WholeFile.h>
#include <antinode_resources.h>

#include <algorithm>

namespace antinode
{
SkinThreshold findSkinThreshold (const std::string& file)
{
    if (! file.empty())
        return readSkinThreshold (readWholeFile (file, { "a CSV file of Hz and um", std::uintmax_t { 1 } << 20 }),
                                  file);

    const auto files = resources::files();
    const auto found =
        std::find_if (files.begin(), files.end(),
                      [] (const auto& each) { return each.name == std::string_view ("Skin/threshold.csv"); });
    return readSkinThreshold (found->text(), "built-in threshold");
}
} // namespace antinode
