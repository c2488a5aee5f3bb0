package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.browser.nodes.group.SwitchNode;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The version of one object that the author wants to see in its place, whatever the schemas select;
 * it outlives successive states of the document. Confined to the preview's thread.
 */
final class VersionOverride {
  private @Nullable SourceAnchor object;
  private int choice = -1;

  /**
   * Chooses another version of the object that is selected or around the selection.
   *
   * @param selection anchors of the selected element and those around it, the nearest first
   * @param steps steps from the version shown; 0 for the one that the schemas select
   */
  void step(PreviewScene scene, List<SourceAnchor> selection, int steps) {
    Optional<SourceAnchor> anchor =
        selection.stream().filter(each -> find(scene, each).isPresent()).findFirst();
    if (steps == 0 || anchor.isEmpty()) {
      object = null;
      choice = -1;
    } else {
      SwitchNode node = find(scene, anchor.get()).orElseThrow();
      int count = node.children().size();
      object = anchor.get();
      choice = count == 0 ? -1 : Math.floorMod(node.whichChoice() + steps, count);
    }
    apply(scene);
  }

  /** Applies the choice to a scene of another state of the document. */
  void apply(PreviewScene scene) {
    Optional<SwitchNode> node = Optional.ofNullable(object).flatMap(each -> find(scene, each));
    boolean there = node.filter(found -> choice < found.children().size()).isPresent();
    scene.version(there ? node.get() : null, there ? choice : -1);
  }

  private static Optional<SwitchNode> find(PreviewScene scene, SourceAnchor anchor) {
    return scene
        .nodes()
        .find(List.of(anchor))
        .filter(SwitchNode.class::isInstance)
        .map(SwitchNode.class::cast);
  }

  /** Returns the line of text about it in the picture; empty for no choice. */
  static Optional<String> words(PreviewScene scene) {
    return scene
        .versioned()
        .map(
            node ->
                Texts.of(
                    "compare.version",
                    node.name() == null ? node.type().name() : node.name(),
                    Integer.toString(node.whichChoice() + 1),
                    Integer.toString(node.children().size()),
                    DecimalFormatter.grouped(scene.shownPolygons(node))));
  }
}
