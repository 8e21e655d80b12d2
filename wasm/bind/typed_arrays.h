#pragma once

// Copies JavaScript typed arrays in and out.

#include <emscripten/val.h>

#include <cstddef>
#include <vector>

namespace limber {

using emscripten::val;

template <typename T>
std::vector<T> vectorOf(const val& array) {
  return emscripten::convertJSArrayToNumberVector<T>(array);
}

// A copy in JavaScript's own memory. `slice` copies shared memory into a plain buffer.
template <typename T>
val typedArray(const std::vector<T>& values) {
  return val(emscripten::typed_memory_view(values.size(), values.data())).template call<val>("slice");
}

// Copies a typed array to `target`, which has room for its `count` elements.
template <typename T>
void copyTo(T* target, size_t count, const val& array) {
  val(emscripten::typed_memory_view(count, target)).template call<void>("set", array);
}

}  // namespace limber
