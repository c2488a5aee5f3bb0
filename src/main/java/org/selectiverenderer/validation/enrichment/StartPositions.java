package org.selectiverenderer.validation.enrichment;

import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.polygon.count.SceneModel;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Where viewers start. */
final class StartPositions {
  private StartPositions() {}

  static boolean isViewpoint(ParsedNode node) {
    return node.type().name().equals("Viewpoint") || node.type().name().equals("OrthoViewpoint");
  }

  /** A viewpoint's places in the world. */
  static List<Vector3d> eyes(ParsedNode viewpoint, SceneModel model) {
    float[] p = viewpoint.floats("position");
    return model.places(viewpoint).stream()
        .map(place -> place.transformPosition(new Vector3d(p[0], p[1], p[2])))
        .toList();
  }

  /**
   * Where the viewer is at first: at the first viewpoint of the scene's own file (X3D 4.0, 23.3.1).
   * Empty if there is none, or if something moves it.
   */
  static Optional<Vector3d> start(EnrichedScene scene, SceneModel model) {
    for (ParsedNode node : scene.view().main().nodes()) {
      if (node.type().is("X3DViewpointNode")) {
        boolean known = isViewpoint(node) && !scene.driven(node, "position");
        return known ? eyes(node, model).stream().findFirst() : Optional.empty();
      }
    }
    return Optional.empty();
  }
}
