package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** Declares the rules about areas. */
final class SensorRules {
  static final Rule WITHOUT_SCHEMAS =
      Rule.warning(
              "SR403", "the sensor names no schema and has no route, so entering it has no effect")
          .because(
              """
              An area activates the schemas that the metadata of its ProximitySensor names; a \
              sensor without them, from which no route leads either, has no effect.""")
          .bad(
              "<ProximitySensor DEF='ShelfProx' size='3 2 3'/>\n"
                  + RuleExampleFragments.desk()
                  + RuleExampleFragments.LAMP)
          .good(RuleExampleFragments.desk() + RuleExampleFragments.LAMP)
          .see("thesis 4.2.2, Fig 42");

  static final Rule NOT_ENRICHED =
      Rule.info("SR426", "the sensor names no schema; the scene is not enriched yet")
          .because(
              """
              The scene has no schema metadata at all. Its sensors may get theirs later, or \
              serve an application.""")
          .bad("<ProximitySensor DEF='DeskProx' size='3 2 3'/>")
          .good(RuleExampleFragments.desk() + RuleExampleFragments.LAMP)
          .see("thesis 5.4.2, Fig 76");

  static final Rule WITHOUT_EXIT =
      Rule.warning(
              "SR404",
              "the sensor has an enterTimeSchema but no exitTimeSchema, so objects "
                  + "do not change back when the viewer leaves")
          .because(
              """
              Leaving an area activates its exitTimeSchema, which is the schema of the place around \
              it; without one, what entering has changed stays changed.""")
          .bad(
              RuleExampleFragments.sensor("3 2 3", RuleExampleFragments.ENTER_DESK)
                  + RuleExampleFragments.LAMP)
          .good(RuleExampleFragments.desk() + RuleExampleFragments.LAMP)
          .see("thesis 4.3, Fig 48");

  static final Rule NAMES_NOTHING =
      Rule.warning("SR408", "{field} names no schema; it is ignored")
          .because("Metadata without a value has no effect.")
          .bad(
              RuleExampleFragments.sensor(
                      "3 2 3",
                      RuleExampleFragments.string("enterTimeSchema", "")
                          + RuleExampleFragments.EXIT_OFFICE)
                  + RuleExampleFragments.LAMP)
          .good(RuleExampleFragments.desk() + RuleExampleFragments.LAMP)
          .see("thesis 4.2.2");

  static final Rule NO_VOLUME =
      Rule.warning("SR421", "the sensor's box has no volume, so nobody can enter it")
          .because(
              """
              A ProximitySensor senses the viewer in a box; where one of its sides is 0, which is \
              the default, or a Transform above it has a scale of 0, it senses nothing.""")
          .bad(RuleExampleFragments.desk().replace("3 2 3", "3 0 3") + RuleExampleFragments.LAMP)
          .good(RuleExampleFragments.desk() + RuleExampleFragments.LAMP)
          .see("X3D 4.0, 22.4.1");

  static final Rule UNREACHABLE =
      Rule.warning("SR423", "the viewer can never enter the sensor's box: {reason}")
          .because(
              """
              An area that nobody can enter activates nothing. The box must lie where the scene \
              is, or where one of its viewpoints stands, and the sensor must be enabled.""")
          .bad(
              "<Transform translation='0 900 0'>"
                  + RuleExampleFragments.desk()
                  + "</Transform>"
                  + RuleExampleFragments.LAMP)
          .good(RuleExampleFragments.desk() + RuleExampleFragments.LAMP)
          .see("X3D 4.0, 22.4.1");

  static final List<Rule> ALL =
      List.of(WITHOUT_SCHEMAS, WITHOUT_EXIT, NAMES_NOTHING, NO_VOLUME, UNREACHABLE, NOT_ENRICHED);

  private SensorRules() {}
}
