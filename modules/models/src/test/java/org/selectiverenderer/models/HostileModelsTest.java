package org.selectiverenderer.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.models.importer.ImportLimits;
import org.selectiverenderer.testing.RequiresSymbolicLinks;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.HttpFetcher;
import org.selectiverenderer.x3d.url.UrlResolver;

/** A model by a stranger is read, or is refused with a line that names it. */
class HostileModelsTest {
  private static final Path CORPUS = Path.of("src/test/resources/hostile/models");
  private static final Duration ENDS = Duration.ofMinutes(5);
  private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl secret\nf 1 2 3\n";
  private static final String MATERIAL = "newmtl secret\nKd 1 0.5 0.25\n";

  private static ModelReader reader;

  @TempDir Path folder;

  private final ProblemCollector problems = new ProblemCollector();

  @BeforeAll
  static void open() {
    ImportLimits standard = ImportLimits.standard();
    reader =
        new ModelReader(
            NodeCatalogue.load(),
            ContentAccessPolicy.none(),
            Optional.empty(),
            new ImportLimits(
                1 << 20,
                1 << 21,
                100,
                1 << 23,
                standard.time(),
                standard.timePerMebibyte(),
                300 << 20,
                24));
  }

  @AfterAll
  static void close() {
    reader.close();
  }

