package org.selectiverenderer.natives;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.platform.ChildProcessCommand;
import org.selectiverenderer.testing.RequiresDisplay;

/**
 * What another user has put into the folder of temporary files, under names that libraries look for
 * there, is neither loaded nor changed, and nothing is deleted through his links. What he plants is
 * the real library, so that it would be taken.
 */
@EnabledOnOs(
    value = OS.LINUX,
    architectures = "amd64",
    disabledReason = "/proc says what is loaded, and the planted files are of one platform")
@Timeout(value = 60, unit = TimeUnit.SECONDS)
class NativeLibrariesTest {
  private static final String LWJGL = "linux/x64/org/lwjgl/";
  private static final String MODEL =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

  @TempDir private Path folder;
  private Path temporary;
  private Path cache;
  private final Map<Path, byte[]> planted = new LinkedHashMap<>();

  @BeforeEach
  void folders() throws IOException {
    Path real = folder.toRealPath();
    temporary = Files.createDirectory(real.resolve("tmp"));
    cache = Files.createDirectory(real.resolve("cache"));
  }

  @Test
  void jSerialComm() throws Exception {
    Path there = temporary.resolve("jSerialComm");
    plant("Linux/x86_64/libjSerialComm.so", there.resolve("2.11.4/libjSerialComm.so"));
    Path victim = Files.createDirectory(folder.resolve("documents"));
    Path letter = Files.writeString(victim.resolve("letter.txt"), "Dear");
    Files.createSymbolicLink(there.resolve("1.0"), victim);
    use("jSerialComm", "");
    loaded("libjSerialComm.so");
    assertThat(letter).hasContent("Dear");
  }

  @Test
  @RequiresDisplay
  void jogl() throws Exception {
    for (String name : List.of("gluegen_rt", "jogl_desktop", "nativewindow_x11")) {
      String file = "lib" + name + ".so";
      plant("natives/linux-amd64/" + file, temporary.resolve(file));
      plant(
          "natives/linux-amd64/" + file,
          temporary.resolve("jogamp_0000/file_cache/jln/jln/natives/linux-amd64/" + file));
    }
    use("JOGL", "");
    loaded("libgluegen_rt.so");
    loaded("libnativewindow_x11.so");
  }

  @Test
  void assimpAndMeshoptimizer() throws Exception {
    plantLwjgl("liblwjgl.so", "assimp/libassimp.so", "assimp/libdraco.so");
    plantLwjgl("meshoptimizer/liblwjgl_meshoptimizer.so");
    Path model = Files.writeString(folder.resolve("model.obj"), MODEL);
    use("Assimp and meshoptimizer", model.toString());
    loaded("libassimp.so");
    loaded("liblwjgl_meshoptimizer.so");
  }

  @Test
  void openXr() throws Exception {
    plantLwjgl("liblwjgl.so", "openxr/libopenxr_loader.so");
    use("OpenXR", "");
    loaded("libopenxr_loader.so");
  }

  /** It makes new files with names of its own there, which nobody can plant. */
  @Test
  @RequiresDisplay
  void flatLaf() throws Exception {
    use("FlatLaf", "");
    loaded("libflatlaf-linux-x86_64.so");
  }

  @Test
  void libffiForTheUsersLiblsl() throws Exception {
    plantLwjgl("liblwjgl.so");
    Path other = folder.resolve("liblsl.so");
    copy("Linux/x86_64/libjSerialComm.so", other);
    use("libffi", other.toString());
    loaded("liblwjgl.so");
  }

  /** Below a folder for the user, named as LWJGL names it, and each version that it may have. */
  private void plantLwjgl(String... names) throws IOException {
    String version = org.lwjgl.Version.getVersion();
    for (String each : List.of(version, version.replace(' ', '-'))) {
      for (String name : names) {
        Path user = temporary.resolve("lwjgl_" + System.getProperty("user.name").strip());
        plant(LWJGL + name, user.resolve(each).resolve("x64").resolve(Path.of(name).getFileName()));
      }
    }
  }

  private void plant(String resource, Path file) throws IOException {
    Files.createDirectories(file.getParent());
    copy(resource, file);
    planted.put(file, Files.readAllBytes(file));
  }

  private static void copy(String resource, Path file) throws IOException {
    ClassLoader loader = Objects.requireNonNull(NativeLibrariesTest.class.getClassLoader());
    try (InputStream in = Objects.requireNonNull(loader.getResourceAsStream(resource), resource)) {
      Files.write(file, in.readAllBytes());
    }
  }

  /** Runs the process, which is to load nothing of the temporary folder and leave it as it is. */
  private void use(String library, String argument) throws Exception {
    List<Path> before = files(temporary);
    ProcessBuilder builder =
        new ProcessBuilder(
                ChildProcessCommand.of(
                    NativeLibraryUser.class.getName(),
                    List.of("-Djava.io.tmpdir=" + temporary, "-XX:TieredStopAtLevel=1"),
                    List.of(library, argument)))
            .redirectError(folder.resolve("errors.txt").toFile());
    builder.environment().put("XDG_CACHE_HOME", cache.toString());
    Process process = builder.start();
    String maps = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(() -> read(folder.resolve("errors.txt"))).isZero();
    assertThat(maps.lines()).as("in memory").noneMatch(line -> line.startsWith("" + temporary));
    assertThat(files(temporary)).containsExactlyInAnyOrderElementsOf(before);
    planted.forEach((file, content) -> assertThat(file).hasBinaryContent(content));
  }

  /** Whether the library was unpacked into the user's own folder. */
  private void loaded(String name) throws IOException {
    assertThat(files(cache.resolve("selective-renderer/natives")))
        .anyMatch(file -> file.endsWith(name));
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return new ArrayList<>(files.toList());
    }
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return e.toString();
    }
  }
}
