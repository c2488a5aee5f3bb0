package org.selectiverenderer.schema;

import java.util.List;
import java.util.Optional;

/** Metadata written in a test. */
record TestMetadataNode(
    boolean isSet,
    String name,
    List<String> values,
    List<TestMetadataNode> children,
    Optional<TestMetadataNode> metadata)
    implements MetadataNode {
  static TestMetadataNode set(TestMetadataNode... children) {
    return new TestMetadataNode(true, "", List.of(), List.of(children), Optional.empty());
  }

  static TestMetadataNode string(String name, String... values) {
    return new TestMetadataNode(false, name, List.of(values), List.of(), Optional.empty());
  }

  static TestMetadataNode named(String name, TestMetadataNode... children) {
    return new TestMetadataNode(true, name, List.of(), List.of(children), Optional.empty());
  }

  TestMetadataNode with(TestMetadataNode ofItself) {
    return new TestMetadataNode(isSet, name, values, children, Optional.of(ofItself));
  }

  /** One choice as the figures write it. */
  static TestMetadataNode choice(String type, String degree, String schema) {
    return set(
        string("consistencyType", type),
        string("degreeOfConsistency", degree),
        string("schemaBelonginess", schema));
  }
}
