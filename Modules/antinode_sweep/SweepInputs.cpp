#include "SweepInputs.h"

#include <antinode_library/Inputs.h>
#include <antinode_text/JsonText.h>

#include <xxhash.h>

#include <utility>

namespace antinode
{
namespace
{
constexpr auto usualDevice = "staple";

/** What the library takes: a file's name begins at the plan's folder. */
std::string nameFrom (const nlohmann::json& json, const std::filesystem::path& plan)
{
    const auto name = json.get<std::string>();
    return isFileName (name) ? (plan.parent_path() / name).string() : name;
}

nlohmann::json focusDocument (const nlohmann::json& json, const std::filesystem::path& plan)
{
    if (json.is_object())
        return json;

    const auto name = nameFrom (json, plan);
    auto document = loadDocument (LibraryKind::focus, name);

    if (document.is_object() && ! document.contains ("name"))
        document["name"] = std::filesystem::path (name).stem().string();

    return document;
}

nlohmann::json deviceDocument (const SweepPlan& plan, const std::filesystem::path& file)
{
    if (plan.device.is_object())
        return plan.device;

    if (plan.device.is_string())
        return loadDocument (LibraryKind::device, nameFrom (plan.device, file));

    const auto named =
        plan.focus.is_string() ? namedDevice (LibraryKind::focus, nameFrom (plan.focus, file), {}) : std::string();
    return loadDocument (LibraryKind::device, named.empty() ? usualDevice : named);
}

std::string hashOf (const nlohmann::json& document)
{
    const auto bytes = document.dump() + "\n" ANTINODE_VERSION;
    const auto hash = XXH3_128bits (bytes.data(), bytes.size());
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash (&canonical, hash);
    std::string text;

    for (const auto byte : canonical.digest)
    {
        constexpr auto digits = "0123456789abcdef";
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }

    return text;
}
} // namespace

SweepInputs sweepInputs (nlohmann::json document, const std::filesystem::path& file)
{
    SweepInputs inputs;
    inputs.document = std::move (document);
    inputs.plan = readSweepPlan (inputs.document, file.string());
    const auto device = deviceDocument (inputs.plan, file);
    inputs.document["focus"] = focusDocument (inputs.plan.focus, file);
    inputs.document["device"] = device;
    inputs.hash = hashOf (inputs.document);
    return inputs;
}

SweepInputs loadSweep (const std::filesystem::path& file)
{
    return sweepInputs (readJsonFile (file), file);
}
} // namespace antinode
