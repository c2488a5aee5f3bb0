package org.selectiverenderer.enricher.tree;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.structure.ChildPosition;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Moves or copies nodes that are dragged in the tree. */
public interface NodeDrop {
  /** Returns why nodes cannot go to a position, as a sentence; empty if they can. */
  Optional<String> complaint(List<DocumentElement> nodes, ChildPosition position, boolean copy);

  /** Moves or copies nodes to a position. */
  void drop(List<DocumentElement> nodes, ChildPosition position, boolean copy);
}
