package org.selectiverenderer.x3d.tessellate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Reads a geometry's vertex attributes for shader programs, one tuple per point, from {@code
 * attrib} (X3D 4.0, 31.4.2, 31.4.3, 31.4.4) and {@code fogCoord} (24.4.2). A matrix takes one
 * attribute per column.
 */
final class ShaderVertexAttributes {
  /**
   * The maximum number of columns of all attributes and further texture coordinates of a geometry,
   * which every graphics card supports beside the standard attributes.
   */
  static final int MOST = 12;

  private final TessellationContext job;
  private final int points;
  private final int room;
  private final List<VertexAttribute> found = new ArrayList<>();

  private ShaderVertexAttributes(TessellationContext job, int points, int room) {
    this.job = job;
    this.points = points;
    this.room = room;
  }

  /**
   * Reads the attributes of the job's node.
   *
   * @param corners the point of each corner
   * @param before the number of columns used by further texture coordinates
   */
  static List<VertexAttribute> of(TessellationContext job, int[] corners, int before) {
    NodeView node = job.node();
    if (node.type().field("attrib").isEmpty()
        || (node.nodes("attrib").isEmpty() && node.node("fogCoord") == null)) {
      return List.of();
    }
    int points = Arrays.stream(corners).max().orElse(-1) + 1;
    ShaderVertexAttributes all = new ShaderVertexAttributes(job, points, MOST - before);
    NodeView fog = node.node("fogCoord");
    if (fog != null && fog.type().name().equals("FogCoordinate")) {
      all.add("fogCoord", Mesh.FOG_DEPTH, toTheLast(fog.floats("depth"), points), 1, 1);
    }
    node.nodes("attrib").forEach(all::add);
    return all.found;
  }

  /** Extends the depths to all points by repeating the last one. */
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
        // not an attribute; the file reader has reported it
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
      job.problem("has more than %s attribute columns; its %s is left out".formatted(room, what));
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
