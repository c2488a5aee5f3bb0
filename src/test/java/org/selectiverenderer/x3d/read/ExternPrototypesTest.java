package org.selectiverenderer.x3d.read;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.files.ContentAccess;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.UrlChoice;
import org.selectiverenderer.x3d.source.ReadLimits;

/** X3D 4.0, 4.4.5 External prototypes. */
class ExternPrototypesTest {
  private static final String LAMP =
      """
      <ProtoDeclare name='Lamp'>
        <ProtoInterface>
          <field name='at' type='SFVec3f' accessType='inputOutput' value='1 1 1'/>
          <field name='on' type='SFBool' accessType='inputOutput' value='true'/>
          <field name='shade' type='SFNode' accessType='initializeOnly'><Material DEF='Own'/></field>
        </ProtoInterface>
        <ProtoBody>
          <Transform><IS><connect nodeField='translation' protoField='at'/></IS>
            <PointLight><IS><connect nodeField='on' protoField='on'/></IS></PointLight>
            <Shape><Appearance><IS><connect nodeField='material' protoField='shade'/></IS>
              <ImageTexture url='"glow.png"'/></Appearance></Shape>
          </Transform>
        </ProtoBody>
      </ProtoDeclare>
      """;

  private static final String RED =
      """
      <ProtoDeclare name='Red'>
        <ProtoBody><Material diffuseColor='1 0 0'/></ProtoBody>
      </ProtoDeclare>
      """;

  @TempDir private Path folder;
  private final Problems problems = new Problems();
  private final X3dReader reader =
      new X3dReader(NodeCatalogue.load(), new ReadLimits(1 << 24, 1000, 100, 10_000));
  private ContentRoot root;
  private ContentBase here;

  @BeforeEach
  void libraries() throws IOException {
    root = new ContentRoot(folder, ContentAccess.none());
    here = ContentBase.folder(folder);
    write("lib/lamps.x3d", RED + LAMP);
  }

