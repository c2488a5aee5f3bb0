package org.selectiverenderer.runtime.nodes.group;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A node with children (X3D 4.0, 10.2.1): Group, StaticGroup, Anchor, and the base of those that
 * choose among their children or place them.
 */
public class GroupingNode extends Node {
  private final int children;
  private final int visible;
  private final int pickable;
  private final int objectType;

  public GroupingNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    children = index(type, "children");
    visible = index(type, "visible");
    pickable = index(type, "pickable");
    objectType = index(type, "objectType");
  }

  private static int index(NodeType type, String field) {
    return type.field(field).map(FieldDefinition::index).orElse(-1);
  }

  /** What stands in the group, in order. */
  @SuppressWarnings("unchecked")
  public List<Node> children() {
    return children < 0 ? List.of() : (List<Node>) value(children);
  }

  /** Whether the child at that index is to be seen, as far as this node decides. */
  public boolean shows(int child) {
    return visible();
  }

  /** The field {@code visible} (X3D 4.0); true for what has none. */
  protected final boolean visible() {
    return visible < 0 || (Boolean) value(visible);
  }

  /** From the children's coordinates to the group's own; empty when they are the same. */
  public Optional<Matrix4d> placement() {
    return Optional.empty();
  }

  /** What a change of a field means for the instances of the group. */
  public Effect effectOf(int field) {
    if (field == children) {
      return Effect.STRUCTURE;
    }
    return field == visible || field == pickable || field == objectType
        ? Effect.CHOICE
        : Effect.NONE;
  }

  /** What follows from a new value of a field. */
  public enum Effect {
    NONE,
    /** Other children. */
    STRUCTURE,
    /** Other children are shown, or may be picked. */
    CHOICE,
    /** The children are elsewhere. */
    PLACEMENT,
    /** What is in it has another form: {@link Deforming#deform()}. */
    FORM
  }

  @Override
  @SuppressWarnings("unchecked")
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
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

  /** What is already there is not added, what is not there not removed (X3D 4.0, 10.2.1). */
  private void sendChildren(List<Node> now, Cascade cascade) {
    if (now.size() != children().size()) {
      emit(children, List.copyOf(now), cascade);
    }
  }
}
