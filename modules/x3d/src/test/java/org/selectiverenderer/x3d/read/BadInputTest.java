package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

class BadInputTest {
  private static final String GOOD =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 4.0//EN" "x3d-4.0.dtd">
      <X3D version='4.0' profile='Full'><head><meta name='a' content='b'/></head><Scene>
      <!-- a comment --><WorldInfo title='&lt;Büro&#x20AC;' info='"a" "b\\"c"'/>
      <ProtoDeclare name='P'><ProtoInterface><field name='f' type='SFVec3f' accessType='inputOutput'
       value='1 2 3'/></ProtoInterface><ProtoBody><Transform><IS><connect nodeField='scale'
       protoField='f'/></IS></Transform></ProtoBody></ProtoDeclare>
      <ProtoInstance name='P' DEF='I'><fieldValue name='f' value='4 5 6'/></ProtoInstance>
      <Transform DEF='T'><Shape><IndexedFaceSet coordIndex='0 1 2 -1'><Coordinate
       point='0 0 0, 1.5 0 -2e-3, 0 1 0'/></IndexedFaceSet></Shape><ProtoInstance USE='I'/></Transform>
      <Script><![CDATA[code < 1]]></Script><Shape><Appearance>
      <PixelTexture image='1 1 1 0xFF'/></Appearance></Shape>
      <ROUTE fromNode='I' fromField='f' toNode='T' toField='scale'/>
      </Scene></X3D>
      """;

  private final ReaderFixture fixture = new ReaderFixture();

  private static byte[] gzip(byte[] text) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (GZIPOutputStream gzip = new GZIPOutputStream(out)) {
      gzip.write(text);
    }
    return out.toByteArray();
  }

  @Test
  void aFileThatIsCutOffKeepsWhatWasRead() {
    X3dFile file =
        fixture.read("<X3D><Scene><Group/><Group DEF='G'><Shape/>\n<Shape><Box size='1 2");
    fixture.assertOnly("test.x3d:2:22: the file is cut off here; the part before it is kept");
    assertThat(file.nodes()).hasSize(2);
    assertThat(file.named().get("G").nodes("children")).hasSize(2);
  }

  @Test
  void aPrototypeThatIsCutOffIsNoFaultBesides() {
    fixture.read("<X3D><Scene><Group/><ProtoDeclare name='P'><ProtoInterface>\n");
    assertThat(fixture.problems.list())
        .singleElement()
        .satisfies(problem -> assertThat(problem.message()).contains("the part before it is kept"));
    fixture.read("#X3D V4.0 utf8\nGroup {}\nPROTO P [ inputOutput SFFloat size 1");
    assertThat(fixture.problems.list())
        .singleElement()
        .satisfies(problem -> assertThat(problem.message()).contains("the part before it is kept"));
    fixture.read("<X3D><Scene><ProtoDeclare name='P'/></Scene></X3D>");
    fixture.assertOnly(
        "test.x3d:1:13: a ProtoDeclare needs a name and a ProtoBody; this one is left out");
  }

  @Test
  void whatIsNotWellFormedKeepsWhatWasRead() {
    X3dFile file = fixture.read("<X3D><Scene><Group>\n</Transform></Scene></X3D>");
    assertThat(fixture.problems.list()).hasSize(1);
    assertThat(fixture.problems.list().get(0).toString())
        .startsWith("test.x3d:2:")
        .endsWith(
            "the XML is not well formed: </Group> is expected here; the part before "
                + "it is kept");
    assertThat(file.nodes()).hasSize(1);
    fixture.read("<X3D><Scene><Group/><Box size='1' size='2'/></Scene></X3D>");
    assertThat(fixture.problems.list().get(0).message()).contains("an attribute is given twice");
    fixture.read("<X3D><Scene/></X3D><X3D/>");
    assertThat(fixture.problems.list().get(0).message()).contains("follows the end of the root");
    fixture.read("<X3D a:b='1'><Scene/></X3D>");
    assertThat(fixture.problems.list().get(0).message()).contains("the prefix a is not declared");
  }

  @Test
  void aTagThatEndsWithTheFileIsTold() {
    for (String end : new String[] {"<", "<\n", "&", "&\n", "<Group\n", "</\n"}) {
      X3dFile file = fixture.read("<X3D><Scene><Group/>\n" + end);
      assertThat(fixture.problems.list()).as(end).hasSize(1);
      assertThat(fixture.problems.list().get(0).toString())
          .startsWith("test.x3d:")
          .endsWith("the part before it is kept");
      assertThat(file.nodes()).as(end).hasSize(1);
    }
  }

  @Test
  void whatIsNoSceneIsTold() {
    fixture.read("hello");
    fixture.assertOnly(
        "test.x3d: this is neither XML nor VRML nor JSON: a scene begins with '<', '#X3D V', "
            + "'#VRML V' or '{'; nothing can be shown");
    fixture.read("");
    fixture.assertOnly("test.x3d: the file is empty; nothing can be shown");
    fixture.read("<html><body/></html>");
    fixture.assertOnly(
        "test.x3d:1:1: this is an HTML page without an x3d element, so it holds no scene; nothing "
            + "can be shown");
    fixture.read("<X3D/>");
    fixture.assertOnly("test.x3d:1:1: the file has no Scene element; nothing can be shown");
    fixture.read("<X3D><Scene/><Shape/></X3D>");
    fixture.assertOnly(
        "test.x3d:1:14: Shape is outside of Scene; it and its children are left out");
    fixture.read("#Inventor V2.1 ascii\nSeparator {}");
    fixture.assertOnly(
        "test.x3d: this is a scene of Open Inventor, which is not read; convert it to X3D, for "
            + "example with view3dscene");
    fixture.read(new byte[] {(byte) 0xe0, 0, 0, 1, 0, 1, 'x'});
    fixture.assertOnly(
        "test.x3d: this is a scene in X3D's binary encoding (.x3db), which is not read; save it as "
            + "X3D XML in the program that made it, or convert it with Xj3D's converter");
    assertThat(fixture.read(" ".repeat(100)).nodes()).isEmpty();
    assertThat(fixture.problems.list()).hasSize(1);
  }

  @Test
  void entitiesOfOtherFilesAreNotFetched() {
    String bomb =
        """
        <!DOCTYPE X3D [

          <!ENTITY file SYSTEM "file:///etc/hostname">
        ]>
        <X3D><Scene><Group/>
        """;
    X3dFile file = fixture.read(bomb + "<WorldInfo title='&file;'/></Scene></X3D>");
    assertThat(fixture.problems.list()).hasSize(1);
    assertThat(fixture.problems.list().get(0).toString())
        .startsWith("test.x3d:6:")
        .contains("the entity &file; is external and is never fetched");
    assertThat(file.nodes()).hasSize(1);
    file = fixture.read(bomb + "<WorldInfo DEF='W'/>&file;<Group/></Scene></X3D>");
    fixture.assertOnly(
        "test.x3d:6:21: the entity &file; is external and is never fetched; it is left out");
    assertThat(file.nodes()).hasSize(3);
  }

  @Test
  void readsCompressedFilesWhateverTheirEnding(@TempDir Path folder) throws IOException {
    Path plain = Files.writeString(folder.resolve("plain.x3dz"), GOOD);
    Path packed =
        Files.write(folder.resolve("packed.x3d"), gzip(GOOD.getBytes(StandardCharsets.UTF_8)));
    X3dReader reader = new X3dReader(NodeCatalogue.load());
    ProblemCollector problems = new ProblemCollector();
    assertThat(reader.read(plain, problems).named()).containsOnlyKeys("I", "T");
    assertThat(reader.read(packed, problems).named()).containsOnlyKeys("I", "T");
    try (InputStream in = Files.newInputStream(packed)) {
      assertThat(reader.read("stream", in, problems).nodes()).hasSize(5);
    }
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void aDamagedCompressionKeepsWhatCouldBeUnpacked() throws IOException {
    String scene = "<X3D><Scene><Group/>" + "<Shape/>\n".repeat(2000) + "</Scene></X3D>";
    byte[] packed = gzip(scene.getBytes(StandardCharsets.UTF_8));
    X3dFile file = fixture.read(Arrays.copyOf(packed, packed.length - 40));
    assertThat(file.nodes()).isNotEmpty();
    fixture.assertOnly(
        "test.x3d: the gzip compression is damaged or cut off here; the part before "
            + "it is kept");
    fixture.read(Arrays.copyOf(packed, 5));
    fixture.assertOnly(
        "test.x3d: the gzip compression is damaged at its start; nothing can be shown");
  }

  @Test
  void aCompressionBombIsLeftOut() throws IOException {
    byte[] bomb = gzip(new byte[12 << 20]);
    assertThat(fixture.read(bomb).nodes()).isEmpty();
    assertThat(fixture.problems.list().get(0).message()).contains("more than 1000 times its size");
    ReaderFixture small = new ReaderFixture(new ReadLimits(1 << 16, 1000, 100, 100));
    small.read(gzip(new byte[1 << 20]));
    small.assertOnly(
        "test.x3d: the file has more than 65536 bytes of text, which is the limit; it is left out");
    small.read(new byte[1 << 20]);
    assertThat(small.problems.list()).hasSize(1);
  }

  @Test
  void depthAndNumberOfNodesAreLimited() {
    ReaderFixture small = new ReaderFixture(new ReadLimits(1 << 20, 1000, 10, 50));
    small.scene("<Group>".repeat(1000) + "</Group>".repeat(1000));
    assertThat(small.problems.list()).hasSize(1);
    assertThat(small.problems.list().get(0).message()).contains("nested more than 10 deep");
    X3dFile file = small.scene("<Group/>".repeat(1000));
    assertThat(small.problems.list()).hasSize(1);
    assertThat(file.nodes()).hasSize(50);
    small.scene("<Teapot>".repeat(5000) + "</Teapot>".repeat(5000));
    assertThat(small.problems.list()).hasSize(1);
  }

  /** Prototypes of ten of the one before each, and what their bodies stand in. */
  private static String multiplying(int levels, String body) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < levels; i++) {
      String instances = "<ProtoInstance name='P%d'/>".formatted(i - 1).repeat(10);
      text.append("<ProtoDeclare name='P").append(i).append("'><ProtoBody>");
      text.append(i == 0 ? "<Group/>" : body.formatted(instances));
      text.append("</ProtoBody></ProtoDeclare>\n");
    }
    return text.toString();
  }

  @Test
  @Timeout(60)
  void whatPrototypesMultiplyBeyondTheLimitIsNotBegun() {
    for (String body : List.of("<Group>%s</Group>", "%s")) {
      X3dFile file =
          fixture.scene(
              multiplying(40, body)
                  + "<ProtoInstance name='P39'/><ProtoInstance name='P1'/><Group/>");
      fixture.assertOnly(
          "test.x3d:42:1: this instance of the prototype P39 exceeds the limit of 10000 nodes in a"
              + " file; it is left out");
      assertThat(file.nodes()).hasSize(2);
    }
  }

  @Test
  void beyondTheLimitNoInstanceIsSaidToHaveNoNode() {
    ReaderFixture small = new ReaderFixture(new ReadLimits(1 << 20, 1000, 10, 20));
    X3dFile file =
        small.scene(
            "<ProtoDeclare name='P'><ProtoBody><Group/></ProtoBody></ProtoDeclare>"
                + "<Group/>".repeat(18)
                + "<ProtoInstance name='P'/>".repeat(5)
                + "<Group><ProtoInstance name='P'/></Group>");
    assertThat(file.nodes()).hasSize(18);
    assertThat(small.problems.list())
        .extracting(Problem::message)
        .containsExactly(
            "this instance of the prototype P exceeds the limit of 20 nodes in a file; it is left"
                + " out",
            "the file has more than 20 nodes and routes, which is the limit; the rest is left out");
  }

  @Test
  void theStandardLimitOfDepthFitsASmallStack() throws InterruptedException {
    X3dReader reader = new X3dReader(NodeCatalogue.load());
    ProblemCollector problems = new ProblemCollector();
    StringBuilder text = new StringBuilder("<X3D><Scene>");
    for (int i = 0; i < 600; i++) {
      text.append("<ProtoDeclare name='P").append(i).append("'><ProtoBody>");
      text.append(i == 0 ? "<Group/>" : "<Group><ProtoInstance name='P" + (i - 1) + "'/></Group>");
      text.append("</ProtoBody></ProtoDeclare>");
    }
    text.append("<ProtoInstance name='P599'/></Scene></X3D>");
    byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
    Thread thread = new Thread(null, () -> reader.read("deep", bytes, problems), "small", 1 << 19);
    thread.start();
    thread.join();
    assertThat(problems.list()).hasSize(1);
    assertThat(problems.list().get(0).message()).contains("250 deep");
  }

  @Test
  @Timeout(60)
  void manyFaultsOfOneFileTakeNoLongerThanItsLength() {
    fixture.scene("<Transform" + attributes(5_000) + "/>");
    assertReadable();
    assertThat(fixture.problems.list()).hasSize(ProblemCollector.LIMIT + 1);
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 5_000; i++) {
      text.append("<Group DEF='N").append(i).append("'/><Group USE='M").append(i).append("'/>");
    }
    fixture.scene(text.toString());
    assertReadable();
  }

  @Test
  @Timeout(60)
  void aTagOfVeryManyAttributesEndsTheFile() {
    X3dFile file = fixture.scene("<Group/>\r\n <Group" + attributes(200_000) + "/><Group/>");
    fixture.assertOnly(
        "test.x3d:3:2: an element has more than 10000 attributes, more than any node "
            + "has; the part before it is kept");
    assertThat(file.nodes()).hasSize(1);
  }

  private static String attributes(int count) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < count; i++) {
      text.append(" name").append(i).append("='x'");
    }
    return text.toString();
  }

  @Test
  void aFileThatCannotBeReadIsAnExceptionOfOneLine(@TempDir Path folder) {
    X3dReader reader = new X3dReader(NodeCatalogue.load());
    assertThatThrownBy(() -> reader.read(folder.resolve("none.x3d"), new ProblemCollector()))
        .isInstanceOf(IOException.class)
        .hasMessage(folder.resolve("none.x3d") + ": the file does not exist");
    assertThatThrownBy(() -> reader.read(folder, new ProblemCollector()))
        .isInstanceOf(IOException.class)
        .hasMessageEndingWith("this is a folder, not a file");
  }

  @Test
  void aSceneCutAtAnyByteIsReadAsFarAsItGoes() {
    byte[] good = GOOD.getBytes(StandardCharsets.UTF_8);
    for (int length = 0; length < good.length - 1; length++) {
      fixture.read(Arrays.copyOf(good, length));
      if (length < GOOD.indexOf("</X3D>")) {
        assertThat(fixture.problems.any()).as("cut at " + length).isTrue();
      }
      assertReadable();
    }
  }

  @Test
  void noMutationOfASceneThrows() throws IOException {
    Random random = new Random(7);
    byte[] good = GOOD.getBytes(StandardCharsets.UTF_8);
    byte[] wide = GOOD.getBytes(StandardCharsets.UTF_16);
    byte[] packed = gzip(good);
    for (int round = 0; round < 20_000; round++) {
      byte[] from = round % 8 == 0 ? packed : round % 8 == 1 ? wide : good;
      byte[] bytes = from.clone();
      for (int i = random.nextInt(4); i >= 0; i--) {
        int at = random.nextInt(bytes.length);
        switch (random.nextInt(3)) {
          case 0 -> bytes[at] = (byte) random.nextInt();
          case 1 -> bytes[at] = (byte) "<>&;'\"/=! -]".charAt(random.nextInt(12));
          default -> {
            int length = Math.min(random.nextInt(20), bytes.length - at);
            System.arraycopy(from, random.nextInt(from.length - length), bytes, at, length);
          }
        }
      }
      fixture.read(bytes);
      assertReadable();
    }
  }

  /** Every problem is a sentence with a place that an editor could jump to. */
  private void assertReadable() {
    assertThat(fixture.problems.list()).hasSizeLessThanOrEqualTo(ProblemCollector.LIMIT + 1);
    for (Problem problem : fixture.problems.list()) {
      assertThat(problem.toString())
          .startsWith("test.x3d")
          .doesNotContain("Exception", "\n", "StreamReader", "null");
      assertThat(problem.location().line()).isBetween(0, 40);
    }
  }
}
