package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.nodes.sensor.ProximitySensorNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.polygon.metadata.NodeViewMetadata;
import org.selectiverenderer.render.preview.BoxOverlay;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SensorSchemas;

/**
 * The boxes of a scene's ProximitySensors: draws them as box marks and labels, and counts the
 * polygons in each.
 */
final class SensorBoxOverlay {
  /** Largest product of shapes and areas for which polygons are counted per area. */
  private static final long MOST_TESTS = 2_000_000;

  private static final float[] EDGES = {0.10f, 0.45f, 0.95f, 0.9f};
  private static final float[] SIDES = {0.20f, 0.55f, 1.00f, 0.06f};
  private static final float[] SELECTED_EDGES = {1.00f, 0.60f, 0.00f, 1.0f};
  private static final float[] SELECTED_SIDES = {1.00f, 0.70f, 0.10f, 0.12f};

  /**
   * Candidate points for a label in the unit cube, the best first: middle of the top, top edges,
   * centre, faces, corners.
   */
  private static final double[][] LABEL_POINTS = {
    {0, 0.5, 0}, {0, 0.5, 0.5}, {0, 0.5, -0.5}, {0.5, 0.5, 0}, {-0.5, 0.5, 0},
    {0, 0, 0}, {0, 0, 0.5}, {0, 0, -0.5}, {0.5, 0, 0}, {-0.5, 0, 0},
    {0.5, 0.5, 0.5}, {-0.5, 0.5, 0.5}, {0.5, 0.5, -0.5}, {-0.5, 0.5, -0.5}, {0, -0.5, 0}
  };

  /** Least distance of a label from the edge of the picture, as a share of the picture. */
  private static final double LABEL_MARGIN = 0.04;

  /** A sensor of the document. */
  private record Area(ProximitySensorNode node, SensorSchemas schemas) {}

  private final World world;
  private final PreviewNodeIndex nodes;
  private final List<Area> areas = new ArrayList<>();
  private long[] polygons = {};

  SensorBoxOverlay(World world, PreviewNodeIndex nodes) {
    this.world = world;
    this.nodes = nodes;
    SchemaReader reader = new SchemaReader(problem -> {}); // The document's findings report them.
    for (Node node : nodes.all()) {
      if (node instanceof ProximitySensorNode sensor) {
        areas.add(
            new Area(
                sensor,
                NodeViewMetadata.of(sensor)
                    .flatMap(reader::sensor)
                    .orElse(new SensorSchemas(List.of(), List.of()))));
      }
    }
  }

  /** Counts the polygons in each area: those of shown shapes whose centre is in its box. */
  void count() {
    List<ShapeInstance> shapes = world.instances().shapes();
    if ((long) shapes.size() * areas.size() > MOST_TESTS) {
      polygons = new long[0];
      return;
    }
    List<Counted> shown = new ArrayList<>();
    for (ShapeInstance shape : shapes) {
      if (shape.shown() && shape.bounds()[0] <= shape.bounds()[3]) {
        double[] b = shape.bounds();
        Vector3d middle = new Vector3d(b[0] + b[3], b[1] + b[4], b[2] + b[5]).mul(0.5);
        shown.add(new Counted(middle, shape.mesh().map(mesh -> mesh.polygons()).orElse(0)));
      }
    }
    polygons = new long[areas.size()];
    Vector3d local = new Vector3d();
    for (int i = 0; i < polygons.length; i++) {
      List<Matrix4d> inverse = new ArrayList<>();
      places(areas.get(i).node()).forEach(place -> inverse.add(new Matrix4d(place).invert()));
      for (Counted shape : shown) {
        if (holds(inverse, shape.middle(), local)) {
          polygons[i] += shape.polygons();
        }
      }
    }
  }

  /** A shape that may be in an area. */
  private record Counted(Vector3d middle, int polygons) {}

