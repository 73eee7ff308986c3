#include "models/materials.h"

#include <algorithm>

#include "rasterizer/error.h"

namespace scanlit::models {

namespace {

constexpr const char* by_eye = "chosen by eye";

// Metals reflect by their measured reflectance and have no diffuse part.
std::vector<NamedMaterial> metal_materials() {
  const Tangents lathe{.field = TangentField::around, .axis = {0, 1, 0}, .centre = {0, 0, 0}};
  const std::string noble = "F: Johnson and Christy 1972; roughness chosen by eye";
  const std::string rakic = "F: Rakic 1995; roughness chosen by eye";
  return {
      {"copper", "cook-torrance:F=copper,m=.35", noble},
      {"gold", "cook-torrance:F=gold,m=.35", noble},
      {"silver", "cook-torrance:F=silver,m=.3", noble},
      {"aluminium", "cook-torrance:F=aluminium,m=.5", rakic},
      {"brushed-aluminium", "cook-torrance:F=aluminium,D=anisotropic-beckmann,ax=.18,ay=.6", rakic,
       lathe},
      {"chromium", "cook-torrance:F=chromium,m=.3",
       "F: Johnson and Christy 1974; roughness chosen by eye"},
      {"brass", "cook-torrance:F=schlick,f0=.88/.7/.3,m=.4", by_eye},
  };
}

// Plastics and glazes are a coloured diffuse body under a dielectric surface.
std::vector<NamedMaterial> coated_materials() {
  return {
      {"white-plastic", "clear-coat:base=(lambert:kd=.85),a=.15", by_eye},
      {"red-plastic", "clear-coat:base=(lambert:kd=.75/.06/.04),a=.15", by_eye},
      {"green-plastic", "clear-coat:base=(lambert:kd=.08/.5/.12),a=.15", by_eye},
      {"blue-plastic", "clear-coat:base=(lambert:kd=.06/.15/.7),a=.15", by_eye},
      {"black-plastic", "clear-coat:base=(lambert:kd=.02),a=.15", by_eye},
      {"rubber", "clear-coat:base=(oren-nayar:rho=.05,sigma=.4),a=.5", by_eye},
      {"porcelain", "clear-coat:base=(lambert:kd=.93/.92/.88),a=.06", by_eye},
      {"car-paint",
       "clear-coat:base=(cook-torrance:F=aluminium,m=.35,ks=.7/.03/.04,kd=.1/.005/.008),a=.03",
       by_eye},
  };
}

std::vector<NamedMaterial> matt_materials() {
  const Tangents down{.field = TangentField::along, .axis = {0, 1, 0}, .centre = {0, 0, 0}};
  return {
      {"chalk", "oren-nayar-full:rho=.87/.86/.82,sigma=.6", by_eye},
      {"clay", "oren-nayar-full:rho=.6/.27/.15,sigma=.4", by_eye},
      {"velvet",
       "lafortune:rd=.05/.004/.012,lobe=(cx=1/.7/.77,cz=.1,n=4),lobe=(cx=-1/-.7/-.77,cz=.1,n=4)",
       by_eye},
      {"satin", "ward:kd=.12/.03/.2,rho=.3/.12/.42,ax=.15,ay=.5", by_eye, down},
      {"blue-house-paint",
       "lafortune:rd=.3264/.3967/.7084,"
       "lobe=(cx=.870567/.857255/.670982,cz=.774290/.619944/.586674,n=21.8201/18.5978/7.4727),"
       "lobe=(cx=-.451218/-.406681/-.477976,cz=.023123/.017625/.227295,n=3.0293/2.5815/3.6777),"
       "lobe=(cx=-1.031545/-1.029426/-1.026588,cz=.706734/.696530/.687715,"
       "n=66.8991/63.7679/57.4892)",
       "Lafortune, Foo, Torrance and Greenberg 1997: a fit to their measurements"},
  };
}

// Finished wood, carved from a trunk that is about as large as a built-in shape; its geometry is
// given to the colour and to the fibres alike.
std::vector<NamedMaterial> wood_materials() {
  const auto wood = [](const char* name, const std::string& trunk, const std::string& colour,
                       const std::string& fibre, const std::string& rest) {
    return NamedMaterial{name,
                         "finished-wood:kd=wood-colour(" + colour + ',' + trunk +
                             "),u=wood-fibre(" + fibre + ',' + trunk + ")," + rest,
                         by_eye};
  };
  return {
      wood("maple", "axis=1/.06/.04,ring=.07", "early=.5/.33/.17,late=.36/.2/.09,streaks=.15",
           "unrest=3", "kf=.05/.037/.02,a=.08"),
      wood("curly-maple", "axis=1/.06/.04,ring=.07", "early=.5/.33/.17,late=.36/.2/.09,streaks=.15",
           "curl=9,wave=.07", "kf=.07/.052/.029,a=.08"),
      wood("oak", "axis=1/.05/.02,pith=.5,ring=.05,streak=.015",
           "early=.38/.23/.1,late=.2/.105/.04,pores=.5", "unrest=5", "kf=.045/.03/.015,a=.2"),
      wood("walnut", "axis=1/.05/.02,pith=.35,towards=0/-.3/-1,ring=.07,streak=.02",
           "early=.2/.105/.05,late=.085/.042/.02,pores=.4", "unrest=5", "kf=.04/.027/.015,a=.12"),
  };
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const NamedMaterial& material : materials()) all.push_back(material.name);
  return all;
}

/// The material's own text, with what is given in place of all that has the same key there.
std::string overridden(const std::string& text, std::span<const Argument> given) {
  Specification specification = parse_specification(text);
  std::erase_if(specification.arguments, [&](const Argument& own) {
    return std::ranges::find(given, own.key, &Argument::key) != given.end();
  });
  specification.arguments.insert(specification.arguments.end(), given.begin(), given.end());
  std::string result = specification.name;
  char separator = ':';
  for (const auto& [key, value] : specification.arguments) {
    result += separator + key + '=' + value;
    separator = ',';
  }
  return result;
}

const NamedMaterial& find_material(std::span<const Argument> arguments) {
  const bool is_named = !arguments.empty() && arguments[0].key.empty();
  const std::string name = is_named ? arguments[0].value : "";
  const auto found = std::ranges::find(materials(), name, &NamedMaterial::name);
  if (found == materials().end())
    throw Error("unknown material '" + name + "'" + did_you_mean(name, names()));
  return *found;
}

NamedModel make_material(const ModelInfo&, std::span<const Argument> arguments,
                         const Context& context) {
  const NamedMaterial& material = find_material(arguments);
  const auto given = arguments.subspan(1);
  for (const Argument& argument : given)
    if (argument.key.empty())
      throw Error(context.where,
                  "expected key=value after '" + material.name + "', not '" + argument.value + "'");
  NamedModel result = make(overridden(material.specification, given), context);
  result.tangents = material.tangents;
  return result;
}

}  // namespace

const std::vector<NamedMaterial>& materials() {
  static const std::vector<NamedMaterial> all = [] {
    std::vector<NamedMaterial> result = metal_materials();
    for (const auto& group : {coated_materials(), wood_materials(), matt_materials()})
      result.insert(result.end(), group.begin(), group.end());
    return result;
  }();
  return all;
}

std::string model_behind(const std::string& specification) {
  const Specification given = parse_specification(specification);
  if (given.name != "material") return specification;
  const NamedMaterial& material = find_material(given.arguments);
  return overridden(material.specification, std::span(given.arguments).subspan(1));
}

Entry material_entry() {
  return {.info = {.year = 2026,
                   .name = "material",
                   .title = "A material by its name: material:copper, material:copper,m=.2",
                   .source = "each material's own",
                   .reciprocal = true,
                   .energy_bounded = true,
                   .exceptions = "as they are, with nothing changed",
                   .example = "material:copper"},
          .make = &make_material};
}

}  // namespace scanlit::models
