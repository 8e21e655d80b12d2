#pragma once

#include "bind/convert.h"
#include "elastic/material.h"

namespace limber {

template <>
struct Fields<ElasticMaterial> {
  static constexpr auto list =
      std::tuple(field("young", &ElasticMaterial::young), field("poisson", &ElasticMaterial::poisson),
                 field("density", &ElasticMaterial::density), field("thickness", &ElasticMaterial::thickness),
                 field("unit", &ElasticMaterial::unit));
};

}  // namespace limber
