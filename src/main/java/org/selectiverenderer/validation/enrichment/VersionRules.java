package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** What can be wrong with the versions themselves and when they are shown. */
final class VersionRules {
  private static final String DESK = Examples.choice("low", "Desk");
  private static final String OFFICE = Examples.choice("high", "Office");
  private static final String VERSIONS = Examples.DETAILED + Examples.SIMPLE;
  private static final String GOOD = Examples.desk() + Examples.LAMP;

  private static final String VIEW = "<Viewpoint position='0 0 8'/>\n";

  static final Rule DEGREE_AGAINST_POLYGONS =
      Rule.warning(
              "SR416",
              "choice {consistent} is more consistent than choice {other}, but has {polygons}"
                  + " polygons and that {fewer}")
          .because(
              """
              Consistent objects are expected and drawn with few polygons, inconsistent ones with \
              many: the version of the higher degree must be the lighter one. The listings of Figs \
              52 and 78 have it the other way round.""")
          .bad(
              Examples.desk()
                  + Examples.lamp("1", DESK + OFFICE, Examples.SIMPLE + Examples.DETAILED))
          .good(GOOD)
          .see("thesis 4.2.1");

  static final Rule HEAVIER_REDUCTION =
      Rule.warning(
              "SR417",
              "choice {reduced} is a reduced version of choice {original}, but has {polygons}"
                  + " polygons and that {fewer}")
          .because("A reduced version is there to save polygons.")
          .bad(
              Examples.desk()
                  + Examples.lamp(
                      "1",
                      DESK + OFFICE.replace("high", "low"),
                      Examples.SIMPLE + Examples.DETAILED))
          .good(GOOD)
          .see("thesis 4.2.1, Fig 67");

  static final Rule OTHER_SIZE =
      Rule.warning(
              "SR418", "choice {choice} is {percent} % off the size or place of choice {original}")
          .because(
              """
              When the versions change places, an object must not jump or grow: the sides of their \
              bounding boxes may lie at most 2 % of the object's largest extent apart.""")
          .bad(
              Examples.desk()
                  + Examples.lamp(
                      "1",
                      DESK + OFFICE,
                      Examples.DETAILED + "  <Shape><Box size='2 2 2.2'/></Shape>\n"))
          .good(GOOD)
          .see("thesis 4.2.1");

  static final Rule NOT_AS_AT_START =
      Rule.warning(
              "SR420",
              "the Switch shows choice {choice} at the start, but {schema}, which holds at the"
                  + " start viewpoint, shows choice {other}")
          .because(
              """
              Where the scene's first viewpoint stands, the areas around it are entered at once; \
              outside all areas the schemas hold that leaving them activates. What the file shows \
              should agree with them.""")
          .bad(VIEW + Examples.desk() + Examples.lamp("0", DESK + OFFICE, VERSIONS))
          .good(VIEW + GOOD)
          .see("thesis 5.4.3, Fig 80");

  static final Rule ORDER_DEPENDENT =
      Rule.warning(
              "SR422",
              "{area} and {other} overlap and show choices {choice} and {otherChoice} of the"
                  + " Switch; the area entered last wins")
          .because(
              """
              Who stands in both areas sees the object as the area says that was entered last, so \
              that the same place can look one way or the other. Give both areas the same choice, \
              or keep them apart.""")
          .bad(overlap(DESK, Examples.choice("high", "Office\" \"Shelf")))
          .good(overlap(Examples.choice("low", "Desk\" \"Shelf"), OFFICE))
          .see("thesis 6.2, Fig 89");

  static final Rule NEVER_SHOWN =
      Rule.warning("SR424", "choice {choice} of the Switch is never shown: {reason}")
          .because(
              """
              A version that the scene does not start with is shown when a schema is activated \
              that it belongs to, unless a later schema of the same area has another choice.""")
          .bad(
              Examples.desk()
                  + Examples.LAMP
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

  private VersionRules() {}

  /** Two areas that overlap. */
  private static String overlap(String first, String second) {
    String shelf =
        Examples.sensor("2 4 2", Examples.string("enterTimeSchema", "Shelf") + Examples.EXIT_OFFICE)
            .replace("DeskProx", "ShelfProx");
    return Examples.desk() + shelf + Examples.lamp("1", first + second, VERSIONS);
  }
}
