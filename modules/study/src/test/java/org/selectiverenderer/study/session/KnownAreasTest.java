package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;

/** Which areas a table of items may name. */
class KnownAreasTest {
  @TempDir private Path folder;

  private List<String> read(String more, String... areas) throws IOException {
    Files.writeString(
        folder.resolve("rooms.x3d"),
        """
        <X3D version='4.0'><Scene><Viewpoint DEF='Here'/><Inline url='"part.x3d"'/></Scene></X3D>
        """);
    Files.writeString(
        folder.resolve("part.x3d"),
        """
        <X3D version='4.0'><Scene><ProximitySensor size='1 1 1' DEF=' BookcaseProx '/>
        <MetadataString name='schema' value='"DeskSchema"'/></Scene></X3D>
        """);
    StringBuilder table = new StringBuilder("area,object,consistency,present,en\n");
    for (String area : areas) {
      table.append(area).append(",coat,consistent,yes,Coat\n");
    }
    Files.writeString(folder.resolve("r.csv"), table);
    Path file =
        Files.writeString(
            folder.resolve("study.json"),
            """
            {"name": "Rooms", "conditions": ["high"], "participants": 1, %s
             "questionnaires": [{"kind": "recognition", "items": "r.csv"}]}
            """
                .formatted(more));
    ProblemCollector problems = new ProblemCollector();
    Optional<LoadedStudy> study = LoadedStudy.read(file, problems);
    assertThat(study.isEmpty()).isEqualTo(problems.anyError());
    return problems.list().stream().map(Problem::toString).toList();
  }

  private static final String SCENE =
      "\"scene\": \"rooms.x3d\","
          + " \"areas\": [{\"name\": \"hall\", \"viewpoint\": \"Here\", \"seconds\": 1}],";

  @Test
  void areasOfTheStudyAndPartsOfItsSceneAreKnown() throws IOException {
    assertThat(read(SCENE, "hall", "bookcase", "desk")).isEmpty();
  }

  @Test
  void aMistypedAreaIsAnErrorWithItsPlaceAndASuggestion() throws IOException {
    assertThat(read(SCENE, "hall", "bokcase"))
        .singleElement()
        .asString()
        .contains(
            "r.csv:3:1", "is no area of the study or its scene", "did you mean \"bookcase\"?");
    assertThat(read(SCENE, "Hall")).singleElement().asString().contains("did you mean \"hall\"?");
  }

  @Test
  void anAreaThatNothingResemblesIsTold() throws IOException {
    assertThat(read(SCENE, "restaurant"))
        .singleElement()
        .asString()
        .contains("it has a list of its own: declare it if it is meant");
  }

  @Test
  void aDeclaredAreaIsKnown() throws IOException {
    assertThat(read(SCENE + "\"item_areas\": [\"restaurant\"],", "restaurant")).isEmpty();
    assertThat(read("\"item_areas\": [\"hall\"],", "hal"))
        .singleElement()
        .asString()
        .contains("did you mean \"hall\"?");
  }

  @Test
  void aStudyWithoutASceneTakesAnyArea() throws IOException {
    assertThat(read("", "anything")).isEmpty();
  }
}
