#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shading/scene/scene.h"

namespace xnewell {

/// Scene files: one JSON object. Every key is optional, except that some object must have a face.
///
///   "shows"     a sentence that says what the scene is for
///   "up"        "y" (the default) or "z"
///   "camera"    any of "eye", "look_at", "up" [x, y, z], "fov" degrees, "parallel" height or true,
///               "oblique" {"kind": "cavalier" or "cabinet", "angle": degrees}, and the textbook's
///               "vrp", "vpn", "vup", "prp" [x, y, z], "window" [umin, umax, vmin, vmax], "front", "back"
///   "objects"   a list; each object has one of
///                 "file"      an .obj or .bpt file; a relative path starts at the scene file's folder
///                 "polygons"  a list of polygons, each a list of corners [x, y, z]; with "uv", a list of
///                             the same form with [u, v] for each corner
///                 "solid"     "cube", "sphere" or "torus" about the origin (solids.h), with "around" and
///                             "down" or "across"
///               It may also have "name"; "color" or "material"; "divisions" of patches (default: those that
///               the user asks for); and "scale" (a factor, or [x, y, z]), "rotate" and "move" [x, y, z],
///               applied in this order. "rotate" is [x, y, z], degrees about the axes one after the other,
///               or {"axis": [x, y, z], "degrees": d}; it turns counter-clockwise as seen from the axis' tip
///   "materials" {"name": {"color", "specular" (the highlight's colour), "ka", "kd", "ks", "n", "texture":
///               "F.png" in the scene file's folder}, ...}; an .obj file keeps its own materials unless its
///               object names one
///   "ambient"   Ia: a number, or [r, g, b] with one value per channel
///   "lights"    a list of light sources (light.h); each has
///                 "kind"      "directional" (the default), "point" or "spot"
///                 "Ip" or "color"  a number or [r, g, b]; lights without it share equally what the others
///                             Ia leave, at most the Ip of the settings in all
///                 "towards"   [x, y, z], for directional: the direction to the light (default: upper left)
///                 "at"        [x, y, z], for point and spot, required: where the light is
///                 "attenuation" a name of kAttenuations, with "range" (default: twice the distance to the
///                             scene's centre) or "c" [c1, c2, c3] (default: half the light at the centre)
///                 "shines"    a direction, or "look_at" a point, for spot; default: at the scene's centre
///                 "inner", "outer" half angles of a spot in degrees (default: 15, 20); "falloff" (default 1)
///               Ia + the sum of Ip must not exceed 1 in any channel
///   "shading"   what the user's choices are to begin with; the command line may say otherwise. Its keys are
///               those of settingRows(), "table.i0" as "table": {"i0"}; their rows say what each is. "fill"
///               is for a window; "ka", "kd", "ks" and "n" are for surfaces that do not say; "Ia" is for a
///               scene without "ambient", a light for one without "lights"
///   "scene"     instead of "objects", "up", "materials", "ambient" and "lights": a built-in name, or a
///               scene's file (a relative path starts at this file's folder), that has them; with
///               "divisions" of patches, "without", a list of what that scene must not set (kStrippable),
///               and "texture", a PNG for all its surfaces. This is how a set-up is saved (save_scene.h)
///
/// A colour is "color": [r, g, b] from 0 to 1, or "color255": [r, g, b] from 0 to 255; "specular" works
/// alike.
/// The number of decimals in an object's corners shows how they are rounded (RoundingOfNumbers), and so which
/// faces count as lying in one plane. In a file of six decimals write 2.500000 or 2.5, not
/// 2.4999999999999996. Faces are numbered object by object. Unknown keys, wrong types and values out of range
/// are errors.
/// @throws ParseError `room.json: objects[2].polygons[0]: a polygon needs at least 3 corners`, or with the
/// line number if the text is not JSON; std::system_error
[[nodiscard]] Scene readSceneFile(const std::filesystem::path& file, int divisions = kDefaultDivisions);

/// The "shows" sentence of a file; "" if it has none. It throws what readSceneFile() throws.
[[nodiscard]] std::string sentenceOf(const std::filesystem::path& file);

/// Reads a scene file from its text. `name` stands for the file in errors; other files are looked for in
/// `folder`.
[[nodiscard]] Scene parseSceneFile(std::string_view text, const std::string& name,
                                   const std::filesystem::path& folder, int divisions = kDefaultDivisions);

}  // namespace xnewell
