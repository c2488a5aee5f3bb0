package org.selectiverenderer.x3d.tessellate;

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
import org.selectiverenderer.x3d.geodesy.GeoCoordinateTransform;

/**
 * Returns the children and the transform of each kind of grouping node, in a file or a running
 * scene. The content of Inlines is not known here.
 */
public final class GroupingNodeChildren {
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

  private GroupingNodeChildren() {}

  /** Returns whether a node type is a grouping node, whose children are in the same file. */
  public static boolean isGroup(NodeType type) {
    return WITH_CHILDREN.contains(type.name())
        || type.name().equals("CADFace")
        || type.name().equals("CollidableShape")
        || type.name().equals("CollidableOffset")
        || type.name().equals("GeoLOD")
        || type.name().equals("HAnimHumanoid");
  }

  /** Returns the children of a group or the layers of a LayerSet, shown or not; else none. */
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
   * Returns a humanoid's skeleton, skin and motions, and those of its viewpoints that are not part
   * of the skeleton (X3D 4.0, 26.3.2).
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

  /** Returns the transform from a group's local coordinates to its parent's; empty if identity. */
  public static Optional<Matrix4d> placement(NodeView node) {
    return switch (node.type().name()) {
      case "GeoLocation" -> Optional.of(GeospatialMatrix.location(node));
      case "GeoTransform" -> Optional.of(GeospatialMatrix.transform(node));
      case "CollidableShape", "CollidableOffset" -> Optional.of(TransformMatrix.ofCollidable(node));
      default ->
          TRANSFORMS.contains(node.type().name())
              ? Optional.of(TransformMatrix.of(node, new Matrix4d()))
              : Optional.empty();
    };
  }

  /** Computes the transforms of geospatial grouping nodes in doubles (X3D 4.0, clause 25). */
  private static final class GeospatialMatrix {
    private static final float[] NO_CENTER = {0, 0, 0};

    private GeospatialMatrix() {}

    /** Returns the transform of a GeoLocation (25.3.7): x east, y up, z south. */
    static Matrix4d location(NodeView node) {
      return GeoCoordinateTransform.of(node).place((double[]) node.value("geoCoords"));
    }

    /**
     * Returns the transform of a GeoTransform (25.3.11), which translates, rotates and scales in
     * the local frame (east, up, south) of its {@code geoCenter}.
     */
    static Matrix4d transform(NodeView node) {
      Matrix4d center = GeoCoordinateTransform.of(node).place((double[]) node.value("geoCenter"));
      Matrix4d back = center.invertAffine(new Matrix4d());
      return TransformMatrix.of(
              center,
              node.floats("translation"),
              NO_CENTER,
              node.floats("rotation"),
              node.floats("scale"),
              node.floats("scaleOrientation"))
          .mul(back);
    }
  }
}
