package org.selectiverenderer.enricher.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Selects nodes by clicks: a click again on the node that was clicked on selects what is around it,
 * up to the scene and then the node again; a click with a key down adds a node to the selection or
 * takes it away.
 */
public final class ClickSelection {
  private final EnricherSession session;
  private @Nullable DocumentElement clicked;
  private @Nullable DocumentElement chosen;

  /** Creates the clicks of one view. */
  public ClickSelection(EnricherSession session) {
    this.session = session;
  }

  /**
   * A click on a node.
   *
   * @param origin the view
   */
  public void select(DocumentElement node, Object origin) {
    boolean again =
        clicked == node
            && chosen != null
            && session.selectedElements().equals(List.of(chosen))
            && chosen.attached();
    Optional<DocumentElement> around = again ? chosen.parent() : Optional.empty();
    DocumentElement now = around.filter(parent -> !outside(parent)).orElse(node);
    clicked = node;
    chosen = now;
    session.select(now, origin);
  }

  private static boolean outside(DocumentElement element) {
    return element.name().equals("Scene") || element.name().equals("X3D");
  }

  /** A click on a node with Ctrl or Shift. */
  public void toggle(DocumentElement node, Object origin) {
    List<DocumentElement> now = new ArrayList<>(session.selectedElements());
    if (!now.remove(node)) {
      now.add(node);
    }
    clicked = null;
    session.selectAll(now, origin);
  }

  /** Whether a node is one of several that are selected. */
  public boolean among(DocumentElement node) {
    return session.selectedElements().size() > 1 && session.selectedElements().contains(node);
  }
}
