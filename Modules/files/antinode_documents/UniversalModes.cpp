#include "UniversalModes.h"

#include "ShapeMesh.h"

#include <antinode_responses/UniversalRecordText.h>

#include <algorithm>
#include <string_view>

namespace antinode
{
namespace
{
constexpr std::string_view program = "Antinode " ANTINODE_VERSION;
constexpr int colour = 8, loadCase = 1;

UniversalHeader makeHeader (const ModalModel& model)
{
    const std::string noDate (20, ' '), writer (program);
    return { { "Device " + model.name, "Normal modes of the surface of a haptic device", writer,
               noDate + "         0         0         0", noDate, writer, noDate } };
}

UniversalUnits metresAndNewtons()
{
    constexpr int relativeTemperature = 2;
    return { 1, "SI: Meter (newton)", relativeTemperature, 1, 1, 1, 273.14999999999998 };
}

UniversalNodes makeNodes (const ShapeMesh& mesh)
{
    UniversalNodes nodes;
    nodes.isDouble = false;
    nodes.places = Eigen::MatrixX3d::Zero (mesh.points.rows(), 3);
    nodes.places.leftCols (2) = mesh.points;

    for (Eigen::Index p = 0; p < mesh.points.rows(); ++p)
    {
        nodes.labels.push_back (p + 1);
        nodes.systems.push_back ({ 0, 0, colour });
    }

    return nodes;
}

/** Long traces go into several sets, each of which begins with the last node of the one before. */
void appendTraces (std::vector<UniversalSet>& sets, const ShapeMesh& mesh)
{
    constexpr std::size_t maximumNodes = 125; // Of the format 250, of old readers of it 125.
    int number = 0;

    for (const auto& trace : mesh.traces)
        for (std::size_t first = 0; first + 1 < trace.size(); first += maximumNodes - 1)
        {
            const auto end = std::min (first + maximumNodes, trace.size());
            UniversalTrace line { ++number, colour, "Line " + std::to_string (number), {} };

            for (auto i = first; i < end; ++i)
                line.nodes.push_back (trace[i] + 1);

            sets.emplace_back (std::move (line));
        }
}

/** What real and complex modes have in common. */
UniversalShape commonShape (const ModalModel& model, const ShapeMesh& mesh, const UniversalNodes& nodes,
                            Eigen::Index mode, const std::string& meaning)
{
    constexpr int structural = 1, translations = 2, displacement = 8, alongZ = 2;
    std::string place = "Mode      ";
    appendInteger (place, mode + 1);
    place += " Frequency";
    appendReal (place, model.frequencyHz (mode));

    UniversalShape shape;
    shape.lines = { "Device " + model.name, std::string (program), "NONE", meaning, place };
    shape.modelType = structural;
    shape.dataCharacteristic = translations;
    shape.specificType = displacement;
    shape.integers = { loadCase, mode + 1 };
    shape.nodes = nodes.labels;
    shape.values = Eigen::MatrixXcd::Zero (mesh.shapes.rows(), 3);
    shape.values.col (alongZ).real() = mesh.shapes.col (mode);

    if (model.hasComplexModes())
        shape.values.col (alongZ).imag() = mesh.shapes.col (model.modes() + mode);

    return shape;
}

/** A complex mode has its pole, modal A and modal B with A = 2 j b, so that one which is real has modal mass 1. */
UniversalShape makeShape (const ModalModel& model, const ShapeMesh& mesh, const UniversalNodes& nodes,
                          Eigen::Index mode)
{
    constexpr int normalMode = 2, complexMode = 3;

    if (! model.hasComplexModes())
    {
        constexpr double modalMass = 1, hystereticDamping = 0;
        auto shape =
            commonShape (model, mesh, nodes, mode, "Shape along z, normal to the surface, mass-normalised, kg^-1/2");
        shape.analysisType = normalMode;
        shape.reals = { model.frequencyHz (mode), modalMass, model.dampingRatios[mode], hystereticDamping };
        return shape;
    }

    const auto decay = decayRates (model)[mode], turn = dampedFrequencies (model)[mode];
    auto shape = commonShape (model, mesh, nodes, mode,
                              "Complex shape along z, normal to the surface, modal A = 2 j Im(pole), kg^-1/2");
    shape.analysisType = complexMode;
    shape.isComplex = true;
    shape.reals = { -decay, turn, 0, 2 * turn, 2 * turn * turn, 2 * turn * decay };
    return shape;
}
} // namespace

std::vector<UniversalSet> modeSets (const ModalModel& model)
{
    const auto mesh = shapeMesh (model);
    const auto nodes = makeNodes (mesh);
    std::vector<UniversalSet> sets { makeHeader (model), metresAndNewtons(), nodes };
    appendTraces (sets, mesh);

    for (Eigen::Index mode = 0; mode < model.modes(); ++mode)
        sets.emplace_back (makeShape (model, mesh, nodes, mode));

    return sets;
}
} // namespace antinode
