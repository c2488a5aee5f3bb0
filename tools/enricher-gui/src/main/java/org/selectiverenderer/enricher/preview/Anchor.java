package org.selectiverenderer.enricher.preview;

import java.util.Optional;
import org.selectiverenderer.runtime.scene.Node;

/**
 * What an element of the document and a node of the running scene have in common: the DEF name, and
 * the place in the text that was loaded.
 *
 * @param line of the start tag, from 1
 * @param column of the start tag, from 1
 */
record Anchor(Optional<String> def, int line, int column) {
  static Anchor of(Node node) {
    return new Anchor(
        Optional.ofNullable(node.name()), node.location().line(), node.location().column());
  }
}
