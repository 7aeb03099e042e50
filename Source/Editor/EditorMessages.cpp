#include "EditorMessages.h"

#include <antinode_session/DesignSentences.h>

#include <string>

namespace antinode
{
namespace
{
/** What goes on, where nothing else is said. */
std::string progressSentence (AntinodeProcessor& processor, bool isWorking)
{
    const auto session = processor.session().snapshot();
    const auto progress = processor.session().progress();

    if (session->isSolving || session->model == nullptr)
        return "Solving " + processor.device()->description.name + " \xE2\x80\xA6";

    if (! progress.isDone())
        return "Designing " + std::to_string (progress.designed) + " of " + std::to_string (progress.wanted)
               + " positions \xE2\x80\xA6";

    return isWorking ? "Ready; rendering the charts \xE2\x80\xA6" : "";
}

std::string restSentence (AntinodeProcessor& processor)
{
    return processor.session().snapshot()->isAsWritten
               ? "Ready; every note plays the design as it was written, moving a parameter designs its focus again"
               : "Ready";
}
} // namespace

std::vector<UserMessage> editorMessages (AntinodeProcessor& processor, const DesignPicture* picture, bool isWorking,
                                         const std::vector<UserMessage>& beside)
{
    auto messages = processor.messages();
    messages.insert (messages.end(), beside.begin(), beside.end());
    const auto session = processor.session().snapshot();
    const auto isShown = picture != nullptr && ! session->isSolving && picture->question.model == session->model;

    if (isShown)
    {
        addMessage (messages, Urgency::warning, picture->error);

        for (const auto& fault : picture->faults)
            addMessage (messages, Urgency::caution, fault);
    }

    addMessage (messages, Urgency::calm, progressSentence (processor, isWorking));

    if (const auto progress = processor.session().progress(); progress.isDone() && ! session->isSolving)
        messages.push_back (unplayableNotesMessage (progress, session->playback.sampleRate));

    std::erase_if (messages, [] (const auto& message) { return message.text.empty(); });

    if (messages.empty())
        messages.push_back ({ Urgency::calm, restSentence (processor) });

    return messages;
}

juce::String playedFigures (AntinodeProcessor& processor)
{
    const auto& meters = processor.session().meters();
    const auto rate = processor.session().snapshot()->playback.sampleRate;
    return (rate > 0 ? juce::String (rate / 1000, 1) + " kHz" : juce::String ("not playing")) + "    " + "voices "
           + juce::String (meters.voices()) + "    triggers " + juce::String (meters.triggered());
}
} // namespace antinode
