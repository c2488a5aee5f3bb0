package org.selectiverenderer.browser.loading;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;

/** Updates the imports of a running scene when the contents of its Inlines change. */
final class ImportUpdater {
  private final Scene scene;
  private final ProblemCollector problems;

  /**
   * @param scene the outermost scene
   */
  ImportUpdater(Scene scene, ProblemCollector problems) {
    this.scene = scene;
    this.problems = problems;
  }

  /** Returns the scene that an Inline shows; empty if it shows none or the node is no Inline. */
  static Optional<Scene> content(Node node) {
    return node instanceof InlineNode inline ? inline.shown() : Optional.empty();
  }

  /**
   * Updates all scenes with imports until nothing changes, since a scene may import a node that
   * another scene has imported.
   *
   * @param inlines all Inlines in the scene whose contents import anything
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
        changed |= each.imports().refresh(each, ImportUpdater::content, problems::error);
      }
    }
  }
}
