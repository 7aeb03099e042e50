#include "OutlineFile.h"

#include "OutlineReader.h"

namespace antinode
{
namespace
{
void embed (nlohmann::json& owner, const std::filesystem::path& folder, const OutlineFileReader& read)
{
    if (! owner.is_object() || ! owner.contains ("outline"))
        return;

    auto& outline = owner["outline"];

    if (outline.is_object() && outline.contains ("file") && outline["file"].is_string())
        outline = outlineToJson (read (folder / outline["file"].get<std::string>(), outline));
}
} // namespace

void embedOutlineFiles (nlohmann::json& device, const std::filesystem::path& folder, const OutlineFileReader& read)
{
    embed (device, folder, read);

    if (device.is_object() && device.contains ("areas") && device["areas"].is_array())
        for (auto& area : device["areas"])
            embed (area, folder, read);
}
} // namespace antinode
