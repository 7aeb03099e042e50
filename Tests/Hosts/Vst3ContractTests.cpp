#include "RawVst3.h"

#include <antinode_documents/FocusFile.h>

#include <catch2/catch.hpp>
#include <juce_core/juce_core.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <string>
#include <thread>

// What Steinberg's validator asks of a VST3 before it plays.

using namespace antinode;
using namespace antinode::test;
using Steinberg::kResultOk;
using Steinberg::kResultTrue;

namespace
{
std::u16string wide (const Steinberg::Vst::TChar* text)
{
    return reinterpret_cast<const char16_t*> (text);
}

Vst::IUnitInfo* unitInfo (RawVst3& plugin)
{
    void* units = nullptr;
    REQUIRE (plugin.controller->queryInterface (Vst::IUnitInfo::iid, &units) == kResultOk);
    return static_cast<Vst::IUnitInfo*> (units);
}

std::u16string parameterText (RawVst3& plugin, Vst::ParamID parameter, double value)
{
    Vst::String128 text {};
    REQUIRE (plugin.controller->getParamStringByValue (parameter, value, text) == kResultTrue);
    return wide (text);
}

/** Places are in percent until the device is solved, then in millimetres. */
void waitForDevice (RawVst3& plugin)
{
    const auto parameters = plugin.parameters();
    const auto place = std::find_if (parameters.begin(), parameters.end(),
                                     [] (const auto& info) { return wide (info.title) == u"Focus x"; });
    REQUIRE (place != parameters.end());

    for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds (60);
         parameterText (plugin, place->id, 0).find (u'%') != std::u16string::npos;)
    {
        REQUIRE (std::chrono::steady_clock::now() < end);
        std::this_thread::sleep_for (std::chrono::milliseconds (1));
    }
}
} // namespace

TEST_CASE ("The factory names one instrument and its controller", "[vst3]")
{
    auto& factory = vst3Factory();
    Steinberg::PFactoryInfo maker {};
    REQUIRE (factory.getFactoryInfo (&maker) == kResultOk);
    CHECK (std::string (maker.vendor) == "Antinode");
    CHECK ((maker.flags & Vst::kDefaultFactoryFlags) != 0);
    // JUCE 8 has a third that names the plug-ins of VST2 that it replaces.
    REQUIRE (factory.countClasses() == (JUCE_MAJOR_VERSION < 8 ? 2 : 3));
    int controllers = 0, instruments = 0;

    for (Steinberg::int32 i = 0; i < factory.countClasses(); ++i)
    {
        Steinberg::PClassInfo info {};
        REQUIRE (factory.getClassInfo (i, &info) == kResultOk);
        instruments += std::string (info.category) == kVstAudioEffectClass ? 1 : 0;
        controllers += std::string (info.category) == kVstComponentControllerClass ? 1 : 0;
    }

    REQUIRE (instruments == 1);
    REQUIRE (controllers == 1);
    void* second = nullptr;
    REQUIRE (factory.queryInterface (Steinberg::IPluginFactory2::iid, &second) == kResultOk);
    Steinberg::PClassInfo2 component {}, controller {};
    REQUIRE (static_cast<Steinberg::IPluginFactory2*> (second)->getClassInfo2 (0, &component) == kResultOk);
    REQUIRE (static_cast<Steinberg::IPluginFactory2*> (second)->getClassInfo2 (1, &controller) == kResultOk);
    static_cast<Steinberg::IPluginFactory2*> (second)->release();
    CHECK (std::string (component.name) == "Antinode");
    CHECK (std::string (component.category) == kVstAudioEffectClass);
    CHECK (std::string (component.subCategories) == "Instrument|Generator");
    CHECK (std::string (component.sdkVersion).starts_with ("VST 3."));
    CHECK (std::string (controller.category) == kVstComponentControllerClass);
    CHECK_FALSE (Steinberg::FUnknownPrivate::iidEqual (component.cid, controller.cid));
}

