package org.selectiverenderer.polygon.count;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/**
 * A file as read, with what its geometry comes to and the files that its Inlines name. Filled by
 * several threads, read when all are done.
 *
 * @param problems found in this file
 * @param sizes by geometry node; shared nodes have one
 */
record SceneFile(
    X3dFile file,
    Problems problems,
    Map<ParsedNode, Size> sizes,
    Map<ParsedNode, CompletableFuture<Optional<SceneFile>>> inlines)
    implements CountedFile {

  SceneFile(X3dFile file, Problems problems) {
    this(file, problems, new ConcurrentHashMap<>(), new ConcurrentHashMap<>());
  }

  /** The same file and its sizes, whose Inlines are to be followed anew. */
  SceneFile again() {
    return new SceneFile(file, problems, sizes, new ConcurrentHashMap<>());
  }

  @Override
  public Size size(ParsedNode geometry) {
    return sizes.getOrDefault(geometry, Size.NOTHING);
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
