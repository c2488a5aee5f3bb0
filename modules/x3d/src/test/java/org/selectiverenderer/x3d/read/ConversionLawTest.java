package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneFormat;

/**
 * The law of conversion: what is written can be read; it is the same scene, or what differs is
 * told; and to convert it again changes and tells nothing.
 */
class ConversionLawTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();
  private static final X3dReader READER = new X3dReader(CATALOGUE);
  private static final SceneDigest DIGEST = new SceneDigest(CATALOGUE);
  private static final long LARGE = 150_000;

  static Stream<Path> scenes() throws IOException {
    return Stream.of(
            "scenes",
            "docs/examples",
            "inlineNodes",
            "modules/render/src/test/resources/conformance",
            "src/test/resources/hostile/scenes")
        .map(Path::of)
        .flatMap(ConversionLawTest::files);
  }

  private static Stream<Path> files(Path folder) {
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> file.toString().matches(".*\\.(x3d|x3dv|wrl|x3dj|json|xml|x3dz)"))
          .filter(file -> file.toFile().length() < LARGE)
          .sorted()
          .toList()
          .stream();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static XmlDocument document(byte[] bytes) throws IOException {
    return READER.document("scene", new ByteArrayInputStream(bytes), bytes.length);
  }

  /** Holds the law for a scene and all encodings that are written. */
  private static void hold(String name, byte[] scene) throws IOException {
    XmlDocument document = document(scene);
    if (document.broken()) {
      return; // is not converted
    }
    for (SceneFormat format : SceneFormat.values()) {
      hold(name + " as " + format, scene, document, format);
    }
  }

  private static void hold(String name, byte[] scene, XmlDocument document, SceneFormat format)
      throws IOException {
    ProblemCollector told = new ProblemCollector();
    String text = format.text(document, CATALOGUE, told);
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    XmlDocument written = document(bytes);
    assertThat(written.faults()).as(name).isEmpty();
    ProblemCollector again = new ProblemCollector();
    byte[] twice = format.text(written, CATALOGUE, again).getBytes(StandardCharsets.UTF_8);
    same(
        name + " again",
        DIGEST.document(document(twice)).stream(),
        DIGEST.document(written).stream());
    assertThat(again.list()).as(name).isEmpty();
    if (told.any()) {
      return;
    }
    ProblemCollector first = new ProblemCollector();
    ProblemCollector second = new ProblemCollector();
    List<String> original = DIGEST.scene(READER.read("scene", scene, first));
    List<String> now = DIGEST.scene(READER.read("scene", bytes, second));
    same(name + " as a scene", now.stream(), original.stream());
    assertThat(messages(first)).as(name).containsAll(messages(second)); // encodings are mended
    same(
        name + " as a document",
        DIGEST.document(written).stream(),
        DIGEST.document(document).stream());
  }

  /** Compares lines, and shows only the first difference and what is around it. */
  private static void same(String name, Stream<String> now, Stream<String> original) {
    List<String> left = now.toList();
    List<String> right = original.toList();
    int at = 0;
    while (at < left.size() && at < right.size() && left.get(at).equals(right.get(at))) {
      at++;
    }
    assertThat(part(left, at)).as(name + ", line " + (at + 1)).isEqualTo(part(right, at));
  }

  private static List<String> part(List<String> lines, int at) {
    return lines.size() == at
        ? List.of()
        : lines.subList(Math.max(0, at - 2), Math.min(lines.size(), at + 2));
  }

  private static List<String> messages(ProblemCollector problems) {
    return problems.list().stream()
        .map(problem -> problem.message().replaceAll("scene:\\d+:\\d+", "there"))
        .toList();
  }

  @ParameterizedTest
  @MethodSource
  void scenes(Path scene) throws IOException {
    hold(scene.toString(), Files.readAllBytes(scene));
  }
}
