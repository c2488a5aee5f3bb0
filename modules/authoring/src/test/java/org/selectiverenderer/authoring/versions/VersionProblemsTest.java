package org.selectiverenderer.authoring.versions;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.models.simplify.SimplificationTarget;

/** What is refused, and what is said of the versions that are made. */
class VersionProblemsTest extends VaseScene {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "Nobody | <Shape DEF='A'><Box/></Shape> | no node with DEF 'Nobody'",
        "A | <Shape DEF='A'><Box/></Shape><Shape DEF='A'><Box/></Shape> | of several nodes",
        "A | <Shape DEF='A'><Box/></Shape><TouchSensor DEF='T'/><ROUTE fromNode='T' "
            + "fromField='isOver' toNode='A' toField='visible'/> | ROUTE here refers to 'A'",
        "A | <Shape DEF='A'><Appearance/></Shape> | the object 'A' has no faces",
        "A | <Group DEF='A'><Viewpoint/></Group> | the object 'A' has no faces",
        "A | <Viewpoint DEF='A'/> | the object 'A' has no faces",
        "A | <Switch DEF='A'><Shape><Box/></Shape><Shape><Box/></Shape></Switch> | has a Switch already",
        "A | <Shape DEF='A'><IndexedFaceSet/></Shape> | the object 'A' has no faces",
      })
  void whatCannotBeReplacedIsLeftAsItIs(String object, String content, String message)
      throws IOException {
    Path scene = scene("<X3D version='4.0'><Scene>" + content + "</Scene></X3D>");
    Map<Path, String> before = files();

    assertThat(plan(scene, object, new SimplificationTarget.Polygons(6))).isEmpty();

    assertThat(problems.list().toString()).contains(message).contains("scene.x3d");
    assertThat(files()).isEqualTo(before);
  }

  @Test
  void moreThanTheOriginalHasIsRefused() throws IOException {
    assertThat(plan(scene(SCENE), "Vase", new SimplificationTarget.Polygons(961))).isEmpty();
    assertThat(problems.list().toString()).contains("'Vase' has only 960 polygons");
  }

  @Test
  void aFolderOutOfReachIsRefused() throws IOException {
    Path scene = scene(SCENE);

    assertThat(plan(new VersionsEdit.Request(scene, "Vase", GOALS, scene, "../elsewhere")))
        .isEmpty();
    assertThat(problems.list().toString()).contains("outside the scene's folder");
  }

  @Test
  void textThatIsNotWellFormedIsNotTouched() throws IOException {
    Path scene = scene(SCENE.replace("</Shape>", ""));

    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> plan(scene, "Vase", new SimplificationTarget.Polygons(6)))
        .withMessageContaining("scene.x3d:");
  }

  @Test
  void bytesThatAreNoTextAreNotTouched() throws IOException {
    byte[] bytes = SCENE.getBytes(UTF_8);
    bytes[Arrays.asList(SCENE.split("")).indexOf("ß") + 1] = (byte) 0xff;
    Path scene = scene(bytes);

    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> plan(scene, "Vase", new SimplificationTarget.Polygons(6)))
        .withMessageContaining("not changed");
    assertThat(scene).hasBinaryContent(bytes);
  }

  @Test
  void inAnotherFolderWhatElseTheSceneNamesIsSaidToBeMissing() throws IOException {
    Path scene =
        other(
            "s.x3d",
            shape("Vase", "<Sphere/>")
                + "  <Shape><Appearance><ImageTexture url='\"wood.png\"'/></Appearance>"
                + "<Box/></Shape>\n");
    VersionsEdit.Request request =
        new VersionsEdit.Request(scene, "Vase", GOALS, folder.resolve("copy/s.x3d"), "inlineNodes");

    assertThat(plan(request)).isPresent();

    assertThat(problems.any()).isTrue();
    assertThat(problems.list().toString()).contains("s.x3d:3:").contains("wood.png");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<PointLight/> | PointLight",
        "<Viewpoint/> | Viewpoint",
        "<TouchSensor/> | TouchSensor",
        "<Billboard><Shape><Box/></Shape></Billboard> | Billboard",
        "<Switch whichChoice='0'><Shape><Box/></Shape><Shape><Cone/></Shape></Switch> | Switch",
        "<LOD range='5'><Shape><Box/></Shape><Shape><Cone/></Shape></LOD> | LOD",
      })
  void whatReducedVersionsDoNotHaveIsSaid(String content, String node) throws IOException {
    Path scene =
        other(
            "s.x3d",
            "<Group DEF='A'><Group>\n    <Shape><Sphere/></Shape>\n    "
                + content
                + "\n</Group></Group>\n");

    assertThat(plan(scene, "A", new SimplificationTarget.Polygons(100))).isPresent();

    assertThat(problems.list().toString())
        .contains("s.x3d:4:5")
        .contains("the " + node + " is not geometry");
  }

  @Test
  void moreThanOnePolygonIsSaidAsOneSays() throws IOException {
    Path scene =
        other(
            "s.x3d",
            shape("A", "<TriangleSet><Coordinate point='0 0 0 1 0 0 0 1 0'/></TriangleSet>"));

    assertThat(plan(scene, "A", new SimplificationTarget.Polygons(2))).isEmpty();
    assertThat(problems.list().toString()).contains("has only 1 polygon and 3 vertices");
  }
}
