package org.selectiverenderer.x3d.catalogue;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * A read-only view of a node's fields, implemented by the nodes of a file ({@link ParsedNode}) and
 * of a running scene. Code for both (tessellation, metadata, counting) uses this interface.
 */
public interface NodeView {
  /** Returns the node type. */
  NodeType type();

  /** Returns the DEF name, or null. */
  @Nullable String name();

  /** Returns where the node was read. */
  SourceLocation location();

  /** Returns the value of a field, or its default, by its index in {@link NodeType#fields()}. */
  @Nullable Object value(int field);

  /**
   * Returns the value of a field that the node type is known to have.
   *
   * @throws IllegalArgumentException if it has no such field
   */
  default @Nullable Object value(String field) {
    return value(type().indexOf(field));
  }

  /** Returns the value of a field of floats: SFVec3f, MFFloat, SFColor ... */
  default float[] floats(String field) {
    return (float[]) value(field);
  }

  /** Returns the value of an MFInt32 or an image. */
  default int[] ints(String field) {
    return (int[]) value(field);
  }

  /** Returns the value of an MFString. */
  default String[] strings(String field) {
    return (String[]) value(field);
  }

  /** Returns the value of an SFFloat. */
  default float number(String field) {
    return (Float) value(field);
  }

  /** Returns the value of an SFInt32. */
  default int integer(String field) {
    return (Integer) value(field);
  }

  /** Returns the value of an SFBool. */
  default boolean bool(String field) {
    return (Boolean) value(field);
  }

  /** Returns the value of an SFString. */
  default String string(String field) {
    return (String) value(field);
  }

  /** Returns the node in an SFNode field, or null. */
  default @Nullable NodeView node(String field) {
    return (NodeView) value(field);
  }

  /** Returns the nodes in an MFNode field. */
  @SuppressWarnings("unchecked")
  default List<? extends NodeView> nodes(String field) {
    return (List<? extends NodeView>) value(field);
  }
}
