package org.selectiverenderer.document.hand;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/**
 * A field of a node as an author sees it: what it may be, and what is written.
 *
 * @param definition of the catalogue; empty for DEF, USE, the attributes of statements, and those
 *     that the node does not have
 * @param written the value in the text, references replaced; empty where the default holds
 * @param choices words that may stand there, to choose from; empty for any
 * @param readOnly why it cannot be changed in a form: a sentence; empty if it can
 */
public record NodeField(
    String name,
    Kind kind,
    Optional<FieldDefinition> definition,
    Optional<String> written,
    List<String> choices,
    Optional<String> readOnly) {
  /** How a value is edited. */
  public enum Kind {
    TEXT,
    BOOLEAN,
    COLOR,
    /** One of the choices; others may be typed where the standard leaves the list open. */
    CHOICE
  }

  /** The default as X3D text; empty for none. */
  public String defaultText() {
    return definition.map(FieldDefinition::defaultText).orElse("");
  }

  /** Type, default and range in one line: {@code SFFloat, 0.2 by default, from 0, to 1}. */
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
