package org.selectiverenderer.validation.language;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The attributes of statements, the elements that are not nodes (X3D 4.0 XML encoding, 4.3). */
final class StatementAttributes {
  /**
   * Attributes that every element may have for HTML; the empty name stands for attributes of other
   * namespaces.
   */
  static final List<String> GENERAL = List.of("class", "id", "style", "");

  private static final Map<String, List<String>> ATTRIBUTES =
      Map.ofEntries(
          Map.entry("X3D", List.of("profile", "version")),
          Map.entry("head", List.of()),
          Map.entry("component", List.of("name", "level")),
          Map.entry("unit", List.of("category", "name", "conversionFactor")),
          Map.entry("meta", List.of("name", "content", "dir", "http-equiv", "lang", "scheme")),
          Map.entry("Scene", List.of()),
          Map.entry("ROUTE", List.of("fromNode", "fromField", "toNode", "toField")),
          Map.entry("IMPORT", List.of("inlineDEF", "importedDEF", "AS")),
          Map.entry("EXPORT", List.of("localDEF", "AS")),
          Map.entry("IS", List.of()),
          Map.entry("connect", List.of("nodeField", "protoField")),
          Map.entry("ProtoDeclare", List.of("name", "appinfo", "documentation")),
          Map.entry("ProtoInterface", List.of()),
          Map.entry("ProtoBody", List.of()),
          Map.entry("ExternProtoDeclare", List.of("name", "url", "appinfo", "documentation")),
          Map.entry(
              "field", List.of("name", "type", "accessType", "value", "appinfo", "documentation")),
          Map.entry("fieldValue", List.of("name", "value")));

  private StatementAttributes() {}

  /** Returns the attributes of a statement; empty for other elements. */
  static Optional<List<String>> attributes(DocumentElement element) {
    return Optional.ofNullable(ATTRIBUTES.get(element.name()));
  }

  /** Returns whether an attribute is unknown to the statement that it is on. */
  static boolean unknown(DocumentAttribute attribute) {
    return attributes(attribute.element())
        .filter(names -> !names.contains(attribute.name()))
        .filter(names -> !GENERAL.contains(attribute.name()))
        .isPresent();
  }

  /**
   * Returns whether an attribute is missing. A misspelt one does not count as missing, since it is
   * reported as unknown with a suggestion.
   */
  static boolean lacks(DocumentElement element, String needed) {
    List<String> names = attributes(element).orElse(List.of());
    return element.attribute(needed).isEmpty()
        && element.attributes().stream()
            .filter(StatementAttributes::unknown)
            .flatMap(attribute -> SpellingSuggester.nearest(attribute.name(), names).stream())
            .noneMatch(needed::equals);
  }
}
