package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.movie.MoviePlayback;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.nodes.network.LoadSensorNode;
import org.selectiverenderer.browser.nodes.sensor.TestFrameContext;
import org.selectiverenderer.browser.nodes.sound.MovieTextureNode;
import org.selectiverenderer.browser.scene.Node;

/** Pictures, films and files of other nodes that are read while the scene runs. */
class RunningSceneMediaTest extends RunningSceneLoaderTestCase {
  @Test
  void anotherImageTakesTheOldOnesPlaceWhenItIsThere() throws Exception {
    picture("a.png", 3);
    picture("b.png", 5);
    load("<Shape><Appearance><ImageTexture DEF='T' url='\"a.png\"'/></Appearance><Box/></Shape>");
    assertThat(width()).isEqualTo(3);
    set("T", "url", url("b.png"));
    assertThat(width()).isEqualTo(3);
    arrive();
    assertThat(width()).isEqualTo(5);
    set("T", "repeatS", false);
    assertThat(arrivals).isEmpty();
    assertThat(width()).isEqualTo(5);
    set("T", "url", url("none.png"));
    arrive();
    assertThat(tree.shapes().get(0).surface().texture()).isNull();
    assertThat(problems.list())
        .extracting(Problem::toString)
        .containsExactly(
            "test.x3d:2:20: ImageTexture url 'none.png' is missing; the texture is left out");
  }

  private void picture(String name, int width) throws IOException {
    BufferedImage image = new BufferedImage(width, 2, BufferedImage.TYPE_INT_RGB);
    ImageIO.write(image, "png", folder.resolve(name).toFile());
  }

  private int width() {
    Texture texture = tree.shapes().get(0).surface().texture();
    return texture == null ? 0 : texture.image().width();
  }

  @Test
  void theFilesOfAGeoLodInAPrototypeLieBesideThePrototype() throws Exception {
    Files.createDirectory(folder.resolve("library"));
    write("library/near.x3d", "<Shape><Box/></Shape>".repeat(2));
    write(
        "library/tiles.x3d",
        "<ProtoDeclare name='Tile'><ProtoBody>"
            + "<GeoLOD child1Url='\"near.x3d\"' range='1e9'/>"
            + "</ProtoBody></ProtoDeclare>");
    load(
        "<ExternProtoDeclare name='Tile' url='\"library/tiles.x3d#Tile\"'/>"
            + "<ProtoInstance name='Tile'/>");
    GroupingNode tile = (GroupingNode) loaded.scene().root().nodes("children").get(0);
    files.watch(tile.children().stream().map(InlineNode.class::cast).toList());
    frame();
    tree.view(new Vector3d(), new Vector3d(0, 1, 0), cascade);
    frame();
    arrive();
    assertBoxes(2);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void loadSensorHearsOfFilesThatAreReadLater() throws Exception {
    load(
        "<Inline DEF='I' load='false' url='\"boxes2.x3d\"'/>"
            + "<LoadSensor DEF='S'><Inline USE='I'/></LoadSensor>");
    LoadSensorNode sensor = (LoadSensorNode) node("S");
    files.watchFrameNodes(List.of(sensor));
    TestFrameContext frames = new TestFrameContext();
    frames.step(sensor, 1, cascade);
    assertThat(sensor.awake()).isFalse();
    set("I", "load", true);
    assertThat(sensor.awake()).isTrue();
    frames.step(sensor, 2, cascade);
    assertThat(sensor.bool("isActive")).isTrue();
    assertThat(sensor.bool("isLoaded")).isFalse();
    arrive();
    frames.step(sensor, 3, cascade);
    assertThat(sensor.bool("isActive")).isFalse();
    assertThat(sensor.bool("isLoaded")).isTrue();
    assertThat(sensor.value(sensor.type().indexOf("loadTime"))).isEqualTo(3.0);
  }

  @Test
  void movieWithAnotherUrlShowsThatFromItsBeginning() throws Exception {
    Path movies = Path.of("modules/render/src/test/resources/conformance/texturing/_movies");
    Files.copy(movies.resolve("colours.m1v"), folder.resolve("colours.m1v"));
    Files.copy(movies.resolve("parts.gif"), folder.resolve("parts.gif"));
    load(
        "<Shape><Appearance><MovieTexture DEF='M' url='\"colours.m1v\"'/></Appearance>"
            + "<Box/></Shape>");
    MovieTextureNode movie = (MovieTextureNode) node("M");
    MoviePlayback before = movie.film().orElseThrow();
    assertThat(before.seconds()).isEqualTo(1);
    set("M", "url", url("parts.gif"));
    assertThat(movie.film()).contains(before);
    arrive();
    assertThat(movie.film().orElseThrow().seconds()).isEqualTo(2);
    assertThat(tree.shapes().get(0).surface().texture().image().width()).isEqualTo(8);
    set("M", "load", false);
    assertThat(movie.film()).isEmpty();
    assertThat(tree.shapes().get(0).surface().texture()).isNull();
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void aNodeThatAScriptOfAnInlineMakesStartsAtTheFileOfTheScript() throws Exception {
    Files.createDirectories(folder.resolve("rooms"));
    write("rooms/room.x3d", "<Script/>");
    write("rooms/lamp.x3d", "<Shape><Box/></Shape>");
    load("<Inline DEF='I' url='\"rooms/room.x3d\"'/>");
    Node script = ((InlineNode) node("I")).content().orElseThrow().root().nodes("children").get(0);
    InlineNode made =
        (InlineNode) files.make(script, "Inline", SourceLocation.of("made")).orElseThrow();
    made.init(made.urlField(), url("lamp.x3d"));
    files.watch(List.of(made));
    files.update();
    arrive();

    assertThat(made.content()).isPresent();
    assertThat(problems.list())
        .extracting(Problem::severity)
        .doesNotContain(Problem.Severity.ERROR);
  }
}
