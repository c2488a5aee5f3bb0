package org.selectiverenderer.validation.settings;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;

/** A budget may be for one file of the folder, whatever the others have in common with it. */
class BudgetFilesTest {
  private static final String ROOM =
      """
      <?xml version='1.0' encoding='UTF-8'?>
      <X3D profile='Immersive' version='4.0'><Scene>
      <Group DEF='Kitchen'>
      <Switch DEF='Switch_Cup' whichChoice='0'>
        <MetadataSet containerField='metadata' name='Cup'>
          <MetadataSet containerField='value' name='Cup_v1'>
            <MetadataString containerField='value' name='schemaBelonginess' value='"Desk"'/>
          </MetadataSet>
        </MetadataSet>
        <Shape><Box/></Shape>
      </Switch>
      </Group>
      </Scene></X3D>
      """;

  @TempDir Path folder;

  @BeforeEach
  void scenes() throws IOException {
    Files.createDirectories(folder.resolve("rooms"));
    Files.writeString(folder.resolve("rooms/living.x3d"), ROOM);
    Files.writeString(folder.resolve("house.x3d"), ROOM);
  }

  private Optional<ValidationSettings> settings(String budget, ProblemCollector problems)
      throws IOException {
    Path file = folder.resolve("validate.json");
    Files.writeString(file, "{\"budgets\": [" + budget + "]}");
    return new ValidationSettingsReader(file, RuleCatalogue.standard()).read(problems);
  }

  private List<String> findings(String budget) throws IOException {
    ValidationSettings settings = settings(budget, new ProblemCollector()).orElseThrow();
    return new Validator(RuleCatalogue.standard(), settings, folder)
            .validate(
                Stream.of("rooms/living.x3d", "house.x3d")
                    .map(name -> SourceFile.of(folder.resolve(name), folder))
                    .toList())
            .findings()
            .stream()
            .filter(finding -> finding.rule().id().startsWith("SR50"))
            .map(finding -> finding.location().file() + " " + finding.rule().id())
            .toList();
  }

  @Test
  void aBudgetOfAFileHoldsForThatFileAlone() throws IOException {
    assertThat(findings("{\"scope\": \"Kitchen\", \"polygons\": 5}"))
        .containsExactlyInAnyOrder("house.x3d SR501", "rooms/living.x3d SR501");
    assertThat(
            findings("{\"file\": \"rooms/living.x3d\", \"scope\": \"Kitchen\", \"polygons\": 5}"))
        .containsExactly("rooms/living.x3d SR501");
    assertThat(findings("{\"file\": \"./rooms/../house.x3d\", \"polygons\": 5}"))
        .containsExactly("house.x3d SR501");
  }

  @Test
  void misspeltNamesAreToldInThatFileAndMissingFilesInTheSettings() throws IOException {
    assertThat(findings("{\"file\": \"house.x3d\", \"scope\": \"Kichen\", \"polygons\": 5}"))
        .containsExactly("house.x3d SR502");
    assertThat(findings("{\"file\": \"living.x3d\", \"scope\": \"Kitchen\", \"polygons\": 5}"))
        .containsExactly("validate.json SR503");
  }

  @Test
  void texturesAndDrawCallsHaveBudgetsToo() throws IOException {
    assertThat(findings("{\"scope\": \"Kitchen\", \"drawCalls\": 0, \"textureBytes\": 0}"))
        .containsExactlyInAnyOrder("house.x3d SR501", "rooms/living.x3d SR501");
    assertThat(findings("{\"scope\": \"Kitchen\", \"drawCalls\": 1, \"textureBytes\": 0}"))
        .isEmpty();
    ProblemCollector problems = new ProblemCollector();
    assertThat(settings("{\"scope\": \"Kitchen\"}", problems)).isEmpty();
    assertThat(problems.list().toString())
        .contains("a budget needs \"polygons\", \"textureBytes\" or \"drawCalls\"");
  }

  @Test
  void whatCanBeNoFileIsAFault() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    assertThat(settings("{\"file\": \"a\\u0000b\", \"polygons\": 5}", problems)).isEmpty();
    assertThat(problems.list().toString()).contains("cannot be the name of a file");
  }
}
