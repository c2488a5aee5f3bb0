package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** Declares the rules about the versions of objects and about when they are shown. */
final class ObjectVersionRules {
  private static final String DESK = RuleExampleFragments.choice("low", "Desk");
  private static final String OFFICE = RuleExampleFragments.choice("high", "Office");
  private static final String VERSIONS =
      RuleExampleFragments.DETAILED + RuleExampleFragments.SIMPLE;
  private static final String GOOD = RuleExampleFragments.desk() + RuleExampleFragments.LAMP;

  private static final String VIEW = "<Viewpoint position='0 0 8'/>\n";

  static final Rule DEGREE_AGAINST_POLYGONS =
      Rule.warning(
              "SR416",
              "choice {consistent} is more consistent than choice {other}, but has "
                  + "more polygons: {polygons} instead of {fewer}")
          .because(
              """
              Consistent objects are expected and drawn with few polygons, inconsistent ones \
              with many. So the version with the higher degree must have fewer polygons. The \
              listings of Figs 52 and 78 have it the other way round.""")
          .bad(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.lamp(
                      "1",
                      DESK + OFFICE,
                      RuleExampleFragments.SIMPLE + RuleExampleFragments.DETAILED))
          .good(GOOD)
          .see("thesis 4.2.1");

  static final Rule HEAVIER_REDUCTION =
      Rule.warning(
              "SR417",
              "choice {reduced} is a reduced version of choice {original}, but does "
                  + "not have fewer polygons: {polygons} and {fewer}")
          .because("A reduced version must have fewer polygons than the original.")
          .bad(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.lamp(
                      "1",
                      DESK + OFFICE.replace("high", "low"),
                      RuleExampleFragments.SIMPLE + RuleExampleFragments.DETAILED))
          .good(GOOD)
          .see("thesis 4.2.1, Fig 67");

  static final Rule OTHER_SIZE =
      Rule.warning(
              "SR418",
              "choice {choice} differs by {percent} % in size or position from "
                  + "choice {original}")
          .because(
              """
              When one version replaces the other, the object must not jump or grow. The \
              sides of their bounding boxes may differ by at most 2 % of the object's \
              largest extent.""")
          .bad(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.lamp(
                      "1",
                      DESK + OFFICE,
                      RuleExampleFragments.DETAILED + "  <Shape><Box size='2 2 2.2'/></Shape>\n"))
          .good(GOOD)
          .see("thesis 4.2.1");

  static final Rule NOT_AS_AT_START =
      Rule.warning(
              "SR420",
              "the Switch shows choice {choice} at the start, but {schema}, which is "
                  + "active at the start viewpoint, shows choice {other}")
          .because(
              """
              The areas around the scene's first viewpoint are entered at once. Outside all \
              areas the schemas are active that leaving them activates. The file should show \
              the choices of these schemas.""")
          .bad(
              VIEW
                  + RuleExampleFragments.desk()
                  + RuleExampleFragments.lamp("0", DESK + OFFICE, VERSIONS))
          .good(VIEW + GOOD)
          .see("thesis 5.4.3, Fig 80");

  static final Rule ORDER_DEPENDENT =
      Rule.warning(
              "SR422",
              "{area} and {other} overlap and show choices {choice} and {otherChoice} of the"
                  + " Switch; the area entered last wins")
          .because(
              """
              A viewer in both areas sees the version of the area entered last, so the same \
              place can look different. Give both areas the same choice, or keep the areas \
              apart.""")
          .bad(overlap(DESK, RuleExampleFragments.choice("high", "Office\" \"Shelf")))
          .good(overlap(RuleExampleFragments.choice("low", "Desk\" \"Shelf"), OFFICE))
          .see("thesis 6.2, Fig 89");

  static final Rule NEVER_SHOWN =
      Rule.warning("SR424", "choice {choice} of the Switch is never shown: {reason}")
          .because(
              """
              A version that is not shown at the start is shown when a schema is activated \
              to which it belongs, unless a later schema of the same area shows another \
              version.""")
          .bad(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.LAMP
                  + """
                  <Switch DEF='Cup' whichChoice='0'>
                    <Inline url='"cup_v1.x3d"'/>
                    <Inline url='"cup_v2.x3d"'/>
                  </Switch>
                  """)
          .good(GOOD)
          .see("thesis 4.3, Figs 48 and 49");

  static final List<Rule> ALL =
      List.of(
          DEGREE_AGAINST_POLYGONS,
          HEAVIER_REDUCTION,
          OTHER_SIZE,
          NOT_AS_AT_START,
          ORDER_DEPENDENT,
          NEVER_SHOWN);

  private ObjectVersionRules() {}

  /** Returns a scene with two overlapping areas. */
  private static String overlap(String first, String second) {
    String shelf =
        RuleExampleFragments.sensor(
                "2 4 2",
                RuleExampleFragments.string("enterTimeSchema", "Shelf")
                    + RuleExampleFragments.EXIT_OFFICE)
            .replace("DeskProx", "ShelfProx");
    return RuleExampleFragments.desk()
        + shelf
        + RuleExampleFragments.lamp("1", first + second, VERSIONS);
  }
}
