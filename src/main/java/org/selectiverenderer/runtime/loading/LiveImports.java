package org.selectiverenderer.runtime.loading;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;

/** Brings imports up to date when Inlines of a running scene have other contents. */
final class LiveImports {
  private final Scene scene;
  private final Problems problems;

  /**
   * @param scene the outermost
   */
  LiveImports(Scene scene, Problems problems) {
    this.scene = scene;
    this.problems = problems;
  }

  /** The scene that an Inline shows; empty for one that shows none and for other nodes. */
  static Optional<Scene> content(Node node) {
    return node instanceof InlineNode inline ? inline.shown() : Optional.empty();
  }

  /**
   * Looks at all scenes that import anything, until nothing changes: what one imports another may
   * import from it.
   *
   * @param inlines all those in the scene whose contents import anything
   */
  void refresh(Collection<InlineNode> inlines) {
    List<Scene> importing = new ArrayList<>();
    inlines.forEach(inline -> inline.content().ifPresent(importing::add));
    if (!scene.imports().isEmpty()) {
      importing.add(scene);
    }
    boolean changed = true;
    for (int round = 0; changed && round <= importing.size(); round++) {
      changed = false;
      for (Scene each : importing) {
        changed |= each.imports().refresh(each, LiveImports::content, problems::error);
      }
    }
  }
}
