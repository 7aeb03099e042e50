#pragma once

#include <antinode_fingers/Sensation.h>
#include <antinode_focus/PlacedDesigns.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_model/ModalModel.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** What a map is asked for. */
struct MapOptions
{
    int places = 2000;                           ///< About so many, in a grid of square cells.
    std::optional<SkinThreshold> threshold = {}; ///< By which felt contrast is computed; none: it is not.
    Playback playback { Reconstruction::bandLimited, 192000 };
    std::size_t threads = 1;
};

/** A focus at one place of a map. */
struct MapPlace
{
    double x = 0, y = 0; ///< Of the first target, m.
    int controlled = 0;  ///< Modes.
    double captured = 0;
    double vScore = 0, fieldError = 0; ///< Against the wanted field.
    double peakVoltage = 0;            ///< V
    double spillOver = 0;              ///< The part of the field in modes beyond the device's own.
    std::optional<double> contrast;    ///< Felt, dB.
    bool isShared = false;             ///< Whether its design came from what all places share.
    std::string error;                 ///< Why there is no design; empty where there is.
};

/** A focus everywhere on a surface: places row by row from below. */
struct FocusMap
{
    std::string device, focus;
    Eigen::Index columns = 0, rows = 0;
    double xMinimum = 0, xMaximum = 0, yMinimum = 0, yMaximum = 0; ///< Of the surface, m: the edges of the outer cells.
    double voltageLimit = 0;                                       ///< V
    std::vector<MapPlace> places;
};

/** Designs a focus at every place of a surface, its first target there and the others as far from it as they are. The
   fields are those of the closed form at the focus; what is felt is played with the modes that skin can feel.
    @param wide  the device with modes beyond its own
    @param show  called now and then with how many places are done, by one thread at a time
    @throws InputError  where the focus cannot be mapped at all; Cancelled as checkWatch()
    [worker] Docs/Design/sweeps.md. */
FocusMap mapFocus (const WideModel& wide, const FocusDescription&, const MapOptions&,
                   const std::function<void (int done, int all)>& show = {});

/** map.json and map.csv: a place per row. [worker] Docs/FileFormats.md. */
nlohmann::ordered_json mapToJson (const FocusMap&);
std::string mapToCsv (const FocusMap&, const std::function<std::string (std::string)>& inWords);

/** Designs one focus at many places of a surface, with what the places share computed once. */
class PlaceMapper
{
public:
    /** @throws InputError  where the focus cannot be designed for the device
        [worker] */
    PlaceMapper (const WideModel&, const FocusDescription&, const MapOptions&);

    /** The designs at places, x and y in m, one per row; where there is none, its error says why.
        @throws Cancelled  as checkWatch()
        [worker], several at once. */
    std::vector<MapPlace> mapped (const Eigen::MatrixX2d& places) const;

private:
    /** Projections of fields on all modes: by masses, as designs take them, and by areas, as scores do. */
    struct Projections
    {
        Eigen::MatrixXd fields;         ///< N_p x places, m/s
        Eigen::MatrixXd byMass, byArea; ///< N_m x places
    };

    Projections projected (const std::vector<FocusDescription>&) const;
    void compute (MapPlace&, const FocusDescription& moved, const Projections&, Eigen::Index) const;
    void computeAlone (MapPlace&, const FocusDescription& moved) const;
    void score (MapPlace&, const Eigen::VectorXd& velocities, const Projections&, Eigen::Index) const;
    void feel (MapPlace&, const FocusDesign&, const FocusDescription& moved) const;

    const WideModel& wide;
    const FocusDescription& focus;
    const MapOptions& options;
    ModalModel known, felt;
    Eigen::VectorXd areas; ///< Shares of the whole surface.
    Eigen::VectorXd means; ///< Of each shape over the surface.
    std::optional<PlacedDesigns> shared;
};

/** The modes that skin may feel, those below 3 kHz and at least 24, on a grid with half as many places in each
   direction.
    @throws nothing
    [worker] Docs/Design/sweeps.md. */
ModalModel feltModes (const ModalModel&);
} // namespace antinode
