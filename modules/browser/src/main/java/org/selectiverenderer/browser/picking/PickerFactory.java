package org.selectiverenderer.browser.picking;

import java.util.Optional;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.nodes.picking.PickSensorNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.convex.ConvexShape;
import org.selectiverenderer.geometry.mesh.Mesh;

/** Makes a {@link Picker} from a sensor's picking geometry. */
final class PickerFactory {
  private PickerFactory() {}

  static Picker of(PickSensorNode.With with, @Nullable Node geometry, AssetProvider assets) {
    Optional<Mesh> mesh =
        Optional.ofNullable(geometry).flatMap(assets::mesh).filter(made -> !made.isEmpty());
    if (geometry == null || mesh.isEmpty()) {
      return Picker.NOTHING;
    }
    return switch (with) {
      case POINTS -> new PointPicker(mesh.get());
      case LINES -> new LinePicker(mesh.get());
      case PRIMITIVE -> primitive(geometry, mesh.get());
      case HULL -> hull(mesh.get(), true);
    };
  }

  /**
   * Makes a picker from one of the four primitives, or from the convex hull of any other geometry.
   */
  private static Picker primitive(Node node, Mesh mesh) {
    BoundingBox box = BoundingBox.of(mesh.bounds());
    Vector3d middle = new Vector3d();
    ConvexShape body;
    switch (node.type().name()) {
      case "Box" -> {
        float[] size = node.floats("size");
        body = ConvexShape.box(size[0], size[1], size[2]);
      }
      case "Sphere" -> body = ConvexShape.sphere(node.number("radius"));
      case "Cylinder" -> body = ConvexShape.cylinder(node.number("radius"), node.number("height"));
      case "Cone" -> {
        body = ConvexShape.cone(node.number("bottomRadius"), node.number("height"));
        middle.y = node.number("height") / 2;
      }
      default -> {
        return hull(mesh, false);
      }
    }
    return new ConvexBodyPicker(body, box, middle, false);
  }

  private static Picker hull(Mesh mesh, boolean vertices) {
    double[] points = new double[mesh.positions().length];
    for (int i = 0; i < points.length; i++) {
      points[i] = mesh.positions()[i];
    }
    BoundingBox box = BoundingBox.of(mesh.bounds());
    return new ConvexBodyPicker(
        ConvexShape.hull(points), box, box.min().add(box.max()).mul(0.5), vertices);
  }
}
