package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** Reads small texts as {@code test.x3d} and compares the problems found with those expected. */
final class ReaderFixture {
  ProblemCollector problems = new ProblemCollector();
  private final X3dReader reader;

  ReaderFixture() {
    this(new ReadLimits(1 << 24, 1000, 100, 10_000));
  }

  ReaderFixture(ReadLimits limits) {
    reader = new X3dReader(NodeCatalogue.load(), limits);
  }

  X3dFile read(byte[] bytes) {
    problems = new ProblemCollector();
    return reader.read("test.x3d", bytes, problems);
  }

  X3dFile read(String text) {
    return read(text.getBytes(StandardCharsets.UTF_8));
  }

  /** A scene whose content starts at the second line. */
  X3dFile scene(String content) {
    return read("<X3D version='4.0' profile='Full'><Scene>\n" + content + "</Scene></X3D>");
  }

  /** The routes of a file as {@code node.field -> node.field}. */
  static List<String> routes(X3dFile file) {
    return file.routes().stream()
        .map(
            route ->
                end(route.from(), route.fromField()) + " -> " + end(route.to(), route.toField()))
        .toList();
  }

  private static String end(ParsedNode node, int field) {
    return node.name() + "." + node.type().fields().get(field).name();
  }

  void assertClean() {
    assertThat(problems.list()).isEmpty();
  }

  /** These problems and no other. */
  void assertOnly(String... expected) {
    assertMessages(expected);
    assertThat(problems.any()).isTrue();
  }

  void assertMessages(String... expected) {
    assertThat(problems.list()).extracting(Problem::toString).containsExactly(expected);
  }
}
