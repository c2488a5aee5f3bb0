package org.selectiverenderer.geometry.tessellate;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Which nodes a group of a file or of a running scene holds, and where it places them. Inlines hold
 * another file, which is not known here.
 */
public final class NodeContent {
  private static final Set<String> TRANSFORMS =
      Set.of("Transform", "CADPart", "EspduTransform", "HAnimHumanoid", "HAnimJoint", "HAnimSite");
  private static final Set<String> WITH_CHILDREN =
      Set.of(
          "Group",
          "StaticGroup",
          "Layer",
          "LayoutGroup",
          "LayoutLayer",
          "ScreenGroup",
          "Anchor",
          "CADAssembly",
          "CADLayer",
          "CADPart",
          "PickableGroup",
          "ViewpointGroup",
          "Transform",
          "EspduTransform",
          "Viewport",
          "Switch",
          "LOD",
          "Billboard",
          "Collision",
          "HAnimJoint",
          "HAnimSegment",
          "HAnimSite",
          "GeoLocation",
          "GeoTransform");

  private NodeContent() {}

  /** Whether nodes of a type hold others of the same file that are drawn. */
  public static boolean isGroup(NodeType type) {
    return WITH_CHILDREN.contains(type.name())
        || type.name().equals("CADFace")
        || type.name().equals("CollidableShape")
        || type.name().equals("CollidableOffset")
        || type.name().equals("GeoLOD")
        || type.name().equals("HAnimHumanoid");
  }

  /** The nodes in a group or the layers of a LayerSet, shown or not; none for all others. */
  public static List<? extends NodeView> of(NodeView node) {
    return switch (node.type().name()) {
      case "CADFace", "CollidableShape" -> one(node.node("shape"));
      case "CollidableOffset" -> one(node.node("collidable"));
      case "GeoLOD" -> node.nodes("rootNode");
      case "HAnimHumanoid" -> figure(node);
      case "LayerSet" -> node.nodes("layers");
      default -> WITH_CHILDREN.contains(node.type().name()) ? node.nodes("children") : List.of();
    };
  }

  private static List<? extends NodeView> one(@Nullable NodeView held) {
    return held == null ? List.of() : List.of(held);
  }

  /**
   * A humanoid's skeleton, skin and motions, and those of its viewpoints that do not stand in the
   * skeleton (X3D 4.0, 26.3.2).
   */
  private static List<? extends NodeView> figure(NodeView humanoid) {
    List<NodeView> all = new ArrayList<>(humanoid.nodes("skeleton"));
    List<? extends NodeView> viewpoints = humanoid.nodes("viewpoints");
    if (!viewpoints.isEmpty()) {
      Set<NodeView> inSkeleton = Collections.newSetFromMap(new IdentityHashMap<>());
      all.forEach(root -> collect(root, inSkeleton));
      viewpoints.stream().filter(site -> !inSkeleton.contains(site)).forEach(all::add);
    }
    all.addAll(humanoid.nodes("skin"));
    all.addAll(humanoid.nodes("motions"));
    return List.copyOf(all);
  }

  private static void collect(NodeView node, Set<NodeView> seen) {
    List<NodeView> open = new ArrayList<>(List.of(node));
    while (!open.isEmpty()) {
      NodeView next = open.remove(open.size() - 1);
      if (seen.add(next)) {
        open.addAll(of(next));
      }
    }
  }

  /** From the coordinates of a group's content to those of its parent; empty when the same. */
  public static Optional<Matrix4d> placement(NodeView node) {
    return switch (node.type().name()) {
      case "GeoLocation" -> Optional.of(GeoPlacement.location(node));
      case "GeoTransform" -> Optional.of(GeoPlacement.transform(node));
      case "CollidableShape", "CollidableOffset" ->
          Optional.of(TransformPlacement.ofCollidable(node));
      default ->
          TRANSFORMS.contains(node.type().name())
              ? Optional.of(TransformPlacement.of(node, new Matrix4d()))
              : Optional.empty();
    };
  }
}
