#pragma once

// Conversions between C++ values and plain JavaScript values. The members of a struct that cross the boundary
// are listed once, in `Fields`; the values of an enum once, in `Names`. Both directions of the conversion use
// these lists. Typed arrays are copied.

#include <emscripten/val.h>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/vec3.h"
#include "bind/typed_arrays.h"

namespace limber {

// Specialise with a member `list`: a std::tuple of `field` and `optionalField`.
template <class Struct>
struct Fields;

// Specialise with a member `list`: an array of the names of an enum's values, in their order; and a member
// `what`: the noun for such a value in messages.
template <class Enum>
struct Names;

template <class Struct, class Value>
struct Field {
  const char* name;
  Value Struct::* member;
  bool isOptional;
};

// A required member.
template <class Struct, class Value>
constexpr Field<Struct, Value> field(const char* name, Value Struct::* member) {
  return {name, member, false};
}

// An optional member, which keeps its default if JavaScript omits it.
template <class Struct, class Value>
constexpr Field<Struct, Value> optionalField(const char* name, Value Struct::* member) {
  return {name, member, true};
}

template <class T>
concept HasFields = requires { Fields<T>::list; };
template <class T>
concept HasNames = requires { Names<T>::list; };

// The conversion of a type, specialised for each kind of type.
template <class T>
struct Convert;

template <class T>
val toJs(const T& value) {
  return Convert<T>::toJs(value);
}

// Throws std::invalid_argument if `in` lacks a required field or has an unknown enum name.
template <class T>
T fromJs(const val& in) {
  return Convert<T>::fromJs(in);
}

// JavaScript has one type of number; integers of 64 bits are exact up to 2^53.
template <class T>
  requires std::is_arithmetic_v<T>
struct Convert<T> {
  static val toJs(T value) {
    if constexpr (sizeof(T) == 8)
      return val(static_cast<double>(value));
    else
      return val(value);
  }
  static T fromJs(const val& in) { return in.as<T>(); }
};

template <>
struct Convert<std::string> {
  static val toJs(const std::string& value) { return val(value); }
  static std::string fromJs(const val& in) { return in.as<std::string>(); }
};

template <HasNames Enum>
struct Convert<Enum> {
  static val toJs(Enum value) { return val(std::string(Names<Enum>::list[static_cast<size_t>(value)])); }
  static Enum fromJs(const val& in) {
    const auto name = in.as<std::string>();
    for (size_t i = 0; i < Names<Enum>::list.size(); ++i)
      if (name == Names<Enum>::list[i]) return static_cast<Enum>(i);
    throw std::invalid_argument("There is no " + std::string(Names<Enum>::what) + " \"" + name + "\": take " +
                                choices() + ".");
  }

 private:
  // "a, b or c"
  static std::string choices() {
    std::string all;
    const size_t count = Names<Enum>::list.size();
    for (size_t i = 0; i < count; ++i)
      all += (i == 0 ? "" : i + 1 == count ? " or " : ", ") + std::string(Names<Enum>::list[i]);
    return all;
  }
};

template <HasFields Struct>
struct Convert<Struct> {
  static val toJs(const Struct& value) {
    val out = val::object();
    std::apply(
        [&](const auto&... fields) { (out.set(fields.name, limber::toJs(value.*fields.member)), ...); },
        Fields<Struct>::list);
    return out;
  }
  static Struct fromJs(const val& in) {
    Struct out;
    std::apply([&](const auto&... fields) { (read(in, fields, out), ...); }, Fields<Struct>::list);
    return out;
  }

 private:
  template <class Value>
  static void read(const val& in, const Field<Struct, Value>& field, Struct& out) {
    const val value = in[field.name];
    if (!value.isUndefined())
      out.*field.member = limber::fromJs<Value>(value);
    else if (!field.isOptional)
      throw std::invalid_argument("The core was called without \"" + std::string(field.name) + "\".");
  }
};

// An empty optional is null in JavaScript.
template <class T>
struct Convert<std::optional<T>> {
  static val toJs(const std::optional<T>& value) { return value ? limber::toJs(*value) : val::null(); }
  static std::optional<T> fromJs(const val& in) {
    if (in.isNull() || in.isUndefined()) return std::nullopt;
    return limber::fromJs<T>(in);
  }
};

// A typed array.
template <class T>
  requires std::is_arithmetic_v<T>
struct Convert<std::vector<T>> {
  static val toJs(const std::vector<T>& values) { return typedArray(values); }
  static std::vector<T> fromJs(const val& in) { return vectorOf<T>(in); }
};

// An array of objects.
template <class T>
  requires(!std::is_arithmetic_v<T>)
struct Convert<std::vector<T>> {
  static val toJs(const std::vector<T>& values) {
    val out = val::array();
    for (const T& value : values) out.call<void>("push", limber::toJs(value));
    return out;
  }
  static std::vector<T> fromJs(const val& in) {
    std::vector<T> out;
    const auto count = in["length"].as<uint32_t>();
    out.reserve(count);
    for (uint32_t i = 0; i < count; ++i) out.push_back(limber::fromJs<T>(in[i]));
    return out;
  }
};

// [x, y, z]
template <>
struct Convert<Vec3> {
  static val toJs(const Vec3& v) {
    val out = val::array();
    for (int c = 0; c < 3; ++c) out.set(c, v[c]);
    return out;
  }
  static Vec3 fromJs(const val& in) { return {in[0].as<double>(), in[1].as<double>(), in[2].as<double>()}; }
};

}  // namespace limber
