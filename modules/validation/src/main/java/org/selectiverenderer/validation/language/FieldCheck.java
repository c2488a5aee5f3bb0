package org.selectiverenderer.validation.language;

import java.util.List;
import java.util.Set;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.LegacyFieldNames;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Checks the attributes of nodes against the node catalogue: names, access types and the syntax of
 * values.
 */
final class FieldCheck implements FileCheck {
  /** Attributes that are not fields: those of the XML encoding, of X3DOM and of HTML. */
  private static final Set<String> GENERAL =
      Set.of("DEF", "USE", "containerField", "class", "id", "style", "");

  @Override
  public void check(FileContext file, FindingCollector findings) {
    for (DocumentElement element : file.document().elements()) {
      file.catalogue()
          .find(element.name())
          .ifPresent(
              type -> element.attributes().forEach(attribute -> check(type, attribute, findings)));
    }
  }

  private static void check(NodeType type, DocumentAttribute attribute, FindingCollector findings) {
    String name = attribute.name();
    FieldDefinition field = type.field(name).orElse(null);
    if (field == null) {
      String now = LegacyFieldNames.now(type, name);
      if (!now.equals(name)) {
        findings.add(FieldRules.OLD_SPELLING, attribute, name, now);
      } else if (!GENERAL.contains(name)) {
        List<String> names = type.fields().stream().map(FieldDefinition::name).toList();
        findings.add(
            FieldRules.UNKNOWN_ATTRIBUTE,
            attribute,
            type,
            "field " + name,
            SpellingSuggestion.of(name, names));
      }
    } else if (field.type().isNode()) {
      findings.add(FieldRules.NODE_AS_ATTRIBUTE, attribute, name, type);
    } else if (!field.access().initialisable()) {
      findings.add(FieldRules.ACCESS, attribute, name, type, field.access().spelling());
    } else {
      value(attribute, field.type(), findings);
    }
  }

  /** Reports faults in a value. */
  static void value(DocumentAttribute attribute, FieldType type, FindingCollector findings) {
    for (FieldParser.Flaw flaw : attribute.flaws(type)) {
      findings.addAt(
          flaw.severity() == Severity.ERROR ? FieldRules.VALUE : FieldRules.LOOSE_VALUE,
          attribute,
          flaw.offset(),
          attribute.name(),
          flaw.message());
    }
  }
}
