package org.selectiverenderer.models.draco;

import java.util.List;
import java.util.Optional;

/**
 * A decoded mesh. The arrays must not be modified.
 *
 * @param points the number of vertices
 * @param indices three vertices for each triangle; those of damaged data may not exist
 * @param attributes the values of the vertices
 */
public record DracoMesh(int points, int[] indices, List<Attribute> attributes) {
  /** Makes a defensive copy of the list. */
  public DracoMesh {
    attributes = List.copyOf(attributes);
  }

  /**
   * Values of the vertices, such as their normals.
   *
   * @param id the unique number by which glTF refers to it
   * @param components the number of values of each vertex
   * @param integers whether they were stored as integers
   * @param values those of the first vertex, then those of the second, and so on
   */
  public record Attribute(int id, int components, boolean integers, float[] values) {}

  /** Returns the attribute with a number. */
  public Optional<Attribute> attribute(int id) {
    return attributes.stream().filter(attribute -> attribute.id() == id).findFirst();
  }
}
