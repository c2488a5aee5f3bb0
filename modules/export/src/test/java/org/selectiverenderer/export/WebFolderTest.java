package org.selectiverenderer.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.Gzip;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.write.SceneFormat;

/** The folder of a page tells it what to load first. */
class WebFolderTest {
  private static final String MODEL =
      "<X3D profile='Interchange' version='3.3'><head/><Scene>%s</Scene></X3D>";

  @TempDir Path folder;

  private String object(String versions) {
    return "<Switch DEF='Switch_Cup' whichChoice='1'><MetadataSet>"
        + "<MetadataSet><MetadataString name='schemaBelonginess' value='\"Desk\"'/></MetadataSet>"
        + "<MetadataSet><MetadataString name='consistencyType' value='\"Consistent\"'/></MetadataSet>"
        + "</MetadataSet>"
        + versions
        + "</Switch>";
  }

  private WebFolder page(Condition condition, String content) throws IOException {
    String area =
        "<ProximitySensor DEF='Prox' size='1 1 1'><MetadataString name='enterTimeSchema'"
            + " value='\"Desk\"'/></ProximitySensor>";
    Path scene = folder.resolve("scene.x3d");
    Files.writeString(
        scene,
        "<X3D profile='Immersive' version='3.3'><head/><Scene>\n%s\n%s\n</Scene></X3D>"
            .formatted(area, content));
    ExportSettings settings =
        new ExportSettings(condition, 0, SceneFormat.XML, WebScene::name, true);
    ExportedScene exported =
        new SceneExporter(NodeCatalogue.load(), ContentAccessPolicy.none(), new ProblemCollector())
            .export(scene, settings, "scene.x3dz")
            .orElseThrow();
    var page = WebFolder.around(exported, condition, 0);
    assumeTrue(page.isPresent(), "this program was built without Node.js");
    return page.get();
  }

  private void model(String name, String content) throws IOException {
    Files.writeString(folder.resolve(name), MODEL.formatted(content));
  }

  private static String text(WebFolder page) throws IOException {
    PackagedFile scene = page.scene().get(0);
    return new String(Gzip.unpacked(scene.changed().orElseThrow()), StandardCharsets.UTF_8);
  }

  private static JsonNode description(WebFolder page) throws IOException {
    PackagedFile file =
        page.page().stream()
            .filter(each -> each.target().equals(Path.of("scene.json")))
            .findFirst()
            .orElseThrow();
    return new ObjectMapper().readTree(file.changed().orElseThrow());
  }

  @Test
  void versionsThatAreNotShownAtTheBeginningAreLoadedLater() throws IOException {
    model("fine.x3d", "<Shape><Sphere/></Shape>");
    model("coarse.x3d", "<Shape><Box/></Shape>");
    String fine = "<Group><Inline url='\"fine.x3d\"'/></Group>";
    String coarse = "<Inline DEF='Coarse' url='\"coarse.x3d\"'/>";

    WebFolder page = page(Condition.SELECTIVE, object(fine + coarse));

    assertThat(text(page)).contains("<Inline url='\"fine.x3dz\"' DEF='Later' load='false'/>");
    assertThat(text(page)).contains("<Inline DEF='Coarse' url='\"coarse.x3dz\"'/>");
    JsonNode later = description(page).get("later");
    assertThat(later).hasSize(1);
    assertThat(later.get(0).toString())
        .isEqualTo(
            "{\"object\":\"Switch_Cup\",\"choice\":0,\"inlines\":[\"Later\"],"
                + "\"files\":[\"fine.x3dz\"]}");
  }

  @Test
  void theVersionOfTheConditionThatThePageBeginsWithIsLoadedAtOnce() throws IOException {
    model("fine.x3d", "<Shape><Sphere/></Shape>");
    model("coarse.x3d", "<Shape><Box/></Shape>");
    String versions = "<Inline url='\"fine.x3d\"'/><Inline url='\"coarse.x3d\"'/>";

    WebFolder page = page(Condition.HIGH, object(versions));

    assertThat(text(page)).doesNotContain("load=");
    assertThat(description(page).has("later")).isFalse();
  }

  @Test
  void inlinesThatAreUsedElsewhereOrWhoseLoadingTheSceneSaysStayAsTheyAre() throws IOException {
    model("fine.x3d", "<Shape><Sphere/></Shape>");
    List<String> versions =
        List.of(
            object("<Inline DEF='Fine' url='\"fine.x3d\"'/><Group/>") + "<Inline USE='Fine'/>",
            object("<Inline load='false' url='\"fine.x3d\"'/><Group/>"),
            object("<Inline DEF='Fine' url='\"fine.x3d\"'/><Group/>")
                + "<BooleanToggle DEF='T'/><ROUTE fromNode='T' fromField='toggle' toNode='Fine'"
                + " toField='load'/>");
    for (String version : versions) {
      assertThat(text(page(Condition.SELECTIVE, version)))
          .contains(version.replace("fine.x3d", "fine.x3dz"));
    }
  }

  @Test
  void anInlineOfAnObjectInTheVersionOfAnotherIsChangedOnce() throws IOException {
    model("fine.x3d", "<Shape><Sphere/></Shape>");
    String inner = object("<Inline url='\"fine.x3d\"'/><Group/>").replace("_Cup", "_Spoon");
    WebFolder page =
        page(Condition.SELECTIVE, object("<Group>" + inner + "</Group><Group DEF='Low'/>"));
    assertThat(text(page)).containsOnlyOnce("load='false'").containsOnlyOnce("DEF='Later'");
    assertThat(description(page).get("later"))
        .extracting(version -> version.get("object").asText() + " " + version.get("inlines"))
        .containsExactlyInAnyOrder("Switch_Cup [\"Later\"]", "Switch_Spoon [\"Later\"]");
  }

  @Test
  void aVersionThatIsShownElsewhereIsLoadedAtOnce() throws IOException {
    model("fine.x3d", "<Shape><Sphere/></Shape>");
    String version = "<Group DEF='Fine'><Inline url='\"fine.x3d\"'/></Group><Group/>";
    assertThat(text(page(Condition.SELECTIVE, object(version) + "<Group USE='Fine'/>")))
        .doesNotContain("load=");
  }

  @Test
  void thePageLearnsWhetherAModelHasNormalMaps() throws IOException {
    model("fine.x3d", "<Shape><Sphere/></Shape>");
    String versions = "<Inline url='\"fine.x3d\"'/><Group/>";
    assertThat(description(page(Condition.SELECTIVE, object(versions))).get("normalMaps"))
        .hasToString("false");

    model(
        "fine.x3d",
        "<Shape><Appearance><PhysicalMaterial><PixelTexture containerField='normalTexture'"
            + " image='1 1 3 0x8080ff'/></PhysicalMaterial></Appearance><Sphere/></Shape>");
    assertThat(description(page(Condition.SELECTIVE, object(versions))).get("normalMaps"))
        .hasToString("true");
  }
}
