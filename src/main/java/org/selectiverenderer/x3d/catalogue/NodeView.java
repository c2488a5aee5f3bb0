package org.selectiverenderer.x3d.catalogue;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Reads a node's fields, whether it is a node of a file ({@link ParsedNode}) or one of a running
 * scene. What works on either (tessellation, metadata, counting) is written against this.
 */
public interface NodeView {
  NodeType type();

  /** The DEF name, or null. */
  @Nullable String name();

  /** Where the node was read. */
  Location location();

  /** The value of a field by its index in {@link NodeType#fields()}, or its default. */
  @Nullable Object value(int field);

  /**
   * The value of a field that the node type is known to have.
   *
   * @throws IllegalArgumentException if it has no such field
   */
  default @Nullable Object value(String field) {
    return value(type().indexOf(field));
  }

  default float[] floats(String field) {
    return (float[]) value(field);
  }

  default int[] ints(String field) {
    return (int[]) value(field);
  }

  default String[] strings(String field) {
    return (String[]) value(field);
  }

  default float number(String field) {
    return (Float) value(field);
  }

  default int integer(String field) {
    return (Integer) value(field);
  }

  default boolean bool(String field) {
    return (Boolean) value(field);
  }

  default String string(String field) {
    return (String) value(field);
  }

  /** The node in an SFNode field, or null. */
  default @Nullable NodeView node(String field) {
    return (NodeView) value(field);
  }

  /** The nodes in an MFNode field. */
  @SuppressWarnings("unchecked")
  default List<? extends NodeView> nodes(String field) {
    return (List<? extends NodeView>) value(field);
  }
}
