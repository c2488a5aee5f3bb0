package org.selectiverenderer.authoring.area;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.tessellate.TransformMatrix;

/**
 * The local coordinate system of a node, and its transformation to scene coordinates.
 *
 * @param world transformation from node to scene coordinates
 * @param axis for each axis X, Y, Z of the scene the node's nearest axis: 0, 1 or 2
 * @param scale for each axis of the scene the length in the scene of a unit along the node's
 *     nearest axis
 * @param turned whether the node's axes are not parallel to those of the scene
 * @param transforms the enclosing Transforms that translate, rotate or scale the node, the
 *     innermost first
 */
public record LocalCoordinateSystem(
    Matrix4dc world,
    List<Integer> axis,
    Vector3dc scale,
    boolean turned,
    List<DocumentElement> transforms) {
  /** The tolerance for parallel axes. */
  private static final double PARALLEL = 1e-6;

  private static final int[][] ORDERS = {
    {0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}
  };

  /**
   * Computes the frame of a node from the text.
   *
   * @return empty where the text does not determine it: in a ProtoBody, under a Billboard or
   *     geospatial node, under a Transform with a zero scale
   */
  public static Optional<LocalCoordinateSystem> of(DocumentElement node) {
    return node.parent()
        .map(LocalCoordinateSystem::within)
        .orElseGet(() -> of(new Matrix4d(), List.of()));
  }

  /**
   * Computes the frame of the children of a node from the text.
   *
   * @return empty where the text does not determine it
   */
  public static Optional<LocalCoordinateSystem> within(DocumentElement parent) {
    List<DocumentElement> transforms = new ArrayList<>();
    Matrix4d world = new Matrix4d();
    for (Optional<DocumentElement> each = Optional.of(parent);
        each.isPresent();
        each = each.get().parent()) {
      DocumentElement at = each.get();
      switch (at.name()) {
        case "Transform", "CADPart", "HAnimJoint", "HAnimSite", "HAnimHumanoid" -> {
          Matrix4d own = placement(at);
          if (!own.equals(new Matrix4d())) {
            transforms.add(at);
            own.mul(world, world);
          }
        }
        case "Billboard",
            "GeoTransform",
            "GeoLocation",
            "ProtoBody",
            "ScreenGroup",
            "LayoutLayer",
            "LayoutGroup",
            "EspduTransform" -> {
          return Optional.empty();
        }
        default -> {}
      }
    }
    return of(world, transforms);
  }

  private static Matrix4d placement(DocumentElement transform) {
    return TransformMatrix.of(
        new Matrix4d(),
        numbers(transform, "translation", FieldType.SFVec3f, 0, 0, 0),
        numbers(transform, "center", FieldType.SFVec3f, 0, 0, 0),
        numbers(transform, "rotation", FieldType.SFRotation, 0, 0, 1, 0),
        numbers(transform, "scale", FieldType.SFVec3f, 1, 1, 1),
        numbers(transform, "scaleOrientation", FieldType.SFRotation, 0, 0, 1, 0));
  }

  /** Returns the numbers of an attribute, or default values if there are none that can be read. */
  public static float[] numbers(
      DocumentElement element, String attribute, FieldType type, float... otherwise) {
    Object value =
        element
            .text(attribute)
            .map(text -> new FieldParser().parse(type, text).value())
            .orElse(null);
    return value instanceof float[] read && read.length == otherwise.length ? read : otherwise;
  }

  private static Optional<LocalCoordinateSystem> of(
      Matrix4d world, List<DocumentElement> transforms) {
    Vector3d[] columns = new Vector3d[3];
    for (int i = 0; i < 3; i++) {
      columns[i] = world.getColumn(i, new Vector3d());
      if (!(columns[i].length() > 0) || !columns[i].isFinite()) {
        return Optional.empty();
      }
    }
    if (!world.invert(new Matrix4d()).isFinite()) {
      return Optional.empty();
    }
    int[] best = ORDERS[0];
    double most = -1;
    for (int[] order : ORDERS) {
      double along = 0;
      for (int k = 0; k < 3; k++) {
        along += Math.abs(columns[order[k]].get(k)) / columns[order[k]].length();
      }
      if (along > most + PARALLEL) {
        most = along;
        best = order;
      }
    }
    Vector3d scale =
        new Vector3d(
            columns[best[0]].length(), columns[best[1]].length(), columns[best[2]].length());
    return Optional.of(
        new LocalCoordinateSystem(
            world,
            List.of(best[0], best[1], best[2]),
            scale,
            most < 3 - PARALLEL,
            List.copyOf(transforms)));
  }

  /** Transforms a sensor's box to scene coordinates. */
  AreaBox toScene(float[] centre, float[] size) {
    return new AreaBox(
        world.transformPosition(new Vector3d(centre[0], centre[1], centre[2])),
        new Vector3d(size[axis.get(0)], size[axis.get(1)], size[axis.get(2)]).mul(scale));
  }

  /** Returns the centre of a box in node coordinates: x, y, z. */
  public float[] ownCentre(AreaBox box) {
    return floats(world.invert(new Matrix4d()).transformPosition(new Vector3d(box.centre())));
  }

  /** Returns the size of a box along the node's axes: x, y, z. */
  public float[] ownSize(AreaBox box) {
    Vector3d own = new Vector3d();
    for (int k = 0; k < 3; k++) {
      own.setComponent(axis.get(k), box.size().get(k) / scale.get(k));
    }
    return floats(own);
  }

  private static float[] floats(Vector3dc of) {
    return new float[] {(float) of.x(), (float) of.y(), (float) of.z()};
  }

  /**
   * Returns the unit vector in scene coordinates of the node's axis nearest to an axis of the
   * scene.
   */
  public Vector3d direction(int k) {
    Vector3d own = world.getColumn(axis.get(k), new Vector3d()).normalize();
    return own.get(k) < 0 ? own.negate() : own;
  }
}
