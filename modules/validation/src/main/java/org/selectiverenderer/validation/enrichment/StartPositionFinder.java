package org.selectiverenderer.validation.enrichment;

import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Finds the start positions of viewers. */
final class StartPositionFinder {
  private StartPositionFinder() {}

  static boolean isViewpoint(ParsedNode node) {
    return node.type().name().equals("Viewpoint") || node.type().name().equals("OrthoViewpoint");
  }

  /** Returns the world positions of all instances of a viewpoint. */
  static List<Vector3d> eyes(ParsedNode viewpoint, EnrichmentPolygonModel model) {
    float[] p = viewpoint.floats("position");
    return model.places(viewpoint).stream()
        .map(place -> place.transformPosition(new Vector3d(p[0], p[1], p[2])))
        .toList();
  }

  /**
   * Returns the initial position of the viewer: the first viewpoint of the scene's own file (X3D
   * 4.0, 23.3.1). Empty if there is no viewpoint, or if a route or script may move it.
   */
  static Optional<Vector3d> start(EnrichedScene scene, EnrichmentPolygonModel model) {
    for (ParsedNode node : scene.view().main().nodes()) {
      if (node.type().is("X3DViewpointNode")) {
        boolean known = isViewpoint(node) && !scene.driven(node, "position");
        return known ? eyes(node, model).stream().findFirst() : Optional.empty();
      }
    }
    return Optional.empty();
  }
}
