// A1: what is asked, and what is said about the answers.
#include <algorithm>
#include <set>

#include "lessons/assignments/A1_scan_conversion/reference.h"
#include "lessons/assignments/judge/dice.h"
#include "lessons/assignments/judge/judged_picture.h"
#include "lessons/assignments/judge/registry.h"
#include "models/registry.h"
#include "rasterizer/shapes.h"

namespace scanlit::assignments {
namespace {

using namespace a1;

enum Kind { ask_edge = 1, ask_owns, ask_covers, ask_span, ask_scan_convert };  // as in main.cpp

std::string words(Point p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }
std::string words(const Triangle& t) {
  return words(t.corners[0]) + " " + words(t.corners[1]) + " " + words(t.corners[2]);
}

void put(const Edge& e, std::vector<std::int64_t>& to) {
  to.insert(to.end(), {e.a, e.b, e.c, e.owned});
}
void put(const Edge (&edges)[3], std::vector<std::int64_t>& to) {
  for (const Edge& e : edges) put(e, to);
}
void put(const Triangle& t, std::vector<std::int64_t>& to) {
  for (const Point& p : t.corners) to.insert(to.end(), {p.x, p.y});
}

/// Corners on a raster of half pixels: many centres lie exactly on edges, and at corners.
Triangle coarse_triangle(Dice& dice, int low, int high) {
  Triangle t;
  for (Point& p : t.corners) p = {128 * dice.between(low, high), 128 * dice.between(low, high)};
  return t;
}

/// As coarse_triangle(), with an area, and with its edges.
Triangle with_edges(Dice& dice, const ScanVariant& variant, int low, int high, Edge (&edges)[3]) {
  for (;;) {
    const Triangle t = coarse_triangle(dice, low, high);
    if (right_edges(variant, t, edges)) return t;
  }
}

// -------------------------------------------------------------------------------------- A1.1, A1.2

Finding test_edge(Examination& e) {
  Dice dice(e.questions, "A1.1");
  for (int i = 0; i < 60; ++i) {
    // The largest come to 2^50: what is computed in 32 bits, or in float, is wrong there.
    const int size = i < 30 ? 2560 : (1 << 24) - 1;
    Triangle t;
    Edge right;
    do {
      for (Point& p : t.corners) p = {dice.between(-size, size), dice.between(-size, size)};
      right = right_edge(t.corners[0], t.corners[1], t.corners[2]);
    } while (right.a * t.corners[2].x + right.b * t.corners[2].y + right.c == 0);
    Numbers question;
    put(t, question.integers);
    const auto got = e.student.ask(ask_edge, question, AnswerSize::integers(4)).integers;
    if (got[0] == right.a && got[1] == right.b && got[2] == right.c) continue;
    const auto coefficients = [](std::int64_t a, std::int64_t b, std::int64_t c) {
      return "a = " + std::to_string(a) + ", b = " + std::to_string(b) +
             ", c = " + std::to_string(c);
    };
    std::string why;
    if (got[0] == -right.a && got[1] == -right.b && got[2] == -right.c)
      why = "\nThe sign is wrong: E must be positive at the third corner.";
    else if (i >= 30)
      why = "\nSmall triangles were right: do the products fit into 64 bits all the way?";
    return Finding::wrong("edge(" + words(t.corners[0]) + ", " + words(t.corners[1]) + ", third " +
                          words(t.corners[2]) +
                          ")\n  yours:     " + coefficients(got[0], got[1], got[2]) +
                          "\n  should be: " + coefficients(right.a, right.b, right.c) + why);
  }
  return {};
}

std::string kind_of(const ScanVariant& variant, const Edge& edge) {
  if (edge.a != 0)
    return edge.a > 0 ? "a left edge (the triangle lies to its right)"
                      : "a right edge (the triangle lies to its left)";
  return (edge.b > 0) != variant.y_up ? "a horizontal top edge (the triangle lies below it)"
                                      : "a horizontal bottom edge (the triangle lies above it)";
}

std::string rule_of(const ScanVariant& variant) {
  return std::string(variant.owns_top ? "top" : "bottom") + "-" +
         (variant.owns_left ? "left" : "right");
}

Finding test_owns(Examination& e) {
  const ScanVariant variant = scan_variant(e.variant);
  Dice dice(e.questions, "A1.2");
  for (int i = 0; i < 64; ++i) {
    // First the eight winds, then edges of any slope, many of them almost horizontal or vertical.
    static constexpr int winds[8][2] = {{1, 0}, {0, 1},  {-1, 0},  {0, -1},
                                        {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    const auto any = [&] { return dice.between(-3, 3) * (dice.coin() ? 1 : 10000); };
    Edge edge{256 * any(), 256 * any(), dice.between(-100000, 100000)};
    if (i < 8) edge = {256 * winds[i][0], 256 * winds[i][1], edge.c};
    if (edge.a == 0 && edge.b == 0) continue;
    Numbers question;
    put(edge, question.integers);
    const bool got = e.student.ask(ask_owns, question, AnswerSize::integers(1)).integers[0] != 0;
    if (got == right_owns(variant, edge)) continue;
    return Finding::wrong(
        "The edge E(p) = " + std::to_string(edge.a) + " x + " + std::to_string(edge.b) + " y + " +
        std::to_string(edge.c) + " is " + kind_of(variant, edge) + ".\nBy the " + rule_of(variant) +
        " rule its points " + (got ? "are not" : "are") +
        " the triangle's; your owns() says that they " + (got ? "are." : "are not."));
  }
  return {};
}

// -------------------------------------------------------------------------------------- A1.3, A1.4

Finding test_covers(Examination& e) {
  const ScanVariant variant = scan_variant(e.variant);
  Dice dice(e.questions, "A1.3");
  constexpr int size = 9;
  for (int i = 0; i < 12; ++i) {
    Edge edges[3];
    const Triangle t = with_edges(dice, variant, 0, 2 * size - 1, edges);
    CoverageGrid grid(size, size);
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) {
        Numbers question;
        put(edges, question.integers);
        question.integers.insert(question.integers.end(), {column, row});
        const auto got = e.student.ask(ask_covers, question, AnswerSize::integers(1)).integers[0];
        grid.covered[grid.at(column, engine_row(variant, row, size))] = got != 0;
        grid.expected[grid.at(column, engine_row(variant, row, size))] =
            right_covers(variant, edges, column, row);
      }
    const std::string faults = draw_faults(grid, variant.y_up);
    if (!faults.empty())
      return Finding::wrong("The triangle " + words(t) + " by your covers(), pixel by pixel:\n" +
                            faults);
  }
  return {};
}

Finding wrong_span(const Triangle& t, int row, const Span& got, const Span& right) {
  const auto span = [](const Span& s) {
    return s.begin < s.end
               ? "columns " + std::to_string(s.begin) + " to " + std::to_string(s.end - 1) +
                     " (begin " + std::to_string(s.begin) + ", end " + std::to_string(s.end) + ")"
               : std::string("no column (end <= begin)");
  };
  return Finding::wrong("The triangle " + words(t) + ", row " + std::to_string(row) +
                        ":\n  yours:     " + span(got) + "\n  should be: " + span(right));
}

Finding test_span(Examination& e) {
  const ScanVariant variant = scan_variant(e.variant);
  Dice dice(e.questions, "A1.4");
  for (int i = 0; i < 40; ++i) {
    const bool large = i >= 30;  // far beyond the picture
    const int width = large ? 5000 : dice.between(6, 30), height = large ? 40 : 20;
    Edge edges[3];
    const Triangle t = large ? with_edges(dice, variant, -100000, 100000, edges)
                             : with_edges(dice, variant, i < 15 ? 0 : -20, i < 15 ? 12 : 50, edges);
    CoverageGrid grid(width, height);
    for (int row = 0; row < height; ++row) {
      Numbers question;
      put(edges, question.integers);
      question.integers.insert(question.integers.end(), {row, width});
      const auto answer = e.student.ask(ask_span, question, AnswerSize::integers(2)).integers;
      const Span right = right_span(variant, edges, row, width);
      const Span got{int(std::clamp(answer[0], std::int64_t(-1 << 30), std::int64_t(1 << 30))),
                     int(std::clamp(answer[1], std::int64_t(-1 << 30), std::int64_t(1 << 30)))};
      const bool empty = got.begin >= got.end && right.begin >= right.end;
      if (empty || (got.begin == right.begin && got.end == right.end)) continue;
      Finding finding = wrong_span(t, row, got, right);
      if (got.begin < got.end && (got.begin < 0 || got.end > width))
        finding.message +=
            "\nThat leaves the picture, whose columns are 0 to " + std::to_string(width - 1) + ".";
      return finding;
    }
  }
  return {};
}

// -------------------------------------------------------------------------------------- A1.5, A1.6

/// What the student's scan_convert() asks back, while it is judged alone.
Numbers right_answer(const ScanVariant& variant, int kind, const Numbers& question) {
  const auto& n = question.integers;
  constexpr std::size_t counts[] = {0, 6, 4, 14, 14};
  if (kind < ask_edge || kind > ask_span || n.size() != counts[kind])
    throw Unanswered("your program asked back for what there is not");
  Numbers answer;
  Edge edges[3];
  for (std::size_t i = 0; i < 3 && kind >= ask_covers; ++i)
    edges[i] = {n[4 * i], n[4 * i + 1], n[4 * i + 2], n[4 * i + 3] != 0};
  switch (kind) {
    case ask_edge:
      put(right_edge({n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}), answer.integers);
      break;
    case ask_owns: answer.integers = {right_owns(variant, {n[0], n[1], n[2]})}; break;
    case ask_covers:
      answer.integers = {right_covers(variant, edges, int(n[12]), int(n[13]))};
      break;
    default: {
      const Span span = right_span(variant, edges, int(n[12]), int(n[13]));
      answer.integers = {span.begin, span.end};
    }
  }
  return answer;
}

/// Fragments of the student's scan_convert(): with the judge's own earlier stages, or with all the
/// student's. At most four times as many as the picture has pixels.
std::vector<Fragment> ask_fragments(Respondent& student, const ScanVariant& variant,
                                    const Triangle& t, const Picture& picture, bool alone) {
  Numbers question{.integers = {alone, picture.width, picture.height}, .reals = {}};
  put(t, question.integers);
  const auto most = std::size_t(8) * std::size_t(picture.width * picture.height);
  const auto counsel = [&](int kind, const Numbers& asked) {
    return right_answer(variant, kind, asked);
  };
  const auto n = student
                     .ask(ask_scan_convert, question, {.most_integers = most},
                          alone ? Counsel(counsel) : Counsel())
                     .integers;
  std::vector<Fragment> fragments;
  for (std::size_t i = 0; i + 1 < n.size(); i += 2) {
    const auto limited = [](std::int64_t x) {
      return int(std::clamp(x, std::int64_t(-1 << 30), std::int64_t(1 << 30)));
    };
    fragments.push_back({limited(n[i]), limited(n[i + 1])});
  }
  return fragments;
}

std::string outside(const Fragment& f, const Picture& picture) {
  if (f.column >= 0 && f.column < picture.width && f.row >= 0 && f.row < picture.height) return "";
  return "the fragment at column " + std::to_string(f.column) + ", row " + std::to_string(f.row) +
         " lies outside of the picture of " + std::to_string(picture.width) + " x " +
         std::to_string(picture.height) + " pixels";
}

/// Triangles around a point, which together cover what each of their outer edges bounds: every
/// pixel in the middle once, whatever the rule.
std::vector<Triangle> fan(Dice& dice, int size) {
  const int count = dice.between(3, 9);
  const Point middle{128 * dice.between(size - 4, size + 4),
                     128 * dice.between(size - 4, size + 4)};
  const int corners[8][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  std::vector<Point> around;
  for (int i = 0; i < 8 && int(around.size()) < count; ++i)
    around.push_back({128 * (size * corners[i][0] + dice.between(-2, 2)),
                      128 * (size * corners[i][1] + dice.between(-2, 2))});
  std::vector<Triangle> all;
  for (std::size_t i = 0; i < around.size(); ++i)
    all.push_back({{middle, around[i], around[(i + 1) % around.size()]}});
  return all;
}

Finding test_group(Examination& e, const std::vector<Triangle>& group, const Picture& picture,
                   const std::string& what) {
  const ScanVariant variant = scan_variant(e.variant);
  CoverageGrid grid(picture.width, picture.height);
  for (const Triangle& t : group) {
    const auto at = [&](const Fragment& f) {
      return grid.at(f.column, engine_row(variant, f.row, picture.height));
    };
    for (const Fragment& f : right_fragments(variant, t, picture)) ++grid.expected[at(f)];
    for (const Fragment& f : ask_fragments(e.student, variant, t, picture, true)) {
      const std::string where = outside(f, picture);
      if (!where.empty()) return Finding::wrong("The triangle " + words(t) + ": " + where + ".");
      ++grid.covered[at(f)];
    }
  }
  const std::string faults = draw_faults(grid, variant.y_up);
  return faults.empty() ? Finding() : Finding::wrong(what + ":\n" + faults);
}

Finding test_scan_convert(Examination& e) {
  Dice dice(e.questions, "A1.5");
  for (int i = 0; i < 24; ++i) {
    const Picture picture{dice.between(8, 40), dice.between(8, 20)};
    const Triangle t = i < 12 ? coarse_triangle(dice, 0, 24) : coarse_triangle(dice, -30, 90);
    const Finding finding = test_group(e, {t}, picture, "The triangle " + words(t));
    if (finding.share < 1) return finding;
  }
  for (int i = 0; i < 6; ++i) {
    const auto group = fan(dice, 16);
    std::string what = std::to_string(group.size()) + " triangles around the point " +
                       words(group[0].corners[0]) +
                       ", which share edges: each pixel belongs to one of them";
    const Finding finding = test_group(e, group, {20, 20}, what);
    if (finding.share < 1) return finding;
  }
  return {};
}

constexpr int picture_width = 160, picture_height = 120;

Scene teapot_scene() {
  Scene scene;
  Object& teapot = scene.objects.emplace_back();
  teapot.mesh = std::make_shared<const Mesh>(make_shape("teapot:4"));
  teapot.material.model = models::make("blinn-phong:kd=.55/.35/.2,ks=.4,n=30").model;
  teapot.shading = Shading::gouraud;
  teapot.sides = Sides::front;
  scene.lights.emplace_back().direction = {1, 2, 3};
  scene.background = {0.02, 0.03, 0.06};
  return scene;
}

Framebuffer teapot_by(decltype(StageFunctions::spans) spans) {
  const Scene scene = teapot_scene();
  Camera camera;
  camera.eye = {1.5, 3, 6};
  camera = framed(camera, bounding_sphere(scene), double(picture_width) / picture_height);
  camera.fov_deg = 25;  // the handle and the spout leave the picture
  StageFunctions stages;
  stages.spans = std::move(spans);
  RenderSettings settings;
  settings.stages = &stages;
  Framebuffer framebuffer(picture_width, picture_height, {.ids = true});
  render(scene, camera, settings, framebuffer);
  return framebuffer;
}

Framebuffer right_teapot(const ScanVariant& variant) {
  return teapot_by([&](const ScreenTriangle& t, const Rect&, const EmitSpan& emit) {
    for (const Fragment& f : right_fragments(variant, in_variant(variant, t, picture_height),
                                             {picture_width, picture_height}))
      emit(engine_row(variant, f.row, picture_height), f.column, f.column + 1);
  });
}

/// Each triangle's box: what the starter draws.
Framebuffer box_teapot() {
  return teapot_by([](const ScreenTriangle& t, const Rect& picture, const EmitSpan& emit) {
    const auto& [a, b, c] = t.vertices;
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    for (int y = std::max(top >> 8, 0); y <= std::min(bottom >> 8, picture.y_end - 1); ++y)
      emit(y, left >> 8, (right >> 8) + 1);
  });
}

std::string what_is_there(const Framebuffer& picture, std::size_t pixel) {
  return picture.triangle_id[pixel] == no_id
             ? "the background"
             : "triangle " + std::to_string(picture.triangle_id[pixel]);
}

Finding test_picture(Examination& e) {
  const ScanVariant variant = scan_variant(e.variant);
  const Picture picture{picture_width, picture_height};
  std::string complaint;
  const Framebuffer fresh =
      teapot_by([&](const ScreenTriangle& screen, const Rect&, const EmitSpan& emit) {
        const Triangle t = in_variant(variant, screen, picture_height);
        std::set<std::pair<int, int>> seen;
        for (const Fragment& f : ask_fragments(e.student, variant, t, picture, false)) {
          const std::string where = outside(f, picture);
          if (!where.empty() && complaint.empty())
            complaint = "The triangle " + words(t) + ": " + where + ".";
          if (!seen.insert({f.row, f.column}).second && complaint.empty())
            complaint = "The triangle " + words(t) + " has two fragments at column " +
                        std::to_string(f.column) + ", row " + std::to_string(f.row) + ".";
          emit(engine_row(variant, f.row, picture_height), f.column, f.column + 1);
        }
      });
  const Framebuffer reference = right_teapot(variant);
  e.pictures.push_back(judged("A1.6-teapot", "A teapot of your fragments", fresh, reference));
  if (const auto off = first_difference(e.pictures.back(), 0)) {
    const auto pixel = std::size_t(off->y * picture_width + off->x);
    const int row = engine_row(variant, off->y, picture_height);
    complaint = std::to_string(off->count) + " pixels differ, first that at column " +
                std::to_string(off->x) + ", row " + std::to_string(row) +
                ":\n  yours:     " + what_is_there(fresh, pixel) +
                "\n  should be: " + what_is_there(reference, pixel) +
                (complaint.empty() ? "" : "\n" + complaint);
  }
  return complaint.empty() ? Finding() : Finding::wrong(complaint);
}

// ----------------------------------------------------------------------------------------- the
// page

/// A triangle with centres on its edges, as the variant covers it.
std::string example(const ScanVariant& variant) {
  const int height = 6;
  const int shift = variant.centre();
  const Triangle t{
      {{shift + 256, shift + 256}, {shift + 256 * 7, shift + 256}, {shift + 256, shift + 256 * 4}}};
  std::vector<std::string> rows(std::size_t(height), std::string(9, '.'));
  for (const Fragment& f : right_fragments(variant, t, {9, height}))
    rows[std::size_t(engine_row(variant, f.row, height))][std::size_t(f.column)] = '#';
  std::string text = "The triangle " + words(t) + " covers\n\n";
  for (int y = 0; y < height; ++y)
    text += "    row " + std::to_string(engine_row(variant, y, height)) + "  " +
            rows[std::size_t(y)] + "\n";
  return text;
}

Words words_of(std::uint64_t seed) {
  const ScanVariant v = scan_variant(seed);
  const auto truth = [](bool b) { return std::string(b ? "true" : "false"); };
  return {
      {"y_up", truth(v.y_up)},
      {"owns_left", truth(v.owns_left)},
      {"owns_top", truth(v.owns_top)},
      {"centre_256", std::to_string(v.centre())},
      {"centre", v.centres_at_integers ? "(i, j)" : "(i + 1/2, j + 1/2)"},
      {"centre in 1/256", v.centres_at_integers ? "(256 i, 256 j)" : "(256 i + 128, 256 j + 128)"},
      {"y", v.y_up ? "up" : "down"},
      {"row 0", v.y_up ? "at the bottom" : "on top"},
      {"rule", rule_of(v)},
      {"side", v.owns_left ? "left" : "right"},
      {"other side", v.owns_left ? "right" : "left"},
      {"end", v.owns_top ? "top" : "bottom"},
      {"beyond", v.owns_top ? "below" : "above"},
      {"example", example(v)}};
}

}  // namespace

Assignment a1_scan_conversion() {
  return {.id = "A1",
          .title = "Scan conversion",
          .folder = "A1_scan_conversion",
          .file = "scan_conversion.cpp",
          .header = "scan_conversion.h",
          .words = words_of,
          .illustrations =
              [](std::uint64_t seed) {
                const auto shown = [](const Framebuffer& f) { return judged("", "", f, f); };
                return std::map<std::string, JudgedPicture>{
                    {"before.png", shown(box_teapot())},
                    {"after.png", shown(right_teapot(scan_variant(seed)))}};
              },
          .parts = {{"A1.1", "Edge function", test_edge},
                    {"A1.2", "Fill rule", test_owns},
                    {"A1.3", "Coverage of a pixel", test_covers},
                    {"A1.4", "Spans", test_span},
                    {"A1.5", "Scan conversion", test_scan_convert},
                    {"A1.6", "The picture", test_picture}}};
}

}  // namespace scanlit::assignments
