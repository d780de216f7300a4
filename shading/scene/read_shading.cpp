#include "shading/scene/read_shading.h"

#include <algorithm>

namespace xnewell {

namespace {

void readTable(TableSettings& table, const Node& node) {
  node.expectKeys({"kind", "shades", "i0", "pick", "hue", "bits"});
  if (node.has("kind")) table.kind = node.at("kind").choice(kTables);
  if (node.has("shades")) table.shades = node.at("shades").whole(2, kMaxShades);
  if (node.has("i0")) {
    table.I0 = node.at("i0").number();
    if (!(table.I0 > 0.0 && table.I0 < 1.0)) node.at("i0").fail("a number between 0 and 1 is needed");
  }
  if (node.has("pick")) table.pick = node.at("pick").choice(kPicks);
  if (node.has("hue")) {
    table.hue = node.at("hue").color();
    if (std::max({table.hue.r, table.hue.g, table.hue.b}) != 1.0)
      node.at("hue").fail("the largest of r, g, b must be 1");
  }
  if (node.has("bits")) {
    table.bits = node.at("bits").whole(8, 16);
    if (table.bits != 8 && table.bits != 16) node.at("bits").fail("8 or 16 is needed");
  }
}

}  // namespace

void readShading(PictureSettings& settings, const Node& node) {
  node.expectKeys({"method", "normals", "crease", "polygons", "adapt", "form", "environment", "mapping",
                   "order", "cull", "fill", "colors", "dither", "table"},
                  {"Ia", "Ip", "ka", "kd", "ks", "n", "light", "light_at", "attenuation", "range", "c",
                   "constant_l", "constant_v", "sided"});
  const auto choose = [&](const char* key, const auto& rows, auto& choice) {
    if (node.has(key)) choice = node.at(key).choice(rows);
  };
  choose("method", kShadings, settings.shading);
  choose("normals", kNormalRules, settings.normals);
  choose("polygons", kPolygons, settings.polygons);
  choose("form", kForms, settings.light.form);
  choose("environment", kEnvironmentForms, settings.environment);
  choose("mapping", kTextureMappings, settings.mapping);
  choose("order", kOrders, settings.order);
  choose("colors", kColorPlans, settings.colors);
  if (node.has("crease")) settings.crease = node.at("crease").numberFrom(0, 180);
  if (node.has("dither")) settings.dither = node.at("dither").truth();
  if (node.has("table")) readTable(settings.table, node.at("table"));

  Illumination& light = settings.light;
  const auto share = [&](const char* key, double& k) {
    if (node.has(key)) k = node.at(key).numberFrom(0, 1);
  };
  share("Ia", light.Ia), share("Ip", light.Ip);
  share("ka", light.ka), share("kd", light.kd), share("ks", light.ks);
  if (light.Ia + light.Ip > 1.0) {
    if (node.has("Ia") && node.has("Ip")) node.fail("Ia + Ip must not exceed 1");
    (node.has("Ia") ? light.Ip : light.Ia) = 1.0 - (node.has("Ia") ? light.Ia : light.Ip);
  }
  if (node.has("n")) light.n = node.at("n").whole(0, 1'000'000);
  if (node.has("light")) light.light = node.at("light").direction();
  if (node.has("light_at")) light.lightPosition = node.at("light_at").point();
  choose("attenuation", kAttenuations, light.attenuation);
  if (node.has("range")) light.range = node.at("range").numberAbove(0);
  if (node.has("c")) {
    light.c = node.at("c").point();
    if (std::min({light.c->x, light.c->y, light.c->z}) < 0.0)
      node.at("c").fail("c1, c2 and c3 must not be negative");
  }
  if (node.has("constant_l")) light.constantL = node.at("constant_l").truth();
  if (node.has("constant_v")) light.constantV = node.at("constant_v").truth();
  const auto oneOf = [&](const char* key, const char* no, const char* yes) {
    const std::string word = node.at(key).text();
    if (word != no && word != yes) node.at(key).fail(std::string{no} + " or " + yes + " is needed");
    return word == yes;
  };
  if (node.has("sided")) light.twoSided = oneOf("sided", "one", "two");
  if (node.has("cull")) settings.cull = oneOf("cull", "none", "back") ? Cull::Back : Cull::Keep;
  if (node.has("fill")) settings.inPixels = oneOf("fill", "scanline", "x11");
  if (node.has("adapt")) settings.adapt = node.at("adapt").numberFrom(0, 1);
}

void expectCounts(const PictureSettings& settings, const Node& node) {
  const Illumination& light = settings.light;
  if (node.has("range") && light.attenuation != Attenuation::Linear)
    node.at("range").fail("a range is for attenuation linear");
  if (node.has("c") && light.attenuation != Attenuation::Textbook)
    node.at("c").fail("c1, c2 and c3 are for attenuation textbook");
  if (node.has("attenuation") && light.attenuation != Attenuation::None && !light.lightPosition)
    node.at("attenuation")
        .fail("only a light at a place fades: light_at is needed; lights say it themselves");
}

void expectDivides(const PictureSettings& settings, const Node& node) {
  if (!node.has("adapt")) return;
  const Node adapt = node.at("adapt");
  if (settings.adapt == 0.0) adapt.fail("a number above 0 is needed; without adapt nothing is divided");
  if (settings.shading != Shading::Flat && settings.shading != Shading::Gouraud)
    adapt.fail("goes with method flat and gouraud");
}

}  // namespace xnewell
