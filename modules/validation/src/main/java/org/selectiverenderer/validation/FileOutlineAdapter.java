package org.selectiverenderer.validation;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.polygon.FilePolygonMeasurement;
import org.selectiverenderer.polygon.GeometrySize;
import org.selectiverenderer.polygon.TexturePicture;
import org.selectiverenderer.polygon.TexturePictureReader;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Adapts a file outline to the polygon counter. */
public final class FileOutlineAdapter implements FilePolygonMeasurement {
  private final FileOutline outline;
  private final SceneContext scene;
  private final TexturePictureReader pictures;
  private final Map<FileOutline, FileOutlineAdapter> known;

  private FileOutlineAdapter(
      FileOutline outline,
      SceneContext scene,
      TexturePictureReader pictures,
      Map<FileOutline, FileOutlineAdapter> known) {
    this.outline = outline;
    this.scene = scene;
    this.pictures = pictures;
    this.known = known;
  }

  /** Returns the enrichment of a scene with its polygon counts. */
  public static EnrichmentPolygonModel model(SceneContext scene) {
    UrlResolver urls = new UrlResolver(scene.main().file().folder(), scene.settings().access());
    return EnrichmentPolygonModel.of(
        new FileOutlineAdapter(
            scene.main(), scene, new TexturePictureReader(urls), new IdentityHashMap<>()));
  }

  @Override
  public X3dFile file() {
    return outline.scene();
  }

  @Override
  public GeometrySize size(ParsedNode geometry) {
    return outline
        .measure(geometry)
        .map(
            measure ->
                new GeometrySize(
                    measure.polygons(),
                    measure.bounds().length == 0
                        ? BoundingBox.EMPTY
                        : BoundingBox.of(measure.bounds())))
        .orElse(GeometrySize.NOTHING);
  }

  @Override
  public Optional<FileOutlineAdapter> content(ParsedNode inline) {
    return inline.bool("load")
        ? scene
            .content(inline)
            .map(
                content ->
                    known.computeIfAbsent(
                        content, c -> new FileOutlineAdapter(c, scene, pictures, known)))
        : Optional.empty();
  }

  @Override
  public Optional<TexturePicture> picture(ParsedNode texture, List<String> urls) {
    return pictures.picture(texture, urls, outline.file().base());
  }

  /** Returns no problems, since the file's own checks report them. */
  @Override
  public List<Problem> problemList() {
    return List.of();
  }
}
