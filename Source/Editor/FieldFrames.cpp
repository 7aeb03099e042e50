#include "FieldFrames.h"

#include <antinode_base/Watch.h>
#include <antinode_focus/Prediction.h>
#include <antinode_reports/FieldSampling.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int mapCells = 160; // along the longer side

Eigen::VectorXd velocitiesAt (const ModalModel& model, const FocusDesign& design, double fromFocus)
{
    const auto time = std::max (0.0, design.program.focusTime + fromFocus);
    return modalVelocities (model, predictStates (model, design.program, time));
}

/** @param velocities  N_c x frames */
void fill (FieldFrames& frames, const ModalModel& model, const Eigen::MatrixXd& velocities)
{
    Eigen::MatrixXd fields = model.shapes * velocities;

    if (model.surface.kind == SurfaceKind::plate)
        frames.maps = fieldMaps (model.surface, fields, mapCells);
    else
        frames.lines = std::move (fields);
}

FieldFrames framesOfFocus (const ModalModel& model, const Eigen::VectorXd& velocities)
{
    FieldFrames frames;
    frames.focusVelocities = velocities;
    frames.focusField = model.shapes * velocities;
    frames.largest = frames.focusField (pointsOn (model.surface)).cwiseAbs().maxCoeff();
    fill (frames, model, velocities);
    return frames;
}
} // namespace

FieldFrames predictFocus (const ModalModel& model, const FocusDesign& design)
{
    return framesOfFocus (model, velocitiesAt (model, design, 0));
}

FieldFrames makeFrames (const ModalModel& model, const Eigen::MatrixXd& velocities)
{
    const Eigen::MatrixXd fields = model.shapes * velocities;
    Eigen::Index largest = 0;
    fields (pointsOn (model.surface), Eigen::all).cwiseAbs().colwise().maxCoeff().maxCoeff (&largest);
    auto frames = framesOfFocus (model, velocities.col (largest));
    fill (frames, model, velocities);
    return frames;
}

FieldFrames stillFrames (const ModalModel& model)
{
    return framesOfFocus (model, Eigen::VectorXd::Zero (model.coordinates()));
}

std::shared_ptr<const FieldFrames> predictFrames (const ModalModel& model, const FocusDesign& design)
{
    auto frames = std::make_shared<FieldFrames> (predictFocus (model, design));
    Eigen::MatrixXd velocities (model.coordinates(), FieldFrames::count);

    for (int i = 0; i < FieldFrames::count; ++i)
    {
        checkWatch();
        velocities.col (i) = velocitiesAt (model, design, FieldFrames::frameTime (i));
    }

    fill (*frames, model, velocities);
    return frames;
}
} // namespace antinode
