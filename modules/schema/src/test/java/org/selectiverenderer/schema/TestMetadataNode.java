package org.selectiverenderer.schema;

import java.util.List;

/** Metadata written in a test. */
record TestMetadataNode(
    boolean isSet, String name, List<String> values, List<TestMetadataNode> children)
    implements MetadataNode {
  static TestMetadataNode set(TestMetadataNode... children) {
    return new TestMetadataNode(true, "", List.of(), List.of(children));
  }

  static TestMetadataNode string(String name, String... values) {
    return new TestMetadataNode(false, name, List.of(values), List.of());
  }

  /** One choice as the figures write it. */
  static TestMetadataNode choice(String type, String degree, String schema) {
    return set(
        string("consistencyType", type),
        string("degreeOfConsistency", degree),
        string("schemaBelonginess", schema));
  }
}
