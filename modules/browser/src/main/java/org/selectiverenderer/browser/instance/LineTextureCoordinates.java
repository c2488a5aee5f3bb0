package org.selectiverenderer.browser.instance;

import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Adds texture coordinates to line meshes: the distance along the line, so that a dash pattern
 * continues around corners, or a mark of the line's ends, where arrows are drawn.
 */
final class LineTextureCoordinates {
  private LineTextureCoordinates() {}

  /**
   * Returns the lines with the distance from the beginning of the line as the first texture
   * coordinate of each vertex. Lines have no textures (X3D 4.0, 11.2.3), so that texture
   * coordinates are free for this use.
   *
   * @param lines a line mesh whose indices are the end points of segments, those of one line in
   *     sequence
   */
  static Mesh measure(Mesh lines) {
    return marked(lines, false);
  }

  /**
   * Returns the lines with a first texture coordinate of -1 at the first vertex of a line, 1 at the
   * last and 0 in between.
   */
  static Mesh ends(Mesh lines) {
    return marked(lines, true);
  }

  private static Mesh marked(Mesh lines, boolean endsOnly) {
    int[] ends = lines.indices();
    int[] source = new int[ends.length];
    float[] lengths = new float[2 * ends.length];
    int[] indices = new int[ends.length];
    int count = 0;
    for (int i = 0; i + 1 < ends.length; i += 2) {
      if (i == 0 || ends[i] != ends[i - 1]) {
        lengths[2 * count] = endsOnly ? -1 : 0;
        source[count++] = ends[i];
      }
      source[count] = ends[i + 1];
      boolean last = i + 2 >= ends.length || ends[i + 2] != ends[i + 1];
      lengths[2 * count] =
          endsOnly
              ? last ? 1 : 0
              : lengths[2 * (count - 1)] + distance(lines.positions(), ends[i], ends[i + 1]);
      indices[i] = count - 1;
      indices[i + 1] = count++;
    }
    return new Mesh(
        lines.primitive(),
        pick(lines.positions(), 3, source, count),
        lines.normals() == null ? null : pick(lines.normals(), 3, source, count),
        lines.colors() == null ? null : pick(lines.colors(), 4, source, count),
        Arrays.copyOf(lengths, 2 * count),
        attributes(lines, source, count),
        indices,
        lines.solid(),
        lines.bounds());
  }

  /** Copies the other attributes: fog depths and vertex attributes for shader programs. */
  private static List<Mesh.TexCoords> attributes(Mesh lines, int[] source, int count) {
    return lines.moreTexCoords().stream()
        .map(
            more ->
                new Mesh.TexCoords(
                    more.components(),
                    pick(more.values(), more.components(), source, count),
                    more.name()))
        .toList();
  }

  private static float distance(float[] positions, int from, int to) {
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      double d = positions[3 * to + axis] - positions[3 * from + axis];
      sum += d * d;
    }
    return (float) Math.sqrt(sum);
  }

  private static float[] pick(float[] values, int size, int[] source, int count) {
    float[] picked = new float[size * count];
    for (int i = 0; i < count; i++) {
      System.arraycopy(values, size * source[i], picked, size * i, size);
    }
    return picked;
  }

  /**
   * Returns the mesh of a shape, with distances if its lines are dashed and with marked ends if
   * they have arrows.
   */
  static @Nullable Mesh of(@Nullable Mesh mesh, DrawProperties stroke) {
    DrawProperties.Line line = stroke.line();
    if (mesh == null
        || mesh.primitive() != Mesh.Primitive.LINES
        || line == null
        || line.type() == 1) {
      return mesh;
    }
    return line.ended() ? ends(mesh) : measure(mesh);
  }
}
