package org.selectiverenderer.geometry.tessellate;

import org.jspecify.annotations.Nullable;

/**
 * Colours, normals, texture coordinates or others and which of them each corner takes.
 *
 * @param values the tuples one after the other
 * @param components floats per tuple
 * @param ids the tuple of each corner; null when the corner takes the tuple of its point's number
 * @param name of an attribute for programs of shaders, else empty
 */
record VertexAttribute(float[] values, int components, int @Nullable [] ids, String name) {

  VertexAttribute(float[] values, int components, int @Nullable [] ids) {
    this(values, components, ids, "");
  }

  int count() {
    return values.length / components;
  }
}
