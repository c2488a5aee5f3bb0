package org.selectiverenderer.validation.language;

import java.util.Set;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Finds elements that X3D does not define. */
final class UnknownElementCheck implements FileCheck {
  /** The nodes of the X3D 4.1 draft that the node catalogue lacks. */
  private static final Set<String> OF_X3D_4_1 =
      Set.of("FontLibrary", "HAnimPose", "InlineGeometry", "RenderedTexture");

  @Override
  public void check(FileContext file, FindingCollector findings) {
    for (DocumentElement element : file.document().elements()) {
      String name = element.name();
      if (OF_X3D_4_1.contains(name)) {
        findings.add(HeadRules.YOUNGER, element, name);
      } else if (!file.knows(element) && name.indexOf(':') < 0) {
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
