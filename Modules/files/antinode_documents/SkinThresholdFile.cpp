#include "SkinThresholdFile.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_text/CsvTable.h>

namespace antinode
{
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
