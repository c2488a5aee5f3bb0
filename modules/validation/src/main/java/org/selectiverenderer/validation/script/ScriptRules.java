package org.selectiverenderer.validation.script;

import java.util.List;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;

/** Declares the rules SR600 to SR699, about Scripts. */
public final class ScriptRules {
  private static final String GOOD =
      """
      <Script>
        <field name='size' type='SFFloat' accessType='inputOnly'/>
        <field name='twice' type='SFFloat' accessType='outputOnly'/>
        <![CDATA[ecmascript:
        function size(value) { twice = 2 * value; }
        ]]>
      </Script>""";

  static final Rule SYNTAX =
      Rule.warning("SR601", "the program is not ECMAScript from here on: {fault}")
          .because("A program that cannot be parsed does not run at all; the Script does nothing.")
          .bad(GOOD.replace("(value) {", "(value {"))
          .good(GOOD)
          .see("X3D 4.0, 29.2.3; ISO/IEC 19777-1");

  static final Rule NO_FUNCTION =
      Rule.info("SR602", "the program has no function {function} for events of the field {field}")
          .because(
              "Events that such a field receives do nothing unless the program has a function of "
                  + "its name.")
          .bad(GOOD.replace("function size", "function sise"))
          .good(GOOD)
          .see("X3D 4.0, 29.2.4");

  static final Rule TWICE =
      Rule.error("SR603", "the {node} has a field {name} already")
          .because(
              "The second one is left out. Names of the node's other fields, such as url, are taken, "
                  + "too.")
          .bad(GOOD.replace("name='twice'", "name='size'"))
          .good(GOOD)
          .see("X3D 4.0, 29.2.2");

  static final Rule LANGUAGE =
      Rule.error("SR604", "Script {reason}; it does nothing")
          .because(
              """
              Programs are run in ECMAScript only. Those in Java could reach files and the \
              network, and those of other languages run in one program only.""")
          .bad("<Script url='\"Lamp.class\"'/>")
          .good("<Script url='\"lamp.js\"'/>")
          .see("X3D 4.0, 29.2.3; docs/scripts.md");

  private ScriptRules() {}

  /** The rules and their checks. */
  public static RuleGroup group() {
    return new RuleGroup(
        "Scripts",
        List.of(SYNTAX, NO_FUNCTION, TWICE, LANGUAGE),
        List.of(new EmbeddedProgramCheck(), new DuplicateFieldCheck()),
        List.of(new ExternalProgramCheck()));
  }
}
