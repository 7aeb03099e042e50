#include "UniversalFile.h"

#include "ShapeMesh.h"

#include <antinode_model/InputError.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace antinode
{
namespace
{
constexpr std::string_view section = "    -1\n";
constexpr std::string_view program = "Antinode " ANTINODE_VERSION;
constexpr std::size_t lineLength = 80;
constexpr int colour = 8, loadCase = 1;

/** Columns as Fortran writes them: right-justified, I10 and 1PE13.5. */
void appendRight (std::string& text, std::string_view field, std::size_t width)
{
    text.append (width - std::min (width, field.size()), ' ');
    text += field;
}

void appendInteger (std::string& text, Eigen::Index number)
{
    appendRight (text, std::to_string (number), 10);
}

void appendReal (std::string& text, double number)
{
    constexpr double smallest = 1e-99; // An exponent of three digits leaves no space between two columns.
    std::array<char, 32> buffer {};

    if (! std::isfinite (number))
        throw InputError ("universal file", "has a value that is not finite");

    const auto written = std::to_chars (buffer.data(), buffer.data() + buffer.size(),
                                        std::abs (number) < smallest ? 0.0 : number, std::chars_format::scientific, 5);
    std::string field (buffer.data(), written.ptr);
    std::replace (field.begin(), field.end(), 'e', 'E');
    appendRight (text, field, 13);
}

template <typename... Numbers>
std::string integerRecord (Numbers... numbers)
{
    std::string text;
    (appendInteger (text, numbers), ...);
    return text + '\n';
}

template <typename... Numbers>
std::string realRecord (Numbers... numbers)
{
    std::string text;
    (appendReal (text, numbers), ...);
    return text + '\n';
}

/** A record of text: 80 columns of printable ASCII; what is not becomes '?', a '?' a character of UTF-8. */
std::string textRecord (std::string_view text)
{
    std::string line;

    for (const auto character : text)
    {
        const auto byte = static_cast<unsigned char> (character);
        const auto isContinuation = byte >= 0x80 && byte < 0xc0;

        if (! isContinuation && line.size() < lineLength)
            line += byte >= ' ' && byte < 0x7f ? character : '?';
    }

    return line + '\n';
}

void appendSet (std::string& file, int number, std::string_view records)
{
    file += section;
    appendRight (file, std::to_string (number), 6);
    file += '\n';
    file += records;
    file += section;
}

std::string headerRecords (const ModalModel& model)
{
    const std::string noDate (20, ' ');
    auto records = textRecord ("Device " + model.name);
    records += textRecord ("Normal modes of the surface of a haptic device");
    records += textRecord (program);
    records += noDate + integerRecord (0, 0, 0);
    records += noDate + '\n';
    records += textRecord (program);
    return records + noDate + '\n';
}

std::string unitRecords()
{
    return "         1SI: Meter (newton)           2\n"
           "  1.00000000000000000D+00  1.00000000000000000D+00  1.00000000000000000D+00\n"
           "  2.73149999999999977D+02\n";
}

std::string nodeRecords (const ShapeMesh& mesh)
{
    std::string records;

    for (Eigen::Index p = 0; p < mesh.points.rows(); ++p)
    {
        for (const auto number : { p + 1, Eigen::Index (0), Eigen::Index (0), Eigen::Index (colour) })
            appendInteger (records, number);

        records += realRecord (mesh.points (p, 0), mesh.points (p, 1), 0.0);
    }

    return records;
}

/** Long traces go into several sets, each of which begins with the last node of the one before. */
void appendTraces (std::string& file, const ShapeMesh& mesh)
{
    constexpr std::size_t mostNodes = 125, nodesALine = 8; // Of the format 250, of old readers of it 125.
    int number = 0;

    for (const auto& trace : mesh.traces)
        for (std::size_t first = 0; first + 1 < trace.size(); first += mostNodes - 1)
        {
            const auto count = std::min (mostNodes, trace.size() - first);
            auto records = integerRecord (++number, static_cast<Eigen::Index> (count), colour);
            records += textRecord ("Line " + std::to_string (number));

            for (std::size_t i = 0; i < count; ++i)
            {
                appendInteger (records, trace[first + i] + 1);

                if (i + 1 == count || i % nodesALine == nodesALine - 1)
                    records += '\n';
            }

            appendSet (file, 82, records);
        }
}

std::string modeRecords (const ModalModel& model, const ShapeMesh& mesh, Eigen::Index mode)
{
    constexpr int structural = 1, normalMode = 2, translations = 2, displacement = 8, real = 2, valuesANode = 3;
    constexpr double modalMass = 1, hystereticDamping = 0;
    std::string frequency;
    appendReal (frequency, model.frequencyHz (mode));

    auto records = textRecord ("Device " + model.name);
    records += textRecord (program);
    records += textRecord ("NONE");
    records += textRecord ("Shape along z, normal to the surface, mass-normalised, kg^-1/2");
    std::string place = "Mode      ";
    appendInteger (place, mode + 1);
    records += textRecord (place + " Frequency" + frequency);
    records += integerRecord (structural, normalMode, translations, displacement, real, valuesANode);
    records += integerRecord (2, 4, loadCase, mode + 1); // Two integers and four reals follow.
    records += realRecord (model.frequencyHz (mode), modalMass, model.dampingRatios[mode], hystereticDamping);

    for (Eigen::Index p = 0; p < mesh.points.rows(); ++p)
    {
        records += integerRecord (p + 1);
        records += realRecord (0.0, 0.0, mesh.shapes (p, mode));
    }

    return records;
}
} // namespace

std::string encodeUniversalFile (const ModalModel& model)
{
    const auto mesh = shapeMesh (model);
    std::string file;
    appendSet (file, 151, headerRecords (model));
    appendSet (file, 164, unitRecords());
    appendSet (file, 15, nodeRecords (mesh));
    appendTraces (file, mesh);

    for (Eigen::Index mode = 0; mode < model.modes(); ++mode)
        appendSet (file, 55, modeRecords (model, mesh, mode));

    return file;
}
} // namespace antinode
