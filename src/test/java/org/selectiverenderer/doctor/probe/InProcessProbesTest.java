package org.selectiverenderer.doctor.probe;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.doctor.Diagnosis.Status;
import org.selectiverenderer.doctor.Probe;
import org.selectiverenderer.render.window.Monitor;
import org.selectiverenderer.render.window.MonitorMode;

/** What is looked at without other people's libraries. */
class InProcessProbesTest {
  @TempDir private Path folder;

  @Test
  void aFolderThatIsNotThereYetIsNotMade() throws IOException {
    Path settings = folder.resolve("a").resolve("b");
    Diagnosis line = FoldersProbe.place("settings", settings);
    assertThat(line.found()).startsWith(settings + ", ").endsWith(" MB free");
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void nothingIsLeftInAFolder() throws IOException {
    assertThat(FoldersProbe.place("settings", folder).fatal()).isFalse();
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void aFileInTheWayIsNamed() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "");
    Diagnosis line = FoldersProbe.place("settings", file.resolve("settings"));
    assertThat(line.fatal()).isTrue();
    assertThat(line.found()).endsWith("cannot be made: " + file + " is a file");
  }

  @Test
  void namesOfFilesAreGreekInSomeCharsets() {
    assertThat(SystemProbe.encodesGreek("ANSI_X3.4-1968")).isFalse();
    assertThat(SystemProbe.encodesGreek("UTF-8")).isTrue();
    assertThat(SystemProbe.encodesGreek("windows-1253")).isTrue();
    assertThat(SystemProbe.encodesGreek("no such charset")).isTrue();
  }

  @Test
  void adviceOnGreekNamesFitsTheSystem() {
    assertThat(SystemProbe.language("Linux", "US-ASCII").todo()).contains("LC_ALL=C.UTF-8");
    assertThat(SystemProbe.language("Windows 11", "Cp1252").todo())
        .contains("can be opened from file dialogs")
        .contains("language for non-Unicode programs")
        .doesNotContain("LC_ALL");
    assertThat(SystemProbe.language("Windows 11", "Cp1253").todo()).isEmpty();
  }

  @Test
  void javaAndTheSystemAreNamed() throws IOException {
    List<Diagnosis> lines = new ArrayList<>();
    JavaProbe.run(lines::add);
    SystemProbe.run(lines::add);
    assertThat(lines).extracting(Diagnosis::subject).contains("Java", "system", "processor");
    assertThat(lines.get(0).found()).contains(System.getProperty("java.runtime.version"));
    assertThat(lines).noneMatch(line -> line.status() == Status.MISSING);
  }

  @Test
  void monitorsAndSpeedsAreWrittenForEveryLanguage() {
    Monitor monitor = new Monitor(0, 1, "DP-1", 0, 0, 2560, 1440);
    assertThat(DisplayProbe.text(new MonitorMode(monitor, 59.951f, 1.5f)))
        .isEqualTo("2560x1440 at 0,0 (DP-1), 59.95 Hz, scale 1.50");
    assertThat(DisplayProbe.text(new MonitorMode(monitor, 0, 1))).contains(", unknown rate, ");
    assertThat(OpenGlProbe.millions(1_234_567)).isEqualTo("1.23");
    assertThat(OpenGlProbe.millions(12_345_678)).isEqualTo("12.3");
    assertThat(OpenGlProbe.millions(1.2e9)).isEqualTo("1,200");
  }

  @Test
  void aRuntimesFileThatIsNotThereIsToldOf() throws IOException {
    Path file = folder.resolve("runtime.json");
    assertThat(HeadsetProbe.text(file))
        .isEqualTo("; XR_RUNTIME_JSON names " + file + ", which does not exist");
    assertThat(HeadsetProbe.text(Files.writeString(file, "{}"))).isEqualTo("; set up by " + file);
  }

  @Test
  void portsAreAskedOnlyWhenTheUserWantsIt() {
    assertThat(ProbeCatalogue.all(false)).extracting(Probe::name).doesNotContain("tracker");
    assertThat(ProbeCatalogue.all(true))
        .extracting(Probe::name)
        .contains("tracker")
        .doesNotHaveDuplicates();
  }
}
