package org.selectiverenderer.study.gaze;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;

class ViewingDataTest {
  private static final double[] SOME = {0.6, -0.6, 0, 0, 0, 0};

  @TempDir Path folder;

  private final ProblemCollector problems = new ProblemCollector();

  private Path write(String file, String scene, int seed) throws IOException {
    GazeSimulator room =
        new GazeSimulator(scene, List.of("OfficeSchema"), GazeSimulator.along(SOME, 1));
    return GazeSimulator.write(room.log(20, seed), folder.resolve(file));
  }

  private ViewingData read(String... paths) throws IOException {
    List<Path> all = List.of(paths).stream().map(folder::resolve).toList();
    return ViewingData.read(all, "room.x3d", problems);
  }

  @Test
  void aStudysFolderHasTheLogsOfItsParticipants() throws IOException {
    write("sub-001/ses-01/head/exposure_run-01.csv", "room.x3d", 1);
    write("sub-001/ses-02/head/exposure_run-01.csv", "room.x3d", 2);
    write("sub-002/ses-01/head/exposure_run-01.csv", "room.x3d", 3);
    write("sub-002/ses-01/head/practice_run-01.csv", "room.x3d", 4);
    Files.writeString(folder.resolve("participants.csv"), "id,age\n1,2\n");
    ViewingData data = read("");
    assertThat(data.participants()).isEqualTo(2);
    assertThat(problems.list()).isEmpty();
    assertThat(ConsistencyEstimator.of(data, (object, area) -> OptionalDouble.empty()))
        .allSatisfy(each -> assertThat(each.evidence().participants()).isEqualTo(2))
        .hasSize(6);
  }

  @Test
  void logsOfOtherScenesCountOnlyWhereTheirFilesAreNamed() throws IOException {
    write("a.csv", "room.x3d", 1);
    write("b.csv", "elsewhere.x3d", 2);
    assertThat(read("").participants()).isEqualTo(1);
    assertThat(problems.list().toString()).contains("left out: logs of other scenes (elsewhere");
    assertThat(read("a.csv", "b.csv").participants()).isEqualTo(2);
  }

  @Test
  void aLogNamedTwiceCountsOnce() throws IOException {
    write("a.csv", "room.x3d", 1);
    assertThat(read("a.csv", "").participants()).isEqualTo(1);
  }

  @Test
  void aBrokenLogIsLeftOutAndSaidWithItsLine() throws IOException {
    write("a.csv", "room.x3d", 1);
    Path broken = write("b.csv", "room.x3d", 2);
    List<String> lines = Files.readAllLines(broken);
    Files.write(broken, List.of(lines.get(0), lines.get(1).replaceFirst("^[^,]*", "soon")));
    assertThat(read("a.csv", "b.csv").participants()).isEqualTo(1);
    assertThat(problems.list())
        .anySatisfy(
            problem -> {
              assertThat(problem.severity()).isEqualTo(Problem.Severity.ERROR);
              assertThat(problem.toString()).contains("b.csv:2:1").contains("soon");
            });
  }

  @Test
  void pathsWithoutLogsAreRefused() throws IOException {
    assertThatThrownBy(() -> read("nowhere.csv")).hasMessageContaining("does not exist");
    Files.createDirectory(folder.resolve("empty"));
    assertThatThrownBy(() -> read("empty")).hasMessageContaining("no head logs in this folder");
  }

  @Test
  void linksInAFolderAreNotFollowed() throws IOException {
    write("study/a.csv", "room.x3d", 1);
    Path other = write("other/b.csv", "room.x3d", 2);
    Files.createSymbolicLink(folder.resolve("study/b.csv"), other);
    assertThat(read("study").participants()).isEqualTo(1);
  }

  @Test
  void aDescriptionOfTooManyObjectsIsRefused() throws IOException {
    double[] many = new double[1001];
    GazeSimulator room = new GazeSimulator("room.x3d", List.of(), GazeSimulator.along(many, 1));
    GazeSimulator.write(room.log(1, 1), folder.resolve("a.csv"));
    assertThat(read("a.csv").participants()).isZero();
    assertThat(problems.list().toString()).contains("a.csv").contains("more than 1000 objects");
  }

  @Test
  void manySchemasAreRefused() throws IOException {
    GazeSimulator room =
        new GazeSimulator(
            "room.x3d",
            java.util.stream.IntStream.range(0, 200).mapToObj(i -> "S" + i).toList(),
            GazeSimulator.along(SOME, 1));
    GazeSimulator.write(room.log(1, 1), folder.resolve("a.csv"));
    assertThat(read("a.csv").participants()).isZero();
    assertThat(problems.list().toString()).contains("more than 100 areas or schemas");
  }
}
