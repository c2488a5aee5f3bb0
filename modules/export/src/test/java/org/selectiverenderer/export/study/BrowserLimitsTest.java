package org.selectiverenderer.export.study;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BrowserLimitsTest {
  @TempDir Path folder;

  @Test
  void aStudyOfAreasAndQuestionsRuns() throws IOException {
    StudyFixture fixture = new StudyFixture(folder);
    var study = fixture.read(StudyFixture.text("  \"tracker\": \"none\",\n"));
    assertThat(new BrowserLimits(study.get(0), fixture.collector()).keep()).isTrue();
    assertThat(fixture.problems()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "\"triggers\": {\"port\": \"/dev/ttyS0\", \"events\": {\"exposure-began\": 1}}"
            + "|a web browser cannot send triggers by a serial port",
        "\"streams\": {\"lsl\": true}|a web browser has no Lab Streaming Layer",
        "\"tracker\": \"opentrack:4242\"|a web browser reads no head tracker",
        "\"display\": {\"mode\": \"openxr\"}|the page cannot run a study inside a headset yet",
        "\"qualities\": {\"textures\": \"low\"}|the page shows all qualities as the condition says",
        "\"switch\": \"fade:300\"|the page changes versions at once, and cannot do fade:300",
        "\"closed\": true|the page cannot close rooms yet",
        "\"stay\": \"walk\"|the page cannot bound an area yet"
      })
  void whatABrowserCannotDoIsRefusedWithItsLine(String key, String why) throws IOException {
    StudyFixture fixture = new StudyFixture(folder);
    var study = fixture.read(StudyFixture.text("  " + key + ",\n"));
    assertThat(new BrowserLimits(study.get(0), fixture.collector()).keep()).isFalse();
    assertThat(fixture.problems()).hasSize(1);
    assertThat(fixture.problems().get(0)).startsWith("study.json:8:").contains(why);
  }

  @Test
  void anAreaThatIsBoundedIsRefusedWithItsLine() throws IOException {
    StudyFixture fixture = new StudyFixture(folder);
    var study =
        fixture.read(
            StudyFixture.text("")
                .replace("\"seconds\": 2", "\"seconds\": 2,\n    \"stay\": \"walk\""));
    assertThat(new BrowserLimits(study.get(0), fixture.collector()).keep()).isFalse();
    assertThat(fixture.problems())
        .singleElement()
        .asString()
        .startsWith("study.json:9:")
        .contains("the page cannot bound an area yet; write \"turn\" or \"free\"");
  }

  private static final String BLOCK =
      """
        "factors": [{"name": "light", "varies": "within", "levels": [
          {"name": "on"%s}, {"name": "off"}]}],
        "blocks": [{"name": "main",%s
          "trial": [{"show": "exposure", "seconds": 1%s, "keys": ["f"], "correct": "f"}]}],
      """;

  private List<String> ofBlock(String level, String block, String phase) throws IOException {
    StudyFixture fixture = new StudyFixture(folder);
    var study =
        fixture.read(
            StudyFixture.text(BLOCK.formatted(level, block, phase))
                .replace("  \"conditions\": [\"high\", \"selective\"],\n", ""));
    assertThat(new BrowserLimits(study.get(0), fixture.collector()).keep())
        .isEqualTo(fixture.problems().isEmpty());
    return fixture.problems();
  }

  @Test
  void blocksRun() throws IOException {
    assertThat(ofBlock("", "", "")).isEmpty();
  }

  @Test
  void whatTrialsAskForAndABrowserCannotDoIsRefusedWithItsLine() throws IOException {
    assertThat(ofBlock(", \"display\": {\"ipd\": 0}", "", ""))
        .singleElement()
        .asString()
        .startsWith("study.json:8:")
        .contains("the page shows one picture, and cannot vary the display");
    assertThat(ofBlock("", "\"staircase\": {\"factor\": \"light\"},", ""))
        .singleElement()
        .asString()
        .startsWith("study.json:9:")
        .contains("cannot choose levels by the responses yet");
    assertThat(ofBlock("", "", ", \"until\": \"scene\""))
        .singleElement()
        .asString()
        .startsWith("study.json:10:")
        .contains("the page cannot end exposures by events of the scene yet");
  }
}
