package org.selectiverenderer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The jar of a package, which {@code packaging/SlimJar.java} makes of the application's. */
class SlimJarTest {
  private static final long SECONDS = 1_600_000_000;

  @TempDir private Path folder;

  @Test
  void itHasTheNativePartsOfOneSystemAndAllFolders() throws Exception {
    Path made = folder.resolve("app");
    slim(
        jar(
            "a/",
            "a/Class.class",
            "natives/",
            "natives/linux-amd64/",
            "natives/linux-amd64/libone.so",
            "natives/windows-amd64/",
            "natives/windows-amd64/one.dll",
            "linux/x64/org/lwjgl/liblwjgl.so",
            "windows/x64/org/lwjgl/lwjgl.dll",
            "Linux/x86_64/libjSerialComm.so",
            "OSX/aarch64/libjSerialComm.jnilib"),
        made,
        "linux-x64");
    // JOGL looks for its libraries' folder by its entry; without it, it unpacks them over
    // themselves.
    assertThat(names(made.resolve("selective-renderer.jar")))
        .containsExactly(
            "a/",
            "a/Class.class",
            "natives/",
            "natives/linux-amd64/",
            "natives/linux-amd64/libone.so",
            "linux/x64/org/lwjgl/liblwjgl.so",
            "Linux/x86_64/libjSerialComm.so");
  }

  @Test
  void theLibrariesOfJoglLieBesideIt() throws Exception {
    Path made = folder.resolve("app");
    slim(jar("natives/linux-amd64/", "natives/linux-amd64/libone.so"), made, "linux-x64");
    Path jar = made.resolve("selective-renderer.jar");
    Path natives = made.resolve("natives/linux-amd64");
    assertThat(natives.resolve("libone.so")).hasContent("natives/linux-amd64/libone.so");
    assertThat(Files.getLastModifiedTime(jar).toMillis()).isEqualTo(SECONDS * 1000);
  }

  private Path jar(String... names) throws IOException {
    Path jar = folder.resolve("whole.jar");
    try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(jar))) {
      for (String name : names) {
        out.putNextEntry(new ZipEntry(name));
        if (!name.endsWith("/")) {
          out.write(name.getBytes(StandardCharsets.UTF_8));
        }
      }
    }
    return jar;
  }

  private static void slim(Path jar, Path made, String platform) throws Exception {
    Process process =
        new ProcessBuilder(
                List.of(
                    Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                    "packaging/SlimJar.java",
                    jar.toString(),
                    made.toString(),
                    platform,
                    Long.toString(SECONDS)))
            .redirectErrorStream(true)
            .start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(said).isZero();
  }

  private static List<String> names(Path jar) throws IOException {
    try (JarFile file = new JarFile(jar.toFile());
        Stream<String> names = file.stream().map(ZipEntry::getName)) {
      return names.toList();
    }
  }
}
