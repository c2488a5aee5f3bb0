package org.selectiverenderer.browser.nodes.hanim;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.group.Deformer;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * HAnimSegment (X3D 4.0, 26.3.5): a body segment with its shapes. Its displacers move the points of
 * its {@code coord}, which the shapes share.
 */
public final class HAnimSegmentNode extends GroupingNode implements Deformer {
  private final int displacers;
  private final int coord;
  private final NodeObserver watch = this::watched;
  private final Set<Node> watched = Collections.newSetFromMap(new IdentityHashMap<>());
  private @Nullable RestPoseVertices points;

  public HAnimSegmentNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    displacers = type.indexOf("displacers");
    coord = type.indexOf("coord");
  }

  @Override
  public Effect effectOf(int field) {
    return field == displacers || field == coord ? Effect.FORM : super.effectOf(field);
  }

  private void watched(Node node, int field) {
    if (points == null || node != points.node() || points.others(field)) {
      tellObservers(displacers);
    }
  }

  @Override
  public void deform() {
    List<Node> all = Displacers.of(this);
    Node held = node("coord");
    boolean usable = held != null && held.type().name().equals("Coordinate");
    if (!usable || all.isEmpty()) {
      follow(List.of());
      if (points != null) {
        points.show(points.rest());
        points = null;
      }
      return;
    }
    if (points == null || points.node() != held) {
      points = new RestPoseVertices(held, "point");
    }
    follow(all);
    if (watched.add(held)) {
      held.addObserver(watch);
    }
    float[] moved = points.rest().clone();
    Displacers.apply(all, moved);
    points.show(moved);
  }

  private void follow(List<Node> now) {
    watched.removeIf(
        node -> {
          boolean gone = !now.contains(node);
          if (gone) {
            node.removeObserver(watch);
          }
          return gone;
        });
    for (Node node : now) {
      if (watched.add(node)) {
        node.addObserver(watch);
      }
    }
  }
}
