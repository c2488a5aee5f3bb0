package org.selectiverenderer.models.importer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.selectiverenderer.base.platform.ChildProcessCommand;

class ModelImportProcessTest {
  private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

  private final ImportLimits standard = ImportLimits.standard();

  private static ModelFileSource source(byte[] content) {
    return url ->
        url.startsWith("a.")
            ? Optional.of(
                new ModelFileSource.OpenFile(content.length, new ByteArrayInputStream(content)))
            : Optional.empty();
  }

  private static ModelFileSource source(String content) {
    return source(content.getBytes(StandardCharsets.UTF_8));
  }

  private ImportLimits limits(Duration time, long memory) {
    return new ImportLimits(
        1 << 20, 1 << 20, 10, standard.maxModelBytes(), time, Duration.ZERO, memory, 0);
  }

  @Test
  void aCrashOfTheLibraryEndsTheChildOnlyAndTheNextModelIsRead() throws Exception {
    String tooDeep = "{\"asset\":{\"version\":\"2.0\"},\"nodes\":" + "[".repeat(1_000_000);
    try (ModelImportProcess process = new ModelImportProcess(standard)) {
      assertThatExceptionOfType(ModelImportException.class)
          .isThrownBy(() -> process.read("a.gltf", source(tooDeep)))
          .withMessageContaining("the model reader ended unexpectedly")
          .withMessageContaining("damaged");

      ImportedModel next = process.read("a.obj", source(TRIANGLE)).orElseThrow();
      assertThat(next.meshes().get(0).triangles()).hasSize(3);
    }
    try (Stream<Path> files = Files.list(Path.of(""))) {
      assertThat(files.map(Path::toString))
          .noneMatch(name -> name.startsWith("hs_err") || name.startsWith("core"));
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void aModelThatTakesTooMuchMemoryIsNotRead() {
    byte[] header =
        ("ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\n"
                + "property float y\nproperty float z\nelement face 1\n"
                + "property list uint int vertex_indices\nend_header\n")
            .getBytes(StandardCharsets.US_ASCII);
    ByteBuffer file = ByteBuffer.allocate(header.length + 16);
    file.put(header).putInt(header.length + 12, 0x3fffffff);
    try (ModelImportProcess process =
        new ModelImportProcess(limits(Duration.ofMinutes(1), 200 << 20))) {
      assertThatExceptionOfType(ModelImportException.class)
          .isThrownBy(() -> process.read("a.ply", source(file.array())))
          .withMessageContaining("took more than 200 MiB of memory");
    }
  }

  @Test
  void aModelThatTakesTooLongIsNotRead() {
    try (ModelImportProcess process =
        new ModelImportProcess(limits(Duration.ofMillis(1), 1L << 40))) {
      assertThatExceptionOfType(ModelImportException.class)
          .isThrownBy(() -> process.read("a.obj", source(TRIANGLE)))
          .withMessageContaining("took more than 0 s");
    }
  }

  @Test
  void filesThatAreTooLargeOrTooManyAreNotRead() {
    try (ModelImportProcess process =
        new ModelImportProcess(limits(Duration.ofMinutes(1), 1L << 40))) {
      assertThatExceptionOfType(ModelImportException.class)
          .isThrownBy(() -> process.read("a.obj", source("#".repeat((1 << 20) + 1))))
          .withMessageContaining("larger than 1 MiB");

      String many = "mtllib b.mtl\n".repeat(20) + TRIANGLE;
      assertThatExceptionOfType(ModelImportException.class)
          .isThrownBy(() -> process.read("a.obj", source(many)))
          .withMessageContaining("more than 10 times");
    }
  }

  @Test
  void aFileThatCannotBeReadIsSaidAndTheNextModelIsRead() throws Exception {
    try (ModelImportProcess process = new ModelImportProcess(standard)) {
      ModelFileSource broken =
          url -> {
            throw new IOException(url + " is gone");
          };
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(() -> process.read("a.obj", broken))
          .withMessage("a.obj is gone");
      assertThat(process.read("a.obj", source(TRIANGLE))).isPresent();
      assertThat(process.read("a.ply", source("no model"))).isEmpty();
      assertThat(process.read("a.obj", source(TRIANGLE))).isPresent();
    }
  }

  @Test
  void aLibraryThatDoesNotLoadIsNoFaultOfTheModel() {
    List<String> command =
        ChildProcessCommand.minimal(
            ModelImportMain.class.getName(), List.of("-Dorg.lwjgl.assimp.libname=no-such-library"));
    try (ModelImportProcess process = new ModelImportProcess(standard, command)) {
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(() -> process.read("a.obj", source(TRIANGLE)))
          .withMessageContaining("models of other programs cannot be read: ");
    }
  }

  @Test
  void aProgramThatReadsNoModelsIsSaid() {
    Path java = Path.of(System.getProperty("java.home"), "bin", "java");
    try (ModelImportProcess process =
        new ModelImportProcess(standard, List.of(java.toString(), "-version"))) {
      assertThatExceptionOfType(ModelImportException.class)
          .isThrownBy(() -> process.read("a.obj", source(TRIANGLE)))
          .withMessageContaining("ended unexpectedly");
    }
    try (ModelImportProcess process = new ModelImportProcess(standard, List.of("no-such-java"))) {
      assertThatExceptionOfType(IOException.class)
          .isThrownBy(process::start)
          .withMessageContaining("cannot be started");
    }
  }
}
