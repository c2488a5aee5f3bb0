package org.selectiverenderer.app.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class ExampleFolderTest {
  private static final Map<String, byte[]> EXAMPLES =
      Map.of("scenes/a.x3d", bytes("a"), "inlineNodes/b.x3d", bytes("b"));

  @TempDir Path folder;

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  @Test
  void theFolderIsMadeWithAllFilesAndASecondTimeNothingIsWritten() throws IOException {
    ExampleFolder copies = new ExampleFolder(folder.resolve("new/Παραδείγματα"));
    assertThat(copies.complete(EXAMPLES).written())
        .containsExactlyInAnyOrder(copies.file("scenes/a.x3d"), copies.file("inlineNodes/b.x3d"));
    assertThat(copies.file("scenes/a.x3d")).hasContent("a");
    assertThat(copies.complete(EXAMPLES).written()).isEmpty();
  }

  @Test
  void whatTheUserHasChangedStaysAndWhatIsMissingComesBack() throws IOException {
    ExampleFolder copies = new ExampleFolder(folder);
    copies.complete(EXAMPLES);
    Files.writeString(copies.file("scenes/a.x3d"), "mine");
    Files.delete(copies.file("inlineNodes/b.x3d"));
    ExampleFolder.Copies done = copies.complete(EXAMPLES);
    assertThat(done.changed()).containsExactly(copies.file("scenes/a.x3d"));
    assertThat(done.written()).containsExactly(copies.file("inlineNodes/b.x3d"));
    assertThat(copies.file("scenes/a.x3d")).hasContent("mine");
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "links take rights there")
  void nothingIsWrittenThroughALinkThatLeadsElsewhere(@TempDir Path elsewhere) throws IOException {
    Files.createSymbolicLink(folder.resolve("scenes"), elsewhere);
    assertThatThrownBy(() -> new ExampleFolder(folder).complete(EXAMPLES))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("a link that leads out of");
    assertThat(elsewhere).isEmptyDirectory();
    assertThat(folder.resolve("inlineNodes")).doesNotExist();
  }

  @Test
  void theProgramBringsWhatItsScenesShow() throws IOException {
    Map<String, byte[]> examples = ExampleFiles.read();
    assertThat(examples)
        .containsKeys(
            "scenes/trashcan.x3d",
            "scenes/apartment.x3d",
            "scenes/apartment-plain.x3d",
            "scenes/paths/desk-visit.csv",
            "inlineNodes/trashCan_v1.x3d",
            "docs/examples/sculptures.x3dv",
            "docs/examples/change-blindness/study.json")
        .doesNotContainKey("scenes/apartment-lit.x3d");
    assertThat(examples.keySet()).allSatisfy(name -> assertThat(name).doesNotContain(".."));
  }
}
