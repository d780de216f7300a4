#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shading/scene.h"

/// Scene files: one JSON object.
///
///   "shows"    a sentence on what the scene is for
///   "up"       "y" (also if left out) or "z"
///   "camera"   any of "eye", "look_at", "up" [x, y, z], "fov" degrees, "parallel" height,
///              "oblique" {"kind": "cavalier" or "cabinet", "angle": degrees}, and the textbook's
///              "vrp", "vpn", "vup", "prp" [x, y, z], "window" [umin, umax, vmin, vmax], "front", "back"
///   "objects"  a list; each has one of
///                "file"      an .obj or .bpt file, beside the scene file unless absolute
///                "polygons"  a list of polygons, each a list of corners [x, y, z]
///                "solid"     "cube", "sphere" or "torus" about the origin (solids.h), with "around" and
///                "down" or "across"
///              and, if wanted, "name", "color" [r, g, b], "divisions" (of patches), "scale" (a factor) and
///              "move" [x, y, z], in this order
///
/// How many decimals the corners of an object carry tells how they are rounded (RoundingOfNumbers), and so
/// what counts as lying in one plane: write 2.500000 or 2.5 in a file of six decimals,
/// not 2.4999999999999996. Faces are numbered object by object. Unknown keys, wrong types and values out of
/// range are refused.
/// @throws ParseError `room.json: objects[2].polygons[0]: a polygon needs at least 3 corners`, or with the
/// line where it is no JSON at all; std::system_error
[[nodiscard]] Scene readSceneFile(const std::filesystem::path& file);

/// What the file says it shows; "" if it does not say. @throws as readSceneFile()
[[nodiscard]] std::string sentenceOf(const std::filesystem::path& file);

/// The same from text; files are looked for in `folder`.
[[nodiscard]] Scene parseSceneFile(std::string_view text, const std::string& name,
                                   const std::filesystem::path& folder);
