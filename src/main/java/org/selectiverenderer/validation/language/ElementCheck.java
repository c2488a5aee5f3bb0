package org.selectiverenderer.validation.language;

import java.util.Set;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileView;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.DocumentElement;

/** Elements that X3D does not know. */
final class ElementCheck implements FileCheck {
  /** Elements that are no nodes. */
  static final Set<String> STATEMENTS =
      Set.of(
          "X3D",
          "head",
          "component",
          "meta",
          "unit",
          "Scene",
          "ROUTE",
          "IMPORT",
          "EXPORT",
          "IS",
          "connect",
          "ProtoDeclare",
          "ProtoInterface",
          "ProtoBody",
          "ExternProtoDeclare",
          "ProtoInstance",
          "field",
          "fieldValue");

  @Override
  public void check(FileView file, Findings findings) {
    for (DocumentElement element : file.document().elements()) {
      String name = element.name();
      if (!STATEMENTS.contains(name) && file.catalogue().find(name).isEmpty()) {
        String suggestion =
            file.catalogue()
                .suggestion(name)
                .map(near -> "; did you mean " + near + "?")
                .orElse("");
        findings.add(LanguageRules.UNKNOWN_ELEMENT, element, name, suggestion);
      }
    }
  }
}
