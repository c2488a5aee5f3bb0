package org.selectiverenderer.validation;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.x3d.source.XmlDocument;

/**
 * A comment {@code validate-ignore SR102 SR3: why}, which an author writes before an element to
 * suppress findings about it.
 *
 * @param ids ids of rules, or prefixes of ids
 */
public record SuppressionComment(List<String> ids) {
  private static final String WORD = "validate-ignore";

  /** Parses a comment; empty if it is not a validate-ignore comment. */
  public static Optional<SuppressionComment> of(XmlDocument.Comment comment) {
    String text = comment.text().strip();
    if (!text.startsWith(WORD)) {
      return Optional.empty();
    }
    String ids = text.substring(WORD.length()).split(":", 2)[0].strip();
    return Optional.of(
        new SuppressionComment(ids.isEmpty() ? List.of() : Arrays.asList(ids.split("[\\s,]+"))));
  }
}
