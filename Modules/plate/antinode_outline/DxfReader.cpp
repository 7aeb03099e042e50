#include "DxfReader.h"

#include "DxfEntities.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <set>

namespace antinode
{
namespace
{
/** m of the units by their numbers in $INSUNITS; 0: not one of length that is allowed. */
double unitByNumber (int number)
{
    constexpr std::array<double, 15> units {
        0, 0.0254, 0.3048, 0, 1e-3, 1e-2, 1, 0, 0, 25.4e-6, 0.9144, 0, 0, 1e-6, 0.1
    };
    return number >= 0 && number < static_cast<int> (units.size()) ? units[static_cast<std::size_t> (number)] : 0;
}

/** Takes up records one after the other, and knows in which section they are. */
class DxfWalk
{
public:
    DxfWalk (const std::vector<DxfRecord>& all, std::string file, const DrawingChoice& wanted)
        : records (all), strokes { std::move (file), {} }, choice (wanted), unit (wanted.unit)
    {
    }

    std::vector<Stroke> walk()
    {
        for (std::size_t i = 0; i < records.size(); ++i)
            if (const auto& record = records[i]; record.type == "SECTION")
            {
                section = record.text (2);

                if (section == "HEADER" && ! (choice.unit > 0))
                    readUnit (record);
            }
            else if (section == "TABLES" && record.type == "LAYER")
                readLayer (record);
            else if (section == "ENTITIES" && ! isLeftOut (record))
                readEntity (i);

        if (! hasEntities)
            throw InputError (strokes.source, "has no section ENTITIES; allowed: an SVG file or a DXF drawing");

        if (strokes.list.empty() && ! choice.layer.empty())
            throw InputError (strokes.source, "shows nothing in layer " + inQuotes (choice.layer)
                                                  + "; allowed: " + listed ({ layers.begin(), layers.end() }));

        return std::move (strokes.list);
    }

private:
    void readUnit (const DxfRecord& header)
    {
        for (auto group = header.groups.begin(); group != header.groups.end(); ++group)
            if (group->code == 9 && group->value == "$INSUNITS" && std::next (group) != header.groups.end())
                unit = unitByNumber (
                    static_cast<int> (std::clamp (dxfNumber (*std::next (group), strokes.source), 0.0, 99.0)));
    }

    /** Layers that are off have a negative colour, frozen ones a flag. */
    void readLayer (const DxfRecord& layer)
    {
        if (layer.number (62, 7, strokes.source) < 0 || (layer.integer (70, 0, strokes.source) & 1) != 0)
            hidden.insert (layer.text (2));
    }

    bool isLeftOut (const DxfRecord& record)
    {
        const auto layer = record.text (8);
        const auto isOnPaper = record.integer (67, 0, strokes.source) == 1,
                   isInvisible = record.integer (60, 0, strokes.source) == 1;
        hasEntities = true;

        if (isDxfCurve (record.type) && ! isOnPaper)
            layers.insert (layer);

        return isOnPaper || isInvisible || hidden.count (layer) > 0
               || (! choice.layer.empty() && layer != choice.layer);
    }

    void readEntity (std::size_t index)
    {
        static constexpr std::array<std::string_view, 12> others { "INSERT", "3DFACE", "SOLID",   "TRACE",
                                                                   "REGION", "BODY",   "3DSOLID", "SURFACE",
                                                                   "MESH",   "MLINE",  "HELIX",   "RAY" };
        const auto& record = records[index];

        if (std::find (others.begin(), others.end(), record.type) != others.end())
            throw InputError (strokes.source,
                              printable (record.type) + " in line " + std::to_string (record.line)
                                  + " is not read; allowed: LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE and "
                                    "SPLINE (explode blocks), or choose a layer");

        // Texts, dimensions, hatches and marks are no outline.
        if (! isDxfCurve (record.type))
            return;

        if (! (unit > 0))
            throw InputError (strokes.source,
                              "does not say its unit ($INSUNITS); allowed: in, ft, mm, cm, m, mil, yd, micron and "
                              "dm, or a unit beside the file's name");

        const auto* const end = records.data() + records.size();
        strokes.add (
            { strokes.source + ": " + printable (record.type) + " in line " + std::to_string (record.line),
              dxfPieces (record, records.data() + index + 1, end, { strokes.source, unit, choice.deviation }, edge) });
    }

    const std::vector<DxfRecord>& records;
    DrawnStrokes strokes;
    const DrawingChoice& choice;
    double unit;
    std::string_view section;
    std::set<std::string_view> hidden, layers;
    bool hasEntities = false;
    int edge = 0;
};
} // namespace

std::vector<Stroke> dxfStrokes (std::string_view bytes, const std::string& source, const DrawingChoice& choice)
{
    const auto records = readDxf (bytes, source);
    return DxfWalk (records, source, choice).walk();
}
} // namespace antinode
