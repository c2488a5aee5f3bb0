package org.selectiverenderer.authoring.enrichment;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.x3d.field.FieldTokenizer;

/**
 * Validates schema names: allowed are all names that survive writing and reading a scene. Quotation
 * marks, commas and backslashes are escaped; line ends and other control characters are altered or
 * forbidden by XML (XML 1.0, 2.2 and 3.3.3).
 */
public final class SchemaNameValidator {
  private SchemaNameValidator() {}

  /**
   * Returns why a name is invalid, as a message that follows its location; empty if it is valid.
   */
  public static Optional<String> complaint(String name) {
    return name.codePoints().anyMatch(c -> Character.isISOControl(c) || c == 0xFFFE || c == 0xFFFF)
        ? Optional.of(
            "the schema name "
                + FieldTokenizer.quote(name)
                + " cannot be written: a schema name is one line without control characters")
        : Optional.empty();
  }

  /**
   * Rejects invalid names.
   *
   * @param there names that the scene contains already, which are not checked
   */
  static void require(Collection<String> names, List<String> there) {
    names.stream()
        .filter(name -> !there.contains(name))
        .flatMap(name -> complaint(name).stream())
        .findFirst()
        .ifPresent(
            why -> {
              throw new EditRejectedException(why);
            });
  }
}
