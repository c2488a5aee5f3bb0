package org.selectiverenderer.browser.script.value;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/** Reads and writes fields of nodes on behalf of a script. */
public interface NodeAccess {
  /** Returns the node as the script sees it: of a prototype instance, the interface. */
  Node seen(Node node);

  /** Returns a field's value as {@link org.selectiverenderer.x3d.field.FieldType} represents it. */
  @Nullable Object read(Node node, FieldDefinition field);

  /**
   * Writes a field; routes and node behaviours receive the value when the script's function has
   * ended.
   */
  void write(Node node, FieldDefinition field, @Nullable Object value);
}
