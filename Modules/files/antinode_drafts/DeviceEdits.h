#pragma once

#include <antinode_outline/Outline.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace antinode
{
// What a user does to a device while drawing it: a document in, a document out. Nothing is checked, readDevice() does
// that; keys that an edit is not about stay as they are. Lengths as in files, mm. [any]

/** Whether a device is drawn: its modes are computed, not given or measured. */
bool isDrawn (const nlohmann::json& device);

/** Whether it is a beam or a staple. */
bool isLine (const nlohmann::json& device);

/** The same device by another name. */
nlohmann::json withName (nlohmann::json device, const std::string& name);

/** Whether both sides of a device can be chosen; of discs and drawn paths one is. */
bool hasTwoSizes (const nlohmann::json& device);

/** The extent of a plate; length and width of a beam or of a staple's top. */
Eigen::Vector2d sizeOf (const nlohmann::json& device);

/** A device of another size. What lies on it keeps its share of the size; ceramics stay as large as they are.
    @param size  where one side follows from the other, the first counts */
nlohmann::json withSize (nlohmann::json device, const Eigen::Vector2d& size);

/** A layer as it is drawn, from the bottom up. */
struct DrawnLayer
{
    nlohmann::json material; ///< A name, or constants.
    double thickness = 0;

    bool operator== (const DrawnLayer&) const = default;
};

/** One where the device is no laminate. */
std::vector<DrawnLayer> layersOf (const nlohmann::json& device);

/** @param layers  one or more; of a beam or staple one */
nlohmann::json withLayers (nlohmann::json device, const std::vector<DrawnLayer>& layers);

/** The quality factor of all modes, of several the first; 0: none is given. */
double qualityFactorOf (const nlohmann::json& device);
nlohmann::json withQualityFactor (nlohmann::json device, double qualityFactor);

/** The voltage limit, V. */
double voltageLimitOf (const nlohmann::json& device);

/** @param volts  of the limit, and of a full-scale sample, which is never below it */
nlohmann::json withVoltageLimit (nlohmann::json device, double volts);

/** An edge with its name in the document. */
struct DrawnEdge
{
    std::string name;
    std::vector<PathPiece> pieces; ///< m
};

/** The edges of a plate; of a line its ends, "left" and "right"; of a staple none, its feet are clamped.
    @throws InputError  where its outline is none [worker] */
std::vector<DrawnEdge> edgesOf (const nlohmann::json& device);

/** The boundary of what ceramics may lie on, m. @throws InputError  where it is none [worker] */
Outline outlineOf (const nlohmann::json& device);

/** A plate with another outline, whose edges are held as the first edge of the one before was.
    @param outline  as outlineToJson() gives it */
nlohmann::json withOutline (nlohmann::json device, nlohmann::json outline);

/** What usually holds an edge, by what it is called. Docs/Manual/devices.md has where the numbers are from. */
struct UsualSupport
{
    std::string name;
    std::string word;      ///< In documents; empty: springs.
    double stiffness = 0;  ///< N/mm^2
    double width = 0;      ///< mm, of the strip: the rotational stiffness is that times width^2 / 12.
    double lossFactor = 0; ///< Of the springs.
    bool isOfBeams = false, isOfPlates = true;
};

const std::vector<UsualSupport>& usualSupports();

/** As documents have it. @param stiffness  N/mm^2; 0: the usual one */
nlohmann::json supportJson (const UsualSupport&, double stiffness = 0);

/** Which of the usual ones a support is; nullptr: none of them. */
const UsualSupport* usualSupport (const nlohmann::json& support);

/** How an edge is held. */
nlohmann::json supportOf (const nlohmann::json& device, const std::string& edge);

/** A device with an edge held in another way. @param edge  empty: all of them */
nlohmann::json withSupport (nlohmann::json device, const std::string& edge, const nlohmann::json& support);
} // namespace antinode
