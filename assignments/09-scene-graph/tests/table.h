// Where the parts of a table belong, computed in the judge.
#pragma once

#include <subject/Evidence.h>
#include <subject/Judge.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "../table_fault.h"

namespace truth {

using glm::mat4;
using glm::vec3;

struct Box {
    std::string name;
    vec3 low, high;
};

struct Table {
    vec3 size;
    float thickness;

    Box top() const {
        return {"the top",
                {-0.5f * size.x, size.y - thickness, -0.5f * size.z},
                {0.5f * size.x, size.y, 0.5f * size.z}};
    }
    std::vector<Box> legs() const {
        const vec3 corner(0.5f * size.x, size.y - thickness, 0.5f * size.z);
        std::vector<Box> found;
        for (const float x : {-corner.x, corner.x - thickness}) {
            for (const float z : {-corner.z, corner.z - thickness}) {
                const std::string name = std::string("the leg at the ") +
                                         (x < 0 ? "left" : "right") + (z < 0 ? " back" : " front");
                found.push_back({name, {x, 0, z}, {x + thickness, corner.y, z + thickness}});
            }
        }
        return found;
    }
    std::string tell() const {
        return judge::say("buildTable with size {}, thickness {}", size, thickness);
    }
};

/// Middle and half size of the cube of side 1 behind a matrix.
inline std::vector<double> extentOf(const mat4& matrix) {
    const vec3 middle(matrix[3]);
    const vec3 half =
        0.5f * (glm::abs(vec3(matrix[0])) + glm::abs(vec3(matrix[1])) + glm::abs(vec3(matrix[2])));
    return {middle.x, middle.y, middle.z, half.x, half.y, half.z};
}

/// What came of buildTable. A table that cannot be followed ends the test.
struct Built {
    std::vector<mat4> pieces, feet;
    mat4 legPiece;
    int legEdges;
};

inline Built built(const Table& table) {
    const auto [pieces, feet, legPiece, legEdges, numbers] =
        judge::subject()
            .call<std::tuple<std::vector<mat4>, std::vector<mat4>, mat4, int, std::vector<int>>>(
                "table", table.size, table.thickness);
    if (const auto fault = course::TableFault::of(numbers); fault.kind != fault.none) {
        judge::observed("fault", {double(fault.kind)});
        judge::failAndLeave(table.tell() + ": " + fault.tell());
    }
    std::vector<std::vector<double>> extents;
    for (const mat4& piece : pieces)
        extents.push_back(extentOf(piece));
    judge::observed("set", judge::orderless(extents));
    return {pieces, feet, legPiece, legEdges};
}

/// Whether the cube of side 1 becomes that box, whichever of its corners comes to lie where.
inline bool fills(const mat4& matrix, const Box& box) {
    for (int wanted = 0; wanted < 8; ++wanted) {
        const vec3 corner(wanted & 1 ? box.high.x : box.low.x, wanted & 2 ? box.high.y : box.low.y,
                          wanted & 4 ? box.high.z : box.low.z);
        bool found = false;
        for (int each = 0; each < 8; ++each) {
            const vec3 p(each & 1 ? 0.5f : -0.5f, each & 2 ? 0.5f : -0.5f, each & 4 ? 0.5f : -0.5f);
            const vec3 got(matrix * glm::vec4(p, 1.0f));
            found |= glm::distance(got, corner) <= 1e-4f * std::max(1.0f, glm::length(corner));
        }
        if (!found)
            return false;
    }
    return true;
}

/// "from (0, 0, 0) to (1, 1, 1)": the extent of the cube of side 1 behind a matrix.
inline std::string extent(const mat4& matrix) {
    const auto e = extentOf(matrix);
    const vec3 middle(e[0], e[1], e[2]), half(e[3], e[4], e[5]);
    return judge::say("from {} to {}", middle - half, middle + half);
}

/// One of the matrices makes the cube that box.
inline bool expectBox(const Table& table, const std::vector<mat4>& pieces, const Box& box) {
    const bool found = std::any_of(pieces.begin(), pieces.end(),
                                   [&](const mat4& piece) { return fills(piece, box); });
    if (found)
        return true;
    std::string there = judge::say("there are {} pieces", int(pieces.size()));
    for (std::size_t k = 0; k < std::min<std::size_t>(pieces.size(), 5); ++k)
        there += (k ? ", " : ": ") + extent(pieces[k]);
    judge::fail(table.tell() + ": no piece is " + box.name +
                judge::say(", which reaches from {} to {}; ", box.low, box.high) + there);
    return false;
}

inline bool expectWhole(const Table& table) {
    const Built got = built(table);
    std::vector<Box> boxes = table.legs();
    boxes.push_back(table.top());
    for (const Box& box : boxes) {
        if (!expectBox(table, got.pieces, box))
            return false;
    }
    return judge::expectThat(table.tell() + ": five pieces", got.pieces.size() == 5,
                             judge::say("found {}", int(got.pieces.size())));
}

}  // namespace truth
