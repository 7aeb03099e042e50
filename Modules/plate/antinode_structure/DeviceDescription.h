#pragma once

#include "Materials.h"

#include <antinode_model/ModalModel.h>

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace antinode
{
enum class EdgeCondition
{
    clamped,
    simplySupported,
    free,
    guided ///< Beam ends only: no slope, free to move.
};

enum class CeramicMounting
{
    bothSides,
    oneSide
};

enum class CeramicWiring
{
    parallel, ///< Each ceramic of a pair sees the whole voltage.
    series    ///< Each sees half of it.
};

enum class CeramicShape
{
    rectangle,
    disc, ///< sizeX = sizeY is its diameter.
    ring  ///< A disc with a round hole in its middle.
};

/** A ceramic of a beam, staple (y and sizeY across the width) or plate. Those of plates may have any shape and angle;
   they are turned about the middle of the rectangle that x, y and the sizes give. */
struct CeramicDescription
{
    std::string name;
    double x = 0, y = 0; ///< Lower left corner, m (files give a beam's ceramics by their centre: the reader converts).
    double sizeX = 0, sizeY = 0; ///< m
    double thickness = 0;        ///< m, of one ceramic
    PiezoelectricMaterial material;
    std::optional<GlueLayer> glue;      ///< Between it and the plate; none: soldered, or of one piece.
    std::optional<CarrierDisc> carrier; ///< Of a disc bender, whose diameter the sizes give.
    CeramicMounting mounting = CeramicMounting::bothSides;
    CeramicWiring wiring = CeramicWiring::parallel;
    int polarity = 1;                    ///< 1 or -1
    double capacitance = 0;              ///< Measured, of what the amplifier sees, F; 0: from the material.
    double lossFactor = usualLossFactor; ///< tan delta
    CeramicShape shape = CeramicShape::rectangle;
    double angle = 0;         ///< rad, counter-clockwise
    double innerDiameter = 0; ///< Of a ring, m.

    Eigen::Vector2d centre() const { return { x + sizeX / 2, y + sizeY / 2 }; }
};

enum class BendingTheory
{
    thin, ///< Kirchhoff's; of beams that of Euler and Bernoulli.
    thick ///< With shear and rotary inertia: Mindlin's, of beams Timoshenko's.
};

/** The common properties of all described (not measured) devices. */
struct StructureCommon
{
    double thickness = 0;                 ///< m
    ElasticMaterial material;             ///< Of a laminate that of its first layer that is not soft.
    std::vector<LayerDescription> layers; ///< Of a laminate, from the bottom up; empty: one of the material.
    SectionReference reference;           ///< Of a laminate with soft layers: the solver gives it.
    BendingTheory theory = BendingTheory::thin;
    std::vector<double> dampingRatios; ///< One for all modes, or one per mode; the last one serves all further modes.
                                       ///< Soft layers add theirs; with them it may be empty.
    std::vector<CeramicDescription> ceramics;
    double voltageLimit = 0;                ///< V, of every ceramic
    double slewLimit = 0;                   ///< V/s, of every amplifier; 0: none.
    double currentLimit = 0;                ///< A, of every amplifier; 0: none.
    double fullScaleVoltage = 0;            ///< V
    std::optional<double> maximumFrequency; ///< Hz
    std::optional<int> modeCount;
};

/** A straight beam; x from its middle. Ceramics are `width`-centred. */
struct BeamDescription
{
    StructureCommon common;
    double length = 0, width = 0; ///< m
    EdgeCondition left = EdgeCondition::free, right = EdgeCondition::free;
};

/** A staple: a top on two legs with clamped feet, sharp corners; x from the middle of the top, ceramics on the top. */
struct StapleDescription
{
    StructureCommon common;
    double topLength = 0, legLength = 0, width = 0; ///< m
};

/** A rectangular plate; origin in its lower left corner. */
struct PlateDescription
{
    StructureCommon common;
    double lengthX = 0, lengthY = 0; ///< m
    EdgeCondition left = EdgeCondition::free, right = EdgeCondition::free;
    EdgeCondition bottom = EdgeCondition::free, top = EdgeCondition::free;
};

/** How an edge of a plate of any outline is held: fixed, or free but for springs along it, as tape or foam are. */
struct PlateEdge
{
    EdgeCondition condition = EdgeCondition::free; ///< clamped, simplySupported or free
    double translation = 0;                        ///< Stiffness per length against displacement, N/m^2.
    double rotation = 0;                           ///< Against the slope across the edge, N.
    double lossFactor = 0;                         ///< Of the springs.
};

/** What lies under or on a part of a plate. */
struct PlateArea
{
    Outline outline;        ///< m
    double stiffness = 0;   ///< Winkler's, N/m^3.
    double lossFactor = 0;  ///< Of the stiffness.
    double massPerArea = 0; ///< kg/m^2
};

/** What a plate is fastened to, or bears, at one place. */
struct PlatePoint
{
    double x = 0, y = 0;   ///< m
    double stiffness = 0;  ///< Of a spring to ground, N/m.
    double lossFactor = 0; ///< Of the spring.
    double damping = 0;    ///< Of a dashpot to ground, N s/m.
    double mass = 0;       ///< kg
};

/** A plate of any outline, held along its edges in any way. */
struct OutlinedPlate
{
    StructureCommon common;
    Outline outline;              ///< m
    std::vector<PlateEdge> edges; ///< By the numbers of the outline's edges.
    double foundation = 0;        ///< Winkler's under the whole plate, N/m^3.
    double foundationLoss = 0;    ///< Its loss factor.
    std::vector<PlateArea> areas;
    std::vector<PlatePoint> points;
};

struct DeviceDescription;

/** A mode of a drawn device as it was measured: its shape is the drawing's, or a mixture of the drawing's shapes. */
struct MeasuredMode
{
    /** How much of a shape of the drawing it has. */
    struct Share
    {
        Eigen::Index drawn = 0; ///< Which mode, from 0.
        double share = 0;
    };

    /** What the drawing's mode has of one ceramic: it tells whether a solution has the mode with the other sign. */
    struct Reference
    {
        Eigen::Index ceramic = 0;
        double participation = 0; ///< N kg^-1/2 / V
    };

    Eigen::Index drawn = 0;      ///< Which mode of the drawing it is, from 0.
    double angularFrequency = 0; ///< rad/s
    double dampingRatio = 0;
    Eigen::MatrixXd participation; ///< 1 x N_b, of a complex mode 2 x N_b with the imaginary parts below; N kg^-1/2 / V
    std::optional<Reference> reference;
    std::vector<Share> shares = {}; ///< Of all shapes that its own is made of; none: of that mode alone.
};

/** What was measured of a ceramic and its amplifier. */
struct MeasuredCeramic
{
    std::optional<double> voltageLimit, slewLimit; ///< V, V/s; none: the drawing's.
    InputLag lag;
};

/** A drawn device of which modes were measured, but no shapes. */
struct MeasuredDevice
{
    std::shared_ptr<const DeviceDescription> drawing; ///< A beam, staple or plate.
    std::vector<MeasuredMode> modes;                  ///< All that the device has, ascending in frequency.
    std::vector<MeasuredCeramic> ceramics;            ///< N_b, or empty.
    ModeOrigin origin { ModeSource::retuned };
};

/** The kinds of device whose modes are computed, for messages. */
inline constexpr auto computedKinds = "beam, staple, plate";

/** A device as a file describes it. Docs/FileFormats.md. */
struct DeviceDescription
{
    std::string name;
    std::string description;
    std::variant<BeamDescription, StapleDescription, PlateDescription, OutlinedPlate, ModalModel, MeasuredDevice> body;
    bool requiresArming = false;          ///< Stays silent after loading until the user arms the output.
    std::vector<std::string> warnings {}; ///< Sentences about values that hardly any device has.
    std::string document {}; ///< Its file as JSON, without modes and points that are given; empty: made without one.
};

/** Whether the modes of a device are computed from its description, not given. [any] */
bool isComputed (const DeviceDescription&);

/** The extent of the surface of a described device, before it is solved. [any] */
Surface deviceExtent (const DeviceDescription&);

/** The modal model of a described device: solves a beam, staple or plate; hands a measured model on as it is.
    @param modeCount  how many flexible modes, or none: what the description says, or a default of 40
    @throws InputError  where the description cannot be solved, saying why; Cancelled as checkWatch()
    [worker] Docs/Theory.md, section 1. */
ModalModel solveStructure (const DeviceDescription&, std::optional<int> modeCount = {});

/** A described device with a number of modes, of a plate to some percent of their frequencies, in a small part of the
   time: what it has while it is being drawn. A measured model as it is.
    @throws InputError, Cancelled  as solveStructure [worker] */
ModalModel solveCoarsely (const DeviceDescription&, int modeCount);

/** The word for a device's kind, as files and tables have it: "beam", "staple", "plate" or "modal"; of a measured one
   that of its drawing. [any]
 */
const char* deviceKind (const DeviceDescription&);

/** How many modes are solved at most: a beam of more has waves far shorter than thin-beam theory allows; of a plate the
    memory ends it. */
inline constexpr int maximumBeamModes = 200, maximumPlateModes = 500;

/** How many modes of a plate are solved where nothing says how many. */
inline constexpr int defaultPlateModes = 100;

/** @throws InputError  where a plate cannot have so many modes solved [any] */
void requirePlateModes (int count);

/** The one of a device that is solved. [any] */
inline int maximumModes (const DeviceDescription& device)
{
    const auto isPlate =
        std::holds_alternative<PlateDescription> (device.body) || std::holds_alternative<OutlinedPlate> (device.body);
    return isPlate ? maximumPlateModes : maximumBeamModes;
}
} // namespace antinode
