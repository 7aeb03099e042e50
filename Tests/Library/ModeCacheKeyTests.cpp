#include "Support/DescribedDevices.h"
#include "Support/GridModel.h"
#include "Support/TemporaryFolder.h"

#include <antinode_documents/ModeCache.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

using namespace antinode;
using test::beam;
using test::plate;
using test::staple;

namespace
{
template <typename Body>
Body& bodyIn (DeviceDescription& device)
{
    return std::get<Body> (device.body);
}

using Change = std::function<void (DeviceDescription&)>;

ViscoelasticMaterial softMaterial (double lossFactor)
{
    ViscoelasticMaterial material;
    material.table = { { 1, 1e6, lossFactor } };
    return material;
}

std::vector<Change> commonChanges (const std::function<StructureCommon&(DeviceDescription&)>& common)
{
    const std::vector<std::function<void (StructureCommon&)>> changes {
        [] (auto& c) { c.thickness = std::nextafter (c.thickness, 1); },
        [] (auto& c) { c.material.youngsModulus1 += 1; },
        [] (auto& c) { c.material.youngsModulus2 += 1; },
        [] (auto& c) { c.material.shearModulus += 1; },
        [] (auto& c) { c.material.poissonRatio12 += 0.01; },
        [] (auto& c) { c.material.density += 1; },
        [] (auto& c) { c.dampingRatios[1] += 1e-6; },
        [] (auto& c) { c.dampingRatios.pop_back(); },
        [] (auto& c) { c.dampingRatios.push_back (c.dampingRatios.back()); },
        [] (auto& c) { c.ceramics.pop_back(); },
        [] (auto& c) { c.ceramics.clear(); },
        [] (auto& c) { std::swap (c.ceramics[0], c.ceramics[1]); },
        [] (auto& c) { c.ceramics[1].name = "other"; },
        [] (auto& c) { c.ceramics[1].x += 1e-6; },
        [] (auto& c) { c.ceramics[1].y += 1e-6; },
        [] (auto& c) { c.ceramics[1].sizeX += 1e-6; },
        [] (auto& c) { c.ceramics[1].sizeY += 1e-6; },
        [] (auto& c) { c.ceramics[1].thickness += 1e-6; },
        [] (auto& c) { c.ceramics[1].material.youngsModulus += 1; },
        [] (auto& c) { c.ceramics[1].material.poissonRatio += 0.01; },
        [] (auto& c) { c.ceramics[1].material.density += 1; },
        [] (auto& c) { c.ceramics[1].material.d31 *= 2; },
        [] (auto& c) { c.ceramics[1].material.permittivityRelative += 1; },
        [] (auto& c) { c.ceramics[1].material.fibres = FibreComposite {}; },
        [] (auto& c) {
            c.ceramics[1].glue = GlueLayer { 1e-6, c.material };
        },
        [] (auto& c) {
            c.ceramics[1].carrier = CarrierDisc { 1e-6, c.material };
        },
        [] (auto& c) {
            c.layers = { { c.thickness, c.material } };
        },
        [] (auto& c) {
            c.layers = { { c.thickness, softMaterial (0.1) } };
        },
        [] (auto& c) {
            c.layers = { { c.thickness, softMaterial (0.2) } };
        },
        [] (auto& c) { c.theory = BendingTheory::thick; },
        [] (auto& c) { c.ceramics[1].mounting = CeramicMounting::oneSide; },
        [] (auto& c) { c.ceramics[1].wiring = CeramicWiring::series; },
        [] (auto& c) { c.ceramics[1].polarity = -1; },
        [] (auto& c) { c.voltageLimit += 1; },
        [] (auto& c) { c.fullScaleVoltage += 1; },
        [] (auto& c) { *c.maximumFrequency += 1; },
        [] (auto& c) { c.maximumFrequency.reset(); },
        [] (auto& c) { *c.modeCount += 1; },
        [] (auto& c) { c.modeCount.reset(); },
    };
    std::vector<Change> result { [] (auto& device) { device.name += "x"; } };

    for (const auto& change : changes)
        result.push_back ([=] (auto& device) { change (common (device)); });

    return result;
}

template <typename Body>
std::vector<Change> bodyChanges (std::vector<std::function<void (Body&)>> changes)
{
    auto result = commonChanges ([] (auto& device) -> StructureCommon& { return bodyIn<Body> (device).common; });

    for (const auto& change : changes)
        result.push_back ([=] (auto& device) { change (bodyIn<Body> (device)); });

    return result;
}

/** Stores for the device and all its variations, each with a model of its own: each must get its own back. */
void checkAllDiffer (const DeviceDescription& device, const std::vector<Change>& changes)
{
    const TemporaryFolder scratch;
    const ModeCache cache (scratch.path());
    auto model = test::gridModel (2, 1, 2);
    cache.store (device, {}, model);

    for (std::size_t i = 0; i < changes.size(); ++i)
    {
        INFO ("change " << i);
        auto changed = device;
        changes[i](changed);
        CHECK_FALSE (cache.find (changed, {}));
        model.unknowns = static_cast<int> (i);
        cache.store (changed, {}, model);
        CHECK (cache.find (changed, {}).value().unknowns == static_cast<int> (i));
    }

    CHECK (cache.find (device, {}).value().unknowns == 1234);
}
} // namespace

TEST_CASE ("Whatever is changed in a description, its modes are others", "[files][cache]")
{
    checkAllDiffer (beam(), bodyChanges<BeamDescription> ({
                                [] (auto& b) { b.length += 1e-6; },
                                [] (auto& b) { b.width += 1e-6; },
                                [] (auto& b) { b.left = EdgeCondition::guided; },
                                [] (auto& b) { b.right = EdgeCondition::simplySupported; },
                            }));
    checkAllDiffer (staple(), bodyChanges<StapleDescription> ({
                                  [] (auto& s) { s.topLength += 1e-6; },
                                  [] (auto& s) { s.legLength += 1e-6; },
                                  [] (auto& s) { s.width += 1e-6; },
                              }));
    checkAllDiffer (plate(), bodyChanges<PlateDescription> ({
                                 [] (auto& p) { p.lengthX += 1e-6; },
                                 [] (auto& p) { p.lengthY += 1e-6; },
                                 [] (auto& p) { p.left = EdgeCondition::clamped; },
                                 [] (auto& p) { p.right = EdgeCondition::clamped; },
                                 [] (auto& p) { p.bottom = EdgeCondition::clamped; },
                                 [] (auto& p) { p.top = EdgeCondition::clamped; },
                             }));
}
