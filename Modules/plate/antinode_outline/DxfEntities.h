#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** A value of a DXF file with the code that says what it is. */
struct DxfGroup
{
    int code = 0;
    std::string_view value; ///< Without blanks around it; it lives as long as the file's bytes.
    long line = 0;
};

/** A record that begins with group 0: an entity, a layer, a mark. */
struct DxfRecord
{
    std::string_view type;
    std::vector<DxfGroup> groups; ///< Without the first.
    long line = 0;

    /** The first value of a code; empty where there is none. [any] */
    std::string_view text (int code) const;

    /** The same as a number. @throws InputError  with source and line where it is none [any] */
    double number (int code, double otherwise, const std::string& source) const;
    int integer (int code, int otherwise, const std::string& source) const;

    /** All values of a code, in order. @throws InputError [any] */
    std::vector<double> numbers (int code, const std::string& source) const;
};

/** A number of a group. @throws InputError  with source and line where it is none, or not finite [any] */
double dxfNumber (const DxfGroup&, const std::string& source);

/** All records of a DXF file of text.
    @throws InputError  source, line, what is wrong
    [worker] AutoCAD 2012 DXF Reference. */
std::vector<DxfRecord> readDxf (std::string_view bytes, const std::string& source);

/** What the readers of entities need to know. */
struct DxfSetting
{
    const std::string& source;
    double unit = 0;      ///< m of one unit of the drawing.
    double deviation = 0; ///< m: how far arcs may lie from free curves.
};

/** What an entity shows, in m.
    @param rest  what follows the entity, for the vertices of a POLYLINE
    @param edge  the number of the next edge, counted on
    @throws InputError  source, entity, what is wrong
    [worker] */
std::vector<PathPiece> dxfPieces (const DxfRecord&, const DxfRecord* rest, const DxfRecord* end, const DxfSetting&,
                                  int& edge);

/** Whether an entity is geometry that dxfPieces() reads. [any] */
bool isDxfCurve (std::string_view type);

/** A SPLINE by its knots, control points and weights, drawn as arcs and lines.
    @throws InputError  with its name, where it is given by other points or its numbers do not fit
    [worker] Piegl and Tiller, The NURBS Book, section 4.1. */
std::vector<PathPiece> dxfSplinePieces (const DxfRecord&, const std::string& name, const DxfSetting&, int& edge);
} // namespace antinode
