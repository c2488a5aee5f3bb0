package org.selectiverenderer.x3d.tessellate;

import org.jspecify.annotations.Nullable;

/**
 * An indexed vertex attribute: colours, normals, texture coordinates or others, and the index of
 * each corner.
 *
 * @param values the tuples
 * @param components floats per tuple
 * @param ids the tuple index of each corner; null if it equals the index of the corner's point
 * @param name the name of an attribute for shader programs, else empty
 */
record VertexAttribute(float[] values, int components, int @Nullable [] ids, String name) {

  VertexAttribute(float[] values, int components, int @Nullable [] ids) {
    this(values, components, ids, "");
  }

  int count() {
    return values.length / components;
  }
}
