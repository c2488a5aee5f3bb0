package org.selectiverenderer.enricher.preview;

import java.util.Comparator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;

/**
 * A ProtoInstance of the document, whose place in the running scene the nodes of a body take.
 *
 * @param first the first node of the body
 * @param location of the ProtoInstance in the text that was loaded
 */
record ProtoInstanceOrigin(Node first, SourceLocation location) {
  private static final Comparator<SourceLocation> ORDER =
      Comparator.comparingInt(SourceLocation::line).thenComparingInt(SourceLocation::column);

  /** Returns the instance whose place a node takes; null for a node that is written itself. */
  static @Nullable ProtoInstanceOrigin of(Node node) {
    return PrototypeInstance.location(node)
        .map(location -> new ProtoInstanceOrigin(node, location))
        .orElse(null);
  }

  /**
   * Returns whether a node below the first one is written in the instance, as a value of a field. A
   * body always precedes its instances, or is in another file.
   */
  boolean given(SourceLocation node) {
    return ofItsFile(node) && ORDER.compare(node, location) > 0;
  }

  /** Returns whether a node's location is in the file of the instance. */
  boolean ofItsFile(SourceLocation node) {
    return node.file().equals(location.file());
  }
}