  /**
   * @param local is overwritten
   */
  private static boolean holds(List<Matrix4d> inverse, Vector3d middle, Vector3d local) {
    for (Matrix4d place : inverse) {
      place.transformPosition(middle, local);
      if (Math.abs(local.x) <= 0.5 && Math.abs(local.y) <= 0.5 && Math.abs(local.z) <= 0.5) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns the matrices that map the unit cube about the origin to the boxes of a sensor in the
   * world, one per instance.
   */
  private List<Matrix4d> places(Node sensor) {
    float[] c = sensor.floats("center");
    float[] s = sensor.floats("size");
    List<Matrix4d> places = new ArrayList<>();
    if (s[0] > 0 && s[1] > 0 && s[2] > 0) {
      for (Matrix4dc place : world.instances().places(sensor)) {
        places.add(new Matrix4d(place).translate(c[0], c[1], c[2]).scale(s[0], s[1], s[2]));
      }
    }
    return places;
  }

  /**
   * @param selected the node that is selected, if any
   */
  List<BoxOverlay> marks(@Nullable Node selected) {
    List<BoxOverlay> marks = new ArrayList<>();
    for (Area area : areas) {
      boolean chosen = area.node() == selected;
      for (Matrix4d place : places(area.node())) {
        marks.add(
            new BoxOverlay(
                place, chosen ? SELECTED_EDGES : EDGES, chosen ? SELECTED_SIDES : SIDES));
      }
    }
    return marks;
  }

  /**
   * Returns the labels of the boxes that are in the picture, in its pixels.
   *
   * @param seen whether a world point is visible from the viewer
   */
  List<PreviewFrame.Label> labels(
      Camera camera, @Nullable Node selected, Predicate<Vector3dc> seen) {
    List<PreviewFrame.Label> labels = new ArrayList<>();
    for (int i = 0; i < areas.size(); i++) {
      Area area = areas.get(i);
      Optional<Long> count = i < polygons.length ? Optional.of(polygons[i]) : Optional.empty();
      for (Matrix4d place : places(area.node())) {
        Optional<Vector2d> open = inPicture(place, camera, seen);
        Optional<Vector2d> at = open.or(() -> inPicture(place, camera, point -> true));
        if (at.isPresent()) {
          labels.add(
              new PreviewFrame.Label(
                  (int) Math.round(at.get().x * camera.width()),
                  (int) Math.round(at.get().y * camera.height()),
                  Optional.ofNullable(area.node().name()).orElse("ProximitySensor"),
                  area.schemas(),
                  count,
                  area.node() == selected,
                  open.isEmpty(),
                  nodes.anchor(area.node())));
        }
      }
    }
    return labels;
  }

  /**
   * Returns the first label point that is visible in the picture, from 0 to 1 from the upper left.
   */
  private static Optional<Vector2d> inPicture(
      Matrix4d place, Camera camera, Predicate<Vector3dc> seen) {
    for (double[] candidate : LABEL_POINTS) {
      Vector4d point = place.transform(new Vector4d(candidate[0], candidate[1], candidate[2], 1));
      Vector3d inWorld = new Vector3d(point.x, point.y, point.z);
      camera.projection().transform(camera.view().transform(point));
      Vector2d at = new Vector2d((point.x / point.w + 1) / 2, (1 - point.y / point.w) / 2);
      if (point.w > 0
          && Math.abs(at.x - 0.5) < 0.5 - LABEL_MARGIN
          && Math.abs(at.y - 0.5) < 0.5 - LABEL_MARGIN
          && seen.test(inWorld)) {
        return Optional.of(at);
      }
    }
    return Optional.empty();
  }

  /** The bounding box of all boxes of a sensor; empty if it has none. */
  Optional<BoundingBox> bounds(Node sensor) {
    BoundingBox cube = new BoundingBox(-0.5, -0.5, -0.5, 0.5, 0.5, 0.5);
    List<Matrix4d> places =
        sensor instanceof ProximitySensorNode ? places(sensor) : List.<Matrix4d>of();
    return places.stream().map(cube::transformed).reduce(BoundingBox::union);
  }
}
