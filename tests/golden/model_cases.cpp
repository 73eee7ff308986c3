// One picture of each reflection model, of each input, and of the ways a surface is brushed.
#include <unistd.h>

#include <filesystem>

#include "models/measured/tabulate.h"
#include "tests/golden/scenes.h"

namespace scanlit::golden {
namespace {

Framebuffer sphere(const std::string& model) {
  return draw(scene({object("sphere:24", model.c_str())}));
}

Framebuffer brushed(const char* shape, const char* model, const Tangents& tangents) {
  Object result = object(shape, model);
  result.material.tangents = tangents;
  Shot shot;
  shot.framing = 1.2;
  return draw(scene({result}), shot);
}

Framebuffer turned_teapot(const char* model) {
  Shot shot;
  shot.framing = 1.4;
  return draw(scene({object("teapot:6", model)}), shot);
}

// A table is made of an analytic model, drawn, and deleted.
template <class Tabulate>
Framebuffer table(const std::string& model, const char* source, const Tabulate& tabulate,
                  const std::string& arguments = "") {
  const auto file = std::filesystem::temp_directory_path() /
                    ("scanlit-golden-" + std::to_string(getpid()) + "." + model);
  tabulate(*models::make(source).model, file);
  Framebuffer picture = sphere(model + ":file=" + file.string() + arguments);
  std::filesystem::remove(file);
  return picture;
}

}  // namespace

std::vector<Case> model_cases() {
  const auto case_of = [](const char* name, const char* model) {
    return Case{name, rounding, [model] { return sphere(model); }};
  };
  constexpr const char* broad = "blinn-phong:kd=.15/.35/.6,ks=.3,n=12,normalised=1";
  return {
      case_of("sphere_lambert", "lambert:kd=.15/.35/.6"),
      case_of("sphere_phong", "phong:kd=.15/.35/.6,ks=.4,n=20"),
      case_of("sphere_blinn_phong", "blinn-phong:kd=.15/.35/.6,ks=.4,n=50"),
      case_of("sphere_blinn_phong_normalised", "blinn-phong:kd=.15/.35/.6,ks=.1,n=50,normalised=1"),
      case_of("sphere_torrance_sparrow", "torrance-sparrow:kd=.15/.35/.6,D=blinn,n=20"),
      case_of("sphere_cook_torrance_copper", "cook-torrance:m=.5,F=copper"),
      case_of("sphere_cook_torrance_lecture", "cook-torrance:D=gaussian,m=.35,F=gold,form=lecture"),
      case_of("sphere_cook_torrance_ggx", "cook-torrance:D=ggx,a=.4,G=smith-correlated,F=silver"),
      case_of("sphere_cook_torrance_conductor",
              "cook-torrance:m=.5,G=none,F=conductor,eta=.3/1/1.2,k=3.2/2.6/2.4"),
      case_of("sphere_oren_nayar", "oren-nayar:rho=.7/.5/.4,sigma=.5"),
      case_of("sphere_oren_nayar_full", "oren-nayar-full:rho=.7/.5/.4,sigma=.5"),
      case_of("sphere_ward", "ward:kd=.1/.2/.4,rho=.2,ax=.1,ay=.4"),
      case_of("sphere_ashikhmin_shirley", "ashikhmin-shirley:rd=.2/.3/.5,rs=.3,nu=400,nv=20"),
      case_of("sphere_lafortune",
              "lafortune:rd=.2/.3/.5,lobe=(cx=-1,cz=1,n=20),lobe=(cx=.8,cz=.6,n=8/6/4)"),
      case_of("sphere_finished_wood", "finished-wood"),
      case_of("sphere_sum", "sum:(oren-nayar:rho=.1/.25/.4),(ward:rho=.3,ax=.1,ay=.3)"),
      case_of("sphere_clear_coat", "clear-coat:base=(oren-nayar:rho=.6/.1/.1,sigma=.4),a=.15"),
      case_of("sphere_house_paint", "material:blue-house-paint"),
      case_of("sphere_distribution", "distribution:D=ggx,a=.6"),
      case_of("sphere_fresnel", "fresnel:F=gold"),
      {"sphere_merl", rounding, [] { return table("merl", broad, models::tabulate_merl); }},
      // Its bins' borders lie where the arithmetic has them.
      {"sphere_merl_nearest",
       {1e-4f, 1e-4f, 19, "a bin's border moves by rounding"},
       [] { return table("merl", broad, models::tabulate_merl, ",lookup=nearest"); }},
      {"sphere_utia", rounding, [] { return table("utia", broad, models::tabulate_utia); }},
      {"lid_brushed_in_circles", rounding,
       [] {
         return brushed("cylinder:48", "cook-torrance:D=anisotropic-ggx,ax=.1,ay=.5,F=aluminium",
                        {.field = TangentField::around, .axis = {0, 1, 0}});
       }},
      {"sphere_brushed_along", rounding,
       [] {
         return brushed("sphere:24", "ward:rho=.5,kd=.1,ax=.05,ay=.4",
                        {.field = TangentField::along, .axis = {0, 1, 0}});
       }},
      {"plane_checker", rounding,
       [] { return brushed("plane:1", "lambert:kd=checker(count=8,a=.8/.7/.5,b=.1)", {}); }},
      {"sphere_noise", rounding,
       [] { return sphere("blinn-phong:kd=noise(a=.1/.2/.5,b=.9,scale=.4),n=noise(a=5,b=200)"); }},
      {"teapot_wooden", rounding,
       [] {
         return turned_teapot("finished-wood:kd=wood-colour(ring=.15),u=wood-fibre(curl=15)");
       }},
  };
}

}  // namespace scanlit::golden
