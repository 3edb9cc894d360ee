// The group that you build in Table.cpp. Provided.
#pragma once

#include <glm/glm.hpp>

#include "Node.h"

/// Makes a table out of three nodes that are empty at the call, by filling their lists:
///
///     table   has the edges: one to top, four to leg
///     top     has the model of the table top (or table itself has it)
///     leg     has the model of one leg, which is thereby drawn four times
///
/// `piece` is the cube of side 1 around the origin; scaled and moved it is the top and each leg.
/// `size` is the table's width, height and depth along x, y and z, all above 2 * thickness. In the
/// coordinates of `table` it stands on the plane y = 0 with its middle on the y axis:
///
///     top     width x thickness x depth, its upper side at y = height
///     legs    thickness x thickness, from y = 0 to the lower side of the top, flush with its
///     corners
///
/// Nothing is drawn or allocated here.
void buildTable(Node& table, Node& top, Node& leg, Model* piece, const glm::vec3& size,
                float thickness);
