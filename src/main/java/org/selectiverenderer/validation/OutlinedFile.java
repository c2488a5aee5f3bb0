package org.selectiverenderer.validation;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.polygon.count.CountedFile;
import org.selectiverenderer.polygon.count.SceneModel;
import org.selectiverenderer.polygon.count.Size;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/** Adapts a file outline to the polygon counter. */
public final class OutlinedFile implements CountedFile {
  private final FileOutline outline;
  private final SceneView scene;
  private final Map<FileOutline, OutlinedFile> known;

  private OutlinedFile(FileOutline outline, SceneView scene, Map<FileOutline, OutlinedFile> known) {
    this.outline = outline;
    this.scene = scene;
    this.known = known;
  }

  /** Returns the enrichment of a scene with its polygon counts. */
  public static SceneModel model(SceneView scene) {
    return SceneModel.of(new OutlinedFile(scene.main(), scene, new IdentityHashMap<>()));
  }

  @Override
  public X3dFile file() {
    return outline.scene();
  }

  @Override
  public Size size(ParsedNode geometry) {
    return outline
        .measure(geometry)
        .map(
            measure ->
                new Size(
                    measure.polygons(),
                    measure.bounds().length == 0 ? Bounds.EMPTY : Bounds.of(measure.bounds())))
        .orElse(Size.NOTHING);
  }

  @Override
  public Optional<OutlinedFile> content(ParsedNode inline) {
    return inline.bool("load")
        ? scene
            .content(inline)
            .map(content -> known.computeIfAbsent(content, c -> new OutlinedFile(c, scene, known)))
        : Optional.empty();
  }

  /** Returns no problems, since the file's own checks report them. */
  @Override
  public List<Problem> problemList() {
    return List.of();
  }
}
