#include "UniversalModes.h"

#include "ShapeMesh.h"

#include <antinode_universal/UniversalRecordText.h>

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

/** A complex mode: pole, modal A and modal B with A = 2 j b, so that a mode which is real has modal mass 1. */
UniversalShape makeComplexShape (const ModalModel& model, const ShapeMesh& mesh, const UniversalNodes& nodes,
                                 Eigen::Index mode)
{
    constexpr int structural = 1, complexMode = 3, translations = 2, displacement = 8, alongZ = 2;
    const auto decay = decayRates (model)[mode], turn = dampedFrequencies (model)[mode];
    std::string place = "Mode      ";
    appendInteger (place, mode + 1);
    place += " Frequency";
    appendReal (place, model.frequencyHz (mode));

    UniversalShape shape;
    shape.lines = { "Device " + model.name, std::string (program), "NONE",
                    "Complex shape along z, normal to the surface, modal A = 2 j Im(pole), kg^-1/2", place };
    shape.modelType = structural;
    shape.analysisType = complexMode;
    shape.dataCharacteristic = translations;
    shape.specificType = displacement;
    shape.isComplex = true;
    shape.integers = { loadCase, mode + 1 };
    shape.reals = { -decay, turn, 0, 2 * turn, 2 * turn * turn, 2 * turn * decay };
    shape.nodes = nodes.labels;
    shape.values = Eigen::MatrixXcd::Zero (mesh.shapes.rows(), 3);
    shape.values.col (alongZ).real() = mesh.shapes.col (mode);
    shape.values.col (alongZ).imag() = mesh.shapes.col (model.modes() + mode);
    return shape;
}

UniversalShape makeShape (const ModalModel& model, const ShapeMesh& mesh, const UniversalNodes& nodes,
                          Eigen::Index mode)
{
    constexpr int structural = 1, normalMode = 2, translations = 2, displacement = 8, alongZ = 2;

    if (model.hasComplexModes())
        return makeComplexShape (model, mesh, nodes, mode);

    constexpr double modalMass = 1, hystereticDamping = 0;
    std::string place = "Mode      ";
    appendInteger (place, mode + 1);
    place += " Frequency";
    appendReal (place, model.frequencyHz (mode));

    UniversalShape shape;
    shape.lines = { "Device " + model.name, std::string (program), "NONE",
                    "Shape along z, normal to the surface, mass-normalised, kg^-1/2", place };
    shape.modelType = structural;
    shape.analysisType = normalMode;
    shape.dataCharacteristic = translations;
    shape.specificType = displacement;
    shape.integers = { loadCase, mode + 1 };
    shape.reals = { model.frequencyHz (mode), modalMass, model.dampingRatios[mode], hystereticDamping };
    shape.nodes = nodes.labels;
    shape.values = Eigen::MatrixXcd::Zero (mesh.shapes.rows(), 3);
    shape.values.col (alongZ).real() = mesh.shapes.col (mode);
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
