package org.selectiverenderer.validation.xml;

import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Finds text between elements. */
final class StrayTextCheck implements FileCheck {
  private static final int SHOWN = 40;

  @Override
  public void check(FileContext file, FindingCollector findings) {
    for (DocumentElement element : file.document().elements()) {
      boolean script =
          file.catalogue()
              .find(element.name())
              .filter(type -> type.field("sourceCode").isPresent())
              .isPresent();
      // Text in scripts, in shaders and in elements of other namespaces is allowed.
      if (!element.text().isEmpty() && !script && file.knows(element)) {
        String text = element.text().strip();
        String shown = text.length() > SHOWN ? text.substring(0, SHOWN) + "..." : text;
        findings.addWithin(XmlRules.TEXT, element, element.textLocation(), "'" + shown + "'");
      }
    }
  }
}
