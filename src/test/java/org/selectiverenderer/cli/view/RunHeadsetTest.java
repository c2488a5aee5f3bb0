package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.cli.CommandTestCase;

/** What {@code run --display openxr} refuses, before it looks for a headset. */
class RunHeadsetTest extends CommandTestCase {
  @TempDir private Path folder;

  private void refused(String said, String... arguments) {
    List<String> all = new ArrayList<>(List.of("run", "scenes/trashcan.x3d"));
    all.addAll(List.of(arguments));
    assertThat(execute(all.toArray(String[]::new))).isEqualTo(2);
    assertThat(messages()).contains(said).doesNotContain("Exception");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--offscreen | cannot be combined with",
        "--ipd 63 | a headset brings its own",
        "--hmd proview50 | a headset brings its own",
        "--hmd-check | a headset brings its own",
        "--tracker opentrack | has the headset's own tracker; leave --tracker out",
        "--tracker-position on | leave it out",
        "--user-scale 0 | --user-scale must be a number from 0.01 to 100",
        "--user-scale 101 | --user-scale must be a number from 0.01 to 100",
        "--turn 181 | --turn must be a number of degrees from 0 to 180",
        "--turn -1 | --turn must be a number of degrees from 0 to 180",
        "--posture lying | --posture",
        "--mirror none | --mirror"
      })
  void whatAHeadsetCannotOrNeedNotBeTold(String options, String said) {
    List<String> all = new ArrayList<>(List.of("--display", "openxr"));
    all.addAll(List.of(options.split(" ")));
    refused(said, all.toArray(String[]::new));
  }

  @ParameterizedTest
  @CsvSource({"--posture,seated", "--user-scale,2", "--turn,45", "--mirror,left"})
  void whatOnlyAHeadsetHas(String option, String value) {
    String said = "--posture, --user-scale, --turn and --mirror need --display openxr";
    refused(said, option, value);
    refused(said, "--display", "side-by-side", option, value);
  }

  @Test
  void aPathThatTurnsTheViewLeavesNothingToTheHeadset() {
    refused(
        "--tracker and --display openxr cannot be combined with a path that turns the view",
        "--display",
        "openxr",
        "--path",
        "scenes/paths/desk-visit.csv",
        "--head-log",
        folder.resolve("p.csv").toString());
    assertThat(folder).isEmptyDirectory();
  }
}
