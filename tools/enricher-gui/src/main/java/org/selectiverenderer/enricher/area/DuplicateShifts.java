package org.selectiverenderer.enricher.area;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.selectiverenderer.authoring.placement.TransformPose;
import org.selectiverenderer.enricher.menu.StructureCommands;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Computes from the running scene how far beside nodes their duplicates lie: along the scene's X
 * axis by what the node measures there, so that both touch.
 */
public final class DuplicateShifts implements StructureCommands.Shifts {
  private final AsyncSceneQueries probe;

  public DuplicateShifts(AsyncSceneQueries probe) {
    this.probe = probe;
  }

  @Override
  public void of(
      List<DocumentElement> nodes, Consumer<Function<DocumentElement, Optional<Vector3d>>> answer) {
    probe.boxes(
        nodes,
        boxes -> {
          Map<DocumentElement, Vector3d> shifts = new HashMap<>();
          boxes.forEach(box -> shift(box).ifPresent(way -> shifts.put(box.element(), way)));
          answer.accept(node -> Optional.ofNullable(shifts.get(node)));
        });
  }

  private static Optional<Vector3d> shift(ObjectBox box) {
    if (!box.element().attached()) {
      return Optional.empty();
    }
    Matrix4d parent = new Matrix4d(box.place());
    if (box.element().name().equals("Transform")) {
      parent.mul(TransformPose.of(box.element()).matrix().invert());
    }
    Vector3d way = parent.invert().transformDirection(new Vector3d(box.bounds().width(), 0, 0));
    return Optional.of(way).filter(found -> found.isFinite() && found.lengthSquared() > 1e-12);
  }
}
