package org.selectiverenderer.browser.script.value;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/**
 * Reads and writes fields of nodes on behalf of a script. What it writes is sent when the script's
 * function has ended; until then the script itself reads it.
 */
public interface NodeAccess {
  /** Returns the node as the script sees it: of a prototype instance, the interface. */
  Node seen(Node node);

  /**
   * Returns a field's value as a script has it. Within one call the object of a field is the same
   * each time, and what is changed in it is written to the field.
   *
   * @param field the field that is read
   * @param input the field that changes are written to, such as {@code set_coordIndex} for {@code
   *     coordIndex}; mostly the same
   */
  @Nullable Object read(Node node, FieldDefinition field, FieldDefinition input);

  /**
   * Writes a field; routes and node behaviours receive the value when the script's function has
   * ended.
   */
  void write(Node node, FieldDefinition field, @Nullable Object value);
}
