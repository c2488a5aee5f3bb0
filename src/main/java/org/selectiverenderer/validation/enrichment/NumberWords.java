package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.schema.nodes.NodeMetadata;

/** Counts with their nouns, for messages. */
final class NumberWords {
  private NumberWords() {}

  /**
   * Returns the number of sets in a Switch's metadata; metadata without sets count as one set for
   * the first child.
   */
  static String sets(List<NodeMetadata> sets) {
    int count = Math.max(1, sets.size());
    return count + (count == 1 ? " MetadataSet" : " MetadataSets");
  }

  static String children(int count) {
    return count + (count == 1 ? " child" : " children");
  }
}
