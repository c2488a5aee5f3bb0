package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** What can be wrong with the metadata of an object in versions. */
final class SwitchRules {
  private static final String DESK = Examples.choice("low", "Desk");
  private static final String OFFICE = Examples.choice("high", "Office");
  private static final String VERSIONS = Examples.DETAILED + Examples.SIMPLE;
  private static final String GOOD = Examples.desk() + Examples.LAMP;

  static final Rule FEWER_SETS =
      Rule.warning("SR401", "the Switch has {sets} for {children}; no schema shows the rest")
          .because(
              """
              MetadataSet i describes child i of the Switch; a child without one is never shown by \
              a schema. A set without words of the vocabulary says that this is meant.""")
          .bad(Examples.desk() + Examples.lamp("0", DESK, VERSIONS))
          .good(GOOD)
          .see("thesis 4.3, Fig 49");

  static final Rule MORE_SETS =
      Rule.warning("SR402", "the Switch has {sets} for {children}; this one is ignored")
          .because(
              """
              MetadataSet i describes child i of the Switch; a set beyond the last child describes \
              nothing, and to follow it would hide the object.""")
          .bad(Examples.desk() + Examples.lamp("0", DESK + OFFICE, Examples.DETAILED))
          .good(GOOD)
          .see("thesis 4.3, Fig 49");

  static final Rule NO_SCHEMA =
      Rule.warning(
              "SR409", "no schema shows choice {choice} of the Switch, as its metadata names none")
          .because(
              """
              The metadata of a version says how consistent it is, but schemaBelonginess, which \
              decides when it is shown, names no schema.""")
          .bad(
              Examples.desk()
                  + Examples.lamp(
                      "1",
                      DESK + Examples.set("value", Examples.string("degreeOfConsistency", "high")),
                      VERSIONS))
          .good(GOOD)
          .see("thesis 4.2.2, Fig 43");

  static final Rule CLAIMED_TWICE =
      Rule.warning("SR410", "choices {choices} claim the schema {schema}; the last one counts")
          .because(
              """
              A schema can show one version of an object only. The algorithm of the thesis sets \
              the choices one after the other, so that the last one stays.""")
          .bad(
              Examples.desk()
                  + Examples.lamp("1", DESK + OFFICE.replace("Office", "Desk"), VERSIONS))
          .good(GOOD)
          .see("thesis 4.3, Fig 49");

  static final Rule UNKNOWN_TYPE =
      Rule.warning(
              "SR411", "consistencyType is neither consistent, inconsistent nor frame but {value}")
          .because("What is not one of the three words is ignored.")
          .bad(typed("usual"))
          .good(typed("inconsistent"))
          .see("thesis 4.2.2");

  static final Rule UNKNOWN_DEGREE =
      Rule.warning(
              "SR412",
              "degreeOfConsistency is neither low, high nor a number from 0 to 1 but {value}")
          .because("What is no degree is ignored; then consistencyType alone decides.")
          .bad(Examples.desk() + Examples.LAMP.replace("low", "medium"))
          .good(GOOD)
          .see("thesis 4.2.2, 7.2");

  static final Rule SEVERAL_VALUES =
      Rule.warning("SR413", "{field} has several values; only the first counts")
          .because("An object is in one version consistent to one degree.")
          .bad(Examples.desk() + Examples.LAMP.replace("\"low\"", "\"low\" \"high\""))
          .good(GOOD)
          .see("thesis 4.2.2");

  static final Rule OUT_OF_RANGE =
      Rule.warning(
              "SR419",
              "whichChoice is {choice}, but the Switch has {children}; nothing is shown until a"
                  + " schema is activated")
          .because("The children are counted from 0; what is beyond them shows nothing.")
          .bad(Examples.desk() + Examples.lamp("2", DESK + OFFICE, VERSIONS))
          .good(GOOD)
          .see("X3D 4.0, 10.4.3");

  static final List<Rule> ALL =
      List.of(
          FEWER_SETS,
          MORE_SETS,
          NO_SCHEMA,
          CLAIMED_TWICE,
          UNKNOWN_TYPE,
          UNKNOWN_DEGREE,
          SEVERAL_VALUES,
          OUT_OF_RANGE);

  private SwitchRules() {}

  private static String typed(String type) {
    String set =
        Examples.set(
            "value",
            Examples.string("consistencyType", type)
                + Examples.string("schemaBelonginess", "Desk"));
    return Examples.desk() + Examples.lamp("1", set + OFFICE, VERSIONS);
  }
}
