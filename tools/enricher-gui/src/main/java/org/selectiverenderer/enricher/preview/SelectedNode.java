package org.selectiverenderer.enricher.preview;

import java.util.List;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A node of the document as the running scene finds it; a value, but for the element, which the
 * preview's thread only hands back.
 *
 * @param element the node
 * @param anchors of the node and of those around it, the nearest first
 * @param inside whether its coordinates are those in it, as of a Transform, or those around it
 * @param use how many nodes before it share its name: 0 for the DEF, 1 for the first USE
 */
record SelectedNode(DocumentElement element, List<SourceAnchor> anchors, boolean inside, int use) {
  SelectedNode {
    anchors = List.copyOf(anchors);
  }
}
