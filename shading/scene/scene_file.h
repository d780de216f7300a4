#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shading/scene/scene.h"

namespace xnewell {

/// Scene files: one JSON object. Everything may be left out but an object with a face.
///
///   "shows"     a sentence on what the scene is for
///   "up"        "y" (also if left out) or "z"
///   "camera"    any of "eye", "look_at", "up" [x, y, z], "fov" degrees, "parallel" height or true,
///               "oblique" {"kind": "cavalier" or "cabinet", "angle": degrees}, and the textbook's
///               "vrp", "vpn", "vup", "prp" [x, y, z], "window" [umin, umax, vmin, vmax], "front", "back"
///   "objects"   a list; each has one of
///                 "file"      an .obj or .bpt file, beside the scene file unless absolute
///                 "polygons"  a list of polygons, each a list of corners [x, y, z]; with "uv", nested alike,
///                             [u, v] for each corner
///                 "solid"     "cube", "sphere" or "torus" about the origin (solids.h), with "around" and
///                 "down" or "across"
///               and, if wanted, "name", "color" or "material", "divisions" (of patches; else those the
///               user asks for), "scale" (a factor, or [x, y, z]), "rotate" and "move" [x, y, z], in this
///               order. "rotate" is [x, y, z], degrees about the axes one after the other, or
///               {"axis": [x, y, z], "degrees": d}; counter-clockwise seen from the axis' tip
///   "materials" {"name": {"color", "specular" (of the highlight), "ka", "kd", "ks", "n", "texture": "F.png"
///               beside the scene file}, ...}; an .obj file keeps its own unless its object names one
///   "ambient"   Ia: a number, or [r, g, b] by channel
///   "lights"    a list of light sources (light.h); each has
///                 "kind"      "directional" (also if left out), "point" or "spot"
///                 "Ip" or "color"  a number or [r, g, b]; those of no Ip share equally what the others and
///                             Ia leave, at most the Ip of the settings in all
///                 "towards"   [x, y, z], directional: the way to the light; else the upper left
///                 "at"        [x, y, z], point and spot: where it is; needed
///                 "attenuation" a name of kAttenuations, with "range" (else twice the way to the scene's
///                             centre) or "c" [c1, c2, c3] (else half the light at the centre)
///                 "shines" a direction, or "look_at" a place; else the scene's centre. Spot
///                 "inner", "outer" half angles of a spot, degrees (else 15, 20); "falloff" (else 1)
///               Ia + the sum of Ip must not exceed 1 in any channel
///   "shading"   what the user's choices are to begin with; the command line may say otherwise. Its keys are
///               those of settingRows(), "table.i0" as "table": {"i0"}; their rows say what each is. "fill"
///               is for a window; "ka", "kd", "ks" and "n" are for surfaces that do not say; "Ia" is for a
///               scene without "ambient", a light for one without "lights"
///   "scene"     in place of "objects", "up", "materials", "ambient" and "lights": a built-in name, or a
///               scene's file beside this one unless absolute, that has them; with "divisions" of patches,
///               "without", a list of what it shall not say itself (kStrippable), and "texture", a PNG for
///               all its surfaces. So a set-up is saved (save_scene.h)
///
/// A colour is "color": [r, g, b] from 0 to 1 or "color255": the same of 255; "specular" likewise.
/// How many decimals the corners of an object carry tells how they are rounded (RoundingOfNumbers), and so
/// what counts as lying in one plane: write 2.500000 or 2.5 in a file of six decimals,
/// not 2.4999999999999996. Faces are numbered object by object. Unknown keys, wrong types and values out of
/// range are refused.
/// @throws ParseError `room.json: objects[2].polygons[0]: a polygon needs at least 3 corners`, or with the
/// line where it is no JSON at all; std::system_error
[[nodiscard]] Scene readSceneFile(const std::filesystem::path& file, int divisions = kDefaultDivisions);

/// What the file says it shows; "" if it does not say. @throws as readSceneFile()
[[nodiscard]] std::string sentenceOf(const std::filesystem::path& file);

/// The same from text; files are looked for in `folder`.
[[nodiscard]] Scene parseSceneFile(std::string_view text, const std::string& name,
                                   const std::filesystem::path& folder, int divisions = kDefaultDivisions);

}  // namespace xnewell
