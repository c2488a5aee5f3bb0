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
  /** What sort of node it is. */
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

  /** The value of a field of floats: SFVec3f, MFFloat, SFColor ... */
  default float[] floats(String field) {
    return (float[]) value(field);
  }

  /** The value of an MFInt32 or an image. */
  default int[] ints(String field) {
    return (int[]) value(field);
  }

  /** The value of an MFString. */
  default String[] strings(String field) {
    return (String[]) value(field);
  }

  /** The value of an SFFloat. */
  default float number(String field) {
    return (Float) value(field);
  }

  /** The value of an SFInt32. */
  default int integer(String field) {
    return (Integer) value(field);
  }

  /** The value of an SFBool. */
  default boolean bool(String field) {
    return (Boolean) value(field);
  }

  /** The value of an SFString. */
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
