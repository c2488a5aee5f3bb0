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
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;

/** X3D 4.0, 4.4.5 External prototypes. */
class ExternPrototypesTest extends AbstractExternPrototypesTest {
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
    ResolvedUrlContent choice =
        ResolvedUrlContent.of(node, root, ((ParsedNode) node).base(here), "");
    assertThat(choice).isInstanceOf(ResolvedUrlContent.Found.class);
    Path file = ((ResolvedUrlContent.Found) choice).content().file().orElseThrow();
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
    X3dReader with = reader.with(new PrototypeLibraryLoader(reader, root), here);
    byte[] text = text(extern("P", "\"big.x3d#P\"") + "<ProtoInstance name='P'/>").getBytes(UTF_8);
    Callable<Integer> read =
        () ->
            with.read("test.x3d", text, new ProblemCollector())
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
}
