#include "SkinThresholds.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/WholeFile.h>
#include <antinode_resources.h>
#include <antinode_text/CsvTable.h>

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

SkinThreshold readSkinThreshold (std::string_view text, const std::string& source)
{
    const auto table = readCsvTable (text, source);

    if (table.numbers.cols() != 2)
        throw InputError (source, "has " + std::to_string (table.numbers.cols())
                                      + " columns; allowed: two, a frequency in Hz and a displacement in um");

    SkinThreshold threshold { source, table.numbers.col (0), table.numbers.col (1) / micro };
    validate (threshold);
    return threshold;
}
} // namespace antinode
