package org.selectiverenderer.enricher.preview;

import java.util.Optional;
import org.selectiverenderer.browser.scene.Node;

/**
 * Identifies a node both in the document and in the running scene: by its DEF name, and by the
 * position of its start tag in the text that was loaded.
 *
 * @param line of the start tag, from 1
 * @param column of the start tag, from 1
 */
record SourceAnchor(Optional<String> def, int line, int column) {
  static SourceAnchor of(Node node) {
    return new SourceAnchor(
        Optional.ofNullable(node.name()), node.location().line(), node.location().column());
  }
}
