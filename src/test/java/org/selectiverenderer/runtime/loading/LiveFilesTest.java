package org.selectiverenderer.runtime.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import javax.imageio.ImageIO;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.runtime.movie.Film;
import org.selectiverenderer.runtime.nodes.NodeFactory;
import org.selectiverenderer.runtime.nodes.group.GroupingNode;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.nodes.network.LoadSensorNode;
import org.selectiverenderer.runtime.nodes.sensor.TestFrame;
import org.selectiverenderer.runtime.nodes.sound.MovieTextureNode;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** The test is the stepping thread: what arrives in the background waits in a queue for it. */
@Timeout(60)
class LiveFilesTest {
  @TempDir private Path folder;
  private final BlockingQueue<Runnable> arrivals = new LinkedBlockingQueue<>();
  private final Problems problems = new Problems();
  private final Cascade cascade = new Cascade(problems);
  private final SceneLoader loader =
      new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);
  private LoadedScene loaded;
  private LiveFiles files;
  private InstanceTree tree;

  @BeforeEach
  void writeScenes() throws IOException {
    for (int boxes = 1; boxes <= 4; boxes++) {
      write("boxes%d.x3d".formatted(boxes), "<Shape><Box/></Shape>".repeat(boxes));
    }
  }

  @AfterEach
  void close() {
    loader.close();
  }

  private static String scene(String nodes) {
    return "<X3D version='4.0'><Scene>\n" + nodes + "</Scene></X3D>";
  }

  private void write(String name, String nodes) throws IOException {
    Files.writeString(folder.resolve(name), scene(nodes));
  }

  private void load(String nodes) throws IOException {
    byte[] text = scene(nodes).getBytes(StandardCharsets.UTF_8);
    loaded = loader.load("test.x3d", new ByteArrayInputStream(text), folder);
    files = new LiveFiles(loaded, problems, arrivals::add);
    tree = new InstanceTree((GroupingNode) loaded.scene().root(), files.assets());
    watch();
    files.update();
  }

  private void watch() {
    files.watch(
        loaded.scene().named().values().stream()
            .filter(InlineNode.class::isInstance)
            .map(InlineNode.class::cast)
            .toList());
  }

  private Node node(String name) {
    return loaded.scene().find(name).orElseThrow();
  }

  private void set(String name, String field, Object value) {
    cascade.send(node(name), node(name).type().indexOf(field), value);
    frame();
  }

  /** What a frame does: events are carried, the tree follows, files are asked for. */
  private void frame() {
    cascade.run();
    tree.update();
    files.update();
  }

  private void arrive() throws InterruptedException {
    arrivals.take().run();
    frame();
  }

  private static String[] url(String... urls) {
    return urls;
  }

  private void assertBoxes(int boxes) {
    assertThat(tree.shownPolygons()).isEqualTo(12L * boxes);
  }

  @Test
  void anInlineThatIsNotLoadedAtFirstIsFilledWhenItIsTurnedOn() throws Exception {
    load("<Inline DEF='I' load='false' url='\"boxes2.x3d\"'/>");
    assertBoxes(0);
    set("I", "load", true);
    assertBoxes(0);
    arrive();
    assertBoxes(2);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void turnedOffItIsEmptyAtOnceAndTurnedOnAgainItIsBackAtOnce() throws Exception {
    load("<Inline DEF='I' url='\"boxes2.x3d\"'/>");
    assertBoxes(2);
    set("I", "load", false);
    assertBoxes(0);
    set("I", "load", true);
    assertBoxes(2);
    assertThat(arrivals).isEmpty();
  }

  @Test
  void theOldContentStaysUntilTheNewIsThere() throws Exception {
    load("<Inline DEF='I' url='\"boxes2.x3d\"'/>");
    set("I", "url", url("boxes3.x3d"));
    assertBoxes(2);
    arrive();
    assertBoxes(3);
  }

  @Test
  void ofSeveralUrlsInARowTheLastCounts() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    set("I", "url", url("boxes2.x3d"));
    set("I", "url", url("boxes3.x3d"));
    set("I", "url", url("boxes4.x3d"));
    arrive();
    arrive();
    arrive();
    assertBoxes(4);
  }

  @Test
  void whatArrivesAfterItWasTurnedOffIsNotShown() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    set("I", "url", url("boxes2.x3d"));
    set("I", "load", false);
    arrive();
    assertBoxes(0);
    set("I", "load", true);
    arrive();
    assertBoxes(2);
  }

  @Test
  void whatCannotBeReadIsAProblemAndLeavesTheInlineEmpty() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    set("I", "url", url("none.x3d"));
    assertThat(problems.list()).isEmpty();
    arrive();
    assertBoxes(0);
    assertThat(problems.list())
        .extracting(Problem::toString)
        .containsExactly("test.x3d:2:1: Inline url 'none.x3d' is missing; the Inline is left out");
    set("I", "url", url("boxes2.x3d"));
    arrive();
    assertBoxes(2);
  }

  @Test
  void aRunningSceneMayNameNoMoreThanItsFileMight() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    set("I", "url", url("../secret.x3d"));
    arrive();
    set("I", "url", url("http://example.org/a.x3d"));
    arrive();
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(
            "Inline url '../secret.x3d' points outside the folders this scene may name; --allow "
                + folder.getParent()
                + " would allow it; the Inline is left out",
            "Inline url 'http://example.org/a.x3d' is on the network; --allow-net example.org would"
                + " allow it; the Inline is left out");
  }

  private static final String SWITCHING =
      """
      <BooleanTrigger DEF='B'/>
      <IMPORT inlineDEF='I' importedDEF='Out' AS='T'/>
      <ROUTE fromNode='T' fromField='triggerTrue' toNode='L' toField='set_on'/>
      <PointLight DEF='L' on='false'/>
      """;

  private static String exporting(String before, String def) {
    return before
        + "<BooleanTrigger DEF='%s'/><EXPORT localDEF='%s' AS='Out'/>".formatted(def, def);
  }

  private Node imported(String name) {
    return loaded.scene().imported().get(name);
  }

  @Test
  void importsFollowAnInlineThatComesAndGoes() throws Exception {
    write("one.x3d", exporting("", "First"));
    write("two.x3d", exporting("<Group/>", "Second"));
    load("<Inline DEF='I' load='false' url='\"one.x3d\"'/>" + SWITCHING);
    assertThat(problems.list()).isEmpty();
    assertThat(imported("T")).isNull();
    set("I", "load", true);
    arrive();
    Node first = imported("T");
    assertThat(first.name()).isEqualTo("First");
    assertThat(loaded.scene().routes()).hasSize(1);
    set("I", "load", false);
    frame();
    assertThat(imported("T")).isNull();
    assertThat(loaded.scene().routes()).isEmpty();
    set("I", "load", true);
    frame();
    assertThat(imported("T")).isSameAs(first);
    set("I", "url", url("two.x3d"));
    arrive();
    assertThat(imported("T").name()).isEqualTo("Second");
    assertThat(loaded.scene().routes()).hasSize(1);
    set("I", "url", url("boxes1.x3d"));
    arrive();
    assertThat(imported("T")).isNull();
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly("the Inline exports no node as Out (Inline I); the IMPORT is left out");
  }

  @Test
  void anImportedNodeMayBeExportedFurther() throws Exception {
    write("one.x3d", exporting("", "First"));
    write(
        "middle.x3d",
        "<Inline DEF='J' load='false' url='\"one.x3d\"'/>"
            + "<IMPORT inlineDEF='J' importedDEF='Out' AS='Mine'/><EXPORT localDEF='Mine' AS='Out'/>");
    load("<Inline DEF='I' url='\"middle.x3d\"'/>" + SWITCHING);
    assertThat(problems.list()).isEmpty();
    assertThat(imported("T")).isNull();
    InlineNode outer = (InlineNode) node("I");
    InlineNode inner = (InlineNode) outer.content().orElseThrow().find("J").orElseThrow();
    files.watch(List.of(outer, inner));
    cascade.send(inner, inner.type().indexOf("load"), true);
    frame();
    arrive();
    assertThat(imported("T").name()).isEqualTo("First");
    assertThat(loaded.scene().routes()).hasSize(1);
  }

  @Test
  void routesReachWhatAnExportedInstanceOfAPrototypeStandsFor() throws Exception {
    write(
        "lamp.x3d",
        """
        <ProtoDeclare name='Lamp'>
          <ProtoInterface><field name='lit' type='SFBool' accessType='inputOutput'/></ProtoInterface>
          <ProtoBody><Group><PointLight><IS><connect nodeField='on' protoField='lit'/></IS></PointLight>
            <SpotLight><IS><connect nodeField='on' protoField='lit'/></IS></SpotLight></Group></ProtoBody>
        </ProtoDeclare>
        <ProtoInstance name='Lamp' DEF='A'/><EXPORT localDEF='A'/>
        """);
    load(
        """
        <Inline DEF='I' url='"lamp.x3d"'/><BooleanTrigger DEF='B'/>
        <IMPORT inlineDEF='I' importedDEF='A'/>
        <ROUTE fromNode='B' fromField='triggerTrue' toNode='A' toField='set_lit'/>
        <ROUTE fromNode='B' fromField='triggerTrue' toNode='A' toField='dim'/>
        """);
    assertThat(loaded.scene().routes())
        .extracting(route -> route.to().type().name())
        .containsExactly("PointLight", "SpotLight");
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(
            "the imported A (Group) has no field dim that receives events; the ROUTE is left out");
  }

  @Test
  void anInlineCannotComeToIncludeItsOwnFile() throws Exception {
    write("outer.x3d", "<Inline DEF='Inner' url='\"boxes1.x3d\"'/>");
    load("<Inline DEF='I' url='\"outer.x3d\"'/>");
    InlineNode outer = (InlineNode) node("I");
    Node inner = outer.content().orElseThrow().find("Inner").orElseThrow();
    files.watch(List.of(outer, (InlineNode) inner));
    cascade.send(inner, inner.type().indexOf("url"), url("outer.x3d"));
    frame();
    arrive();
    assertBoxes(0);
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(folder.resolve("outer.x3d") + " includes itself; the Inline is left out");
  }

  @Test
  void lengthsAreConvertedBetweenTheUnitsOfTheFiles() throws Exception {
    Files.writeString(
        folder.resolve("centimetres.x3d"),
        "<X3D version='4.0'><head><unit category='length' name='cm' conversionFactor='0.01'/></head>"
            + "<Scene><Shape><Box/></Shape></Scene></X3D>");
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    set("I", "url", url("centimetres.x3d"));
    arrive();
    assertThat(tree.shapes().get(0).world().m00()).isEqualTo(0.01);
  }

  @Test
  void anInlineMadeByAnApplicationIsFilledWhenItComesIntoTheScene() throws Exception {
    load("<Group DEF='G'/>");
    Node made =
        loader.factory().make(loader.catalogue().get("Inline"), null, Location.of("(made)"));
    made.init(made.type().indexOf("url"), url("boxes3.x3d"));
    set("G", "children", List.of(made));
    files.watch(List.of((InlineNode) made));
    frame();
    arrive();
    assertBoxes(3);
  }

  @Test
  void anInlineThatLeftTheSceneIsNoLongerFollowed() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    files.watch(List.of());
    set("I", "url", url("boxes2.x3d"));
    assertThat(arrivals).isEmpty();
  }

  @Test
  void anInlineThatLeavesWhileItIsReadIsFilledWhenItIsBack() throws Exception {
    load("<Inline DEF='I' load='false' url='\"boxes2.x3d\"'/>");
    set("I", "load", true);
    files.watch(List.of());
    arrive();
    assertBoxes(0);
    watch();
    frame();
    arrive();
    assertBoxes(2);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void anInlineWhoseUrlIsAnotherWhenItIsBackHasThatContent() throws Exception {
    load("<Inline DEF='I' url='\"boxes1.x3d\"'/>");
    files.watch(List.of());
    set("I", "url", url("boxes3.x3d"));
    watch();
    frame();
    assertBoxes(1);
    arrive();
    assertBoxes(3);
    files.watch(List.of());
    watch();
    frame();
    assertThat(arrivals).isEmpty();
  }

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
    TestFrame frames = new TestFrame();
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
    Path movies = Path.of("src/test/resources/conformance/texturing/_movies");
    Files.copy(movies.resolve("colours.m1v"), folder.resolve("colours.m1v"));
    Files.copy(movies.resolve("parts.gif"), folder.resolve("parts.gif"));
    load(
        "<Shape><Appearance><MovieTexture DEF='M' url='\"colours.m1v\"'/></Appearance>"
            + "<Box/></Shape>");
    MovieTextureNode movie = (MovieTextureNode) node("M");
    Film before = movie.film().orElseThrow();
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
    InlineNode made = (InlineNode) files.make(script, "Inline", Location.of("made")).orElseThrow();
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
