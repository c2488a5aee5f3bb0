package org.selectiverenderer.schema;

import java.util.List;
import java.util.Optional;

/**
 * A metadata node of a file, of a running scene, or of a document being edited. Two sources are
 * equal if they represent the same node.
 */
public interface MetadataNode {
  /** Returns whether the node is a MetadataSet. */
  boolean isSet();

  /** Returns the value of the field {@code name}. */
  String name();

  /** Returns the values, numbers as text; none for a set. */
  List<String> values();

  /** Returns the metadata nodes in a set, in order; none if the node is not a set. */
  List<? extends MetadataNode> children();

  /** Returns the metadata of this metadata node, if it has any. */
  Optional<? extends MetadataNode> metadata();
}
