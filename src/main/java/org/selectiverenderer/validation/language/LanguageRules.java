package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;

/** SR1xx: the X3D language. */
public final class LanguageRules {
  static final Rule UNKNOWN_ELEMENT =
      Rule.error("SR101", "X3D has no element {element}{suggestion}")
          .because(
              """
              A browser leaves out an element that it does not know, with all that is in it.""")
          .bad("<Shpae><Box/></Shpae>")
          .good("<Shape><Box/></Shape>")
          .see("X3D 4.0 XML encoding, 6.2");

  private LanguageRules() {}

  public static RuleGroup group() {
    return new RuleGroup("X3D", List.of(UNKNOWN_ELEMENT), List.of(new ElementCheck()), List.of());
  }
}
