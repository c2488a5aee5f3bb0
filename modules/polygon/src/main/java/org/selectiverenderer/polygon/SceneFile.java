package org.selectiverenderer.polygon;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/**
 * A file as read, with the sizes of its geometry nodes and the files that its Inlines name. Several
 * threads fill it; it is read when all are done.
 *
 * @param problems the problems found in this file
 * @param sizes size by geometry node; a shared node has one entry
 */
record SceneFile(
    X3dFile file,
    ProblemCollector problems,
    Map<ParsedNode, GeometrySize> sizes,
    Map<ParsedNode, CompletableFuture<Optional<SceneFile>>> inlines)
    implements FilePolygonMeasurement {

  SceneFile(X3dFile file, ProblemCollector problems) {
    this(file, problems, new ConcurrentHashMap<>(), new ConcurrentHashMap<>());
  }

  /** Returns the same file with its sizes, but with Inlines still to be followed. */
  SceneFile again() {
    return new SceneFile(file, problems, sizes, new ConcurrentHashMap<>());
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
  public List<Problem> problemList() {
    return problems.list().stream()
        .sorted(
            Comparator.comparingInt((Problem problem) -> problem.location().line())
                .thenComparingInt(problem -> problem.location().column()))
        .toList();
  }
}
