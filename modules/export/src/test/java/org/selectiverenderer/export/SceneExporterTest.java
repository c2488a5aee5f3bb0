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
  void aPrototypeOfAnotherFileWithEnrichedNodesIsTakenIn() throws IOException {
    Files.writeString(
        folder.resolve("rooms/bins.x3d"),
        "<X3D profile='Interactive' version='3.3'><head><component name='Geospatial' level='1'/>"
            + "</head><Scene><ProtoDeclare name='Lid'><ProtoBody><Shape><Appearance>"
            + "<ImageTexture url='\"../pictures/wood.png\"'/></Appearance><Box/></Shape>"
            + "</ProtoBody></ProtoDeclare><ProtoDeclare name='Unused'><ProtoBody><Group/></ProtoBody>"
            + "</ProtoDeclare>"
            + prototype("<ProtoInstance name='Lid'/>")
            + object("Elsewhere", "<Shape/>")
            + "</Scene></X3D>");
    String content =
        scene(
            AREA
                + "<ProtoDeclare name='Lid'><ProtoBody><PointLight/></ProtoBody></ProtoDeclare>"
                + "<ProtoInstance name='Lid'/>"
                + "<ExternProtoDeclare name='Bin' url='\"none.x3d\" \"rooms/bins.x3d#P\"'/>"
                + "<ProtoInstance name='Bin'/><ProtoInstance name='Bin'/>");

    assertThat(exported(content))
        .contains("<ProtoDeclare name='Lid_2'>", "<ProtoInstance name='Lid_2'/>")
        .contains("url='\"pictures/wood.png\"'", "name='Geospatial'")
        .contains("toNode=\"Switch_Cup\"", "toNode=\"Switch_Cup_2\"")
        .doesNotContain("ExternProto", "Unused", "Elsewhere", "name='P'", "name='Bin'");
  }

  @Test
  void prototypesOfOneFileShareThoseThatTheyUse() throws IOException {
    Files.writeString(
        folder.resolve("rooms/bins.x3d"),
        scene(
            "<ProtoDeclare name='Lid'><ProtoBody><PointLight DEF='Glow'/></ProtoBody></ProtoDeclare>"
                + prototype("<ProtoInstance name='Lid'/>")
                + "<ProtoDeclare name='Box'><ProtoBody><Group><ProtoInstance name='Lid'/></Group>"
                + "</ProtoBody></ProtoDeclare>"));
    String content =
        scene(
            AREA
                + "<ProtoDeclare name='Lid'><ProtoBody><Group/></ProtoBody></ProtoDeclare>"
                + "<ExternProtoDeclare name='Bin' url='\"rooms/bins.x3d#P\"'/>"
                + "<ExternProtoDeclare name='Chest' url='\"rooms/bins.x3d#Box\"'/>"
                + "<ProtoInstance name='Bin'/><ProtoInstance name='Chest'/>");

    String exported = exported(content);
    assertThat(exported.split("<PointLight", -1)).hasSize(2); // declared once
    assertThat(exported).contains("<ProtoDeclare name='Lid_2'>").doesNotContain("Lid_3");
    // of both versions of the bin, and of the chest
    assertThat(exported.split("<ProtoInstance name='Lid_2'", -1)).hasSize(4);
  }

  @Test
  void aPrototypeThatComesByWayOfTwoFilesIsTakenIn() throws IOException {
    Files.writeString(folder.resolve("rooms/bins.x3d"), scene(prototype("<Shape/>")));
    Files.writeString(
        folder.resolve("all.x3d"),
        scene("<ExternProtoDeclare name='Q' url='\"rooms/bins.x3d\"'/><ProtoInstance name='Q'/>"));
    Files.writeString(
        folder.resolve("rooms/hall.x3d"),
        scene("<ExternProtoDeclare name='R' url='\"../all.x3d#Q\"'/><ProtoInstance name='R'/>"));

    assertThat(exported(scene(AREA + "<Inline url='\"rooms/hall.x3d\"'/>")))
        .contains("toNode=\"Switch_Cup\"")
        .doesNotContain("Proto", "Inline");
  }

  @Test
  void aPrototypeThatItsFileLacksIsRefusedWithItsPlace() throws IOException {
    Files.writeString(folder.resolve("rooms/bins.x3d"), scene(prototype("<Shape/>")));
    String content =
        scene(
            AREA
                + object("Switch_Cup", "<Shape/>")
                + "\n<ExternProtoDeclare name='Bin' url='\"rooms/bins.x3d#Q\"'/>"
                + "<ProtoInstance name='Bin'/>");

    assertThat(export(content, SceneFormat.XML)).isEmpty();
    assertThat(problems.list())
        .singleElement()
        .satisfies(problem -> assertThat(problem.location().line()).isEqualTo(3))
        .satisfies(
            problem -> assertThat(problem.message()).contains("prototype Bin", "declares no Q"));
  }

  @Test
  void filesThatTakePrototypesFromOneAnotherDoNotLoop() throws IOException {
    Files.writeString(
        folder.resolve("rooms/bins.x3d"),
        scene(
            "<ExternProtoDeclare name='P' url='\"bins.x3d#P\"'/>"
                + "<ExternProtoDeclare name='H' url='\"../house.x3d#Bin\"'/>"
                + object("Switch_Cup", "<Shape/>")));
    String content =
        scene(
            AREA
                + object("Switch_Cup", "<Shape/>")
                + "<ExternProtoDeclare name='Bin' url='\"rooms/bins.x3d#P\"'/>"
                + "<ProtoInstance name='Bin'/>");

    assertThat(export(content, SceneFormat.XML)).isEmpty();
    assertThat(problems.list())
        .singleElement()
        .satisfies(
            problem -> assertThat(problem.message()).contains("prototype P", "from one another"));
  }

  @Test
  void aRoomTakesAPrototypeFromTheHouseThatInlinesIt() throws IOException {
    Files.writeString(
        folder.resolve("rooms/hall.x3d"),
        scene("<ExternProtoDeclare name='R' url='\"../house.x3d#P\"'/><ProtoInstance name='R'/>"));

    assertThat(
            exported(
                scene(
                    AREA
                        + prototype("<Shape/>")
                        + "<ProtoInstance name='P'/><Inline url='\"rooms/hall.x3d\"'/>")))
        .contains("toNode=\"Switch_Cup\"", "toNode=\"Switch_Cup_2\"")
        .doesNotContain("Proto", "Inline");
  }

  @Test
  void aChainOfManyFilesIsRefused() throws IOException {
    for (int i = 0; i < 200; i++) {
      Files.writeString(
          folder.resolve("rooms/r" + i + ".x3d"),
          scene("<Inline url='\"r%d.x3d\"'/>".formatted(i + 1)));
    }
    Files.writeString(folder.resolve("rooms/r200.x3d"), scene(object("Switch_Cup", "<Shape/>")));

    assertThat(export(scene(AREA + "<Inline url='\"rooms/r0.x3d\"'/>"), SceneFormat.XML)).isEmpty();
    assertThat(problems.list())
        .anySatisfy(problem -> assertThat(problem.message()).contains("64 files deep"));
  }

  @Test
  void nodesThatAPrototypeHasByDefaultGetNamesThatAreFree() throws IOException {
    String prototype =
        "<ProtoDeclare name='Shelf'><ProtoInterface>"
            + "<field name='parts' type='MFNode' accessType='initializeOnly'>"
            + "<Transform DEF='Board'><Shape DEF='Wood'><Box/></Shape></Transform>"
            + "<Shape USE='Wood'/></field></ProtoInterface><ProtoBody><Group><Group><IS>"
            + "<connect nodeField='children' protoField='parts'/></IS></Group>"
            + object("Switch_Cup", "<Shape/>")
            + "</Group></ProtoBody></ProtoDeclare>";
    String own = "<fieldValue name='parts'><Shape DEF='Mine'/></fieldValue>";

    assertThat(
            exported(
                scene(
                    AREA
                        + prototype
                        + "<Group DEF='Board'/><ProtoInstance name='Shelf'/>"
                        + "<ProtoInstance name='Shelf'/><ProtoInstance name='Shelf'>"
                        + own
                        + "</ProtoInstance>")))
        .containsOnlyOnce("DEF='Board'")
        .containsOnlyOnce("<Transform DEF='Board_2'><Shape DEF='Wood'>")
        .containsOnlyOnce("<Transform DEF='Board_3'><Shape DEF='Wood_2'>")
        .containsOnlyOnce("<Shape USE='Wood'/>")
        .containsOnlyOnce("<Shape USE='Wood_2'/>")
        .containsOnlyOnce("DEF='Mine'");
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

  @Test
  void roomsThatInlineOneAnotherEnd() throws IOException {
    Files.writeString(
        folder.resolve("rooms/a.x3d"),
        scene(
            object("Switch_Cup", "<Shape/>")
                + "<Inline DEF='B' url='\"b.x3d\"'/><Inline DEF='A' url='\"a.x3d\"'/>"));
    Files.writeString(
        folder.resolve("rooms/b.x3d"),
        scene(object("Switch_Pot", "<Shape/>") + "<Inline DEF='Back' url='\"a.x3d\"'/>"));

    assertThat(exported(scene(AREA + "<Inline url='\"rooms/a.x3d\"'/>")))
        .containsOnlyOnce("DEF='Switch_Cup'")
        .containsOnlyOnce("DEF='Switch_Pot'")
        .contains("<Group DEF='A'>", "<Group DEF='Back'>")
        .doesNotContain("Inline");
  }

  @Test
  void aRoomIsTakenInHoweverItsFileIsReachedFirst() throws IOException {
    Files.writeString(
        folder.resolve("rooms/a.x3d"),
        scene(object("Switch_Cup", "<Shape/>") + "<Inline url='\"b.x3d\"'/>"));
    Files.writeString(folder.resolve("rooms/b.x3d"), scene("<Inline url='\"a.x3d\"'/>"));

    assertThat(
            exported(
                scene(AREA + "<Inline url='\"rooms/a.x3d\"'/><Inline url='\"rooms/b.x3d\"'/>")))
        .contains("DEF='Switch_Cup'", "DEF='Switch_Cup_2'");
  }

  @Test
  void aChainOfManyEnrichedFilesIsRefused() throws IOException {
    for (int i = 0; i < 100; i++) {
      Files.writeString(
          folder.resolve("rooms/r" + i + ".x3d"),
          scene(object("Switch_Cup", "<Shape/>") + "<Inline url='\"r%d.x3d\"'/>".formatted(i + 1)));
    }
    Files.writeString(folder.resolve("rooms/r100.x3d"), scene(""));

    assertThat(export(scene(AREA + "<Inline url='\"rooms/r0.x3d\"'/>"), SceneFormat.XML)).isEmpty();
    assertThat(problems.list())
        .anySatisfy(problem -> assertThat(problem.message()).contains("64 files deep"));
  }
}
