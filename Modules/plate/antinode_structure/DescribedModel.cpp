#include "DescribedModel.h"

#include "DescribedCeramic.h"

#include <antinode_numerics/Decompositions.h>

#include <algorithm>

namespace antinode
{
namespace
{
/** The end of the run of modes from the given one on that have its frequency, to rounding. */
Eigen::Index endOfCluster (const Eigen::VectorXd& frequencies, Eigen::Index first)
{
    constexpr double equal = 1e-8;
    auto end = first + 1;

    while (end < frequencies.size() && frequencies[end] - frequencies[end - 1] <= equal * frequencies[first])
        ++end;

    return end;
}
} // namespace

Eigen::VectorXd dampingOfModes (const std::vector<double>& ratios, Eigen::Index modes)
{
    if (ratios.empty())
        return Eigen::VectorXd::Zero (modes);

    return Eigen::VectorXd::NullaryExpr (
        modes, [&] (Eigen::Index k) { return ratios[std::min (static_cast<std::size_t> (k), ratios.size() - 1)]; });
}

void describe (ModalModel& model, const std::string& name, const StructureCommon& common)
{
    const auto& surface = model.surface;
    model.name = name;
    model.origin.source = ModeSource::drawn;
    model.dampingRatios = dampingOfModes (common.dampingRatios, model.modes());
    model.fullScaleVoltage = common.fullScaleVoltage;

    for (std::size_t i = 0; i < common.ceramics.size(); ++i)
    {
        const auto& ceramic = common.ceramics[i];
        const auto alongX = [&] (double x) { return std::clamp (x, surface.xMinimum, surface.xMaximum); };
        const auto alongY = [&] (double y) { return std::clamp (y, surface.yMinimum, surface.yMaximum); };
        const auto [least, largest] = ceramicExtent (ceramic);
        model.ceramics.push_back ({ ceramic.name.empty() ? "C" + std::to_string (i + 1) : ceramic.name,
                                    alongX (least.x()), alongX (largest.x()), alongY (least.y()), alongY (largest.y()),
                                    common.voltageLimit, slewLimit (common, i), capacitance (ceramic) });

        if (! fillsItsRectangle (ceramic))
            model.ceramics.back().outline = ceramicOutline (ceramic);

        model.ceramics.back().lossFactor = ceramic.lossFactor;
        model.ceramics.back().area = faceArea (ceramic);
        model.ceramics.back().currentLimit = common.currentLimit;
    }
}

void settleSigns (ModalModel& model)
{
    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const Eigen::ArrayXd magnitudes = model.shapes.col (k).cwiseAbs();
        const auto threshold = magnitudes.maxCoeff() / 10;
        Eigen::Index first = 0;
        (magnitudes > threshold).maxCoeff (&first);

        if (model.shapes (first, k) >= 0)
            continue;

        model.shapes.col (k) *= -1;
        model.participation.row (k) *= -1;

        if (model.slopes.size() > 0)
            model.slopes.col (k) *= -1;
    }
}

void settleEqualFrequencies (ModalModel& model)
{
    const Eigen::VectorXd moment = model.surface.masses.cwiseProduct (model.surface.points.col (0).cwiseAbs2());

    for (Eigen::Index first = 0, end = 0; first < model.modes(); first = end)
    {
        end = endOfCluster (model.angularFrequencies, first);
        const auto count = end - first;

        if (count == 1)
            continue;

        const Eigen::MatrixXd shapes = model.shapes.middleCols (first, count);
        const auto turn = symmetricEigen (shapes.transpose() * moment.asDiagonal() * shapes).vectors;
        model.shapes.middleCols (first, count) = shapes * turn;
        model.participation.middleRows (first, count) =
            (turn.transpose() * model.participation.middleRows (first, count)).eval();
        model.angularFrequencies.segment (first, count)
            .setConstant (model.angularFrequencies.segment (first, count).mean());
    }
}

bool isHeld (EdgeCondition condition)
{
    return condition == EdgeCondition::clamped || condition == EdgeCondition::simplySupported;
}

namespace
{
/** The parts of a boundary whose edges are so. */
template <typename IsSo>
std::vector<PathPiece> piecesWhere (const OutlinedPlate& plate, const IsSo& isSo)
{
    std::vector<PathPiece> pieces;

    for (const auto& path : plate.outline.paths)
        for (const auto& piece : path)
            if (isSo (plate.edges[static_cast<std::size_t> (piece.edge)]))
                pieces.push_back (piece);

    return pieces;
}
} // namespace

std::vector<PathPiece> elasticPieces (const DeviceDescription& device)
{
    if (const auto* const measured = std::get_if<MeasuredDevice> (&device.body))
        return elasticPieces (*measured->drawing);

    const auto* const plate = std::get_if<OutlinedPlate> (&device.body);
    return plate == nullptr
               ? std::vector<PathPiece>()
               : piecesWhere (*plate, [] (const PlateEdge& edge) { return edge.translation > 0 || edge.rotation > 0; });
}

Surface outlinedSurface (const OutlinedPlate& plate)
{
    const auto extent = extentOf (plate.outline);
    Surface surface;
    surface.kind = SurfaceKind::plate;
    surface.xMinimum = extent.least.x();
    surface.xMaximum = extent.largest.x();
    surface.yMinimum = extent.least.y();
    surface.yMaximum = extent.largest.y();
    surface.boundary = SurfaceBoundary { plate.outline, piecesWhere (plate, [] (const PlateEdge& edge)
                                                                     { return isHeld (edge.condition); }) };
    return surface;
}
} // namespace antinode
