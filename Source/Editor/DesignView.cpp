#include "DesignView.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusPlaces.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_reports/BankCharts.h>
#include <antinode_reports/FieldFigures.h>
#include <antinode_reports/FocusCharts.h>
#include <antinode_reports/PlateCharts.h>
#include <antinode_session/Documents.h>
#include <antinode_session/FocusSettings.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace antinode
{
namespace
{
/** Designs younger than this are finished even if outdated, so that the field follows a moving parameter. */
constexpr auto longDesign = std::chrono::milliseconds (250);
constexpr auto pause = std::chrono::milliseconds (120); // without a new question before the long part begins

std::vector<std::pair<double, double>> chooseProbes (const DesignQuestion& question)
{
    const auto& surface = question.model->surface;
    auto probes = probePlaces (question.focus->description, question.settings, surface);

    // A focus of another device may have probes outside this surface: the session moves them too.
    for (auto& [x, y] : probes)
    {
        const auto place = nearestOn (surface, x, y);
        x = place.x();
        y = place.y();
    }

    return probes;
}

/** What the report shows of the field too. @param model  that is played
    @param design  none: the surface at rest */
std::shared_ptr<const Chart> makeFieldChart (const DesignPicture& made, const ModalModel& model,
                                             const FocusDesign* design)
{
    const auto& field = made.frames->focusField;

    if (model.surface.kind == SurfaceKind::line)
    {
        const Eigen::VectorXd still = Eigen::VectorXd::Zero (model.points());
        return std::make_shared<const Chart> (fieldChart (model, design != nullptr ? design->target.field : still,
                                                          design != nullptr ? design->truncatedField : still, field));
    }

    // The first place is the spot, which is drawn where it is dragged to.
    auto map = plateFieldChart (model, field, "velocity", { made.focus.targets.begin() + 1, made.focus.targets.end() });

    // Lines where the plate stands still would hide more than they show while it moves.
    map.contours.nodalLinesFrom.reset();

    if (design == nullptr)
        map.contours = {};

    return std::make_shared<const Chart> (std::move (map));
}
/** V; 0 where the method cannot play the focus. */
double peakBy (AllocationMethod method, const ModalModel& model, const DesignPicture& made)
{
    try
    {
        return peakVoltage (
            designFocus (model, withMethod (made.focus, method), made.question.playback, DesignExtent::playable));
    }
    catch (const InputError&)
    {
        return 0;
    }
}
} // namespace

bool DesignQuestion::operator== (const DesignQuestion& other) const
{
    return model == other.model && focus == other.focus && settings == other.settings
           && playback.sampleRate == other.playback.sampleRate
           && playback.reconstruction == other.playback.reconstruction;
}

std::shared_ptr<const DesignPicture> DesignView::picture() const
{
    const std::lock_guard lock (mutex);
    return newest;
}

void DesignView::run()
{
    const WatchScope scope ([this] { return ! questions.hasLeft(); });

    while (const auto question = questions.take())
        answer (*question);
}

void DesignView::answer (const DesignQuestion& question)
{
    DesignPicture made;
    made.model = question.model;
    made.question = question;
    made.focus = withSettings (question.focus->description, question.settings, question.model->surface);
    made.faults = placeFaults (question.model->surface, made.focus);

    if (const auto before = picture(); before != nullptr && before->question.model == question.model)
    {
        made.rendered = before->rendered;
        made.methods = before->methods;
    }

    try
    {
        load (made);
        answerWith (made, playableDesign (made));
    }
    catch (const Cancelled&)
    {
    }
    catch (const std::exception& failure)
    {
        made.error = failure.what();
        made.frames = std::make_shared<const FieldFrames> (stillFrames (*question.model));
        made.field = makeFieldChart (made, *question.model, nullptr);
        made.spectrum = nullptr;
        made.rendered = nullptr;
        made.methods = nullptr;
        made.stage = DesignPicture::Stage::complete;
        show (made);
    }
}

/** Fingers change the modes; a moving parameter does not. */
void DesignView::load (const DesignPicture& made)
{
    const auto& model = made.question.model;
    const auto& wanted = made.focus.fingers;

    if (model == loadedModelOf && wanted == fingers)
        return;

    loadedModelOf = nullptr;
    loaded =
        loadedByFingers ({ *model, model->modes(), "It was played with the modes of its design alone.", {} }, wanted);
    loadedModelOf = model;
    fingers = wanted;
}

FocusDesign DesignView::playableDesign (const DesignPicture& made) const
{
    const WatchScope scope (watch (longDesign));
    return designOf (made, DesignExtent::playable);
}

FocusDesign DesignView::designOf (const DesignPicture& made, DesignExtent extent) const
{
    const auto& model = loaded.designed ? *loaded.designed : loaded.model;

    if (const auto written = writtenFor (*made.question.focus, made.focus))
        return designAsWritten (*written, model);

    return designFocus (model, made.focus, made.question.playback, extent);
}

void DesignView::answerWith (DesignPicture& made, const FocusDesign& playable)
{
    const auto& model = loaded.model;

    if (made.focus.targets.front().level)
        made.velocityOfLevel = playable.description.targets.front().peakVelocity;

    made.frames = std::make_shared<const FieldFrames> (predictFocus (model, playable));
    made.field = makeFieldChart (made, model, &playable);

    if (model.surface.kind == SurfaceKind::plate)
        made.section = std::make_shared<const Chart> (
            crossSectionChart (model, playable, made.frames->focusField, PlateDirection::alongX));

    made.spectrum = std::make_shared<const Chart> (spectrumChart (model, playable, made.frames->focusVelocities));
    made.faults = designFaults (model, playable);
    show (made);

    if (! questions.isQuietFor (pause))
        return;

    const WatchScope scope (watch ({}));
    made.frames = predictFrames (model, playable);
    made.stage = DesignPicture::Stage::animated;
    show (made);
    render (made);
}

void DesignView::render (DesignPicture& made)
{
    const auto& question = made.question;
    RenderOptions options;
    options.playback = question.playback;
    options.probes = chooseProbes (question);
    options.threshold = findSkinThreshold ({});
    options.mayLiftOff = false; // as the plug-in plays
    auto design = designOf (made, DesignExtent::complete);
    const auto focus = renderFocus (loaded, std::move (design), options);
    auto charts = std::make_shared<RenderedCharts>();
    charts->voltages = std::make_shared<const Chart> (voltagesChart (focus.model, focus.design.program, focus.render));
    charts->probe = std::make_shared<const Chart> (probeChart (focus.render, 0, "probe"));
    charts->felt = std::make_shared<const Chart> (feltFigure (focus.model, focus.felt.value()).chart);
    const auto outcome = evaluateOutcome (focus);
    charts->scores = focusScores (focus, outcome);
    made.faults = designFaults (focus.model, focus.design);

    for (auto& fault : outcomeFaults (focus, outcome))
        made.faults.push_back (std::move (fault));

    charts->warnings = focus.design.warnings;
    charts->choices = focus.design.choices;
    made.rendered = std::move (charts);
    made.stage = DesignPicture::Stage::complete;
    show (made);
    compareMethods (made, focus.design);
    show (made);
}

/** What this focus needs by the other methods, and by the one that plays. */
void DesignView::compareMethods (DesignPicture& made, const FocusDesign& designed) const
{
    const auto& model = loaded.designed ? *loaded.designed : loaded.model;
    const auto chosen = designed.description.allocation.method;
    std::vector<MethodVolts> volts;

    for (const auto& [word, method] : allocationMethodWords)
        if (method != chosen)
            volts.push_back ({ std::string (word), peakBy (method, model, made) });

    volts.push_back ({ std::string (wordFor (allocationMethodWords, chosen)) + " (plays)", peakVoltage (designed) });
    made.methods = std::make_shared<const Chart> (
        methodVoltsChart (volts, designed.lowerBoundVoltage, designed.program.voltageLimits.maxCoeff()));
}

void DesignView::show (const DesignPicture& made)
{
    if (questions.isOutdated() && made.stage != DesignPicture::Stage::predicted)
        return;

    auto shown = std::make_shared<const DesignPicture> (made);
    const std::lock_guard lock (mutex);
    newest = std::move (shown);
}

Watch DesignView::watch (std::chrono::milliseconds grace) const
{
    return [this, last = std::chrono::steady_clock::now() + grace]
    { return ! questions.hasLeft() && (! questions.isOutdated() || std::chrono::steady_clock::now() < last); };
}

namespace
{
constexpr double poorCapture = 0.9, poorVelocity = 0.9;

/** "The focus", or one of several. */
std::string named (std::size_t target, std::size_t targets)
{
    return targets > 1 ? "Focus " + std::to_string (target + 1) : "The focus";
}
} // namespace

std::vector<std::string> placeFaults (const Surface& surface, const FocusDescription& focus)
{
    std::vector<std::string> faults;
    const auto& targets = focus.targets;

    for (std::size_t i = 0; i < targets.size(); ++i)
        if (const auto distance = distanceToEdge (surface, targets[i].x, targets[i].y); distance < targets[i].width / 2)
            faults.push_back (named (i, targets.size()) + " lies on an edge: " + fixedText (distance * milli, 1)
                              + " mm from it, which is less than half of its width. Move it inwards, or lower Width.");

    return faults;
}

std::vector<std::string> designFaults (const ModalModel& model, const FocusDesign& design)
{
    auto faults = placeFaults (model.surface, design.description);
    const auto captured = std::min_element (design.moments.begin(), design.moments.end(),
                                            [] (const auto& a, const auto& b) { return a.captured < b.captured; })
                              ->captured;
    const auto usesAll = static_cast<Eigen::Index> (design.controlledModes.size()) == model.modes();

    if (captured < poorCapture)
        faults.push_back ("The controlled modes represent only " + fixedText (captured, 2)
                          + " of the focus (good: 0.9 or more). Raise Width"
                          + (usesAll ? "" : ", set Controlled modes to more or to chosen,") + " or move the focus.");

    return faults;
}

std::vector<std::string> outcomeFaults (const RenderedFocus& focus, const FocusOutcome& outcome)
{
    std::vector<std::string> faults;
    const auto targets = outcome.targets.size();

    for (std::size_t i = 0; i < targets; ++i)
    {
        const auto& wanted = outcome.targets[i].wanted;
        const auto reached = wanted.phase * outcome.targets[i].velocityAtCentre;

        if (focus.design.captured >= poorCapture && reached < poorVelocity * wanted.peakVelocity)
            faults.push_back (named (i, targets) + " reaches " + inWords (reached * milli) + " of "
                              + inWords (wanted.peakVelocity * milli)
                              + " mm/s. Lower Peak velocity, raise Focus time, or choose another Allocation.");
    }

    if (focus.felt)
        for (std::size_t i = 0; i < focus.felt->targets.size(); ++i)
            if (const auto level = focus.felt->targets[i].level; level < 0)
                faults.push_back (named (i, focus.felt->targets.size()) + " is not felt: " + fixedText (level, 1)
                                  + " dB SL, where skin feels from 0 dB SL on. Raise Peak velocity.");

    return faults;
}
} // namespace antinode
