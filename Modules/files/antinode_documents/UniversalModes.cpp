#include "UniversalModes.h"

#include <antinode_responses/UniversalRecords.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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

namespace
{
constexpr Eigen::Index maximumPoints = 4000;

/** How often a row of values changes its sign where it is not small relative to the largest value of its mode. */
Eigen::Index signChanges (const auto& values, double largest)
{
    constexpr double small = 0.05; // Along a nodal line there is nothing but rounding errors.
    Eigen::Index changes = 0;
    double sign = 0;

    for (const auto value : values)
        if (std::abs (value) > small * largest)
        {
            changes += sign * value < 0 ? 1 : 0;
            sign = value < 0 ? -1 : 1;
        }

    return changes;
}

/** Points that an even grid needs along x and y: n sign changes are about (n + 1) / 2 wavelengths. */
Eigen::Array2<Eigen::Index> evenCounts (const PlateGrid& grid, const Eigen::MatrixXd& shapes)
{
    constexpr Eigen::Index pointsAHalfWave = 4, fewest = 2;
    Eigen::Array2<Eigen::Index> changes (0, 0);

    for (const auto& shape : shapes.colwise())
    {
        const auto values = shape.head (grid.x.places.size() * grid.y.places.size())
                                .reshaped (grid.x.places.size(), grid.y.places.size());
        const auto largest = shape.cwiseAbs().maxCoeff();

        for (const auto& alongX : values.colwise())
            changes[0] = std::max (changes[0], signChanges (alongX, largest));

        for (const auto& alongY : values.rowwise())
            changes[1] = std::max (changes[1], signChanges (alongY, largest));
    }

    Eigen::Array2<Eigen::Index> counts = pointsAHalfWave * (changes + 1) + 1;

    if (counts.prod() > maximumPoints)
    {
        const auto scale = std::sqrt (static_cast<double> (maximumPoints) / static_cast<double> (counts.prod()));
        counts = (counts.cast<double>() * scale).cast<Eigen::Index>().max (fewest);
        counts = counts.min (maximumPoints / counts.minCoeff());
    }

    return counts;
}

Eigen::VectorXd evenPlaces (const GridAxis& axis, Eigen::Index count)
{
    return Eigen::VectorXd::LinSpaced (count, axis.edges[0], axis.edges[axis.edges.size() - 1]);
}

ShapeMesh evenMesh (const PlateGrid& grid, const Eigen::MatrixXd& shapes)
{
    const auto counts = evenCounts (grid, shapes);
    const auto x = evenPlaces (grid.x, counts[0]), y = evenPlaces (grid.y, counts[1]);
    const auto rowsX = interpolationRows (grid.x, x), rowsY = interpolationRows (grid.y, y);
    ShapeMesh mesh;
    mesh.points.resize (counts.prod(), 2);
    mesh.points.col (0) = x.replicate (counts[1], 1);
    mesh.points.col (1) = y.transpose().replicate (counts[0], 1).reshaped();
    mesh.shapes.resize (counts.prod(), shapes.cols());

    for (Eigen::Index k = 0; k < shapes.cols(); ++k)
        mesh.shapes.col (k) =
            (rowsX * shapes.col (k).head (rowsX.cols() * rowsY.cols()).reshaped (rowsX.cols(), rowsY.cols())
             * rowsY.transpose())
                .reshaped();

    return mesh;
}

/** Those points that lie on a surface. */
ShapeMesh within (const Surface& surface, const ShapeMesh& mesh)
{
    std::vector<Eigen::Index> on;

    for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
        if (liesOn (surface, mesh.points (i, 0), mesh.points (i, 1)))
            on.push_back (i);

    return { mesh.points (on, Eigen::all), mesh.shapes (on, Eigen::all), {} };
}

/** Points in lines: those that share one coordinate, ascending in the other. */
void addTraces (ShapeMesh& mesh, Eigen::Index shared)
{
    const auto coordinates = mesh.points.col (shared);
    const auto along = mesh.points.col (1 - shared);
    const auto tolerance = 1e-6 * (mesh.points.colwise().maxCoeff() - mesh.points.colwise().minCoeff()).maxCoeff();
    std::vector<Eigen::Index> order (static_cast<std::size_t> (mesh.points.rows()));
    std::iota (order.begin(), order.end(), 0);
    std::sort (order.begin(), order.end(), [&] (auto a, auto b) { return coordinates[a] < coordinates[b]; });

    for (auto begin = order.begin(); begin != order.end();)
    {
        const auto end = std::find_if (begin, order.end(),
                                       [&] (auto i) { return coordinates[i] > coordinates[*begin] + tolerance; });
        std::sort (begin, end, [&] (auto a, auto b) { return along[a] < along[b]; });

        if (end - begin >= 2)
            mesh.traces.emplace_back (begin, end);

        begin = end;
    }
}
} // namespace

ShapeMesh shapeMesh (const ModalModel& model)
{
    const auto& surface = model.surface;
    auto mesh = surface.grid ? evenMesh (*surface.grid, model.shapes) : ShapeMesh { surface.points, model.shapes, {} };

    if (surface.grid && surface.boundary)
        mesh = within (surface, mesh);

    addTraces (mesh, 1);
    addTraces (mesh, 0);
    return mesh;
}
} // namespace antinode
