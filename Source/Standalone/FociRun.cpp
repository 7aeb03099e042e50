#include "FociRun.h"

#include <antinode_base/InputError.h>
#include <antinode_session/DesignSentences.h>

#include <utility>

namespace antinode
{
FociRun::FociRun (StandaloneHost& hostToPlay, std::vector<TimedNote> notes, double seconds, bool isArmed)
    : HeadlessRun (hostToPlay, seconds, isArmed), foci (hostToPlay)
{
    for (auto& note : notes)
        note.seconds += armTime;

    EventSchedule schedule (std::move (notes));

    if (auto numbers = schedule.noteNumbers(); ! numbers.empty())
        foci.processor().session().designFirst (std::move (numbers));

    foci.callback().setSchedule (std::move (schedule));
}

std::string FociRun::waitingFor() const
{
    return "solving the device and designing the foci; the notes start after that";
}

bool FociRun::isReady()
{
    auto& session = foci.processor().session();
    const auto now = session.snapshot();
    const auto progress = session.progress();

    for (const auto* const failure : { &now->error, &now->fingerError, &progress.liveError })
        if (! failure->empty())
            throw InputError ("", *failure);

    const auto isOtherDevice = now->device == nullptr || now->device->text != foci.processor().device()->text;
    return ! now->isSolving && ! isOtherDevice && progress.hasFirst;
}

std::string FociRun::designsText() const
{
    const auto progress = foci.processor().session().progress();
    return progress.isDone() ? std::string()
                             : "; " + std::to_string (progress.designed) + " of " + std::to_string (progress.wanted)
                                   + " positions are designed, the others follow";
}

void FociRun::begin()
{
    auto& session = foci.processor().session();

    if (const auto sentence = unplayableNotes (session.progress(), session.snapshot()->playback.sampleRate);
        ! sentence.empty())
        complain (sentence);

    foci.callback().startSchedule();
}

/** Times are those of the schedule. */
void FociRun::tick()
{
    if (const auto rate = foci.callback().sampleRate(); rate > 0)
        following.print (*foci.processor().session().following().status(),
                         static_cast<double> (foci.callback().scheduleSamples()) / rate - armTime);
}

std::string FociRun::outcomeText()
{
    return following.ending();
}

std::string FociRun::playedText()
{
    return counted (foci.processor().session().meters().triggered(), "trigger");
}
} // namespace antinode
