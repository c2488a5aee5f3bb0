package org.selectiverenderer.schema;

import java.util.List;

/**
 * A value that a field may have, with the schemas that select it.
 *
 * @param metadata consistency and schemas, as of a choice of a Switch; its index counts the levels
 * @param values the strings of the metadata: those of an MFString as they are, of any other field
 *     its value in the XML encoding's syntax, in one string or several
 */
public record FieldLevel(VersionMetadata metadata, List<String> values) {
  /** Makes a defensive copy of the list. */
  public FieldLevel {
    values = List.copyOf(values);
  }
}
