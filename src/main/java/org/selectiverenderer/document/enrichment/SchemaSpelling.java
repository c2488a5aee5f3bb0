package org.selectiverenderer.document.enrichment;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.document.EditRefused;
import org.selectiverenderer.x3d.field.Tokens;

/**
 * Which names a schema may have: all that a scene gives back as they were written. Quotation marks,
 * commas and backslashes are written so that they are; line ends and other control characters XML
 * alters or forbids (XML 1.0, 2.2 and 3.3.3).
 */
public final class SchemaSpelling {
  private SchemaSpelling() {}

  /** Why a name cannot be written, in words that follow the place; empty if it can. */
  public static Optional<String> complaint(String name) {
    return name.codePoints().anyMatch(c -> Character.isISOControl(c) || c == 0xFFFE || c == 0xFFFF)
        ? Optional.of(
            "the schema name "
                + Tokens.quote(name)
                + " cannot stand in a scene: names are one line without control characters")
        : Optional.empty();
  }

  /**
   * Refuses names that cannot be written.
   *
   * @param there names that the scene has already, which stay as they are
   */
  static void require(Collection<String> names, List<String> there) {
    names.stream()
        .filter(name -> !there.contains(name))
        .flatMap(name -> complaint(name).stream())
        .findFirst()
        .ifPresent(
            why -> {
              throw new EditRefused(why);
            });
  }
}
