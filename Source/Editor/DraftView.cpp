#include "DraftView.h"

#include "MotionView.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/LimitUse.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

namespace antinode
{
namespace
{
constexpr int mostJudged = 120; // modes

/** Without ceramics: they are drawn where they are dragged to. */
std::shared_ptr<const Chart> shapeChart (const ModalModel& model, const FieldFrames& frames)
{
    auto chart = motionChart (model, frames);

    if (auto* const map = std::get_if<HeatMap> (&chart))
        map->rectangles.clear();
    else if (auto* const line = std::get_if<LineChart> (&chart))
    {
        line->spans.clear();
        line->yLabel = "shape of the mode";
    }

    return std::make_shared<const Chart> (std::move (chart));
}

/** Motion of a mode alone, its largest velocity 1 mm/s. */
FieldFrames shapeOfMode (const ModalModel& model, Eigen::Index mode)
{
    constexpr double shown = 1e-3;
    Eigen::VectorXd velocity = Eigen::VectorXd::Zero (model.coordinates());
    const auto largest = model.shapes.col (mode) (pointsOn (model.surface)).cwiseAbs().maxCoeff();
    velocity[mode] = largest > 0 ? shown / largest : 0;
    return makeFrames (model, velocity);
}

Eigen::VectorXd sharesOf (const ModalModel& model, std::optional<int> mode)
{
    Eigen::VectorXd shares = Eigen::VectorXd::Zero (model.actuators());

    if (mode && *mode < model.modes())
        shares = model.participation.row (*mode).transpose();

    if (const auto largest = shares.size() > 0 ? shares.cwiseAbs().maxCoeff() : 0.0; largest > 0)
        shares /= largest;

    return shares;
}
} // namespace

bool DraftQuestion::operator== (const DraftQuestion& other) const
{
    return device == other.device && exact == other.exact && focus == other.focus && settings == other.settings
           && playback.sampleRate == other.playback.sampleRate && modes == other.modes && mode == other.mode;
}

std::shared_ptr<const DraftPicture> DraftView::picture() const
{
    const std::lock_guard lock (mutex);
    return newest;
}

void DraftView::run()
{
    const WatchScope scope ([this] { return ! questions.hasLeft(); });

    while (const auto question = questions.take())
    {
        try
        {
            answer (*question);
        }
        catch (const Cancelled&)
        {
            // There is a newer question, or none any more.
        }
        catch (const std::exception&)
        {
            // What was right before stays; the session says why it cannot be solved once it is loaded.
        }
    }
}

void DraftView::solve (const DraftQuestion& question)
{
    if (question.exact == nullptr && question.device != solvedOf)
    {
        const auto start = std::chrono::steady_clock::now();
        solved = std::make_shared<const ModalModel> (solveCoarsely (question.device->description, coarseModes));
        solveTime = std::chrono::duration<double> (std::chrono::steady_clock::now() - start).count();
        solvedOf = question.device;
    }
}

void DraftView::answer (const DraftQuestion& question)
{
    solve (question);
    DraftPicture made;
    made.question = question;
    made.isExact = question.exact != nullptr;
    made.model = made.isExact ? question.exact : solved;
    made.solveTime = solveTime;
    const auto& model = *made.model;
    const auto isMode = question.mode && *question.mode < model.modes();
    auto frames = isMode ? shapeOfMode (model, *question.mode) : stillFrames (model);
    made.field = shapeChart (model, frames);
    made.frames = std::make_shared<const FieldFrames> (std::move (frames));
    made.shares = sharesOf (model, question.mode);

    if (const auto before = picture(); before != nullptr)
    {
        made.captured = before->captured;
        made.volts = before->volts;
    }

    show (made);
    addNumbers (made);
    show (made);
}

const ModalModel& DraftView::judgeOf (const DraftQuestion& question)
{
    if (question.exact != nullptr)
        return *question.exact;

    if (question.device != judgedOf)
    {
        judge = std::make_shared<const ModalModel> (
            solveCoarsely (question.device->description, std::clamp (question.modes, coarseModes, mostJudged)));
        judgedOf = question.device;
    }

    return *judge;
}

/** What the focus is on these modes. A newer question ends it. */
void DraftView::addNumbers (DraftPicture& made)
{
    const WatchScope scope ([this] { return ! questions.isOutdated(); });
    const auto& question = made.question;

    try
    {
        const auto& model = judgeOf (question);
        auto focus = withSettings (question.focus->description, question.settings, model.surface);
        focus.fingers.clear();
        focus.allocation.voltageLimit.reset();

        const auto design =
            designFocus (withoutVoltageLimits (model), focus, question.playback, DesignExtent::playable);
        made.captured = design.captured;
        made.volts = peakVoltage (design);
    }
    catch (const InputError&)
    {
        made.captured = made.volts = std::nullopt; // The session says why once it is loaded.
    }
}

void DraftView::show (const DraftPicture& made)
{
    const std::lock_guard lock (mutex);
    newest = std::make_shared<const DraftPicture> (made);
}
} // namespace antinode
