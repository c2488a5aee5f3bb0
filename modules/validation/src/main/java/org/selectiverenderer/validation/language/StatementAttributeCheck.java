package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Finds unknown attributes of statements, such as the root element, ROUTE or field. */
final class StatementAttributeCheck implements FileCheck {
  @Override
  public void check(FileContext file, FindingCollector findings) {
    for (DocumentElement element : file.document().elements()) {
      List<String> names = StatementAttributes.attributes(element).orElse(null);
      if (names == null) {
        continue;
      }
      for (DocumentAttribute attribute : element.attributes()) {
        if (element.name().equals("IMPORT") && attribute.name().equals("exportedDEF")) {
          findings.add(FieldRules.OLD_SPELLING, attribute, "exportedDEF", "importedDEF");
        } else if (StatementAttributes.unknown(attribute)) {
          findings.add(
              FieldRules.UNKNOWN_ATTRIBUTE,
              attribute,
              element.name(),
              "attribute " + attribute.name(),
              SpellingSuggestion.of(attribute.name(), names));
        }
      }
    }
  }
}
