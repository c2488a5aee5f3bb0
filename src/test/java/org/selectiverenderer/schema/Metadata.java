package org.selectiverenderer.schema;

import java.util.List;

/** Metadata written in a test. */
record Metadata(boolean isSet, String name, List<String> values, List<Metadata> children)
    implements MetadataSource {
  static Metadata set(Metadata... children) {
    return new Metadata(true, "", List.of(), List.of(children));
  }

  static Metadata string(String name, String... values) {
    return new Metadata(false, name, List.of(values), List.of());
  }

  /** One choice as the figures write it. */
  static Metadata choice(String type, String degree, String schema) {
    return set(
        string("consistencyType", type),
        string("degreeOfConsistency", degree),
        string("schemaBelonginess", schema));
  }
}
