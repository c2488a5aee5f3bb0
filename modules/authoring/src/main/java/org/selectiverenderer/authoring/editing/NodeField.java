package org.selectiverenderer.authoring.editing;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/**
 * A field of a node for editing: its definition and its written value.
 *
 * @param definition the definition in the node catalogue; empty for DEF, USE, attributes of
 *     statements, and unknown attributes; of a prototype's field as the interface declares it
 * @param written the value in the text, with character references replaced; empty where the default
 *     applies
 * @param choices the allowed values; empty for any
 * @param readOnly why it cannot be changed in a form, as a sentence; empty if it can
 * @param ofPrototype what the interface of a prototype says about it; empty for an attribute
 */
public record NodeField(
    String name,
    Kind kind,
    Optional<FieldDefinition> definition,
    Optional<String> written,
    List<String> choices,
    Optional<String> readOnly,
    Optional<InterfaceField> ofPrototype) {
  /** The kind of editor for a value. */
  public enum Kind {
    TEXT,
    BOOLEAN,
    COLOR,
    /** One of the choices; other values may be typed where the standard leaves the list open. */
    CHOICE,
    /** Nodes, which are shown only. */
    NODES
  }

  /** Returns the default as X3D text; empty for none. */
  public String defaultText() {
    return definition.map(FieldDefinition::defaultText).orElse("");
  }

  /** Returns type, default and range in one line: {@code SFFloat, 0.2 by default, from 0, to 1}. */
  public String about() {
    if (definition.isEmpty()) {
      return "";
    }
    FieldDefinition field = definition.get();
    StringBuilder line = new StringBuilder(field.type().toString());
    if (!field.defaultText().isEmpty()) {
      line.append(", ").append(field.defaultText()).append(" by default");
    }
    bound(line, field.min(), "from ");
    bound(line, field.max(), "to ");
    return line.toString();
  }

  private static void bound(StringBuilder line, String bound, String word) {
    if (!bound.isEmpty()) {
      boolean open = bound.startsWith(">") || bound.startsWith("<");
      line.append(", ").append(open ? bound : word + bound);
    }
  }
}
