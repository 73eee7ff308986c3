// The grammar of specifications: parentheses, keys, nested models.
#include "models/specification.h"

#include <gtest/gtest.h>

#include "tests/unit/model_queries.h"

namespace scanlit::models {
namespace {

using test::error_of;

/// "name[key=value][=value]": what was understood.
std::string read(const Specification& specification) {
  std::string result = specification.name;
  for (const auto& [key, value] : specification.arguments) result += '[' + key + '=' + value + ']';
  return result;
}

TEST(Specification, KeysAndValues) {
  EXPECT_EQ(read(parse_specification("phong")), "phong");
  EXPECT_EQ(read(parse_specification("phong:kd=1,n=2")), "phong[kd=1][n=2]");
  EXPECT_EQ(read(parse_specification("phong:")), "phong[=]");
  EXPECT_EQ(read(parse_specification("material:copper,m=.2")), "material[=copper][m=.2]");
  EXPECT_EQ(read(parse_specification("a:k=x=y")), "a[k=x=y]") << "the first = divides";
  EXPECT_EQ(read(parse_specification("a:=1")), "a[==1]");
}

TEST(Specification, ParenthesesHoldTogether) {
  EXPECT_EQ(read(parse_specification("sum:(a:x=1,y=2),(b)")), "sum[=(a:x=1,y=2)][=(b)]");
  EXPECT_EQ(read(parse_specification("c:base=(s:(a),(b:k=f(1,2))),e=1")),
            "c[base=(s:(a),(b:k=f(1,2)))][e=1]");
  EXPECT_EQ(read(parse_call("image(a,b.png,space=linear)")), "image[=a][=b.png][space=linear]");
  EXPECT_EQ(read(parse_call("vertex-colour")), "vertex-colour");
  EXPECT_EQ(read(parse_call("noise()")), "noise");
  EXPECT_EQ(without_parentheses("(a:(b))"), "a:(b)");
  EXPECT_EQ(without_parentheses("(a)+(b)"), "(a)+(b)");
  EXPECT_EQ(without_parentheses("a"), "a");
  EXPECT_EQ(without_parentheses("("), "(");
}

TEST(Specification, ParenthesesWithoutPartner) {
  for (const char* text : {"phong:kd=(1", "phong:kd=1)", ")(", "phong:kd=checker(a=1"})
    EXPECT_EQ(error_of(text), "'" + std::string(text) + "': a parenthesis has no partner");
  EXPECT_EQ(error_of("phong:kd=checker(a=1)2"),
            "'checker(a=1)2': there is text after the last parenthesis");
}

TEST(Specification, ModelsAreNotMadeOfParts) {
  EXPECT_EQ(error_of("sum:(lambert),(fresnel)"),
            "model 'sum': 'fresnel' is a part of models and reflects nothing");
  EXPECT_EQ(error_of("clear-coat:base=(distribution:m=.2)"),
            "model 'clear-coat': 'distribution' is a part of models and reflects nothing");
}

TEST(Specification, Choices) {
  EXPECT_EQ(std::get<std::string>(value_of(make("blinn-phong:normalised=1").values, "normalised")),
            "1");
  EXPECT_EQ(error_of("blinn-phong:normalised=2"),
            "model 'blinn-phong': 'normalised' cannot be '2'; there are: 0, 1");
}

TEST(Specification, Inputs) {
  EXPECT_EQ(error_of("lambert:kd=checker"), "no error");
  EXPECT_EQ(error_of("lambert:kd=checker(count=4,a=.5/.1/.1)"), "no error");
  EXPECT_EQ(error_of("lambert:kd=cheker(count=4)"),
            "unknown input 'cheker'; did you mean 'checker'?");
  EXPECT_EQ(error_of("lambert:kd=checker(size=4)"),
            "model 'lambert', checker: unknown parameter 'size'; there are: a, b, count");
  EXPECT_EQ(error_of("lambert:kd=checker(count=0)"),
            "model 'lambert', checker: 'count' wants a number from 0.01 to 10000, not 0");
  EXPECT_EQ(error_of("lambert:kd=checker(count=checker)"),
            "model 'lambert', checker: 'count' cannot vary; it wants one value, not 'checker'");
  EXPECT_EQ(error_of("blinn-phong:normalised=checker"),
            "model 'blinn-phong': 'normalised' cannot vary; it wants one value, not 'checker'");
}

}  // namespace
}  // namespace scanlit::models
