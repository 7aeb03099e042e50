#include "DescribedModel.h"

#include "Capacitance.h"

#include <algorithm>

namespace antinode
{
Eigen::VectorXd dampingOfModes (const std::vector<double>& ratios, Eigen::Index modes)
{
    return Eigen::VectorXd::NullaryExpr (
        modes, [&] (Eigen::Index k) { return ratios[std::min (static_cast<std::size_t> (k), ratios.size() - 1)]; });
}

void describe (ModalModel& model, const std::string& name, const StructureCommon& common)
{
    const auto& surface = model.surface;
    model.name = name;
    model.dampingRatios = dampingOfModes (common.dampingRatios, model.modes());
    model.fullScaleVoltage = common.fullScaleVoltage;

    for (std::size_t i = 0; i < common.ceramics.size(); ++i)
    {
        const auto& ceramic = common.ceramics[i];
        const auto alongX = [&] (double x) { return std::clamp (x, surface.xMinimum, surface.xMaximum); };
        const auto alongY = [&] (double y) { return std::clamp (y, surface.yMinimum, surface.yMaximum); };
        model.ceramics.push_back ({ ceramic.name.empty() ? "C" + std::to_string (i + 1) : ceramic.name,
                                    alongX (ceramic.x), alongX (ceramic.x + ceramic.sizeX), alongY (ceramic.y),
                                    alongY (ceramic.y + ceramic.sizeY), common.voltageLimit, slewLimit (common, i),
                                    capacitance (ceramic) });
        model.ceramics.back().lossFactor = ceramic.lossFactor;
        model.ceramics.back().area = ceramic.sizeX * ceramic.sizeY;
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

bool isHeld (EdgeCondition condition)
{
    return condition == EdgeCondition::clamped || condition == EdgeCondition::simplySupported;
}
} // namespace antinode
