#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>

#include <juce_events/juce_events.h>

#include <optional>

namespace
{
/** Frees JUCE's shared objects when the tests are over, so that a debug build tells real leaks only. */
struct JuceSession : Catch::TestEventListenerBase
{
    using Catch::TestEventListenerBase::TestEventListenerBase;

    void testRunStarting (const Catch::TestRunInfo&) override { juce.emplace(); }
    void testRunEnded (const Catch::TestRunStats&) override { juce.reset(); }

    std::optional<juce::ScopedJuceInitialiser_GUI> juce;
};

CATCH_REGISTER_LISTENER (JuceSession)
} // namespace