TEST_CASE ("Buses have names, counts that fit their speakers, and no neighbours beyond the last", "[vst3]")
{
    const auto ceramics = GENERATE (2, 8, 16, 32, 64);
    RawVst3 plugin (ceramics);
    auto& component = *plugin.component;
    REQUIRE (component.getBusCount (Vst::kAudio, Vst::kOutput) == 2);
    REQUIRE (component.getBusCount (Vst::kAudio, Vst::kInput) == 1);
    Vst::BusInfo sensor {};
    REQUIRE (component.getBusInfo (Vst::kAudio, Vst::kInput, 0, sensor) == kResultTrue);
    CHECK (wide (sensor.name) == u"Sensor");
    CHECK (sensor.channelCount == 1);
    CHECK (sensor.busType == Vst::kAux);
    CHECK ((sensor.flags & Vst::BusInfo::kDefaultActive) == 0);
    CHECK (component.getBusCount (Vst::kEvent, Vst::kInput) == 1);
    CHECK (component.getBusCount (Vst::kEvent, Vst::kOutput) == 0);
    const char16_t* const names[] = { u"Ceramics", u"Monitor" };
    Vst::SpeakerArrangement all[2] {};

    for (int bus = 0; bus < 2; ++bus)
    {
        Vst::BusInfo info {};
        Vst::SpeakerArrangement speakers {};
        REQUIRE (component.getBusInfo (Vst::kAudio, Vst::kOutput, bus, info) == kResultTrue);
        CHECK (wide (info.name) == names[bus]);
        CHECK ((info.flags & Vst::BusInfo::kDefaultActive) != 0);
        CHECK (info.channelCount == (bus == 0 ? ceramics : 2));
        REQUIRE (plugin.processor->getBusArrangement (Vst::kOutput, bus, speakers) == kResultTrue);
        CHECK (Vst::SpeakerArr::getChannelCount (speakers) == info.channelCount);
        all[bus] = speakers;

        // JUCE 7 bears a host that leaves out buses, which VST3 does not allow.
        if (JUCE_MAJOR_VERSION < 8 && bus == 0)
            CHECK (plugin.processor->setBusArrangements (nullptr, 0, &speakers, 1) == kResultTrue);

        for (const auto state : { false, true, true, false, false, true })
            CHECK (component.activateBus (Vst::kAudio, Vst::kOutput, bus, state) == kResultTrue);
    }

    CHECK (plugin.arrange (all[0], all[1]) == kResultTrue);

    for (const auto bus : { -1, 2, 1000 })
    {
        Vst::BusInfo info {};
        CHECK (component.getBusInfo (Vst::kAudio, Vst::kOutput, bus, info) != kResultTrue);
        CHECK (component.activateBus (Vst::kAudio, Vst::kOutput, bus, true) != kResultTrue);
        CHECK (component.getBusInfo (Vst::kAudio, Vst::kInput, bus, info) != kResultTrue);
    }
}

TEST_CASE ("Parameters have identifiers, titles and units of their own, and one of them is the bypass", "[vst3]")
{
    RawVst3 plugin;
    auto* const units = unitInfo (plugin);
    std::set<Vst::ParamID> identifiers;
    std::set<std::u16string> titles;
    std::set<Vst::UnitID> unitIdentifiers;
    int bypasses = 0;

    for (int i = 0; i < units->getUnitCount(); ++i)
    {
        Vst::UnitInfo unit {};
        REQUIRE (units->getUnitInfo (i, unit) == kResultTrue);
        CHECK ((i > 0 || unit.id == Vst::kRootUnitId));
        CHECK (! wide (unit.name).empty());
        CHECK ((i == 0 ? unit.parentUnitId == Vst::kNoParentUnitId : unitIdentifiers.count (unit.parentUnitId) == 1));
        CHECK (unitIdentifiers.insert (unit.id).second);
    }

    units->release();
    CHECK (unitIdentifiers.size() == 6);

    for (const auto& info : plugin.parameters())
    {
        CHECK (info.id < 0x80000000U);
        CHECK (identifiers.insert (info.id).second);
        CHECK (titles.insert (wide (info.title)).second);
        CHECK (! wide (info.title).empty());
        CHECK (unitIdentifiers.count (info.unitId) == 1);
        CHECK (info.stepCount >= 0);
        CHECK (info.defaultNormalizedValue >= 0);
        CHECK (info.defaultNormalizedValue <= 1);
        CHECK (((info.flags & Vst::ParameterInfo::kCanAutomate) != 0)
               == (wide (info.title) != u"Arm" && wide (info.title) != u"Stop"));

        if ((info.flags & Vst::ParameterInfo::kIsBypass) != 0)
        {
            ++bypasses;
            CHECK (info.stepCount == 1);
        }
    }

    CHECK (bypasses == 1);
}

