package org.selectiverenderer.polygon;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiFunction;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/**
 * A file as read, with the sizes of its geometry nodes and the files that its Inlines name. Several
 * threads fill it; it is read when all are done.
 *
 * @param problems the problems found in this file
 * @param pictures finds the picture of a texture of this file for some urls
 * @param sizes size by geometry node; a shared node has one entry
 */
record SceneFile(
    X3dFile file,
    ProblemCollector problems,
    BiFunction<ParsedNode, List<String>, Optional<TexturePicture>> pictures,
    Map<ParsedNode, GeometrySize> sizes,
    Map<ParsedNode, CompletableFuture<Optional<SceneFile>>> inlines)
    implements FilePolygonMeasurement {

  SceneFile(
      X3dFile file,
      ProblemCollector problems,
      BiFunction<ParsedNode, List<String>, Optional<TexturePicture>> pictures) {
    this(file, problems, pictures, new ConcurrentHashMap<>(), new ConcurrentHashMap<>());
  }

  /** Returns the same file with its sizes, but with Inlines still to be followed. */
  SceneFile again(BiFunction<ParsedNode, List<String>, Optional<TexturePicture>> fresh) {
    return new SceneFile(file, problems, fresh, sizes, new ConcurrentHashMap<>());
  }

  @Override
  public GeometrySize size(ParsedNode geometry) {
    return sizes.getOrDefault(geometry, GeometrySize.NOTHING);
  }

  @Override
  public Optional<SceneFile> content(ParsedNode inline) {
    return Optional.ofNullable(inlines.get(inline)).flatMap(CompletableFuture::join);
  }

  @Override
  public Optional<TexturePicture> picture(ParsedNode texture, List<String> urls) {
    return pictures.apply(texture, urls);
  }

  @Override
  public List<Problem> problemList() {
    return problems.list().stream()
        .sorted(
            Comparator.comparingInt((Problem problem) -> problem.location().line())
                .thenComparingInt(problem -> problem.location().column()))
        .toList();
  }
}
