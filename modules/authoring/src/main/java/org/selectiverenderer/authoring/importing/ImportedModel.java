package org.selectiverenderer.authoring.importing;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.UndoableFileWrite;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * A model that is ready to be inlined.
 *
 * @param file the file to inline
 * @param files the new files to be written, the inlined one included; none for a link
 * @param bounds the bounds of its faces in metres; empty if they are not known
 * @param problems what is left out of it
 */
public record ImportedModel(
    Path file,
    List<UndoableFileWrite> files,
    Optional<BoundingBox> bounds,
    List<Problem> problems) {
  public ImportedModel {
    files = List.copyOf(files);
    problems = List.copyOf(problems);
  }

  /** Returns the translation that puts the middle of the model's underside on a point. */
  public Vector3d onto(Vector3dc point) {
    Vector3d moved = new Vector3d(point);
    bounds.ifPresent(
        box -> moved.sub((box.minX() + box.maxX()) / 2, box.minY(), (box.minZ() + box.maxZ()) / 2));
    return moved;
  }
}
