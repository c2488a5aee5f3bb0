package org.selectiverenderer.base.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.testing.RequiresSymbolicLinks;

class FileFinderTest {
  @TempDir Path dir;

  @BeforeEach
  void files() throws IOException {
    for (String name :
        List.of("b.x3d", "a.X3D", "c/z.x3dz", "c/d/y.x3d", "notes.txt", ".git/h.x3d", "c/.k.x3d")) {
      Path file = dir.resolve(name);
      Files.createDirectories(file.getParent());
      Files.writeString(file, "");
    }
  }

  private List<String> find(String name) throws IOException {
    return FileFinder.SCENES.find(name).stream()
        .map(file -> dir.relativize(file).toString().replace('\\', '/'))
        .toList();
  }

  @Test
  void aFolderStandsForItsScenesInOrderOfTheirPathsWithoutHiddenOnes() throws IOException {
    assertThat(find(dir.toString())).containsExactly("a.X3D", "b.x3d", "c/d/y.x3d", "c/z.x3dz");
  }

  @Test
  void aFileStandsForItselfWhateverItsNameAndWhetherItIsThereOrNot() throws IOException {
    assertThat(find(dir.resolve("notes.txt").toString())).containsExactly("notes.txt");
    assertThat(find(dir.resolve("gone.x3d").toString())).containsExactly("gone.x3d");
  }

  @Test
  void aPatternStandsForWhatMatchesAtAnyDepth() throws IOException {
    assertThat(find(dir + "/**/*.x3d"))
        .containsExactlyElementsOf(alsoUpperCase("b.x3d", "c/d/y.x3d"));
    assertThat(find(dir + "/*.{x3d,txt}"))
        .containsExactlyElementsOf(alsoUpperCase("b.x3d", "notes.txt"));
  }

  /** On Windows a pattern matches names of either case, as names there do. */
  private static List<String> alsoUpperCase(String... lowerCase) {
    return Stream.concat(
            OS.WINDOWS.isCurrentOs() ? Stream.of("a.X3D") : Stream.empty(), Stream.of(lowerCase))
        .toList();
  }

  @Test
  @RequiresSymbolicLinks
  void aLinkStaysInTheFolderOrIsNamedByTheUser() throws IOException {
    Path secret = Files.writeString(dir.resolve("secret.xml"), "<password>1</password>");
    Path inside = dir.resolve("c/inside.x3d");
    Files.createSymbolicLink(inside, Path.of("d/y.x3d"));
    assertThat(find(dir.resolve("c").toString()))
        .containsExactly("c/d/y.x3d", "c/inside.x3d", "c/z.x3dz");

    Path outside = dir.resolve("c/outside.x3d");
    Files.createSymbolicLink(outside, secret);
    assertThatThrownBy(() -> find(dir.resolve("c").toString()))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(outside + ": is a link to a file outside " + dir.resolve("c"))
        .hasMessageEndingWith("name it itself");
    assertThatThrownBy(() -> find(dir + "/c/*.x3d")).hasMessageContaining("outside.x3d");
    assertThat(find(outside.toString())).containsExactly("c/outside.x3d");

    Files.delete(outside);
    Files.createSymbolicLink(outside, Path.of("gone.x3d"));
    assertThat(find(dir.resolve("c").toString())).contains("c/outside.x3d");
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "its folders hold no pipes")
  void aFolderStandsForNoPipe() throws IOException, InterruptedException {
    Path pipe = dir.resolve("pipe.x3d");
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    assertThat(find(dir.toString())).doesNotContain("pipe.x3d").contains("b.x3d");
  }

  @Test
  void saysWhenNothingIsFound() throws IOException {
    Path empty = Files.createDirectories(dir.resolve("empty"));

    assertThatThrownBy(() -> FileFinder.SCENES.find(empty.toString()))
        .isInstanceOf(IOException.class)
        .hasMessage(
            "no scene (.x3d, .x3dz, .x3dv, .x3dvz, .wrl, .wrz, .wrl.gz, .x3dj, .x3djz) in "
                + empty);
    assertThatThrownBy(() -> FileFinder.SCENES.find(dir + "/gone/*.x3d"))
        .isInstanceOf(NoSuchFileException.class);
  }

  @Test
  void foldersAndPatternsMeanSeveralFilesButNotAFileWhoseNameLooksLikeAPattern()
      throws IOException {
    Path bracket = Files.writeString(dir.resolve("a[1].x3d"), "");

    assertThat(FileFinder.meansSeveral(dir.toString())).isTrue();
    assertThat(FileFinder.meansSeveral(dir + "/*.x3d")).isTrue();
    assertThat(FileFinder.meansSeveral(bracket.toString())).isFalse();
    assertThat(FileFinder.meansSeveral(dir.resolve("gone.x3d").toString())).isFalse();
  }
}