TEST_CASE ("Hosts are told which parameters have steps, and how many", "[vst3]")
{
    // The words that a choice has, less one.
    const std::map<std::u16string, int> choices { { u"Shape", static_cast<int> (targetShapeWords.size()) - 1 },
                                                  { u"Allocation", 7 }, // Those that are no longer offered too.
                                                  { u"Controlled modes", 512 },
                                                  { u"Notes play", 1 },
                                                  { u"Note off", 2 },
                                                  { u"Retrigger", 1 },
                                                  { u"Focus on the note", 1 },
                                                  { u"Arm", 1 },
                                                  { u"Stop", 1 },
                                                  { u"Bypass", 1 } };

    RawVst3 plugin;

    for (const auto& info : plugin.parameters())
    {
        const auto choice = choices.find (wide (info.title));
        CHECK (info.stepCount == (choice == choices.end() ? 0 : choice->second));
    }
}

TEST_CASE ("Parameters come back from texts, from plain values and from their setters", "[vst3]")
{
    RawVst3 plugin;
    auto& controller = *plugin.controller;
    waitForDevice (plugin);

    for (const auto& info : plugin.parameters())
    {
        const auto steps = info.stepCount > 0 ? std::min (info.stepCount, 16) : 16;

        for (int step = 0; step <= steps; ++step)
        {
            // Floats in between: what a step of an integer is, only its parameter knows.
            const auto value = static_cast<double> (static_cast<float> (step) / static_cast<float> (steps));
            const auto text = parameterText (plugin, info.id, value);
            double read = -1;
            INFO (std::string (text.begin(), text.end()) << " at " << value);
            CHECK (! text.empty());
            REQUIRE (controller.getParamValueByString (
                         info.id, reinterpret_cast<Vst::TChar*> (const_cast<char16_t*> (text.c_str())), read)
                     == kResultTrue);
            CHECK (read >= 0);
            CHECK (read <= 1);
            CHECK (parameterText (plugin, info.id, read) == text);
            CHECK (controller.plainParamToNormalized (info.id, controller.normalizedParamToPlain (info.id, value))
                   == Approx (value).margin (1e-12));
            controller.setParamNormalized (info.id, value);
            CHECK (controller.getParamNormalized (info.id) == value);
        }

        controller.setParamNormalized (info.id, info.defaultNormalizedValue);
    }
}

TEST_CASE ("Texts that say nothing give values within the range", "[vst3]")
{
    RawVst3 plugin;
    std::u16string texts[] = { u"",    u" ",   u"nonsense", u"-1e300",   u"1e300",
                               u"nan", u"inf", u"-inf",     u"\u20ac %", std::u16string (127, u'9') };

    for (const auto& info : plugin.parameters())
        for (auto& text : texts)
        {
            double read = 0;
            plugin.controller->getParamValueByString (info.id, reinterpret_cast<Vst::TChar*> (text.data()), read);
            INFO (std::string (text.begin(), text.end()) << " for parameter " << info.id);
            CHECK (read >= 0);
            CHECK (read <= 1);
        }
}

TEST_CASE ("Component and controller may be ended and begun again", "[vst3]")
{
    RawVst3 plugin;

    for (int i = 0; i < 3; ++i)
    {
        REQUIRE (plugin.component->terminate() == kResultOk);
        Vst::HostApplication application;
        REQUIRE (plugin.component->initialize (&application) == kResultOk);
        plugin.activate ({});
        CHECK (plugin.play (1024, 512, 0).cwiseAbs().maxCoeff() > 0);
        plugin.deactivate();
    }
}

TEST_CASE ("Instances come and go at any moment of their start", "[vst3]")
{
    // Their messages run on a thread of the plug-in's own, which must find none that is not finished or gone.
    for (int i = 0; i < 60; ++i)
    {
        RawVst3 plugin (8, i % 2 == 0 ? RawVst3::Connection::direct : RawVst3::Connection::byMessages);
        std::this_thread::sleep_for (std::chrono::microseconds (300 * (i % 20)));
        CHECK (plugin.channels (0) == 8);
    }
}
