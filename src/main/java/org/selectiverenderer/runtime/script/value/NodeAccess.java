package org.selectiverenderer.runtime.script.value;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/** How a script reads and writes fields of nodes. */
public interface NodeAccess {
  /** What the script sees of a node: of an instance of a prototype, the interface. */
  Node seen(Node node);

  /** The value as {@link org.selectiverenderer.x3d.field.FieldType} represents it. */
  @Nullable Object read(Node node, FieldDefinition field);

  /**
   * Gives a field a value; routes and behaviours hear of it when the script's function has ended.
   */
  void write(Node node, FieldDefinition field, @Nullable Object value);
}
