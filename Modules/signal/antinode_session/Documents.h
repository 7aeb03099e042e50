#pragma once

#include <antinode_documents/DesignFile.h>
#include <antinode_fingers/Finger.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_model/ModalModel.h>
#include <antinode_structure/DeviceDescription.h>

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** A device with the text that it was read from: a state keeps the text, the session solves the description. */
struct DeviceDocument
{
    std::string text; ///< JSON
    DeviceDescription description;
};

/** A design that was written before (design.json), with the text that it was read from. */
struct DesignDocument
{
    std::string text;   ///< JSON
    std::string source; ///< How errors name it.
    std::shared_ptr<const nlohmann::json> json;
    DesignOrigin origin;
};

/** A focus with the text that it was read from. */
struct FocusDocument
{
    std::string text; ///< JSON
    FocusDescription description;
    std::shared_ptr<const DesignDocument> design = {}; ///< What was written for it before; none: it is designed.
};

/** @param source  how errors name it
    @throws InputError  as readDevice [worker] */
DeviceDocument readDeviceDocument (const nlohmann::json&, const std::string& source);

/** A focus, or a design that was written before with the focus that it was made for.
    @throws InputError  as readFocus and readDesignOrigin [worker] */
FocusDocument readFocusDocument (const nlohmann::json&, const std::string& source);

/** Of the library, or of a file. @throws InputError  as loadDocument and the readers [worker] */
std::shared_ptr<const DeviceDocument> deviceDocument (const std::string& nameOrFile);
std::shared_ptr<const FocusDocument> focusDocument (const std::string& nameOrFile);

/** @throws InputError  as readDesignOrigin [worker] */
std::shared_ptr<const DesignDocument> readDesignDocument (const nlohmann::json&, const std::string& source);

/** Whether both say the same, their written designs too. [any] */
bool sayTheSame (const FocusDocument&, const FocusDocument&);

/** A focus with other fingers, in its text too; what was written for it stays.
    @throws InputError  as readFocus: more than maximumFingers, or properties that no file may have [worker] */
FocusDocument withFingers (const FocusDocument&, const std::vector<Finger>&);

/** The design that was written for a document, as long as it is the one that is wanted: fingers do not count, all else
    does. None: the focus is to be designed.
    @param wanted  the focus of the document as parameters changed it
    [worker] */
std::shared_ptr<const DesignDocument> writtenFor (const FocusDocument&, const FocusDescription& wanted);

/** What each ceramic may get while a focus plays, however many of it add up, N_b, V: the lowest of the limits of the
    ceramics, their outputs, the focus and the design that was written for it.
    @param written  none: the focus is designed [worker] */
Eigen::VectorXd limitsInPlay (const ModalModel&, const FocusDescription&, const DesignDocument* written);

/** A design as it was written, for a model with the modes that it knew.
    @throws InputError  as readDesign [worker] */
FocusDesign designAsWritten (const DesignDocument&, const ModalModel&);

/** Whether a written design, if there is one, can be played on a device, as far as can be said before it plays.
    @param model     of that device without fingers; none: not known yet
    @param playback  of the host; a rate of 0: not known yet
    @throws InputError  with the reason why it cannot [worker] */
void requireFit (const FocusDocument&, const DeviceDocument&, const ModalModel*, Playback);

/** A device whose ceramics are also limited by what amplifiers give. @param volts  of a full-scale sample of each
    ceramic; 0 or missing: the device's [any] */
std::shared_ptr<const ModalModel> withAmplifiers (const std::shared_ptr<const ModalModel>&,
                                                  const std::vector<double>& volts);
} // namespace antinode
