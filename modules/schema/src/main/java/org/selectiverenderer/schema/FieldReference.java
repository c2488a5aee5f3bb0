package org.selectiverenderer.schema;

import java.util.Optional;

/**
 * A field of a node, as metadata name it: {@code SofaTexture.url}.
 *
 * @param node the DEF name of the node, in the same file
 * @param field the name of the field
 */
public record FieldReference(String node, String field) {
  /** Parses a DEF name and a field name with a dot between them; a DEF name may have more dots. */
  public static Optional<FieldReference> of(String text) {
    String stripped = text.strip();
    int dot = stripped.lastIndexOf('.');
    return dot > 0 && dot < stripped.length() - 1
        ? Optional.of(new FieldReference(stripped.substring(0, dot), stripped.substring(dot + 1)))
        : Optional.empty();
  }

  /** Returns the text in the metadata. */
  @Override
  public String toString() {
    return node + "." + field;
  }
}
