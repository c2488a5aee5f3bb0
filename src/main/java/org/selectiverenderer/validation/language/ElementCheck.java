package org.selectiverenderer.validation.language;

import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileView;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.DocumentElement;

/** Elements that X3D does not know. */
final class ElementCheck implements FileCheck {
  @Override
  public void check(FileView file, Findings findings) {
    for (DocumentElement element : file.document().elements()) {
      String name = element.name();
      if (!file.knows(element)) {
        String suggestion =
            file.catalogue()
                .suggestion(name)
                .map(near -> "; did you mean " + near + "?")
                .orElse("");
        findings.add(FieldRules.UNKNOWN_ELEMENT, element, name, suggestion);
      }
    }
  }
}
