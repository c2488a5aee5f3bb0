package org.selectiverenderer.render.context;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.Map;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class JoglNativeLibrariesTest {
  @TempDir private Path folder;

  @Test
  void theLibrariesOfThePlatformLieBesideTheJar() throws Exception {
    Path jar =
        jar(
            Map.of(
                "natives/linux-amd64/libone.so", "one",
                "natives/windows-amd64/one.dll", "other",
                "a/Class.class", "class"));
    Path made = JoglNativeLibraries.folder(jar, "linux-amd64").orElseThrow();
    assertThat(made).isEqualTo(folder.resolve("natives/linux-amd64"));
    assertThat(made.resolve("libone.so")).hasContent("one");
    assertThat(made.resolve("one.dll")).doesNotExist();
  }

  @Test
  void anotherJarReplacesThem() throws Exception {
    Path old = jar(Map.of("natives/linux-amd64/libone.so", "one"));
    Path made = JoglNativeLibraries.folder(old, "linux-amd64").orElseThrow();
    Path jar = jar(Map.of("natives/linux-amd64/libone.so", "newer"));
    Files.setLastModifiedTime(jar, FileTime.from(Instant.parse("2020-01-01T00:00:00Z")));
    assertThat(JoglNativeLibraries.folder(jar, "linux-amd64")).contains(made);
    assertThat(made.resolve("libone.so")).hasContent("newer");
  }

  @Test
  void whatIsCompleteIsNotWrittenAgain() throws Exception {
    Path jar = jar(Map.of("natives/linux-amd64/libone.so", "one"));
    Path library =
        JoglNativeLibraries.folder(jar, "linux-amd64").orElseThrow().resolve("libone.so");
    Files.writeString(library, "loaded by others");
    JoglNativeLibraries.folder(jar, "linux-amd64");
    assertThat(library).hasContent("loaded by others");
  }

  /** Its installer may give the jar any time. */
  @Test
  void whatAPackageBringsWithTheJarIsNotWrittenAgain() throws Exception {
    Path jar = jar(Map.of("natives/linux-amd64/libone.so", "one"));
    Path brought = Files.createDirectories(folder.resolve("natives/linux-amd64"));
    Files.writeString(brought.resolve("libone.so"), "the package's");
    Files.writeString(brought.resolve("complete"), Files.size(jar) + " packaged");
    assertThat(JoglNativeLibraries.folder(jar, "linux-amd64")).contains(brought);
    assertThat(brought.resolve("libone.so")).hasContent("the package's");

    Path newer = jar(Map.of("natives/linux-amd64/libone.so", "one of a newer version"));
    assertThat(JoglNativeLibraries.folder(newer, "linux-amd64")).contains(brought);
    assertThat(brought.resolve("libone.so")).hasContent("one of a newer version");
  }

  @Test
  void aFolderThatWasLeftHalfWayIsCompleted() throws Exception {
    Path jar = jar(Map.of("natives/linux-amd64/libone.so", "one"));
    Path half = Files.createDirectories(folder.resolve("natives/linux-amd64"));
    Files.writeString(half.resolve("libone.so"), "o");
    JoglNativeLibraries.folder(jar, "linux-amd64");
    assertThat(half.resolve("libone.so")).hasContent("one");
  }

  @Test
  void aJarWithoutThemLeavesNothing() throws Exception {
    Path jar = jar(Map.of("a/Class.class", "class"));
    assertThat(JoglNativeLibraries.folder(jar, "linux-amd64")).isEmpty();
    assertThat(folder.resolve("natives")).doesNotExist();
    assertThat(JoglNativeLibraries.folder(folder.resolve("missing.jar"), "linux-amd64")).isEmpty();
  }

  @Test
  void aFolderThatCannotBeMadeIsNoFailure() throws Exception {
    Path jar = jar(Map.of("natives/linux-amd64/libone.so", "one"));
    Files.writeString(folder.resolve("natives"), "in the way");
    assertThat(JoglNativeLibraries.folder(jar, "linux-amd64")).isEmpty();
  }

  @Test
  void platformsAreNamedAsTheJarNamesThem() {
    assertThat(JoglNativeLibraries.platform("Linux", "amd64")).contains("linux-amd64");
    assertThat(JoglNativeLibraries.platform("Linux", "aarch64")).contains("linux-aarch64");
    assertThat(JoglNativeLibraries.platform("Windows 11", "amd64")).contains("windows-amd64");
    assertThat(JoglNativeLibraries.platform("Mac OS X", "aarch64")).contains("macosx-universal");
    assertThat(JoglNativeLibraries.platform("Linux", "arm")).isEmpty();
    assertThat(JoglNativeLibraries.platform("SunOS", "amd64")).isEmpty();
  }

  private Path jar(Map<String, String> entries) throws IOException {
    Path jar = folder.resolve("program.jar");
    try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
      for (Map.Entry<String, String> entry : entries.entrySet()) {
        out.putNextEntry(new JarEntry(entry.getKey()));
        out.write(entry.getValue().getBytes(StandardCharsets.UTF_8));
      }
    }
    return jar;
  }
}
