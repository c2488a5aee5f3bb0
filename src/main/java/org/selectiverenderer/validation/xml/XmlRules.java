package org.selectiverenderer.validation.xml;

import java.util.List;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;

/** SR0xx: the file and its XML. */
public final class XmlRules {
  static final Rule NOT_WELL_FORMED =
      Rule.error("SR001", "{fault}")
          .because(
              """
              A file that is not well-formed XML is refused by most programs; this one keeps what \
              stands before the fault. All other findings of the file are about that part.""")
          .bad("<Group><Shape></Group>")
          .good("<Group><Shape/></Group>")
          .see("XML 1.0, 2.1");

  private XmlRules() {}

  public static RuleGroup group() {
    return new RuleGroup(
        "XML and file", List.of(NOT_WELL_FORMED), List.of(new FaultCheck()), List.of());
  }
}
