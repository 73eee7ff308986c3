// What `scanlit tradeoff` sweeps, one thing at a time, all else being the default (study_scene.h).
// A further axis is a function that returns what it measured, and a line in axes.cpp.
#pragma once

#include <string>
#include <vector>

#include "lessons/studio/tradeoff/measurement.h"

namespace scanlit::studio {

struct AxisResult {
  std::string name;   // as on the command line
  std::string title;  // of its plot
  std::string truth;  // what the error is measured against
  std::vector<Measured> points;
};

struct StudyAxis {
  std::string name, title, truth;
  double share;  // of the time that all axes take together, roughly
  std::vector<Measured> (*run)(const Progress&);
};
const std::vector<StudyAxis>& study_axes();

// Flat, Gouraud and Phong shading of meshes from coarse to fine.
std::vector<Measured> sweep_teapot(const Progress&);
std::vector<Measured> sweep_sphere(const Progress&);
// Double, float and vectors; a fast power; normals left as they are interpolated.
std::vector<Measured> sweep_arithmetic(const Progress&);
// Divisions by w: at every pixel, every 8, every 16, none.
std::vector<Measured> sweep_perspective(const Progress&);
// RenderSettings::tolerance, from 0 (all is evaluated) to 8 steps.
std::vector<Measured> sweep_tolerance(const Progress&);
// A metal's reflectance: spectral, at three wavelengths, fitted, by Schlick's formula.
std::vector<Measured> sweep_fresnel(const Progress&);
// A model and tables of it.
std::vector<Measured> sweep_tables(const Progress&);

}  // namespace scanlit::studio
