package org.selectiverenderer.validation.enrichment;

/** Scene fragments for the examples of rules: a desk area, and a lamp whose versions follow it. */
final class RuleExampleFragments {
  static final String ENTER_DESK = string("enterTimeSchema", "Desk");
  static final String EXIT_OFFICE = string("exitTimeSchema", "Office");

  /** Fewer polygons than {@link #DETAILED}. */
  static final String SIMPLE = "  <Shape><Box/></Shape>\n";

  static final String DETAILED = "  <Shape><Sphere/></Shape>\n";

  static final String LAMP =
      lamp("1", choice("low", "Desk") + choice("high", "Office"), DETAILED + SIMPLE);

  private RuleExampleFragments() {}

  /** Returns a correct area of a desk. */
  static String desk() {
    return sensor("3 2 3", ENTER_DESK + EXIT_OFFICE);
  }

  /** Returns an area. */
  static String sensor(String size, String strings) {
    return "<ProximitySensor DEF='DeskProx' size='%s'>\n%s</ProximitySensor>\n"
        .formatted(size, set("metadata", strings).indent(2));
  }

  /** Returns a versioned object. */
  static String lamp(String choice, String sets, String versions) {
    return "<Switch DEF='Lamp' whichChoice='%s'>\n%s%s</Switch>\n"
        .formatted(choice, set("metadata", sets).indent(2), versions);
  }

  /** Returns the MetadataSet of one version. */
  static String choice(String degree, String schema) {
    return set(
        "value", string("degreeOfConsistency", degree) + string("schemaBelonginess", schema));
  }

  static String set(String field, String content) {
    return "<MetadataSet containerField='%s'>\n%s</MetadataSet>\n"
        .formatted(field, content.indent(2));
  }

  static String string(String name, String value) {
    return "<MetadataString containerField='value' name='%s' value='\"%s\"'/>\n"
        .formatted(name, value);
  }
}
