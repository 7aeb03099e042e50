#pragma once

#include <antinode_documents/DeviceFile.h>
#include <antinode_model/ModalModel.h>
#include <antinode_session/Documents.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode::test
{
/** A device whose ceramics lag, each in its own way. */
inline ModalModel withOwnLags (ModalModel model)
{
    for (std::size_t i = 0; i < model.ceramics.size(); ++i)
        model.ceramics[i].lag = { 7e-6 * static_cast<double> (i % 5), 1e-5 * static_cast<double> (i % 3),
                                  0.02 * static_cast<double> (i % 2) };

    return model;
}

/** The document of a model. */
inline DeviceDocument documentOf (const ModalModel& model)
{
    return readDeviceDocument (nlohmann::json::parse (modalDeviceToJson (model, "").dump()), model.name);
}
} // namespace antinode::test
