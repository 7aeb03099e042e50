#pragma once

#include "SurfacePainter.h"

#include <antinode_model/Playback.h>
#include <antinode_reports/FocusScores.h>
#include <antinode_session/PlaySettings.h>
#include <antinode_session/SessionSnapshot.h>

#include <memory>
#include <string>
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
    std::shared_ptr<const Chart> section;  ///< Of a plate, along x through the focus; none if there is no design.
    std::shared_ptr<const Chart> spectrum; ///< None if there is no design.
    std::shared_ptr<const RenderedCharts> rendered; ///< Of an earlier design until the stage is complete.
    std::shared_ptr<const Chart> methods;           ///< What this focus needs by several methods; comes last.
    std::vector<std::string> faults;                ///< What is wrong with the focus, as far as it is known.
    Stage stage = Stage::predicted;
};
} // namespace antinode
