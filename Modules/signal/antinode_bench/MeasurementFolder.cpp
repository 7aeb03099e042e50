#include "MeasurementFolder.h"

#include <antinode_base/InputError.h>
#include <antinode_base/WholeFile.h>
#include <antinode_documents/ExcitationFolder.h>
#include <antinode_responses/PointResponseFile.h>
#include <antinode_text/CsvText.h>

#include <array>
#include <cstdio>
#include <utility>

namespace antinode
{
namespace
{
constexpr const char* pointsFile = "points.csv";
constexpr const char* sheetFile = "excitation.json";
constexpr const char* signalFile = "signal.wav";

std::string pointsText (const Eigen::MatrixX2d& points)
{
    constexpr int digits = 12;
    std::string text = "x_mm,y_mm\n";

    for (Eigen::Index p = 0; p < points.rows(); ++p)
    {
        appendCsvNumber (text, points (p, 0) * 1000, digits);
        text += ',';
        appendCsvNumber (text, points (p, 1) * 1000, digits);
        text += '\n';
    }

    return text;
}
} // namespace

MeasurementFolder::MeasurementFolder (std::filesystem::path folderToUse, const ExcitationSheet& sheet,
                                      const Eigen::MatrixX2d& points)
    : folder (std::move (folderToUse))
{
    const auto sheetText = excitationToJson (sheet, signalFile).dump (2) + "\n", places = pointsText (points);

    if (std::error_code unknown; std::filesystem::exists (folder / sheetFile, unknown))
    {
        if (readWholeFile (folder / sheetFile, {}) != sheetText || readWholeFile (folder / pointsFile, {}) != places)
            throw InputError (folder.string(),
                              "contains a measurement with another excitation or other points; choose another folder");

        return;
    }

    OutputFolder output (folder);
    output.write (pointsFile, places);
    writeSheet (output, sheet);
    output.commit();
}

std::filesystem::path MeasurementFolder::pointFile (Eigen::Index point) const
{
    std::array<char, 32> name {};
    std::snprintf (name.data(), name.size(), "point-%04td.uff", point + 1);
    return folder / name.data();
}

bool MeasurementFolder::has (Eigen::Index point) const
{
    return std::filesystem::exists (pointFile (point));
}

void MeasurementFolder::keep (const SurfaceMeasurement& measurement, Eigen::Index point) const
{
    writeWholeFile (pointFile (point), encodePoint (measurement, point));
}

void MeasurementFolder::restore (SurfaceMeasurement& measurement, Eigen::Index point) const
{
    const auto file = pointFile (point);
    restorePoint (measurement, point, readWholeFile (file, {}), file.string());
}
} // namespace antinode
