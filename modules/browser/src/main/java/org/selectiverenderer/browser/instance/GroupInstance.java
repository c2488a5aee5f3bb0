package org.selectiverenderer.browser.instance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.nodes.group.Deformer;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.layout.LayoutRectangle;
import org.selectiverenderer.browser.nodes.layout.ViewDependentLayout;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;

/** An instance of a grouping node. Its children are in the order of the node's children. */
public final class GroupInstance extends Instance implements NodeObserver {
  private static final GroupingNode.Effect[] NOTHING = {};

  private final GroupingNode group;
  private final InstanceTree tree;
  private Matrix4dc content = IDENTITY;
  List<Instance> children = List.of();
  boolean disposed;
  long restructured;

  /** The layout rectangle for the groups below; null if it is the one of the group above. */
  private @Nullable LayoutRectangle region;

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

  /**
   * Returns the {@link InstanceTree#structureVersion} with which the children of this group or of
   * one below it last became others; 0 if they are those with which it began.
   */
  public long restructured() {
    return restructured;
  }

  /** Returns whether the same group node is an ancestor, as in a scene that contains itself. */
  boolean insideItself() {
    for (GroupInstance above = parent(); above != null; above = above.parent()) {
      if (above.group == group) {
        return true;
      }
    }
    return false;
  }

  /** Returns the matrix from the children's local coordinates to the world. */
  public Matrix4dc content() {
    return content;
  }

  /**
   * Returns the lights that reach the group's children (X3D 4.0, 17.2.1.1): those of the groups
   * above and those whose scope is this group. Without lights of its own it returns the same list
   * object.
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
    if (group instanceof ViewDependentLayout seen) {
      ViewDependentLayout.Spot spot = spot(seen);
      content = spot.content();
      region = spot.region().orElse(null);
    } else {
      content = placed();
    }
  }

  /** Adapts the group to the size of the picture; returns whether that moved its content. */
  boolean see() {
    ViewDependentLayout.Spot spot = spot((ViewDependentLayout) group);
    region = spot.region().orElse(null);
    return !content.equals(spot.content());
  }

  private ViewDependentLayout.Spot spot(ViewDependentLayout seen) {
    Optional<LayoutRectangle> above = Optional.empty();
    for (GroupInstance at = parent(); at != null && above.isEmpty(); at = at.parent()) {
      above = Optional.ofNullable(at.region);
    }
    return seen.spot(world(), tree.sight(), above);
  }

  private Matrix4dc placed() {
    if (group instanceof ViewDependentLayout seen) {
      return spot(seen).content();
    }
    return group.placement().map(local -> (Matrix4dc) world().mul(local, local)).orElse(world());
  }

  /** Returns whether the children's coordinate system has moved since they were last placed. */
  boolean elsewhere() {
    return !content.equals(placed());
  }

  @Override
  public void changed(Node node, int field) {
    GroupingNode.Effect effect = group.effectOf(field);
    if (effect == GroupingNode.Effect.STRUCTURE) {
      tree.structureChanges();
    }
    if (effect != GroupingNode.Effect.NONE) {
      affected(effect);
    }
  }

  /** Stores an effect until the next update of the tree. */
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

  /** Applies the stored effects. */
  void update() {
    GroupingNode.Effect[] effects = pending;
    pending = NOTHING;
    if (disposed) {
      return; // The group left the scene between the change and this update.
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
        case FORM -> ((Deformer) group).deform();
        case NONE -> {}
      }
    }
  }

  /** Shows and hides the children by the node's present state. */
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
