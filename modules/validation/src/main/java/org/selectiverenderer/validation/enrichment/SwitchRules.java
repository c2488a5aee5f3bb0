package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** Declares the rules about the metadata of versioned objects. */
final class SwitchRules {
  private static final String DESK = RuleExampleFragments.choice("low", "Desk");
  private static final String OFFICE = RuleExampleFragments.choice("high", "Office");
  private static final String VERSIONS =
      RuleExampleFragments.DETAILED + RuleExampleFragments.SIMPLE;
  private static final String GOOD = RuleExampleFragments.desk() + RuleExampleFragments.LAMP;

  static final Rule FEWER_SETS =
      Rule.warning(
              "SR401", "the Switch has {sets} for {children}; no schema shows the other children")
          .because(
              """
              MetadataSet i describes child i of the Switch. A child without a set is never \
              shown by a schema. If this is intended, add an empty set.""")
          .bad(RuleExampleFragments.desk() + RuleExampleFragments.lamp("0", DESK, VERSIONS))
          .good(GOOD)
          .see("thesis 4.3, Fig 49");

  static final Rule MORE_SETS =
      Rule.warning("SR402", "the Switch has {sets} for {children}; this one is ignored")
          .because(
              """
              MetadataSet i describes child i of the Switch. A set beyond the last child \
              describes nothing; showing that child would hide the object.""")
          .bad(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.lamp("0", DESK + OFFICE, RuleExampleFragments.DETAILED))
          .good(GOOD)
          .see("thesis 4.3, Fig 49");

  static final Rule NO_SCHEMA =
      Rule.warning(
              "SR409",
              "no schema shows choice {choice} of the Switch, because its metadata names none")
          .because(
              """
              The metadata of a version says how consistent it is, but schemaBelonginess, which \
              decides when it is shown, names no schema. A version with a degree alone is a \
              level of a scale beside those that schemas show.""")
          .bad(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.lamp(
                      "1",
                      DESK
                          + RuleExampleFragments.set(
                              "value",
                              RuleExampleFragments.string("consistencyType", "consistent")
                                  + RuleExampleFragments.string("degreeOfConsistency", "high")),
                      VERSIONS))
          .good(GOOD)
          .see("thesis 4.2.2, Fig 43");

  static final Rule CLAIMED_TWICE =
      Rule.warning(
              "SR410", "choices {choices} all name the schema {schema}; only the last one is used")
          .because(
              """
              A schema can show only one version of an object. The algorithm of the thesis \
              sets the choices one after the other, so the last one remains.""")
          .bad(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.lamp(
                      "1", DESK + OFFICE.replace("Office", "Desk"), VERSIONS))
          .good(GOOD)
          .see("thesis 4.3, Fig 49");

  static final Rule UNKNOWN_TYPE =
      Rule.warning(
              "SR411",
              "consistencyType must be consistent, inconsistent or frame, not "
                  + "{value}{suggestion}")
          .because("Any other word is ignored.")
          .bad(typed("usual"))
          .good(typed("inconsistent"))
          .see("thesis 4.2.2");

  static final Rule UNKNOWN_DEGREE =
      Rule.warning(
              "SR412", "degreeOfConsistency must be low, high or a number from 0 to 1, not {value}")
          .because("Any other value is ignored; then consistencyType alone decides.")
          .bad(RuleExampleFragments.desk() + RuleExampleFragments.LAMP.replace("low", "medium"))
          .good(GOOD)
          .see("thesis 4.2.2, 7.2");

  static final Rule SEVERAL_VALUES =
      Rule.warning("SR413", "{field} has several values; only the first is used")
          .because("A version has one type and one degree of consistency.")
          .bad(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.LAMP.replace("\"low\"", "\"low\" \"high\""))
          .good(GOOD)
          .see("thesis 4.2.2");

  static final Rule OUT_OF_RANGE =
      Rule.warning(
              "SR419",
              "whichChoice is {choice}, but the Switch has {children}; nothing is shown until a"
                  + " schema is activated")
          .because("The children are counted from 0. A choice beyond the last child shows nothing.")
          .bad(
              RuleExampleFragments.desk() + RuleExampleFragments.lamp("2", DESK + OFFICE, VERSIONS))
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
        RuleExampleFragments.set(
            "value",
            RuleExampleFragments.string("consistencyType", type)
                + RuleExampleFragments.string("schemaBelonginess", "Desk"));
    return RuleExampleFragments.desk() + RuleExampleFragments.lamp("1", set + OFFICE, VERSIONS);
  }
}
