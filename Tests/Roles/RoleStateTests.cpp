#include "PlayedRole.h"

#include <Processor/ParameterTypes.h>

#include <catch2/catch.hpp>

#include <limits>

// What states and parameters of plug-ins of all roles keep, stated once.

using namespace antinode;
using namespace antinode::test;

#define ALL_ROLES AntinodeProcessor, TouchProcessor, PlateProcessor

namespace
{
juce::AudioProcessorParameter& asHostsSee (juce::RangedAudioParameter& parameter)
{
    return parameter;
}
} // namespace

TEMPLATE_TEST_CASE ("What a host reads of parameters is what it gets back, to the bit", "[role]", ALL_ROLES)
{
    const auto first = makeRole<TestType> (2);
    std::unique_ptr<TestType> second;
    juce::Random random (7);

    for (int i = 0; i < 1000; ++i)
    {
        if (i % 50 == 0)
            second = makeRole<TestType> (2);

        for (auto* const parameter : first->parameters().all())
        {
            // Hosts have 24 bits: a smaller share is the end of the range.
            const auto share =
                i % 2 == 0 ? random.nextFloat() : std::max (std::pow (random.nextFloat(), 8.0F), 0x1p-24F);
            parameter->setValueNotifyingHost (share);

            if (! hasSteps (*parameter))
                REQUIRE (asHostsSee (*parameter).getValue() == share);
            else
                REQUIRE (parameter->convertTo0to1 (parameter->convertFrom0to1 (share))
                         == asHostsSee (*parameter).getValue());
        }

        const auto kept = stateText (*first);
        setStateText (*second, kept);
        REQUIRE (stateText (*second) == kept);
        REQUIRE (first->parameters().values() == second->parameters().values());

        for (std::size_t k = 0; k < first->parameters().all().size(); ++k)
            REQUIRE (asHostsSee (*first->parameters().all()[k]).getValue()
                     == asHostsSee (*second->parameters().all()[k]).getValue());
    }
}

TEMPLATE_TEST_CASE ("A state comes back to the bit in another instance, and plays the same", "[role]", ALL_ROLES)
{
    const auto first = offlineRole<TestType> (32), second = offlineRole<TestType> (32);
    loadDevice (*first, loadDocument (LibraryKind::device, "glass-148x210"));
    first->session().waitUntilSettled();

    for (auto* const parameter : first->parameters().all())
        if (parameter->getParameterID().endsWith ("_x") || parameter->getParameterID() == "x")
            parameter->setValueNotifyingHost (0.377F
                                              + 0.02F * static_cast<float> (parameter->getParameterIndex()) / 50);

    const auto kept = stateText (*first);
    setStateText (*second, kept);
    CHECK (stateText (*second) == kept);
    CHECK (second->device()->description.name == first->device()->description.name);

    for (auto* const processor : { first.get(), second.get() })
    {
        processor->session().waitUntilSettled();
        prepareRole (*processor);
        playedRole (*processor, 48000, 512); // What played before fades out.
        prepareRole (*processor);
        CHECK (processor->warning().isEmpty());
    }

    const auto played = playedRole (*first, 6000, 512);
    CHECK (played.cwiseAbs().maxCoeff() > 1e-5);
    CHECK (playedRole (*second, 6000, 512) == played);
}

TEMPLATE_TEST_CASE ("A state that cannot be read changes nothing and is one sentence", "[role]", ALL_ROLES)
{
    const auto processor = offlineRole<TestType> (16);
    processor->parameters().all().front()->setValueNotifyingHost (0.25F);
    const auto before = stateText (*processor);
    const auto changed = [&] (const auto& change)
    {
        auto json = nlohmann::json::parse (before);
        change (json);
        return json.dump();
    };

    for (const auto& text :
         { std::string(), std::string ("no state"), std::string (1000, '\0'), std::string ("\0\1\2", 3),
           std::string ("[]"), std::string ("{}"), before.substr (0, 500), before.substr (0, before.size() / 2),
           changed ([] (auto& json) { json["schema"] = "antinode.other/1"; }),
           changed ([] (auto& json) { json["schema"].template get_ref<std::string&>().back() = '2'; }),
           changed ([] (auto& json) { json.erase ("device"); }), changed ([] (auto& json) { json["device"] = 3; }),
           changed ([] (auto& json) { json["device"]["thickness_mm"] = -1; }),
           changed ([] (auto& json) { json["device"]["lengths_mm"] = 100; }),
           changed ([] (auto& json) { json["parameters"].begin().value() = "loud"; }) })
    {
        CAPTURE (text);
        setStateText (*processor, text);
        CHECK (processor->warning().startsWith ("The saved state could not be read; nothing was changed: state"));
        CHECK_FALSE (processor->warning().containsChar ('\n'));
        CHECK (stateText (*processor) == before);
    }

    setStateText (*processor, before);
    CHECK (processor->warning().isEmpty());
}

TEMPLATE_TEST_CASE ("A parameter that is set to what is no number keeps its value", "[role]", ALL_ROLES)
{
    const auto processor = makeRole<TestType>();

    for (auto* const parameter : processor->parameters().all())
    {
        INFO (parameter->getParameterID());
        const auto before = parameterValue (*parameter);

        for (const auto share : { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                                  -std::numeric_limits<float>::infinity() })
        {
            parameter->setValueNotifyingHost (share);
            CHECK (parameterValue (*parameter) == before);
            setValue (*parameter, static_cast<double> (share));
            CHECK (parameterValue (*parameter) == before);
        }
    }
}

TEMPLATE_TEST_CASE ("Texts of parameters read back as what they were written from", "[role]", ALL_ROLES)
{
    const auto processor = offlineRole<TestType>();

    for (auto* const parameter : processor->parameters().all())
    {
        INFO (parameter->getParameterID());
        CHECK (parameter->getName (100).isNotEmpty());

        for (const auto share : { 0.0F, 0.2F, 0.5F, 0.9F, 1.0F })
        {
            const auto text = parameter->getText (parameter->convertTo0to1 (parameter->convertFrom0to1 (share)), 100);
            INFO (text);
            CHECK (parameter->getText (parameter->getValueForText (text), 100) == text);
        }
    }
}