  private Path write(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private List<String> messages() {
    return problems.list().stream().map(Problem::message).toList();
  }

  static Stream<Path> corpus() throws IOException {
    try (Stream<Path> files = Files.list(CORPUS)) {
      return files.sorted().toList().stream();
    }
  }

  @ParameterizedTest
  @MethodSource("corpus")
  void everyFileOfTheCorpusIsAProblemOrAHarmlessModel(Path file) {
    assertTimeoutPreemptively(
        ENDS,
        () -> {
          Optional<Model> model = reader.read(file, problems);

          if (file.getFileName().toString().startsWith("mtllib")) {
            assertThat(model.orElseThrow().polygons()).isEqualTo(1);
          } else {
            assertThat(model).isEmpty();
            assertThat(problems.any()).isTrue();
          }
          assertThat(problems.list()).hasSizeLessThanOrEqualTo(1);
          assertThat(problems.list())
              .allMatch(problem -> problem.location().file().endsWith(file.toString()));
        });
  }

  @Test
  void aMaterialFileOutsideIsNotReadAndSaid() throws IOException {
    write("m.mtl", MATERIAL);
    Path file = write("models/a.obj", "mtllib ../m.mtl\n" + TRIANGLE);

    Model model = reader.read(file, problems).orElseThrow();

    assertThat(model.parts().get(0).appearance().node("material").floats("diffuseColor"))
        .doesNotContain(0.25f);
    assertThat(messages())
        .singleElement()
        .asString()
        .contains("url '../m.mtl' points outside the folders", "--allow ");
  }

  @Test
  void aMaterialFileInAnAllowedFolderIsRead() throws IOException {
    write("m.mtl", MATERIAL);
    Path file = write("models/a.obj", "mtllib ../m.mtl\n" + TRIANGLE);
    ContentAccessPolicy access = new ContentAccessPolicy(List.of(folder), HttpFetcher.none());

    try (ModelReader allowed = new ModelReader(NodeCatalogue.load(), access)) {
      Model model = allowed.read(file, problems).orElseThrow();

      assertThat(model.parts().get(0).appearance().node("material").floats("diffuseColor"))
          .containsExactly(1, 0.5f, 0.25f);
    }
    assertThat(messages()).isEmpty();
    assertThat(access.named().list()).containsExactly(folder.toRealPath().resolve("m.mtl"));
  }

  @Test
  void aMaterialFileThatIsMissingIsAWarning() throws IOException {
    Path file = write("models/a.obj", "mtllib m.mtl\n" + TRIANGLE);

    assertThat(reader.read(file, problems)).isPresent();
    assertThat(problems.list())
        .singleElement()
        .matches(problem -> problem.severity() == Problem.Severity.WARNING)
        .asString()
        .contains("a.obj", "url 'm.mtl' is missing", "left out");
  }

  /** With slashes, as Assimp asks on Linux, and with backslashes, as it asks on Windows. */
  @ParameterizedTest
  @CsvSource({
    "../m.mtl, ./../m.mtl, m.mtl",
    "../m.mtl, .\\../m.mtl, ..\\m.mtl",
    "/etc/passwd, ./\\etc\\passwd, \\etc\\passwd",
    "//127.0.0.1/share/a.bin, .\\//127.0.0.1/share/a.bin, \\127.0.0.1\\share\\a.bin",
  })
  void whatIsAskedAgainWithOtherSlashesIsRefusedOnce(String url, String again, String part)
      throws IOException {
    Path file = write("models/a.obj", TRIANGLE);
    ModelFileAccess access =
        new ModelFileAccess(
            ModelSource.of(file),
            Optional.of(new UrlResolver(file.getParent(), ContentAccessPolicy.none())));

    for (String each : List.of(url, again, part)) {
      assertThat(access.open(each)).isEmpty();
    }

    assertThat(access.report(Problem.Severity.ERROR, "left out", problems)).isTrue();
    assertThat(messages()).singleElement().asString().startsWith("url '%s' ".formatted(url));
  }

  @Test
  @RequiresSymbolicLinks
  void aLinkThatLeadsOutsideIsNotFollowed() throws IOException {
    Path outside = write("secret/m.mtl", MATERIAL);
    Path file = write("models/a.obj", "mtllib m.mtl\n" + TRIANGLE);
    Files.createSymbolicLink(folder.resolve("models/m.mtl"), outside);

    Model model = reader.read(file, problems).orElseThrow();

    assertThat(model.parts().get(0).appearance().node("material").floats("diffuseColor"))
        .doesNotContain(0.25f);
    assertThat(messages()).singleElement().asString().contains("points outside the folders");
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "its folders hold no pipes")
  void aPipeIsNotOpened() throws Exception {
    Path pipe = folder.resolve("pipe.obj");
    assumeTrue(Files.isExecutable(Path.of("/usr/bin/mkfifo")));
    assertThat(new ProcessBuilder("/usr/bin/mkfifo", pipe.toString()).start().waitFor()).isZero();
    Path file = write("a.obj", "mtllib pipe.obj\n" + TRIANGLE);

    assertTimeoutPreemptively(
        ENDS,
        () -> {
          assertThatExceptionOfType(IOException.class)
              .isThrownBy(() -> reader.read(pipe, problems))
              .withMessageContaining("pipe.obj")
              .withMessageContaining("not a file");
          assertThat(reader.read(file, problems)).isPresent();
        });
    assertThat(messages()).singleElement().asString().contains("pipe.obj");
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 100_000})
  void nestedValuesAreSaid(int objects) throws IOException {
    String deep = objects == 1 ? "[".repeat(1_000_000) : "{\"a\":".repeat(objects);
    Path file = write("a.gltf", "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + deep);

    assertThat(reader.read(file, problems)).isEmpty();
    assertThat(messages()).singleElement().asString().contains("nested more than 250 deep");
  }

  @Test
  void nestedNodesAreSaid() throws IOException {
    StringBuilder nodes = new StringBuilder("{\"mesh\":0}");
    for (int i = 0; i < 50_000; i++) {
      nodes.append(",{\"children\":[").append(i).append("]}");
    }
    Path file = write("a.gltf", "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[" + nodes + "]}");

    assertThat(reader.read(file, problems)).isEmpty();
    assertThat(messages()).singleElement().asString().contains("nested more than 500 deep");
  }

  @Test
  void aMeshThatVeryManyNodesShowIsSaid() throws IOException {
    String nodes = String.join(",", Collections.nCopies(9000, "{\"mesh\":0}"));
    Path file =
        write(
            "a.gltf",
            """
            {"asset":{"version":"2.0"},"nodes":[%s],
             "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
             "accessors":[{"bufferView":0,"componentType":5126,"count":100,"type":"VEC3"}],
             "bufferViews":[{"buffer":0,"byteLength":1200}],
             "buffers":[{"byteLength":1200,"uri":"a.bin"}]}
            """
                .formatted(nodes));

    assertThat(reader.read(file, problems)).isEmpty();
    assertThat(messages()).singleElement().asString().contains("more than 8 MiB of vertices");
  }
}
