package org.selectiverenderer.browser.nodes.group;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A grouping node (X3D 4.0, 10.2.1): Group, StaticGroup, Anchor, and the base class of nodes that
 * choose among their children or transform them.
 */
public class GroupingNode extends Node {
  private final int children;
  private final int visible;
  private final int pickable;
  private final int objectType;

  public GroupingNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    children = index(type, "children");
    visible = index(type, "visible");
    pickable = index(type, "pickable");
    objectType = index(type, "objectType");
  }

  private static int index(NodeType type, String field) {
    return type.field(field).map(FieldDefinition::index).orElse(-1);
  }

  /** Returns the children, in order. */
  @SuppressWarnings("unchecked")
  public List<Node> children() {
    return children < 0 ? List.of() : (List<Node>) value(children);
  }

  /** Returns whether this node shows the child at an index. */
  public boolean shows(int child) {
    return visible();
  }

  /** Returns the field {@code visible} (X3D 4.0); true for node types without it. */
  protected final boolean visible() {
    return visible < 0 || (Boolean) value(visible);
  }

  /**
   * Returns the matrix from the children's coordinates to the group's own; empty if they are the
   * same.
   */
  public Optional<Matrix4d> placement() {
    return Optional.empty();
  }

  /** Returns the effect of a changed field on the instances of the group. */
  public Effect effectOf(int field) {
    if (field == children) {
      return Effect.STRUCTURE;
    }
    return field == visible || field == pickable || field == objectType
        ? Effect.CHOICE
        : Effect.NONE;
  }

  /** The effects of a new field value. */
  public enum Effect {
    NONE,
    /** The children are other nodes. */
    STRUCTURE,
    /** Other children are shown or may be picked. */
    CHOICE,
    /** The children have another transformation. */
    PLACEMENT,
    /** The geometry is to be deformed by {@link Deformer#deform()}. */
    FORM
  }

  @Override
  @SuppressWarnings("unchecked")
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    switch (field.name()) {
      case "addChildren" -> {
        Set<Node> all = Collections.newSetFromMap(new IdentityHashMap<>());
        all.addAll(children());
        List<Node> now = new ArrayList<>(children());
        for (Node added : (List<Node>) value) {
          if (all.add(added)) {
            now.add(added);
          }
        }
        sendChildren(now, cascade);
      }
      case "removeChildren" -> {
        Set<Node> removed = Collections.newSetFromMap(new IdentityHashMap<>());
        removed.addAll((List<Node>) value);
        List<Node> now = new ArrayList<>(children());
        now.removeIf(removed::contains);
        sendChildren(now, cascade);
      }
      default -> super.receive(field, value, cascade);
    }
  }

  /**
   * Sends the new children; a child already present is not added again, and removing an absent one
   * has no effect (X3D 4.0, 10.2.1).
   */
  private void sendChildren(List<Node> now, EventCascade cascade) {
    if (now.size() != children().size()) {
      emit(children, List.copyOf(now), cascade);
    }
  }
}
