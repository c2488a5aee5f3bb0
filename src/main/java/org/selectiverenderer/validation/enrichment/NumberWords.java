package org.selectiverenderer.validation.enrichment;

import java.util.List;
import org.selectiverenderer.schema.nodes.NodeMetadata;

/** Numbers in words. */
final class NumberWords {
  private NumberWords() {}

  /** The sets of a Switch's metadata; metadata without sets is one for the first child. */
  static String sets(List<NodeMetadata> sets) {
    int count = Math.max(1, sets.size());
    return count + (count == 1 ? " MetadataSet" : " MetadataSets");
  }

  static String children(int count) {
    return count + (count == 1 ? " child" : " children");
  }
}
