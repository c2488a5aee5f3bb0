package org.selectiverenderer.runtime.instance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.nodes.group.Deforming;
import org.selectiverenderer.runtime.nodes.group.GroupingNode;
import org.selectiverenderer.runtime.nodes.layout.Region;
import org.selectiverenderer.runtime.nodes.layout.Seen;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.NodeObserver;

/** A group in one place. Its children stand in the order of the node's own children. */
public final class GroupInstance extends Instance implements NodeObserver {
  private static final GroupingNode.Effect[] NOTHING = {};

  private final GroupingNode group;
  private final InstanceTree tree;
  private Matrix4dc content = IDENTITY;
  List<Instance> children = List.of();
  boolean disposed;

  /** The rectangle of a layout that groups below lie in; null where it is the one above. */
  private @Nullable Region region;

  private GroupingNode.Effect[] pending = NOTHING;

  GroupInstance(GroupingNode node, @Nullable GroupInstance parent, InstanceTree tree) {
    super(node, parent);
    this.group = node;
    this.tree = tree;
    place();
  }

  @Override
  public GroupingNode node() {
    return group;
  }

  public List<Instance> children() {
    return children;
  }

  /** Whether the same group stands above it: a scene that contains itself. */
  boolean insideItself() {
    for (GroupInstance above = parent(); above != null; above = above.parent()) {
      if (above.group == group) {
        return true;
      }
    }
    return false;
  }

  /** From the children's local coordinates to the world. */
  public Matrix4dc content() {
    return content;
  }

  /**
   * The lights that reach what is in the group (X3D 4.0, 17.2.1.1): those from above, the same list
   * where there are no more, and those of the group whose scope it is.
   */
  List<LightInstance> lit(List<LightInstance> above, Comparator<LightInstance> order) {
    List<LightInstance> all = null;
    for (Instance child : children) {
      if (child instanceof LightInstance light && !light.light().global()) {
        all = all == null ? new ArrayList<>(above) : all;
        all.add(light);
      }
    }
    if (all == null) {
      return above;
    }
    all.sort(order);
    return List.copyOf(all);
  }

  private void place() {
    if (group instanceof Seen seen) {
      Seen.Spot spot = spot(seen);
      content = spot.content();
      region = spot.region().orElse(null);
    } else {
      content = placed();
    }
  }

  /** Follows the picture; says whether its content is elsewhere by it. */
  boolean see() {
    Seen.Spot spot = spot((Seen) group);
    region = spot.region().orElse(null);
    return !content.equals(spot.content());
  }

  private Seen.Spot spot(Seen seen) {
    Optional<Region> above = Optional.empty();
    for (GroupInstance at = parent(); at != null && above.isEmpty(); at = at.parent()) {
      above = Optional.ofNullable(at.region);
    }
    return seen.spot(world(), tree.sight(), above);
  }

  private Matrix4dc placed() {
    if (group instanceof Seen seen) {
      return spot(seen).content();
    }
    return group.placement().map(local -> (Matrix4dc) world().mul(local, local)).orElse(world());
  }

  /** Whether the children's coordinates lie elsewhere than when they were last placed. */
  boolean elsewhere() {
    return !content.equals(placed());
  }

  @Override
  public void changed(Node node, int field) {
    GroupingNode.Effect effect = group.effectOf(field);
    if (effect != GroupingNode.Effect.NONE) {
      affected(effect);
    }
  }

  /** Remembers an effect until the tree is updated. */
  void affected(GroupingNode.Effect effect) {
    for (GroupingNode.Effect known : pending) {
      if (known == effect) {
        return;
      }
    }
    if (pending.length == 0) {
      tree.pending(this);
    }
    pending = Arrays.copyOf(pending, pending.length + 1);
    pending[pending.length - 1] = effect;
  }

  /** Applies the effects remembered. */
  void update() {
    GroupingNode.Effect[] effects = pending;
    pending = NOTHING;
    if (disposed) {
      return; // It left the scene between the change and this update.
    }
    for (GroupingNode.Effect effect : effects) {
      switch (effect) {
        case STRUCTURE -> tree.rebuild(this);
        case PLACEMENT -> {
          moved(tree);
          tree.moved();
        }
        case CHOICE -> {
          choose();
          tree.chosen();
        }
        case FORM -> ((Deforming) group).deform();
        case NONE -> {}
      }
    }
  }

  /** Shows and hides the children as the node now says. */
  void choose() {
    for (int i = 0; i < children.size(); i++) {
      children.get(i).show(shown && group.shows(i), tree);
    }
  }

  @Override
  void show(boolean show, InstanceTree tree) {
    if (show != shown) {
      shown = show;
      choose();
    }
  }

  @Override
  void moved(InstanceTree tree) {
    place();
    for (Instance child : children) {
      child.moved(tree);
    }
  }
}
