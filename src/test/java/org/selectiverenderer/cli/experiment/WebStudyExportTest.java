package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;

/** The example studies as pages for web browsers. */
class WebStudyExportTest extends CommandTestCase {
  @TempDir Path folder;

  @BeforeEach
  void page() {
    assumeTrue(
        WebStudyExportTest.class.getResource("/org/selectiverenderer/web/files.txt") != null
            || System.getenv("SELECTIVE_RENDERER_REQUIRE_WEB") != null,
        "built without the page");
  }

  private int export(String study) {
    return export(Path.of("docs/examples/" + study));
  }

  private int export(Path study) {
    return export(study, "page");
  }

  private int export(Path study, String page) {
    return execute(
        "experiment", "export", study.toString(), "--to", "web", folder.resolve(page).toString());
  }

  /** Begins a study from an example. */
  private Path begun(String design) {
    Path own = folder.resolve("own");
    assertThat(execute("experiment", "new", own.toString(), "--design", design))
        .as(messages())
        .isZero();
    return own;
  }

  @Test
  void theCommandOfTheReceiverIsTold() {
    assertThat(export("change-blindness")).as(messages()).isZero();
    assertThat(printed())
        .contains(
            "tools/web-receiver/receive.py page.sqlite --study 'Change blindness' --slots 24"
                + " --origin https://lab.example.org");
    assertThat(folder.resolve("page/study-web.json")).content().contains("\"show\" : \"repeat\"");
  }

  @Test
  void staircasesAreRefusedWithTheirLine() {
    assertThat(export("levels-of-detail")).isEqualTo(1);
    assertThat(messages()).contains("study.json:19:", "cannot choose levels by the responses yet");
    assertThat(folder.resolve("page")).doesNotExist();
  }

  @Test
  void whereTheAnswersGoIsTold() {
    assertThat(export("change-blindness")).as(messages()).isZero();
    assertThat(printed())
        .contains(
            "set \"receiver\" in "
                + folder.resolve("page/study-settings.json")
                + " to its address; as it is, answers stay with the participant");
  }

  @Test
  void aDisplayThatIsNotUsedIsToldOnlyWhereThereIsOne() throws IOException {
    Path study = begun("change-blindness").resolve("study.json");
    assertThat(export(study.getParent())).as(messages()).isZero();
    assertThat(printed()).contains("shown in one picture").doesNotContain("display");

    Files.writeString(
        study,
        Files.readString(study).replaceFirst("\\{", "{\"display\": {\"mode\": \"window\"},"));
    assertThat(export(study.getParent(), "other")).as(messages()).isZero();
    assertThat(printed()).contains("the study's \"display\" is not used");
  }

  @Test
  void anAddressThatTheAuthorHasNotFilledInIsToldWithItsLine() throws IOException {
    Path own = begun("web");
    Path form = own.resolve("form.json");
    assertThat(messages())
        .contains("change ADDRESS in " + form)
        .contains("experiment export %s --to web %s-page".formatted(own, own));

    assertThat(export(own)).isEqualTo(1);
    assertThat(messages().lines().filter(line -> line.contains("ADDRESS")))
        .hasSize(2)
        .allSatisfy(
            line -> assertThat(line).matches(".*form\\.json:1[01]:\\d+: .*who takes part.*"));
    assertThat(folder.resolve("page/index.html")).isRegularFile();

    Files.writeString(
        form, "// Not ADDRESS\n" + Files.readString(form).replace("ADDRESS", "a@example.org"));
    assertThat(export(own, "other")).as(messages()).isZero();
  }
}
