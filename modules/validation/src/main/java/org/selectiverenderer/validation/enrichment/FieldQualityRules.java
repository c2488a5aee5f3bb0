package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** Declares the rules about qualities of objects other than their versions. */
final class FieldQualityRules {
  private static final String GOOD = lamp("light", "LampLight.on", "true", "false");

  static final Rule UNKNOWN_QUALITY =
      Rule.warning(
              "SR427", "quality must be polygons, textures, shading, light or animation, {instead}")
          .because(
              """
              The quality tells conditions and --quality what a choice or a level varies. A word \
              that is none of them is ignored; so is a field quality without one.""")
          .bad(lamp("lights", "LampLight.on", "true", "false"))
          .good(GOOD)
          .see("docs/qualities.md");

  static final Rule SEVERAL_QUALITIES =
      Rule.warning("SR428", "the versions of a Switch differ in one quality; {value} is ignored")
          .because(
              """
              All choices of a Switch belong to one quality. What varies independently of them is \
              a field quality.""")
          .bad(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.lamp(
                      "1",
                      version("light", "low", "Desk") + version("shading", "high", "Office"),
                      RuleExampleFragments.DETAILED + RuleExampleFragments.SIMPLE))
          .good(
              RuleExampleFragments.desk()
                  + RuleExampleFragments.lamp(
                      "1",
                      version("light", "low", "Desk") + version("light", "high", "Office"),
                      RuleExampleFragments.DETAILED + RuleExampleFragments.SIMPLE))
          .see("docs/qualities.md");

  static final Rule NO_FIELD =
      Rule.warning("SR429", "this field quality sets nothing: {reason}")
          .because(
              """
              A field quality names a node of the same file by its DEF, a dot, and an inputOutput \
              field of a type whose values metadata can hold.""")
          .bad(lamp("light", "LampLights.on", "true", "false"))
          .good(GOOD)
          .see("docs/qualities.md");

  static final Rule NO_VALUE =
      Rule.warning("SR430", "this level of a field quality has no usable value: {reason}")
          .because(
              """
              The MetadataString value of a level holds what is written into the field: the \
              strings of an MFString, else the value as X3D's XML encoding writes it. The whole \
              quality is ignored if one cannot be read.""")
          .bad(lamp("light", "LampLight.on", "true", "dark"))
          .good(GOOD)
          .see("docs/qualities.md");

  static final Rule FIELD_TWICE =
      Rule.warning("SR431", "several qualities set {field}; only the first one does")
          .because(
              """
              Qualities are chosen independently of each other, so two of one field would undo each \
              other's choices.""")
          .bad(
              lamp(
                  light("light", "LampLight.on", "true", "false")
                      + light("animation", "LampLight.on", "true", "false")))
          .good(GOOD)
          .see("docs/qualities.md");

  static final Rule NO_SCHEMA =
      Rule.warning("SR432", "no schema selects a level of this field quality")
          .because(
              """
              Levels name schemas, or follow the versions of their Switch; here neither names any, \
              so only conditions other than selective choose a level.""")
          .bad(
              RuleExampleFragments.desk()
                  + "<Switch DEF='Lamp' whichChoice='0'>\n"
                  + qualities(
                          "light",
                          "LampLight.on",
                          RuleExampleFragments.set(
                              "value", RuleExampleFragments.string("value", "true")))
                      .indent(2)
                  + "  <PointLight DEF='LampLight'/>\n</Switch>\n")
          .good(GOOD)
          .see("docs/qualities.md");

  static final List<Rule> ALL =
      List.of(UNKNOWN_QUALITY, SEVERAL_QUALITIES, NO_FIELD, NO_VALUE, FIELD_TWICE, NO_SCHEMA);

  private FieldQualityRules() {}

  private static String version(String quality, String degree, String schema) {
    return RuleExampleFragments.set(
        "value",
        RuleExampleFragments.string("quality", quality)
            + RuleExampleFragments.string("degreeOfConsistency", degree)
            + RuleExampleFragments.string("schemaBelonginess", schema));
  }

  private static String lamp(String quality, String field, String best, String worst) {
    return lamp(light(quality, field, best, worst));
  }

  private static String lamp(String sets) {
    return RuleExampleFragments.desk()
        + "<Switch DEF='Lamp' whichChoice='0'>\n"
        + around(sets).indent(2)
        + "  <PointLight DEF='LampLight'/>\n</Switch>\n";
  }

  private static String light(String quality, String field, String best, String worst) {
    return set(quality, field, level("low", "Desk", best) + level("high", "Office", worst));
  }

  private static String qualities(String quality, String field, String levels) {
    return around(set(quality, field, levels));
  }

  private static String around(String sets) {
    return RuleExampleFragments.set(
        "metadata",
        RuleExampleFragments.set("metadata", sets)
            .replaceFirst("<MetadataSet", "<MetadataSet name='fieldQualities'"));
  }

  private static String set(String quality, String field, String levels) {
    return RuleExampleFragments.set(
        "value",
        RuleExampleFragments.string("quality", quality)
            + RuleExampleFragments.string("field", field)
            + levels);
  }

  private static String level(String degree, String schema, String value) {
    return RuleExampleFragments.set(
        "value",
        RuleExampleFragments.string("degreeOfConsistency", degree)
            + RuleExampleFragments.string("schemaBelonginess", schema)
            + RuleExampleFragments.string("value", value));
  }
}
