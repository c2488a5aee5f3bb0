package org.selectiverenderer.polygon;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.selectiverenderer.polygon.SmallScene.area;
import static org.selectiverenderer.polygon.SmallScene.count;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.polygon.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.SceneStatistics.StateCount;

class RenderingCostTest {
  private static final long LARGE = 4 * (64 + 16 + 4 + 1);
  private static final long SMALL = 4 * (16 + 4 + 1);

  @TempDir Path folder;
  private final ProblemCollector problems = new ProblemCollector();

  private void picture(String name, int side) throws IOException {
    ImageIO.write(
        new BufferedImage(side, side, BufferedImage.TYPE_INT_RGB),
        "png",
        folder.resolve(name).toFile());
  }

  private static String textured(String texture) {
    return "<Shape><Appearance>%s</Appearance><Box/></Shape>".formatted(texture);
  }

  private static String image(String url) {
    return textured("<ImageTexture url='\"%s\"'/>".formatted(url));
  }

  private RenderingCost cost(String... content) throws IOException {
    return count(folder, problems, content).scopes().get(0).highCost();
  }

  @Test
  void eachPictureIsCountedOnceAndEachPlaceOfAShapeIsDrawn() throws IOException {
    picture("large.png", 8);
    picture("small.png", 4);
    assertThat(cost(image("large.png"), image("./large.png"), image("small.png")))
        .isEqualTo(new RenderingCost(3, LARGE + SMALL));
    assertThat(
            cost(
                "<Group DEF='G'>" + image("large.png") + "</Group>",
                "<Transform><Group USE='G'/></Transform>",
                "<Shape><IndexedLineSet coordIndex='0 1 -1'><Coordinate point='0 0 0 1 1 1'/>"
                    + "</IndexedLineSet></Shape>",
                "<Shape/>"))
        .isEqualTo(new RenderingCost(3, LARGE));
  }

  @Test
  void aFileWhoseNameBeginsWithHttpIsNoWebAddress() throws IOException {
    picture("http-photo.png", 8);
    assertThat(cost(image("http-photo.png"))).isEqualTo(new RenderingCost(1, LARGE));
  }

  @Test
  void whatIsNotShownCostsNothing() throws IOException {
    picture("large.png", 8);
    assertThat(
            cost(
                "<Switch whichChoice='-1'>" + image("large.png") + "</Switch>",
                "<Group visible='false'>" + image("large.png") + "</Group>",
                "<LOD range='5'>" + image("none.png") + image("large.png") + "</LOD>"))
        .isEqualTo(new RenderingCost(1, 0));
  }

  @Test
  void picturesInTheSceneAndOfInlinedFilesCountToo() throws IOException {
    Files.createDirectory(folder.resolve("models"));
    Files.writeString(
        folder.resolve("models/chair.x3d"), SmallScene.document(image("../large.png")));
    picture("large.png", 8);
    assertThat(
            cost(
                "<Inline url='models/chair.x3d'/>",
                image("large.png"),
                textured("<PixelTexture image='2 1 1 0 255'/>")))
        .isEqualTo(new RenderingCost(3, LARGE + 4 * (2 + 1)));
  }

  @Test
  void aPictureOutsideOfTheFoldersOfTheSceneIsNotOpened() throws IOException {
    Path scenes = Files.createDirectory(folder.resolve("scenes"));
    picture("large.png", 8);
    assertThat(
            ScenePolygonCounter.of(
                    SmallScene.write(scenes, image("../large.png")), List.of(), problems)
                .scopes()
                .get(0)
                .highCost())
        .isEqualTo(new RenderingCost(1, 0));
  }

  @Test
  void aStateHasThePicturesThatItsSchemasChoose() throws IOException {
    picture("large.png", 8);
    picture("small.png", 4);
    SceneStatistics scene =
        count(
            folder,
            problems,
            """
            <Switch whichChoice='0'>
              <MetadataSet containerField='metadata'>
                <MetadataSet containerField='metadata' name='fieldQualities'>
                  <MetadataSet containerField='value'>
                    <MetadataString containerField='value' name='quality' value='"textures"'/>
                    <MetadataString containerField='value' name='field' value='"T.url"'/>
                    <MetadataSet containerField='value'>
                      <MetadataString containerField='value' name='schemaBelonginess'
                          value='"Desk"'/>
                      <MetadataString containerField='value' name='degreeOfConsistency'
                          value='"low"'/>
                      <MetadataString containerField='value' name='value' value='"large.png"'/>
                    </MetadataSet>
                    <MetadataSet containerField='value'>
                      <MetadataString containerField='value' name='schemaBelonginess'
                          value='"Hall"'/>
                      <MetadataString containerField='value' name='degreeOfConsistency'
                          value='"high"'/>
                      <MetadataString containerField='value' name='value' value='"small.png"'/>
                    </MetadataSet>
                  </MetadataSet>
                </MetadataSet>
              </MetadataSet>
            """
                + textured("<ImageTexture DEF='T' url='\"small.png\"'/>")
                + "</Switch>",
            area("Desk", "Hall", 0));
    ScopeCount all = scene.scopes().get(0);
    assertThat(all.highCost()).isEqualTo(new RenderingCost(1, LARGE));
    assertThat(all.states())
        .extracting(state -> String.join("+", state.schemas()), StateCount::cost)
        .containsExactly(
            tuple("", new RenderingCost(1, SMALL)), tuple("Desk", new RenderingCost(1, LARGE)));
    assertThat(problems.list())
        .filteredOn(problem -> problem.severity() != Problem.Severity.INFO)
        .isEmpty();
  }
}
