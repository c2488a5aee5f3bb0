package org.selectiverenderer.geometry.tessellate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * What a geometry's {@code attrib} gives the programs of shaders, a tuple for each point (X3D 4.0,
 * 31.4.2, 31.4.3, 31.4.4), and its {@code fogCoord} (24.4.2). A matrix is several attributes, one
 * for each column.
 */
final class ProgramAttributes {
  /**
   * Columns of all attributes of a geometry, with its further texture coordinates: what every
   * graphics card takes beside the others.
   */
  static final int MOST = 12;

  private final TessellationJob job;
  private final int points;
  private final int room;
  private final List<VertexAttribute> found = new ArrayList<>();

  private ProgramAttributes(TessellationJob job, int points, int room) {
    this.job = job;
    this.points = points;
    this.room = room;
  }

  /**
   * @param corners the point of each corner
   * @param before how many columns of other kinds there are
   */
  static List<VertexAttribute> of(TessellationJob job, int[] corners, int before) {
    NodeView node = job.node();
    if (node.type().field("attrib").isEmpty()
        || (node.nodes("attrib").isEmpty() && node.node("fogCoord") == null)) {
      return List.of();
    }
    int points = Arrays.stream(corners).max().orElse(-1) + 1;
    ProgramAttributes all = new ProgramAttributes(job, points, MOST - before);
    NodeView fog = node.node("fogCoord");
    if (fog != null && fog.type().name().equals("FogCoordinate")) {
      all.add("fogCoord", Mesh.FOG_DEPTH, toTheLast(fog.floats("depth"), points), 1, 1);
    }
    node.nodes("attrib").forEach(all::add);
    return all.found;
  }

  /** Points that have no depth of their own have the last that is given. */
  private static float[] toTheLast(float[] depths, int points) {
    if (depths.length == 0 || depths.length >= points) {
      return depths;
    }
    float[] all = Arrays.copyOf(depths, points);
    Arrays.fill(all, depths.length, points, depths[depths.length - 1]);
    return all;
  }

  private void add(NodeView attribute) {
    switch (attribute.type().name()) {
      case "FloatVertexAttribute" ->
          add(attribute, Math.max(1, Math.min(4, attribute.integer("numComponents"))), 1);
      case "Matrix3VertexAttribute" -> add(attribute, 3, 3);
      case "Matrix4VertexAttribute" -> add(attribute, 4, 4);
      default -> {
        // No attribute: the reader has said so.
      }
    }
  }

  private void add(NodeView attribute, int rows, int columns) {
    String name = attribute.string("name");
    add("attribute '" + name + "'", name, attribute.floats("value"), rows, columns);
  }

  private void add(String what, String name, float[] values, int rows, int columns) {
    int size = rows * columns;
    if (values.length / size < points) {
      job.problem("has too few values in its %s; it is left out".formatted(what));
      return;
    }
    for (float value : values) {
      if (!Float.isFinite(value)) {
        job.problem("has values in its %s that are not finite; it is left out".formatted(what));
        return;
      }
    }
    if (found.size() + columns > room) {
      job.problem("has more attributes than %s columns; its %s is left out".formatted(room, what));
      return;
    }
    int count = values.length / size;
    for (int column = 0; column < columns; column++) {
      float[] one = columns == 1 ? Arrays.copyOf(values, count * rows) : new float[rows * count];
      for (int i = 0; columns > 1 && i < count; i++) {
        System.arraycopy(values, size * i + rows * column, one, rows * i, rows);
      }
      found.add(
          new VertexAttribute(one, rows, null, column == 0 ? name : name + "[" + column + "]"));
    }
  }
}
