package org.selectiverenderer.validation.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.polygon.SensorBox;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Checks whether the viewer can enter the box of each area. */
final class AreaReachabilityCheck implements EnrichedSceneCheck {
  /**
   * A viewer may stand outside of the scene's bounding box by this share of its extent plus {@link
   * #METRES}.
   */
  private static final double PART = 0.5;

  private static final double METRES = 3;

  @Override
  public void check(EnrichedScene scene, FindingCollector findings) {
    Optional<BoundingBox> reach = scene.model().flatMap(model -> reach(scene, model));
    for (ParsedNode node : scene.nodes()) {
      if (EnrichedScene.isArea(node) && !scene.driven(node, "size")) {
        check(scene, node, reach, findings);
      }
    }
  }

  private static void check(
      EnrichedScene scene,
      ParsedNode sensor,
      Optional<BoundingBox> reach,
      FindingCollector findings) {
    float[] size = sensor.floats("size");
    if (!SensorMetadataCheck.hasVolume(sensor)) {
      if (Math.min(size[0], Math.min(size[1], size[2])) >= 0) { // SR105 reports negative sizes.
        findings.addAt(SensorRules.NO_VOLUME, scene.file(sensor), sensor, "size");
      }
    } else if (scene.areas().containsKey(sensor)) {
      List<Matrix4dc> places = scene.model().map(m -> m.places(sensor)).orElse(List.of());
      List<SensorBox> boxes = new ArrayList<>();
      places.forEach(
          place -> SensorBox.of(sensor.floats("center"), size, place).ifPresent(boxes::add));
      if (boxes.isEmpty() && !places.isEmpty()) {
        findings.addAt(SensorRules.NO_VOLUME, scene.file(sensor), sensor, "size");
      } else if (!sensor.bool("enabled") && !scene.driven(sensor, "enabled")) {
        findings.addAt(
            SensorRules.UNREACHABLE,
            scene.file(sensor),
            sensor,
            "enabled",
            "it is not enabled, and no route enables it");
      } else if (reach.isPresent()
          && !boxes.isEmpty()
          && boxes.stream().allMatch(box -> box.bounds().apart(reach.get()))) {
        findings.add(
            SensorRules.UNREACHABLE,
            sensor,
            "it is far from everything that the scene shows and from its viewpoints");
      }
    }
  }

  /** Returns the box in which a viewer can be expected; empty if it cannot be known. */
  private static Optional<BoundingBox> reach(EnrichedScene scene, EnrichmentPolygonModel model) {
    boolean moving =
        scene.files().values().stream()
            .flatMap(file -> file.scene().routes().stream())
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
    BoundingBox reach = model.bounds();
    for (ParsedNode node : scene.nodes()) {
      if (StartPositionFinder.isViewpoint(node)) {
        for (Vector3d eye : StartPositionFinder.eyes(node, model)) {
          reach = reach.union(BoundingBox.of(eye, eye));
        }
      }
    }
    return Optional.of(reach.grown(METRES + PART * reach.extent()));
  }
}
