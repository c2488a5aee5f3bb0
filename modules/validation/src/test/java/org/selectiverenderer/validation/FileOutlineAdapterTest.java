package org.selectiverenderer.validation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.polygon.EnrichmentPolygonModel.Version;
import org.selectiverenderer.polygon.ScenePolygonCounter;
import org.selectiverenderer.polygon.SceneStatistics;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;
import org.selectiverenderer.validation.settings.ValidationSettingsReader;

/** The validator counts what {@code polygons} counts, and finds what walking about brings about. */
class FileOutlineAdapterTest {
  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"scenes/trashcan.x3d", "scenes/overlap.x3d", "scenes/hello.x3d"})
  void countsWhatThePolygonsCommandCounts(String scene) throws IOException {
    SceneStatistics statistics =
        ScenePolygonCounter.of(Path.of(scene), List.of(), new ProblemCollector());
    EnrichmentPolygonModel model = model(Path.of(scene));

    assertThat(
            model.objects().stream()
                .map(o -> o.versions().stream().map(Version::polygons).toList()))
        .containsExactlyElementsOf(
            statistics.objects().stream().map(SceneStatistics.ObjectCount::versions).toList());
    long loaded = statistics.scopes().get(0).states().get(0).polygons();
    String scope = statistics.scopes().get(0).scope();
    String group = scope.equals(SceneStatistics.WHOLE_SCENE) ? "" : scope;
    assertThat(model.states(group).get(0).polygons()).isEqualTo(loaded);
  }

  /** Modellers close their spheres by triangles that have two points in the same place. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "0 1 2 -1 0 2 4 -1",
        "0 1 2 -1 1 1 2 -1",
        "0 1 2 -1 0 1 5 -1",
        "0 1 2 3 -1 0 1 4 2 -1",
        "0 1 2 3 -1 0 1 5 6 -1",
        "0 1 2 3"
      })
  void trianglesWithoutAreaAreNotCounted(String faces) throws IOException {
    Path scene =
        Files.writeString(
            folder.resolve("scene.x3d"),
            ("<X3D version='4.0' profile='Immersive'><Scene>%s<Shape><IndexedFaceSet coordIndex='%s'>"
                    + "<Coordinate point='0 0 0 1 0 0 1 1 0 0 1 0 1 1 0 2 0 0 3 0 0'/>"
                    + "</IndexedFaceSet></Shape></Scene></X3D>")
                .formatted(area("A", 0) + lamp("A"), faces));

    countsWhatThePolygonsCommandCounts(scene.toString());
  }

  @Test
  void polygonsAreToldWithThousandsSeparators() throws IOException {
    Path scene =
        Files.writeString(
            folder.resolve("scene.x3d"),
            "<X3D version='4.0' profile='Immersive'><Scene><Switch whichChoice='0'>"
                + "<MetadataSet><MetadataSet containerField='value'><MetadataString"
                + " containerField='value' name='degreeOfConsistency' value='\"high\"'/>"
                + "</MetadataSet><MetadataSet containerField='value'><MetadataString"
                + " containerField='value' name='degreeOfConsistency' value='\"low\"'/>"
                + "</MetadataSet></MetadataSet>"
                + "<Group><Shape><Sphere/></Shape><Shape><Sphere/></Shape></Group>"
                + "<Shape><Box/></Shape></Switch></Scene></X3D>");
    assertThat(report(scene, "{}").findings())
        .extracting(Finding::message)
        .contains(
            "choice 0 is more consistent than choice 1, but has more polygons: 1,920 instead of 12");
  }

  /** Two areas apart, neither of which has an exit schema: both lamps end up detailed. */
  @Test
  void theWorstStateIsThatAfterAWalkThroughAllAreas() throws IOException {
    Path scene =
        Files.writeString(
            folder.resolve("scene.x3d"),
            "<X3D version='4.0' profile='Immersive'><Scene>"
                + area("A", 0)
                + area("B", 10)
                + lamp("A")
                + lamp("B")
                + "</Scene></X3D>");

    long sphere = 960;
    assertThat(
            model(scene).states("").stream()
                .mapToLong(EnrichmentPolygonModel.State::polygons)
                .max())
        .hasValue(2 * sphere);
    assertThat(report(scene, "{\"budgets\": [{\"polygons\": 1919}]}").findings())
        .filteredOn(finding -> finding.rule().id().equals("SR501"))
        .singleElement()
        .extracting(Finding::message)
        .asString()
        .contains("the scene has 1,920 polygons")
        .contains("1 more than its budget of 1,919");
  }

  private static String area(String schema, int x) {
    return """
        <ProximitySensor center='%d 0 0' size='2 2 2'><MetadataString name='enterTimeSchema'
          value='"%s"'/></ProximitySensor>"""
        .formatted(x, schema);
  }

  private static String lamp(String schema) {
    return """
        <Switch whichChoice='1'>
          <MetadataSet><MetadataSet containerField='value'><MetadataString
            containerField='value' name='schemaBelonginess' value='"%s"'/></MetadataSet></MetadataSet>
          <Shape><Sphere/></Shape><Shape><Box/></Shape>
        </Switch>"""
        .formatted(schema);
  }

  private static EnrichmentPolygonModel model(Path scene) throws IOException {
    List<EnrichmentPolygonModel> models = new ArrayList<>();
    RuleGroup probe =
        new RuleGroup(
            "",
            List.of(),
            List.of(),
            List.of((view, found) -> models.add(FileOutlineAdapter.model(view))));
    new Validator(new RuleCatalogue(List.of(probe)), ValidationSettings.standard(), Path.of(""))
        .validate(List.of(SourceFile.of(scene, Path.of(""))));
    return models.get(0);
  }

  private static ValidationReport report(Path scene, String settings) throws IOException {
    Path file = Files.writeString(scene.resolveSibling("settings.json"), settings);
    RuleCatalogue rules = RuleCatalogue.standard();
    return new Validator(
            rules,
            new ValidationSettingsReader(file, rules).read(new ProblemCollector()).orElseThrow(),
            scene.getParent())
        .validate(List.of(SourceFile.of(scene, scene.getParent())));
  }
}