  private void write(String name, String nodes) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text(nodes));
  }

  private static String text(String nodes) {
    return "<X3D version='4.0' profile='Full'><Scene>\n" + nodes + "</Scene></X3D>";
  }

  private X3dFile scene(String nodes) {
    return reader
        .with(new FileLibraries(reader, root), here)
        .read("test.x3d", text(nodes).getBytes(UTF_8), problems);
  }

  private void assertTold(String... expected) {
    assertThat(problems.list())
        .extracting(problem -> problem.toString().replace(folder + "/", ""))
        .containsExactly(expected);
  }

  private static String extern(String name, String url, String... fields) {
    return "<ExternProtoDeclare name='%s' url='%s'>%s</ExternProtoDeclare>\n"
        .formatted(name, url, String.join("", fields));
  }

  @Test
  void anInstanceHasTheLibrarysBodyAndDefaultsAndItsOwnValues() {
    X3dFile file =
        scene(
            extern("Lamp", "\"lib/lamps.x3d#Lamp\"")
                + """
                <ProtoInstance name='Lamp' DEF='A'><fieldValue name='on' value='false'/></ProtoInstance>
                <ProtoInstance name='Lamp' DEF='B'><fieldValue name='at' value='2 0 0'/>
                  <fieldValue name='shade'><Material transparency='0.5'/></fieldValue></ProtoInstance>
                <BooleanTrigger DEF='T'/>
                <ROUTE fromNode='T' fromField='triggerTrue' toNode='A' toField='on'/>
                """);
    assertTold();
    NodeView first = file.nodes().get(0);
    assertThat(first.name()).isEqualTo("A");
    assertThat(first.floats("translation")).containsExactly(1, 1, 1);
    assertThat(first.nodes("children").get(0).bool("on")).isFalse();
    NodeView second = file.nodes().get(1);
    assertThat(second.floats("translation")).containsExactly(2, 0, 0);
    assertThat(second.nodes("children").get(1).node("appearance").node("material"))
        .satisfies(material -> assertThat(material.number("transparency")).isEqualTo(0.5f));
    assertThat(ReaderFixture.routes(file)).containsExactly("T.triggerTrue -> null.on");
  }

  @Test
  void withoutANameInTheUrlTheFirstPrototypeIsMeant() {
    X3dFile file =
        scene(
            extern("Paint", "\"lib/lamps.x3d\"")
                + "<Shape><Appearance><ProtoInstance name='Paint'/></Appearance></Shape>");
    assertTold();
    assertThat(file.nodes().get(0).node("appearance").node("material").floats("diffuseColor"))
        .containsExactly(1, 0, 0);
  }

  @Test
  void theFirstUrlThatCanBeReadIsTaken() {
    X3dFile file =
        scene(
            extern("Red", "\"none.x3d#Red\" \"http://example.org/l.x3d#Red\" \"lib/lamps.x3d#Red\"")
                + "<Shape><Appearance><ProtoInstance name='Red'/></Appearance></Shape>");
    assertTold();
    assertThat(file.nodes().get(0).node("appearance").node("material")).isNotNull();
  }

  @Test
  void aLibraryMayBeDataInTheUrl() {
    X3dFile file =
        scene(
            extern(
                    "Red",
                    "\"data:model/x3d+xml,"
                        + text(RED).replace("'", "%22").replace("<", "%3C").replace("\n", "%0A")
                        + "#Red\"")
                + "<Shape><Appearance><ProtoInstance name='Red'/></Appearance></Shape>");
    assertTold();
    assertThat(file.nodes().get(0).node("appearance").node("material")).isNotNull();
  }

  @Test
  void whatIsDeclaredAndNeverUsedIsNotLookedFor() {
    scene(extern("Door", "\"none.x3d\"") + extern("Wall", "\"http://example.org/a.x3d\""));
    assertTold();
  }

  @Test
  void aMissingLibraryIsOneProblemHoweverManyNodesItWouldHaveMade() {
    X3dFile file =
        scene(
            extern("Door", "\"none.x3d#Door\"")
                + """
                <ProtoInstance name='Door' DEF='A'/><ProtoInstance name='Door' DEF='B'/>
                <Group><ProtoInstance name='Door' USE='A'/></Group>
                <TimeSensor DEF='T'/><EXPORT localDEF='A'/>
                <ROUTE fromNode='T' fromField='fraction_changed' toNode='A' toField='set_fraction'/>
                """);
    assertTold(
        "test.x3d:2:1: the prototype Door cannot be had: url 'none.x3d#Door' is missing; its"
            + " instances are left out");
    assertThat(file.nodes()).hasSize(2);
    assertThat(file.exports()).isEmpty();
  }

  @Test
  void aLibraryThatHasNoSuchPrototypeIsTold() throws IOException {
    write("empty.x3d", "<Group/>");
    scene(
        extern("Lmap", "\"lib/lamps.x3d#Lmap\"")
            + extern("Any", "\"empty.x3d\"")
            + "<ProtoInstance name='Lmap'/><ProtoInstance name='Any'/>");
    assertTold(
        "test.x3d:2:1: the prototype Lmap cannot be had: it is not in lib/lamps.x3d, which has no"
            + " prototype Lmap (did you mean Lamp?); its instances are left out",
        "test.x3d:3:1: the prototype Any cannot be had: it is not in empty.x3d, which declares no"
            + " prototype; its instances are left out");
  }

  @Test
  void interfacesThatDifferAreToldOncePerField() {
    scene(
        extern(
                "Lamp",
                "\"lib/lamps.x3d#Lamp\"",
                "\n<field name='on' type='SFInt32' accessType='inputOutput'/>",
                "\n<field name='at' type='SFVec3f' accessType='initializeOnly'/>",
                "\n<field name='watts' type='SFFloat' accessType='inputOutput'/>")
            + """
            <ProtoInstance name='Lamp' DEF='A'><fieldValue name='watts' value='40'/></ProtoInstance>
            <ProtoInstance name='Lamp'><fieldValue name='watts' value='60'/></ProtoInstance>
            <ScalarInterpolator DEF='S'/>
            <ROUTE fromNode='S' fromField='value_changed' toNode='A' toField='watts'/>
            """);
    assertTold(
        "test.x3d:3:1: on of the prototype Lamp is SFBool in lib/lamps.x3d, not SFInt32; it is used"
            + " as such",
        "test.x3d:4:1: at of the prototype Lamp is inputOutput in lib/lamps.x3d, not"
            + " initializeOnly; it is used as such",
        "test.x3d:5:1: the prototype Lamp of lib/lamps.x3d has no field watts; values and routes of"
            + " it are left out");
  }

  @Test
  void librariesUseLibrariesRelativeToThemselves() throws IOException {
    write(
        "lib/rooms/room.x3d",
        extern("Lamp", "\"../lamps.x3d#Lamp\"")
            + """
            <ProtoDeclare name='Room'><ProtoBody>
              <Group><ProtoInstance name='Lamp'/><Inline url='"desk.x3d"'/></Group>
            </ProtoBody></ProtoDeclare>
            """);
    for (String file : List.of("lib/rooms/desk.x3d", "lib/glow.png", "desk.x3d")) {
      Files.writeString(folder.resolve(file), "");
    }
    X3dFile file =
        scene(extern("Room", "\"lib/rooms/room.x3d#Room\"") + "<ProtoInstance name='Room'/>");
    assertTold();
    List<? extends NodeView> nodes = file.nodes().get(0).nodes("children");
    NodeView appearance = nodes.get(0).nodes("children").get(1).node("appearance");
    assertThat(fileOf(appearance.node("texture"))).isEqualTo(folder.resolve("lib/glow.png"));
    assertThat(fileOf(nodes.get(1))).isEqualTo(folder.resolve("lib/rooms/desk.x3d"));
  }

  @Test
  void aFileThatIsNotBesideTheLibraryIsLookedForBesideTheScene() throws IOException {
    Files.writeString(folder.resolve("glow.png"), "");
    X3dFile file = scene(extern("Lamp", "\"lib/lamps.x3d#Lamp\"") + "<ProtoInstance name='Lamp'/>");
    NodeView appearance = file.nodes().get(0).nodes("children").get(1).node("appearance");
    assertThat(fileOf(appearance.node("texture"))).isEqualTo(folder.resolve("glow.png"));
  }

  private Path fileOf(NodeView node) throws IOException {
    UrlChoice choice = UrlChoice.of(node, root, ((ParsedNode) node).base(here), "");
    assertThat(choice).isInstanceOf(UrlChoice.Found.class);
    Path file = ((UrlChoice.Found) choice).content().file().orElseThrow();
    return folder.resolve(folder.toRealPath().relativize(file));
  }

  @Test
  void aLibraryMayHandOnAPrototypeOfAnother() throws IOException {
    write("all.x3d", extern("Lamp", "\"lib/lamps.x3d#Lamp\""));
    X3dFile file = scene(extern("Lamp", "\"all.x3d#Lamp\"") + "<ProtoInstance name='Lamp'/>");
    assertTold();
    assertThat(file.nodes()).hasSize(1);
  }

  @Test
  void filesThatNameOneAnotherEnd() throws IOException {
    write("a.x3d", extern("P", "\"b.x3d#P\""));
    write("b.x3d", extern("P", "\"a.x3d#P\""));
    write(
        "c.x3d",
        extern("Q", "\"c.x3d#Q\"")
            + "<ProtoDeclare name='R'><ProtoBody><ProtoInstance name='Q'/></ProtoBody></ProtoDeclare>"
            + "<ProtoDeclare name='Q'><ProtoBody><Group><ProtoInstance name='Q'/></Group></ProtoBody>"
            + "</ProtoDeclare>");
    scene(
        extern("P", "\"a.x3d#P\"")
            + extern("Q", "\"c.x3d#Q\"")
            + "<ProtoInstance name='P'/><ProtoInstance name='Q'/>");
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(
            "the prototype P cannot be had: files name one another for it, and none of them"
                + " declares it; its instances are left out",
            "the prototype Q contains itself; this instance is left out");
  }

  @Test
  void aLibraryOfWhichNothingIsReadIsOneProblem() throws IOException {
    Files.write(folder.resolve("picture.x3d"), new byte[] {(byte) 0x89, 'P', 'N', 'G', 0, 1, 2, 3});
    scene(extern("Red", "\"picture.x3d#Red\"") + "<ProtoInstance name='Red'/>");
    assertThat(problems.list()).hasSize(1);
    assertThat(problems.list().get(0).toString())
        .startsWith(
            "test.x3d:2:1: the prototype Red cannot be had: url 'picture.x3d#Red' cannot be read (")
        .endsWith("); its instances are left out");
  }

  @Test
  void aDamagedLibraryIsToldOnceWithItsPlace() throws IOException {
    Files.writeString(folder.resolve("bad.x3d"), text(RED).replace("</Scene>", "<Oops"));
    scene(
        extern("Red", "\"bad.x3d#Red\"")
            + extern("Second", "\"bad.x3d#Red\"")
            + """
            <Shape><Appearance><ProtoInstance name='Red'/></Appearance></Shape>
            <Shape><Appearance><ProtoInstance name='Second'/></Appearance></Shape>
            """);
    assertThat(problems.list()).hasSize(1);
    assertThat(problems.list().get(0).location().file()).endsWith("bad.x3d");
    assertThat(problems.list().get(0).location().line()).isEqualTo(5);
  }

  @Test
  void anglesAreOfTheUnitOfTheFileThatStatesThem() throws IOException {
    String head =
        "<X3D version='4.0'><head><unit category='angle' name='degree'"
            + " conversionFactor='0.5'/></head><Scene>";
    Files.writeString(
        folder.resolve("halves.x3d"),
        head
            + """
            <ProtoDeclare name='Turned'><ProtoInterface>
              <field name='more' type='SFRotation' accessType='initializeOnly' value='0 1 0 4'/>
            </ProtoInterface><ProtoBody>
              <Transform rotation='0 0 1 2'><Transform>
                <IS><connect nodeField='rotation' protoField='more'/></IS>
              </Transform></Transform>
            </ProtoBody></ProtoDeclare></Scene></X3D>
            """);
    X3dFile file =
        scene(
            extern("Turned", "\"halves.x3d\"")
                + "<ProtoInstance name='Turned'/><Transform rotation='1 0 0 3'/>");
    assertTold();
    assertThat(file.nodes().get(0).floats("rotation")).containsExactly(0, 0, 1, 1);
    assertThat(file.nodes().get(0).nodes("children").get(0).floats("rotation"))
        .containsExactly(0, 1, 0, 2);
    assertThat(file.nodes().get(1).floats("rotation")).containsExactly(1, 0, 0, 3);
    X3dFile halves =
        reader.read(
            "test.x3d",
            (head
                    + """
                    <Viewpoint fieldOfView='3' orientation='0 1 0 3'/>
                    <OrthoViewpoint fieldOfView='-2 -2 2 2'/>
                    <OrientationInterpolator key='0 1' keyValue='0 1 0 1, 1 0 0 2'/>
                    <Background skyAngle='1 2'/></Scene></X3D>
                    """)
                .getBytes(UTF_8),
            problems);
    List<ParsedNode> nodes = halves.nodes();
    assertThat(nodes.get(0).number("fieldOfView")).isEqualTo(1.5f);
    assertThat(nodes.get(0).floats("orientation")).containsExactly(0, 1, 0, 1.5f);
    assertThat(nodes.get(1).floats("fieldOfView")).containsExactly(-2, -2, 2, 2);
    assertThat(nodes.get(2).floats("keyValue")).containsExactly(0, 1, 0, 0.5f, 1, 0, 0, 1);
    assertThat(nodes.get(3).floats("skyAngle")).containsExactly(0.5f, 1);
  }

  @Test
  void severalThreadsMayUseOneLibrary() throws Exception {
    String coordinates = "1 2 3 ".repeat(2000);
    write(
        "big.x3d",
        "<ProtoDeclare name='P'><ProtoBody><Shape><PointSet><Coordinate point='%s'/></PointSet></Shape>"
                .formatted(coordinates)
            + "</ProtoBody></ProtoDeclare>");
    X3dReader with = reader.with(new FileLibraries(reader, root), here);
    byte[] text = text(extern("P", "\"big.x3d#P\"") + "<ProtoInstance name='P'/>").getBytes(UTF_8);
    Callable<Integer> read =
        () ->
            with.read("test.x3d", text, new Problems())
                .nodes()
                .get(0)
                .node("geometry")
                .node("coord")
                .floats("point")
                .length;
    ExecutorService threads = Executors.newFixedThreadPool(4);
    try {
      for (Future<Integer> result :
          threads.invokeAll(Stream.generate(() -> read).limit(40).toList())) {
        assertThat(result.get()).isEqualTo(6000);
      }
    } finally {
      threads.shutdownNow();
    }
  }

  @Test
  void prototypesOfOtherFilesThatMultiplyBeyondTheLimitAreLeftOut() throws IOException {
    write("p0.x3d", "<ProtoDeclare name='P'><ProtoBody><Group/></ProtoBody></ProtoDeclare>");
    for (int i = 1; i < 8; i++) {
      write(
          "p" + i + ".x3d",
          extern("Q", "\"p" + (i - 1) + ".x3d#P\"")
              + "<ProtoDeclare name='P'><ProtoBody><Group>"
              + "<ProtoInstance name='Q'/>".repeat(10)
              + "</Group></ProtoBody></ProtoDeclare>");
    }
    X3dFile file = scene(extern("P", "\"p7.x3d#P\"") + "<ProtoInstance name='P'/>");
    assertTold(
        "test.x3d:3:1: an instance of the prototype P makes more than what is left of the 10000"
            + " nodes that a file may have; it is left out");
    assertThat(file.nodes()).isEmpty();
  }

  @Test
  void aPrototypeOfAnotherFileHidesALargeOneOfItsName() throws IOException {
    String many = "<Group/>".repeat(200);
    X3dFile file =
        scene(
            "<ProtoDeclare name='Red'><ProtoBody><Group>"
                + many
                + "</Group></ProtoBody></ProtoDeclare>\n<ProtoDeclare name='All'><ProtoBody>"
                + extern("Red", "\"lib/lamps.x3d#Red\"")
                + "<Group>"
                + "<Shape><Appearance><ProtoInstance name='Red'/></Appearance></Shape>".repeat(100)
                + "</Group></ProtoBody></ProtoDeclare>\n<ProtoInstance name='All'/>");
    assertTold();
    assertThat(file.nodes()).hasSize(1);
  }
}
