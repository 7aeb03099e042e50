#pragma once

#include "NewestQuestion.h"
#include "SurfaceView.h"

#include <antinode_base/Watch.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_model/VoltageProgram.h>
#include <antinode_render/FocusOutcome.h>
#include <antinode_reports/FocusReport.h>
#include <antinode_session/FocusSettings.h>
#include <antinode_session/Session.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** A request for a picture. */
struct DesignQuestion
{
    std::shared_ptr<const ModalModel> model;
    std::shared_ptr<const FocusDocument> focus;
    PlaySettings settings;
    Playback playback; ///< With a rate of more than 0.

    bool operator== (const DesignQuestion&) const;
};

/** The result of a render: the same charts and scores as in the report. */
struct RenderedCharts
{
    std::shared_ptr<const Chart> voltages, probe, felt;
    std::vector<ReportScore> scores;
    std::vector<std::string> warnings, choices;
};

/** The picture of a focus. Immutable. Parts arrive one after the other, the quick ones first. */
struct DesignPicture : SurfacePicture
{
    enum class Stage
    {
        predicted, ///< The field at the focus, and the spectrum.
        animated,  ///< All frames.
        complete   ///< The render too, or the reason why there is none.
    };

    DesignQuestion question;
    FocusDescription focus;                ///< The document as the parameters changed it.
    std::optional<double> velocityOfLevel; ///< m/s of its first target, which the design found for a level.
    std::shared_ptr<const Chart> section;  ///< Of a plate, along x through the focus; none if there is no design.
    std::shared_ptr<const Chart> spectrum; ///< None if there is no design.
    std::shared_ptr<const RenderedCharts> rendered; ///< Of an earlier design until the stage is complete.
    std::shared_ptr<const Chart> methods;           ///< What this focus needs by several methods; comes last.
    std::vector<std::string> faults;                ///< What is wrong with the focus, as far as it is known.
    Stage stage = Stage::predicted;
};

/** Computes the picture for the editor on a thread that runs it: first the predicted field, then its frames, then a
   full render. A newer question replaces an older one, whose work is given up between two steps. The editor may go
   before the thread: both share it. */
class DesignView
{
public:
    /** Answers questions until it is stopped. [worker] */
    void run();

    /** Abandons unfinished work; returns at once. [any but the audio thread] */
    void leave() { questions.leave(); }

    /** Returns at once. [any but the audio thread] */
    void ask (DesignQuestion question) { questions.ask (std::move (question)); }

    /** The latest picture, or none yet. [any but the audio thread] */
    std::shared_ptr<const DesignPicture> picture() const;

    /** Whether the picture of the latest request is complete. [any but the audio thread] */
    bool isDone() const { return questions.isDone(); }

private:
    void answer (const DesignQuestion&);
    void load (const DesignPicture&);
    FocusDesign playableDesign (const DesignPicture&) const;
    FocusDesign designOf (const DesignPicture&, DesignExtent) const;
    void answerWith (DesignPicture&, const FocusDesign& playable);
    void render (DesignPicture&);
    void compareMethods (DesignPicture&, const FocusDesign& designed) const;
    void show (const DesignPicture&);
    Watch watch (std::chrono::milliseconds grace) const;

    std::shared_ptr<const ModalModel> loadedModelOf; ///< Of the thread only, as the next lines.
    std::vector<Finger> fingers;
    WideModel loaded; ///< The device with the fingers on it.
    NewestQuestion<DesignQuestion> questions;
    mutable std::mutex mutex;
    std::shared_ptr<const DesignPicture> newest; ///< Under the mutex.
};

/** What is wrong with the places of a focus, in the words of the window's controls: they lie on an edge. [any] */
std::vector<std::string> placeFaults (const Surface&, const FocusDescription&);

/** The same, and what is wrong with what is designed: its modes represent too little of it. [any] */
std::vector<std::string> designFaults (const ModalModel&, const FocusDesign&);

/** What is wrong with what is reached: too slow, or not felt. [any] */
std::vector<std::string> outcomeFaults (const RenderedFocus&, const FocusOutcome&);
} // namespace antinode
