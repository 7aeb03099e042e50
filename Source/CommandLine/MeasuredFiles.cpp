#include "MeasuredFiles.h"

#include <antinode_reports/MeasurementReport.h>
#include <antinode_responses/UniversalResponses.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_universal/UniversalFile.h>

namespace antinode
{
void writeMeasured (const std::filesystem::path& folder, const SurfaceMeasurement& measurement,
                    const ExcitationSheet& sheet)
{
    OutputFolder output (folder);
    output.write ("responses.uff", encodeUniversalFile (responseSets (measurement.responses)));
    output.write ("report.html", renderReport (measurementReport (measurement, sheet)));
    output.commit();
}
} // namespace antinode
