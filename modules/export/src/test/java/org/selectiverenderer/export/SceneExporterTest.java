package org.selectiverenderer.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.authoring.packaging.ScenePackage;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.write.SceneFormat;

class SceneExporterTest {
  private static final String AREA =
      "<ProximitySensor DEF='Prox' size='1 1 1'><MetadataString name='enterTimeSchema'"
          + " value='\"Desk\"'/></ProximitySensor>";

  @TempDir Path folder;
  private final ProblemCollector problems = new ProblemCollector();

  private static String object(String def, String content) {
    return "<Switch DEF='%s' whichChoice='1'><MetadataSet>".formatted(def)
        + "<MetadataSet><MetadataString name='schemaBelonginess' value='\"Desk\"'/></MetadataSet>"
        + "<MetadataSet><MetadataString name='consistencyType' value='\"Consistent\"'/></MetadataSet>"
        + "</MetadataSet>"
        + content
        + content
        + "</Switch>";
  }

  private static String scene(String content) {
    return "<X3D profile='Immersive' version='3.3'><head/><Scene>\n" + content + "\n</Scene></X3D>";
  }

  @BeforeEach
  void rooms() throws IOException {
    Files.createDirectories(folder.resolve("rooms"));
    Files.createDirectories(folder.resolve("pictures"));
    Files.write(folder.resolve("pictures/wood.png"), new byte[] {1, 2, 3});
    Files.writeString(
        folder.resolve("rooms/cup.x3d"), scene("<Shape><Sphere/></Shape>"), StandardCharsets.UTF_8);
    Files.writeString(
        folder.resolve("rooms/room.x3d"),
        """
        <X3D profile='Interactive' version='3.3'><head><component name='Geospatial' level='1'/></head><Scene>
          <ProtoDeclare name='Lamp'><ProtoBody><PointLight DEF='L'/></ProtoBody></ProtoDeclare>
          <ProtoInstance name='Lamp'/>
          %s
          <Transform DEF='Table'><Shape><Appearance>
            <ImageTexture url='"../pictures/wood.png"'/></Appearance><Box/></Shape></Transform>
          <TimeSensor DEF='Clock'/>
          <ROUTE fromNode='Clock' fromField='isActive' toNode='Table' toField='visible'/>
        </Scene></X3D>
        """
            .formatted(object("Switch_Cup", "<Inline url='\"cup.x3d\"'/>")));
  }

  private Optional<ScenePackage> export(String content, SceneFormat format) throws IOException {
    Path file = Files.writeString(folder.resolve("house.x3d"), content);
    return new SceneExporter(NodeCatalogue.load(), ContentAccessPolicy.none(), problems)
        .export(
            file,
            new ExportSettings(Condition.SELECTIVE, 0, format, UnaryOperator.identity(), true),
            "house.x3d")
        .map(ExportedScene::files);
  }

  private String exported(String content) throws IOException {
    ScenePackage files = export(content, SceneFormat.XML).orElseThrow();
    assertThat(problems.list()).isEmpty();
    return new String(files.scene().changed().orElseThrow(), StandardCharsets.UTF_8);
  }

  @Test
  void aSceneKeepsItsTextAndGetsOneScriptWithItsRoutes() throws IOException {
    String before = scene(AREA + "\n" + object("Switch_Cup", "<Shape><Box/></Shape>"));

    String after = exported(before);

    int script = after.indexOf("<Script ");
    assertThat(before).startsWith(after.substring(0, script).stripTrailing());
    assertThat(after.substring(after.indexOf("</Script>")))
        .isEqualToNormalizingWhitespace(
            """
            </Script>
            <ROUTE fromField="enterTime" fromNode="Prox" toField="enter0" toNode="SchemaController"/>
            <ROUTE fromField="exitTime" fromNode="Prox" toField="exit0" toNode="SchemaController"/>
            <ROUTE fromField="choice0" fromNode="SchemaController" toField="whichChoice" toNode="Switch_Cup"/>
            </Scene></X3D>
            """);
  }

  @Test
  void anInlinedRoomTwiceBecomesTwoGroupsWithNamesOfTheirOwn() throws IOException {
    String after =
        exported(
            scene(
                AREA
                    + "<Transform><Inline DEF='A' url='\"rooms/room.x3d\"' bboxSize='1 1 1'/>"
                    + "</Transform><Inline url='\"rooms/room.x3d\"'/>"));

    assertThat(after)
        .contains("<Group DEF='A' bboxSize='1 1 1'>", "Switch_Cup_2", "Table_2", "Clock_2")
        .contains("<ProtoDeclare name='Lamp'>", "<ProtoDeclare name='Lamp_2'>")
        .contains("<ProtoInstance name='Lamp_2'/>")
        .contains("fromNode='Clock_2' fromField='isActive' toNode='Table_2'")
        .contains("<component name='Geospatial' level='1'/>")
        .contains("pictures/wood.png", "rooms/cup.x3d")
        .contains("toField=\"whichChoice\" toNode=\"Switch_Cup_2\"")
        .doesNotContain("../pictures", "url='\"rooms/room.x3d\"'");
    assertThat(after.indexOf("<ProtoDeclare name='Lamp_2'>")).isLessThan(after.indexOf("<Group"));
  }

