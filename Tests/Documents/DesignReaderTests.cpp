#include "Support/ErrorText.h"
#include "Support/SinePlate.h"

#include <antinode_documents/DesignFile.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
constexpr Playback playback { Reconstruction::bandLimited, 48000 };

ModalModel plate()
{
    auto model = test::SinePlate().model (20);
    model.name = "sine";
    return model;
}

FocusDescription focus (AllocationMethod method)
{
    FocusDescription focus;
    focus.name = "middle";
    auto& target = focus.targets.emplace_back();
    target.shape = TargetShape::bump;
    target.x = 0.11;
    target.y = 0.07;
    target.width = 0.05;
    target.peakVelocity = 0.01;
    focus.focusTime = 0.02;
    focus.modes.count = 8;
    focus.allocation.method = method;
    return focus;
}

nlohmann::json written (const FocusDesign& design)
{
    return parseJson (designToJson (design, plate()).dump(), "design.json");
}

std::string errorOf (const nlohmann::json& json, const ModalModel& model = plate())
{
    return errorText ([&] { readDesign (json, "design.json", model); });
}

void checkSameProgram (const VoltageProgram& a, const VoltageProgram& b)
{
    REQUIRE (a.oscillations.size() == b.oscillations.size());
    CHECK (a.focusTime == b.focusTime);
    CHECK (a.allocation == b.allocation);
    CHECK (a.voltageLimits == b.voltageLimits);

    for (std::size_t c = 0; c < a.oscillations.size(); ++c)
    {
        CHECK (a.oscillations[c].start == b.oscillations[c].start);
        CHECK (a.oscillations[c].end == b.oscillations[c].end);
        CHECK (a.oscillations[c].exponent() == b.oscillations[c].exponent());
        CHECK (a.oscillations[c].phasor() == b.oscillations[c].phasor());
        CHECK (a.oscillations[c].freeDecay == b.oscillations[c].freeDecay);
        CHECK (a.oscillations[c].counterShare == b.oscillations[c].counterShare);
    }
}
} // namespace

TEST_CASE ("A design that was written is read to the bit, with its brake and a train", "[files]")
{
    auto description = focus (AllocationMethod::exact);
    description.transients.brakeDuration = 0.02;
    auto second = description.targets[0];
    second.x = 0.06;
    second.time = 0.03;
    description.targets.push_back (second);
    const auto design = designFocus (plate(), description, playback);
    const auto read = readDesign (written (design), "design.json", plate());
    checkSameProgram (read.program, design.program);
    CHECK (read.controlledModes == design.controlledModes);
    REQUIRE (read.moments.size() == 2);

    for (std::size_t i = 0; i < 2; ++i)
    {
        CHECK (read.moments[i].time == design.moments[i].time);
        CHECK (read.moments[i].wanted == design.moments[i].wanted);
        CHECK (read.moments[i].target.field == design.moments[i].target.field);
        CHECK (read.moments[i].truncatedField == design.moments[i].truncatedField);
    }

    CHECK (read.captured == design.captured);
    CHECK (read.restTime.value() == Approx (design.restTime.value()));
    CHECK (peakVoltage (read) == peakVoltage (design));
    CHECK (read.choices == design.choices);
}

TEST_CASE ("Samples of a design are read to the bit, and say how they are played", "[files]")
{
    const auto design = designFocus (plate(), focus (AllocationMethod::leastVoltage), playback);
    const auto json = written (design);
    const auto read = readDesign (json, "design.json", plate());
    CHECK (read.program.samples.value().values == design.program.samples.value().values);
    CHECK (read.program.samples->firstTime == design.program.samples->firstTime);
    CHECK (read.intersamplePeakVoltage == design.intersamplePeakVoltage);
    const auto origin = readDesignOrigin (json, "design.json");
    CHECK (origin.device == "sine");
    CHECK (origin.isSampled);
    CHECK (origin.playback.sampleRate == 48000);
}

TEST_CASE ("A device whose limits were lowered since keeps them", "[files]")
{
    const auto json = written (designFocus (plate(), focus (AllocationMethod::exact), playback));
    auto model = plate();

    for (auto& ceramic : model.ceramics)
        ceramic.voltageLimit = 0.25;

    CHECK (readDesign (json, "design.json", model).program.voltageLimits.maxCoeff() == 0.25);
}

TEST_CASE ("A design is refused for another device, and where the file is broken, in one sentence each", "[files]")
{
    const auto json = written (designFocus (plate(), focus (AllocationMethod::exact), playback));
    auto other = plate();
    other.name = "phone";
    CHECK (errorOf (json, other)
           == "design.json: /device: is 'sine', and it is to be played on 'phone'; allowed: the device that it was "
              "made for");
    other = plate();
    other.angularFrequencies *= 1.01;
    CHECK_THAT (errorOf (json, other), Catch::Contains ("/controlled_modes/0: has ")
                                           && Catch::Contains ("; allowed: the device that it was made for"));
    other = plate();
    other.ceramics.pop_back();
    other.participation.conservativeResize (Eigen::NoChange, other.participation.cols() - 1);
    CHECK (errorOf (json, other) == "design.json: /ceramics: has 12 ceramics; allowed: the 11 of 'sine'");

    const auto without = [&] (const char* key)
    {
        auto less = json;
        less.erase (key);
        return errorOf (less);
    };
    CHECK_THAT (without ("allocation"), Catch::Contains ("allocation"));
    CHECK_THAT (without ("oscillations"), Catch::Contains ("has neither 'oscillations' nor 'samples'"));
    auto changed = json;
    changed["allocation"][3].erase (0);
    CHECK_THAT (errorOf (changed), Catch::Contains ("/allocation/3: has "));
    changed = json;
    changed["oscillations"][0]["growth_per_s"] = "fast";
    CHECK_THAT (errorOf (changed), Catch::Contains ("/oscillations/0/growth_per_s: "));
    changed = json;
    changed["drives"] = 1;
    CHECK_THAT (errorOf (changed), Catch::Contains ("/drives: is an unknown key"));
    changed = json;
    changed["focus"]["focus_time_ms"] = -1;
    CHECK_THAT (errorOf (changed), Catch::Contains ("/focus") && Catch::Contains ("focus_time_ms"));
    changed = json;
    changed["field"]["truncated_mm_s"].erase (0);
    CHECK_THAT (errorOf (changed), Catch::Contains ("/field/truncated_mm_s: has "));
}
