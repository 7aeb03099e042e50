#pragma once

#include <antinode_documents/DesignFile.h>
#include <antinode_fingers/Finger.h>
#include <antinode_focus/FocusDescription.h>
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
} // namespace antinode
