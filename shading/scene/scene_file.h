#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shading/scene/scene.h"

namespace xnewell {

/// A scene file is one JSON object. Every key is optional, but at least one object must have a face.
///
///   "shows"     a sentence that says what the scene is for
///   "up"        "y" (the default) or "z"
///   "camera"    any of "eye", "look_at", "up" [x, y, z], "fov" degrees, "parallel" height or true,
///               "oblique" {"kind": "cavalier" or "cabinet", "angle": degrees}, and, as in the textbook,
///               "vrp", "vpn", "vup", "prp" [x, y, z], "window" [umin, umax, vmin, vmax], "front", "back".
///               "window", "front" and "back" are measured from "vrp" or "look_at". They go with an "eye" as
///               with a "prp". Two names of one part exclude each other: "eye" and "vpn" or "prp", "look_at"
///               and "vrp", "up" and "vup", "fov" and "window". An option of the command line replaces the
///               same part here, whatever its name, and no other (completed() in scene.h)
///   "objects"   a list; each object has one of
///                 "file"      an .obj, .ply, .off or .bpt file; a relative path starts at the folder of the
///                             scene file
///                 "polygons"  a list of polygons, each a list of corners [x, y, z]; with "uv", a list of
///                             the same form with [u, v] for each corner
///                 "solid"     "cube", "sphere" or "torus" about the origin (solids.h), with "around" and
///                             "down" or "across"
///               It may also have "name"; "color" or "material"; "divisions" of patches (default: the
///               number that the user asks for); and "scale" (a factor, or [x, y, z]), "rotate" and "move"
///               [x, y, z], applied in this order. "rotate" is [x, y, z], degrees about the x axis, then y,
///               then z, or {"axis": [x, y, z], "degrees": d}. It turns counter-clockwise if seen from the
///               tip of the axis
///   "materials" {"name": {"color", "specular" (the highlight's colour), "ka", "kd", "ks", "n", "texture":
///               "F.png" in the scene file's folder}, ...}. An .obj file keeps its own materials and their
///               textures unless its object names a material
///   "ambient"   Ia: a number, or [r, g, b] with one value per channel
///   "lights"    a list of light sources (light.h); each has
///                 "kind"      "directional" (the default), "point" or "spot"
///                 "Ip" or "color"  a number or [r, g, b]. Lights without it share equally what Ia and the
///                             other lights leave of 1, but together at most the Ip of the settings
///                 "towards"   [x, y, z], for directional: the direction to the light (default: upper left)
///                 "at"        [x, y, z], for point and spot, required: where the light is
///                 "attenuation" a name of kAttenuations, with "range" (default: twice the distance to the
///                             scene's centre) or "c" [c1, c2, c3] (default: they halve the light there)
///                 "shines"    a direction, or "look_at" a point, for spot; default: at the scene's centre
///                 "inner", "outer" half angles of a spot in degrees (default: 15, 20); "falloff" (default 1)
///               Ia + the sum of Ip must not exceed 1 in any channel
///   "lines"     a list: "points", a list of [x, y, z]; "color" (default: black); "width"
///               in pixels (default: 1). Faces in front hide parts of them
///   "labels"    a list: "text", which begins "at" [x, y, z]; "color"; "size" in pixels
///               (default: 12). It is there if no face hides that point
///   "shading"   the settings at the start; options of the command line override them. The keys are those of
///               settingRows(), which describe each setting; "table.i0" is written "table": {"i0"}. "fill"
///               has an effect only in a window. "ka", "kd", "ks" and "n" apply to surfaces that do not set
///               them. "Ia" applies if the scene has no "ambient"; "Ip", "light" and "light_at" apply if it
///               has no "lights". "attenuation" is for the light of "light_at"; in a set-up of another scene,
///               for that scene's own lights at places too
///   "scene"     a built-in name, or the file of a scene. A relative path starts at this file's folder. The
///               key takes the place of "objects", "up", "materials", "ambient" and "lights". It allows
///               "divisions" of patches; "without", a list of what that scene must not set (kStrippable);
///               and "texture", a PNG for all its surfaces. A set-up is saved in this form (save_scene.h)
///
/// A colour is "color": [r, g, b] from 0 to 1, or "color255": [r, g, b] from 0 to 255. "specular" and
/// "specular255" work alike.
/// The number of decimals in an object's corners shows how they are rounded (RoundingOfNumbers). This decides
/// which faces count as lying in one plane. So in a file with six decimals, write 2.500000 or 2.5, not
/// 2.4999999999999996. Faces are numbered object by object. Unknown keys, wrong types and values out of range
/// are errors.
/// @throws ParseError such as `room.json: objects[2].polygons[0]: a polygon needs at least 3 corners`; if the
/// text is not JSON, the message gives the line number instead of the key. @throws std::system_error
[[nodiscard]] Scene readSceneFile(const std::filesystem::path& file, int divisions = kDefaultDivisions);

/// True for a file that names another scene. No such file is a part of a scene. It throws what
/// readSceneFile() throws.
[[nodiscard]] bool isSetup(const std::filesystem::path& file);

/// The "shows" sentence of a file, or "" if it has none. It throws what readSceneFile() throws.
[[nodiscard]] std::string sentenceOf(const std::filesystem::path& file);

/// Reads a scene file from its text. Errors show `name` as the file's name. Relative paths start at `folder`.
[[nodiscard]] Scene parseSceneFile(std::string_view text, const std::string& name,
                                   const std::filesystem::path& folder, int divisions = kDefaultDivisions);

}  // namespace xnewell
