package org.selectiverenderer.validation.language;

import java.util.List;
import java.util.Set;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.FieldValueConstraints;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Finds values that are valid for their type, but outside the range that the standard allows. */
final class FieldRangeCheck implements FileCheck {
  @Override
  public void check(FileContext file, FindingCollector findings) {
    for (DocumentElement element : file.document().elements()) {
      file.catalogue()
          .find(element.name())
          .ifPresent(
              type -> {
                for (DocumentAttribute attribute : element.attributes()) {
                  type.field(attribute.name())
                      .filter(field -> field.access().initialisable())
                      .ifPresent(field -> check(attribute, field, findings));
                }
              });
    }
  }

  private static void check(
      DocumentAttribute attribute, FieldDefinition field, FindingCollector findings) {
    if (FieldValueConstraints.bounded(field)) {
      Object value = attribute.value(field.type());
      // SR103 reports values that are invalid for the type; the default used instead is not the
      // author's value.
      if (value != null && !flawed(attribute, field.type())) {
        FieldValueConstraints.beyond(field, value)
            .ifPresent(
                beyond ->
                    findings.add(
                        FieldRules.RANGE, attribute, field.name(), beyond.value(), beyond.bound()));
      }
    } else if (!field.values().isEmpty() && field.type().kind() == FieldType.Kind.STRING) {
      words(attribute, field, findings);
    }
  }

  private static boolean flawed(DocumentAttribute attribute, FieldType type) {
    return attribute.flaws(type).stream().anyMatch(flaw -> flaw.severity() == Severity.ERROR);
  }

  private static void words(
      DocumentAttribute attribute, FieldDefinition field, FindingCollector findings) {
    Set<String> known = FieldValueConstraints.words(field);
    Object value = attribute.value(field.type());
    List<String> given =
        value instanceof String[] strings
            ? List.of(strings)
            : value instanceof String string ? List.of(string) : List.of();
    boolean open = FieldValueConstraints.open(attribute.element().name(), field);
    for (String word : given) {
      if (!known.contains(word) && !word.isEmpty()) {
        // In an open list of words, only a difference in letter case is certainly an error.
        boolean slip = known.stream().anyMatch(word::equalsIgnoreCase);
        if (!open || slip) {
          findings.add(
              FieldRules.CHOICE, attribute, field.name(), word, SpellingSuggestion.of(word, known));
        }
      }
    }
  }
}
