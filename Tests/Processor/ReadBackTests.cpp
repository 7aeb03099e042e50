#include <Processor/AntinodeProcessor.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("A value that a document gives is kept to the bit, and so is the share that a host is told", "[plugin]")
{
    AntinodeProcessor processor (2, juce::AudioProcessor::wrapperType_Undefined);
    auto values = processor.parameters().values();
    values["width"] = 17.3;
    values["x"] = 100.0 / 3;
    processor.parameters().setValues (values);
    CHECK (processor.parameters().values() == values);

    // Hosts send back what they were told: nothing changes.
    for (auto* const parameter : processor.parameters().all())
        parameter->setValueNotifyingHost (static_cast<const juce::AudioProcessorParameter*> (parameter)->getValue());

    CHECK (processor.parameters().values() == values);
}

TEST_CASE ("Who sets a step's neighbourhood is told of the step", "[plugin]")
{
    struct Heard : juce::AudioProcessorParameter::Listener
    {
        void parameterValueChanged (int, float share) override { last = share; }
        void parameterGestureChanged (int, bool) override {}
        float last = -1;
    };

    AntinodeProcessor processor (2, juce::AudioProcessor::wrapperType_Undefined);
    auto& reports = processor.parameters().stepReports();
    const auto& [identifier, share, step] = GENERATE (table<const char*, float, float> (
        { { "focus_on_note", 0.606F, 1.0F }, { "retrigger", 0.3F, 0.0F }, { "note_off", 0.6F, 0.5F } }));
    auto& parameter = *processor.parameters().find (identifier);
    Heard host;
    parameter.addListener (&host);
    parameter.setValueNotifyingHost (share);
    CHECK (reports.isWaiting());
    reports.tell();
    CHECK (host.last == step);
    CHECK_FALSE (reports.isWaiting());
    parameter.setValueNotifyingHost (step);
    CHECK_FALSE (reports.isWaiting());
    parameter.removeListener (&host);
}

TEST_CASE ("Hosts may automate all but the arming, which is restored only where no arming is required", "[plugin]")
{
    AntinodeProcessor processor (2, juce::AudioProcessor::wrapperType_Undefined);

    for (const auto* const parameter : processor.parameters().all())
    {
        INFO (parameter->getParameterID());
        CHECK (parameter->isAutomatable() == (parameter->getParameterID() != "arm"));
    }
}