  @Test
  void theFilesThatTheSceneNamesComeAlong() throws IOException {
    ScenePackage files =
        export(scene(AREA + "<Inline url='\"rooms/room.x3d\"'/>"), SceneFormat.XML).orElseThrow();

    assertThat(files.files())
        .extracting(PackagedFile::target)
        .containsExactlyInAnyOrder(Path.of("rooms/cup.x3d"), Path.of("pictures/wood.png"));
    assertThat(files.left()).isEmpty();
  }

  @Test
  void anInlineThatIsUsedAgainIsUsedAsAGroup() throws IOException {
    String after =
        exported(
            scene(
                AREA
                    + "<Inline DEF='Room' url='\"rooms/room.x3d\"'/>"
                    + "<Transform translation='9 0 0'><Inline USE='Room'/></Transform>"));

    assertThat(after).contains("<Group USE='Room'/>").doesNotContain("Switch_Cup_2");
  }

  @Test
  void otherEncodingsHoldTheSameScript() throws IOException {
    String before = scene(AREA + object("Switch_Cup", "<Shape><Box/></Shape>"));
    for (SceneFormat format : List.of(SceneFormat.CLASSIC, SceneFormat.JSON)) {
      byte[] bytes = export(before, format).orElseThrow().scene().changed().orElseThrow();
      assertThat(new String(bytes, StandardCharsets.UTF_8))
          .contains("SchemaController", "function eventsProcessed()", "whichChoice");
    }
  }

  private static String prototype(String content) {
    return "<ProtoDeclare name='P'><ProtoBody>\n"
        + object("Switch_Cup", content)
        + "</ProtoBody></ProtoDeclare>\n";
  }

  @Test
  void instancesOfPrototypesWithEnrichedNodesAreWrittenOut() throws IOException {
    String after =
        exported(
            scene(
                AREA
                    + prototype("<Shape/>")
                    + "<ProtoInstance name='P' DEF='Mine'/><ProtoInstance name='P'/>"));

    assertThat(after)
        .contains("<Group DEF='Mine'>", "Switch_Cup", "toNode=\"Switch_Cup_2\"")
        .doesNotContain("Proto");
  }

  @Test
  void anInstanceWithRoutesIsRefusedWithItsPlace() throws IOException {
    String content =
        scene(
            prototype("<Shape/>")
                + "<ProtoInstance name='P' DEF='Mine'/><BooleanToggle DEF='T'/>"
                + "<ROUTE fromNode='T' fromField='toggle' toNode='Mine' toField='visible'/>");

    assertThat(export(content, SceneFormat.XML)).isEmpty();
    assertThat(problems.list())
        .singleElement()
        .satisfies(problem -> assertThat(problem.location().line()).isEqualTo(4))
        .satisfies(problem -> assertThat(problem.message()).contains("prototype P", "ROUTE"));
  }

  @Test
  void aPrototypeOfAnotherFileWithEnrichedNodesIsRefusedWithItsPlace() throws IOException {
    Files.writeString(folder.resolve("rooms/bins.x3d"), scene(prototype("<Shape/>")));
    String content =
        scene(
            AREA
                + object("Switch_Cup", "<Shape/>")
                + "\n<ExternProtoDeclare name='Bin' url='\"rooms/bins.x3d#P\"'/>"
                + "<ProtoInstance name='Bin'/>");

    assertThat(export(content, SceneFormat.XML)).isEmpty();
    assertThat(problems.list())
        .singleElement()
        .satisfies(problem -> assertThat(problem.location().line()).isEqualTo(3))
        .satisfies(
            problem ->
                assertThat(problem.message())
                    .contains("prototype Bin", "declare the prototype in the scene"));
  }

  @Test
  void aPrototypeOfAnotherFileWithoutEnrichedNodesStays() throws IOException {
    Files.writeString(
        folder.resolve("rooms/bins.x3d"),
        scene("<ProtoDeclare name='P'><ProtoBody><Shape/></ProtoBody></ProtoDeclare>"));
    String content =
        scene(
            AREA
                + object("Switch_Cup", "<Shape/>")
                + "<ExternProtoDeclare name='Bin' url='\"rooms/bins.x3d#P\"'/>"
                + "<ProtoInstance name='Bin'/>");
    assertThat(exported(content)).contains("ExternProtoDeclare");
  }

  @Test
  void aSceneWithoutEnrichedObjectsIsRefused() throws IOException {
    assertThat(export(scene("<Shape><Box/></Shape>"), SceneFormat.XML)).isEmpty();
    assertThat(problems.list())
        .singleElement()
        .satisfies(problem -> assertThat(problem.message()).contains("enrich it first"));
  }

  @Test
  void aRoomThatInlinesTheHouseDoesNotLoop() throws IOException {
    Files.writeString(
        folder.resolve("rooms/room.x3d"),
        scene(object("Switch_Cup", "<Shape/>") + "<Inline url='\"../house.x3d\"'/>"));

    assertThat(exported(scene(AREA + "<Inline url='\"rooms/room.x3d\"'/>")))
        .contains("Switch_Cup", "url='\"house.x3d\"'");
  }
}
