#include <string>
#include <vector>

#include "lessons/assignments/judge/registry.h"
#include "rasterizer/error.h"

namespace scanlit::assignments {

const std::vector<Assignment>& assignments() {
  static const std::vector<Assignment> all{
      a1_scan_conversion(),  //
      a2_clipping(),         //
      a3_visibility(),       //
      a4_shading(),          //
      a5_phong(),            //
      a6_cook_torrance(),    //
      a7_third_model(),      //
      a8_less_work(),        //
      a9_mutant_hunt(),      //
  };
  return all;
}

const Assignment& assignment(const std::string& id) {
  std::vector<std::string> ids;
  for (const Assignment& each : assignments()) {
    if (each.id == id) return each;
    ids.push_back(each.id);
  }
  throw Error("unknown assignment '" + id + "'" + did_you_mean(id, ids));
}

}  // namespace scanlit::assignments
