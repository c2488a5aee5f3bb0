package org.selectiverenderer.study.headlog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonTree;

class SwitchSightingsTest {
  private static final String CHANGE =
      "{\"t\":%s,\"event\":\"switch\",\"switch\":\"%s\",\"from\":1,\"to\":0,\"schema\":\"A\"%s}\n";

  private static final String SEEN = ",\"visible\":true,\"pixels\":%d,\"turning\":1.5";
  private static final String UNSEEN = ",\"visible\":false,\"pixels\":0,\"turning\":0.0";

  @TempDir Path folder;

  private final ProblemCollector problems = new ProblemCollector();

  private SwitchSightings read(String text) throws IOException {
    return SwitchSightings.read(Files.writeString(folder.resolve("t.jsonl"), text), problems);
  }

  @Test
  void theChangesOfEachObjectAreCounted() throws IOException {
    SwitchSightings read =
        read(
            "{\"t\":0.0,\"event\":\"start\",\"switches\":{\"Can\":1}}\n"
                + CHANGE.formatted("1.0", "Can", SEEN.formatted(900))
                + CHANGE.formatted("1.5", "Cup", UNSEEN)
                + CHANGE.formatted("2.0", "Can", SEEN.formatted(1200))
                + CHANGE.formatted("3.0", "Can", UNSEEN));
    assertThat(problems.list()).isEmpty();
    assertThat(read.text())
        .isEqualTo(
            """
            versions                          changes  visible     pixels
            Can                                     3        2       1200
            Cup                                     1        0          \s
            4 changes, 2 of them visible
            """);
    ObjectNode report = JsonTree.object();
    read.put(report);
    assertThat(report.path("switches")).hasSize(4);
    assertThat(report.path("switches").get(0).toString())
        .isEqualTo(
            "{\"t\":1.0,\"object\":\"Can\",\"visible\":true,\"pixels\":900,\"turning\":1.5}");
  }

  @Test
  void linesThatAreNoneAndOldOnesAreReportedWithTheirPlace() throws IOException {
    SwitchSightings read =
        read(
            "{\"t\":0.0,\n"
                + CHANGE.formatted("1.0", "Can", "")
                + "[]\n\n"
                + CHANGE.formatted("2.0", "Can", UNSEEN));
    assertThat(read.changes()).hasSize(1);
    assertThat(problems.list().get(0).toString()).contains("t.jsonl:1:", "no line of a time line");
    assertThat(problems.list().get(1).toString()).contains("t.jsonl:2:", "does not tell whether");
  }

  @Test
  void whatIsNoTextIsRefusedInOneLine() throws IOException {
    Path file = Files.write(folder.resolve("b.jsonl"), new byte[] {(byte) 0xff, (byte) 0xfe, 1});
    assertThatThrownBy(() -> SwitchSightings.read(file, problems))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("is not a time line in UTF-8");
  }
}
