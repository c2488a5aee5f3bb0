package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

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
    return execute(
        "experiment",
        "export",
        "docs/examples/" + study,
        "--to",
        "web",
        folder.resolve("page").toString());
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
    assertThat(messages())
        .contains("study.json:19:", "cannot choose levels by the responses yet");
    assertThat(folder.resolve("page")).doesNotExist();
  }
}
