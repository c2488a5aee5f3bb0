package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** Declares the rules about the names of schemas and of metadata. */
final class SchemaRules {
  private static final String GOOD = RuleExampleFragments.desk() + RuleExampleFragments.LAMP;

  static final Rule OF_NO_SWITCH =
      Rule.warning("SR405", "no Switch of the scene belongs to the schema {schema}")
          .because(
              """
              Entering the area activates a schema to which no version of any object \
              belongs, so it has no effect. Exit schemas without objects are not reported.""")
          .bad(RuleExampleFragments.desk())
          .good(GOOD)
          .see("thesis 4.3, Figs 48 and 49");

  static final Rule OF_NO_AREA =
      Rule.warning("SR406", "no area of the scene activates the schema {schema}")
          .because(
              """
              A version belongs to a schema that nothing activates. This is not reported if \
              all objects of the schema show the right version from the start, as in a room \
              without areas.""")
          .bad(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.lamp(
                      "1",
                      RuleExampleFragments.choice("low", "Shelf")
                          + RuleExampleFragments.choice("high", "Office"),
                      RuleExampleFragments.DETAILED + RuleExampleFragments.SIMPLE))
          .good(GOOD)
          .see("thesis 5.4.3");

  static final Rule ALMOST_THE_SAME =
      Rule.warning(
              "SR407", "only areas or only objects name the schema {schema}; is {other} meant?")
          .because(
              """
              Names of schemas are compared letter by letter. Only areas or only objects use \
              this name, and the other side uses a very similar one.""")
          .bad(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.LAMP.replace("\"Office\"", "\"Offise\""))
          .good(GOOD)
          .see("thesis 4.3, Fig 49");

  static final Rule OTHER_SPELLING =
      Rule.info("SR414", "{name} is Fig 40's spelling of {usual}")
          .because(
              """
              The thesis has two sets of names: the one of its listings, which other \
              programs know, and the one of its text and Fig 40, which this program reads \
              too.""")
          .bad(GOOD.replace("enterTimeSchema", "enterTimeSchemaActivation"))
          .good(GOOD)
          .see("thesis 4.2.2, Fig 40");

  static final Rule MISPLACED =
      Rule.warning("SR415", "{field} has no effect here: {reason}")
          .because(
              """
              Schemas are read from the metadata of the ProximitySensors and Switches of the \
              scene and its Inlines, in the sets of the choices. Elsewhere they have no effect.""")
          .bad(
              "<Group>\n"
                  + RuleExampleFragments.set("metadata", RuleExampleFragments.ENTER_DESK).indent(2)
                  + "</Group>")
          .good(GOOD)
          .see("thesis 4.2.2");

  static final Rule UNKNOWN_NAME =
      Rule.warning("SR425", "the metadata name {name} has no effect; is {field} meant?")
          .because(
              """
              Metadata may have any name, but this one is very similar to a name of the \
              vocabulary. As written it is ignored.""")
          .bad(GOOD.replace("degreeOfConsistency", "degreeOfConsistancy"))
          .good(GOOD)
          .see("thesis 4.2.2");

  static final List<Rule> ALL =
      List.of(OF_NO_SWITCH, OF_NO_AREA, ALMOST_THE_SAME, OTHER_SPELLING, MISPLACED, UNKNOWN_NAME);

  private SchemaRules() {}
}
