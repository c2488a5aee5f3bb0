package org.selectiverenderer.schema;

import java.util.List;

/**
 * A metadata node, wherever it comes from: a file, a running scene, a document that is being
 * edited. Two sources are equal when they stand for the same node.
 */
public interface MetadataSource {
  /** Whether it is a MetadataSet. */
  boolean isSet();

  /** The name field. */
  String name();

  /** The values, numbers as text; none for a set. */
  List<String> values();

  /** The metadata in a set, in order; none unless it is a set. */
  List<? extends MetadataSource> children();
}
