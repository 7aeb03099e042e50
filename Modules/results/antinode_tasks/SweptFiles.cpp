#include "SweptFiles.h"

#include "Field.h"

#include <antinode_reports/SweepReport.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

namespace antinode
{
void writeSwept (const std::filesystem::path& path, const SweepTable& table, const SweepSummary& summary)
{
    OutputFolder output (path);
    output.write ("results.csv", sweepToCsv (table, withKeysAndOptions));
    output.write ("results.mat", sweepToMatlab (table));
    output.write ("report.html", renderReport (sweepReport (table, summary)));
    output.write ("summary.json", sweepToJson (table, summary).dump (2) + "\n");
    output.commit();
}
} // namespace antinode
