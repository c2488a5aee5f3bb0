package org.selectiverenderer.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What can be said of the workflows for GitHub by reading them. */
class WorkflowsTest {
  private static final Path FOLDER = Path.of(".github", "workflows");

  private static List<Path> workflows() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER)) {
      return files.filter(file -> file.toString().endsWith(".yml")).sorted().toList();
    }
  }

  /** A tag of an action can be moved to other code; a commit cannot. */
  @Test
  void actionsOfOthersAreNamedByTheirCommit() throws IOException {
    List<Path> files = new ArrayList<>(workflows());
    files.add(Path.of("action.yml"));
    Pattern uses = Pattern.compile("uses: *(\\S+)(.*)");
    Map<String, String> pins = new HashMap<>();
    for (Path file : files) {
      for (MatchResult use : uses.matcher(Files.readString(file)).results().toList()) {
        if (use.group(1).startsWith("./")) {
          assertThat(Path.of(use.group(1))).exists();
        } else {
          String[] action = use.group(1).split("@");
          assertThat(action[1]).as("%s in %s", use.group(), file).matches("[0-9a-f]{40}");
          assertThat(use.group(2)).matches(" # v\\d+\\.\\d+\\.\\d+");
          String pin = action[1] + use.group(2);
          assertThat(pin).as(action[0]).isEqualTo(pins.computeIfAbsent(action[0], name -> pin));
        }
      }
    }
    assertThat(pins).containsKeys("actions/checkout", "actions/cache");
  }

  /** A job that hangs would take six hours; one on "latest" changes its system by itself. */
  @Test
  void jobsHaveALimitAndASystem() throws IOException {
    for (Path file : workflows()) {
      String text = Files.readString(file);
      List<String> jobs = Stream.of(text.split("\njobs:\n")[1].split("\n(?=  \\w+:)")).toList();
      for (String job : jobs) {
        if (job.contains("    runs-on: ")) {
          assertThat(job).as("%s: %s", file, job).contains("\n    timeout-minutes: ");
        } else {
          assertThat(job).as("%s: %s", file, job).contains("    uses: ./.github/workflows/");
        }
      }
      assertThat(text).as(file.toString()).doesNotContain("-latest");
    }
  }

  /** What writes says so in its own job. */
  @Test
  void workflowsMayOnlyRead() throws IOException {
    for (Path file : workflows()) {
      assertThat(Files.readString(file))
          .as(file.toString())
          .contains("\npermissions:\n  contents: read\n");
    }
  }

  @Test
  void scriptsThatStepsRunAreThere() throws IOException {
    Pattern script = Pattern.compile("(?:run: |sudo )((?:\\.ci|packaging)/[\\w/-]+)");
    for (Path file : workflows()) {
      script
          .matcher(Files.readString(file))
          .results()
          .forEach(run -> assertThat(Path.of(run.group(1))).as(run.group()).isExecutable());
    }
  }
}
