#pragma once

namespace limber {

// An isotropic elastic sheet, SI units.
struct Sheet {
  double young, poisson, thickness;
  double stretching() const { return young * thickness; }  // N/m
  double bending() const {                                 // N m
    return young * thickness * thickness * thickness / (12 * (1 - poisson * poisson));
  }
};

}  // namespace limber
