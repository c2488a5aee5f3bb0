package org.selectiverenderer.validation.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.polygon.statistics.Bounds;
import org.selectiverenderer.polygon.statistics.SceneModel;
import org.selectiverenderer.polygon.statistics.SensorBox;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.ParsedNode;

/** Whether the viewer can get into the box of each area. */
final class ReachCheck implements EnrichmentPart {
  /** Beyond what is shown a viewer may stand: this part of its extent, and some metres. */
  private static final double PART = 0.5;

  private static final double METRES = 3;

  @Override
  public void check(EnrichedScene scene, Findings findings) {
    Optional<Bounds> reach = scene.model().flatMap(model -> reach(scene, model));
    for (ParsedNode node : scene.nodes()) {
      if (EnrichedScene.isArea(node) && !scene.driven(node, "size")) {
        check(scene, node, reach, findings);
      }
    }
  }

  private static void check(
      EnrichedScene scene, ParsedNode sensor, Optional<Bounds> reach, Findings findings) {
    float[] size = sensor.floats("size");
    if (!(size[0] > 0 && size[1] > 0 && size[2] > 0)) {
      findings.add(SensorRules.NO_VOLUME, sensor);
    } else if (scene.areas().containsKey(sensor)) {
      List<Matrix4dc> places = scene.model().map(m -> m.places(sensor)).orElse(List.of());
      List<SensorBox> boxes = new ArrayList<>();
      places.forEach(
          place -> SensorBox.of(sensor.floats("center"), size, place).ifPresent(boxes::add));
      if (boxes.isEmpty() && !places.isEmpty()) {
        findings.add(SensorRules.NO_VOLUME, sensor);
      } else if (!sensor.bool("enabled") && !scene.driven(sensor, "enabled")) {
        findings.add(SensorRules.UNREACHABLE, sensor, "it is not enabled, and no route enables it");
      } else if (reach.isPresent()
          && !boxes.isEmpty()
          && boxes.stream().allMatch(box -> apart(box.bounds(), reach.get()))) {
        findings.add(
            SensorRules.UNREACHABLE,
            sensor,
            "it lies away from all that the scene shows and from its viewpoints");
      }
    }
  }

  /** Where a viewer can be expected; empty where that cannot be known. */
  private static Optional<Bounds> reach(EnrichedScene scene, SceneModel model) {
    boolean moving =
        scene.view().main().scene().routes().stream()
            .map(route -> route.to().type())
            .anyMatch(type -> type.name().equals("Transform") || type.is("X3DViewpointNode"));
    boolean incomplete =
        scene.nodes().stream()
            .anyMatch(
                node ->
                    node.type().name().equals("Inline") && scene.view().content(node).isEmpty());
    if (moving || incomplete || model.bounds().isEmpty()) {
      return Optional.empty();
    }
    Bounds reach = model.bounds();
    for (ParsedNode node : scene.nodes()) {
      if (Viewpoints.isViewpoint(node)) {
        for (Vector3d eye : Viewpoints.eyes(node, model)) {
          reach = reach.and(new Bounds(eye, eye));
        }
      }
    }
    Vector3d extent = reach.max().sub(reach.min(), new Vector3d());
    double margin = METRES + PART * extent.get(extent.maxComponent());
    return Optional.of(
        new Bounds(
            reach.min().sub(margin, margin, margin, new Vector3d()),
            reach.max().add(margin, margin, margin, new Vector3d())));
  }

  private static boolean apart(Bounds a, Bounds b) {
    Vector3d low = a.min().max(b.min(), new Vector3d());
    Vector3d high = a.max().min(b.max(), new Vector3d());
    return low.x > high.x || low.y > high.y || low.z > high.z;
  }
}
