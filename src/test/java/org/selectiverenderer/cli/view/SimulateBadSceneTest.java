package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.cli.view.SimulateTestCase.BOX;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.zip.Deflater;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Scenes with something wrong in them: one message each, and the rest is shown. */
class SimulateBadSceneTest {
  @TempDir private Path temp;
  private SimulateTestCase folder;

  @BeforeEach
  void writePath() {
    folder = new SimulateTestCase(temp);
  }

  /** Something wrong, then a box, of which {@code polygons} in all are shown. */
  private void assertTold(String nodes, long polygons, String... messages) {
    SimulateTestCase.Result result =
        folder.scene("scene.x3d", nodes + "\n" + BOX).simulate("scene.x3d");
    assertThat(result.messages()).containsExactly(messages);
    assertThat(result.polygons()).isEqualTo(polygons);
    assertThat(result.status()).isEqualTo(1);
  }

  private void assertNothingShown(byte[] bytes, String... messages) {
    SimulateTestCase.Result result = folder.write("scene.x3d", bytes).simulate("scene.x3d");
    assertThat(result.messages()).containsExactly(messages);
    assertThat(result.polygons()).isZero();
    assertThat(result.status()).isEqualTo(1);
  }

  @Test
  void aMissingSceneIsAFailureOfFiles() {
    SimulateTestCase.Result result = folder.simulate("none.x3d");
    assertThat(result.messages())
        .containsExactly("selective-renderer simulate: no such file: none.x3d");
    assertThat(result.status()).isEqualTo(2);
    assertThat(result.out()).isEmpty();
  }

  @Test
  void aFolderStandsForTheScenesInIt() {
    folder.write("scenes/a.x3d", "");
    SimulateTestCase.Result result = folder.simulate("scenes");
    assertThat(result.messages())
        .containsExactly("scenes/a.x3d: the file is empty; nothing can be shown");
    assertThat(result.status()).isEqualTo(1);
  }

  @Test
  void aMissingPathIsAFailureOfFiles() {
    folder.scene("scene.x3d", BOX);
    SimulateTestCase.Result result =
        folder.run(
            "simulate",
            folder.path("scene.x3d").toString(),
            "--path",
            folder.path("none.csv").toString());
    assertThat(result.messages())
        .containsExactly("selective-renderer simulate: no such file: none.csv");
    assertThat(result.status()).isEqualTo(2);
  }

  @Test
  void aPathThatCannotBePlayedIsBadInput() {
    folder.scene("scene.x3d", BOX).write("path.csv", "t,x,y,z\n0,0,0,1\n1,0,here,1\n");
    SimulateTestCase.Result result =
        folder.run(
            "simulate",
            folder.path("scene.x3d").toString(),
            "--path",
            folder.path("path.csv").toString());
    assertThat(result.messages())
        .containsExactly("path.csv:3:5: 'here' is not a number; the path is not played");
    assertThat(result.status()).isEqualTo(1);
    assertThat(result.out()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"0", "-1", "NaN", "Infinity"})
  void aRateMustBeAboveZero(String rate) {
    folder.scene("scene.x3d", BOX);
    SimulateTestCase.Result result =
        folder.run(
            "simulate",
            folder.path("scene.x3d").toString(),
            "--path",
            folder.path("still.csv").toString(),
            "--rate=" + rate);
    assertThat(result.messages().get(0))
        .isEqualTo(
            "selective-renderer simulate: --rate must be a number of frames per second "
                + "above 0");
    assertThat(result.status()).isEqualTo(2);
  }

  @Test
  void anUnknownElementIsLeftOutWithItsChildren() {
    assertTold(
        "<Bogus>" + BOX + "</Bogus>",
        12,
        "scene.x3d:2:1: unknown element Bogus; it and its children are left out");
  }

  @Test
  void aFileThatIsCutOffShowsWhatWasRead() {
    SimulateTestCase.Result result =
        folder
            .write("scene.x3d", "<X3D><Scene>\n" + BOX + "\n<Shape><Box size='1 2")
            .simulate("scene.x3d");
    assertThat(result.messages())
        .containsExactly("scene.x3d:3:22: the file is cut off here; the part before it is kept");
    assertThat(result.polygons()).isEqualTo(12);
    assertThat(result.status()).isEqualTo(1);
  }

  @Test
  void badNumbersAreReplacedOneByOne() {
    assertTold(
        """
        <Shape><IndexedFaceSet coordIndex='0 1 2.5 -1 0 1 9 -1'>
        <Coordinate point='0 0 0 1 0 NaN 0 1 0 3'/></IndexedFaceSet></Shape>
        """,
        13,
        "scene.x3d:2:8: IndexedFaceSet refers to point index 9, but the number of points is 3;"
            + " 1 face is left out",
        "scene.x3d:2:40: coordIndex: '2.5' is not a whole number; 2 is used",
        "scene.x3d:3:30: point: 'NaN' is not a finite number; 0 is used instead",
        "scene.x3d:3:40: point: the last value has only 1 of its 3 numbers; it is left out");
  }

  @Test
  void aUseBeforeItsDefIsLeftOut() {
    assertTold(
        "<Shape USE='Later'/><Shape DEF='Later'><Box/></Shape>",
        24,
        "scene.x3d:2:8: no node above has the name Later; the USE is left out");
  }

  @Test
  void aPrototypeWhoseFileIsMissingIsLeftOut() {
    assertTold(
        "<ExternProtoDeclare name='E' url='\"e.x3d#E\"'/><ProtoInstance name='E'/>",
        12,
        "scene.x3d:2:1: the prototype E cannot be loaded: url 'e.x3d#E' is missing; its instances are"
            + " left out");
  }

  @Test
  void nodesOnlyKeptAreToldOncePerTypeOrComponentAndAreNoProblem() {
    folder.scene(
        "scene.x3d", "<SignalPdu/><SignalPdu/><ReceiverPdu/>\n<NurbsSet/><NurbsSet/>" + BOX);
    SimulateTestCase.Result result = folder.simulate("scene.x3d");
    assertThat(result.messages())
        .containsExactly(
            "scene.x3d:2:1: SignalPdu is kept in the scene, but this program "
                + "does not act on nodes of the DIS component",
            "scene.x3d:3:1: NurbsSet is kept in the scene, but this program does "
                + "not act on it");
    assertThat(result.polygons()).isEqualTo(12);
    assertThat(result.status()).isZero();
  }

  @Test
  void textIsDrawnAndNothingIsSaidOfIt() {
    folder.scene("scene.x3d", "<Shape><Text string='\"a\"'><FontStyle/></Text></Shape>");
    SimulateTestCase.Result result = folder.simulate("scene.x3d");
    assertThat(result.messages()).isEmpty();
    assertThat(result.polygons()).isPositive();
    assertThat(result.status()).isZero();
  }

  @Test
  void anEmptyFileShowsNothing() {
    assertNothingShown(new byte[0], "scene.x3d: the file is empty; nothing can be shown");
  }

  @Test
  void rubbishShowsNothing() {
    byte[] rubbish = new byte[3000];
    new Random(1).nextBytes(rubbish);
    assertNothingShown(
        rubbish,
        "scene.x3d: this is neither XML nor VRML nor JSON: a scene begins with '<', '#X3D V', "
            + "'#VRML V' or '{'; nothing can be shown");
  }

  @Test
  void textThatIsNoXmlShowsNothing() {
    assertNothingShown(
        "hello".getBytes(StandardCharsets.UTF_8),
        "scene.x3d: this is neither XML nor VRML nor JSON: a scene begins with '<', '#X3D V', "
            + "'#VRML V' or '{'; nothing can be shown");
  }

  @Test
  void entitiesOfTheDoctypeAreShown() {
    String subset = "<!DOCTYPE X3D [<!ENTITY d '0.1'><!ENTITY box \"" + BOX + "\">]>\n";
    SimulateTestCase.Result result =
        folder
            .write("scene.x3d", subset + "<X3D><Scene>&box;<Group>&box;</Group></Scene></X3D>")
            .simulate("scene.x3d");
    assertThat(result.messages()).isEmpty();
    assertThat(result.polygons()).isEqualTo(24);
    assertThat(result.status()).isZero();
  }

  @Test
  void entitiesDoNotExhaustMemoryNorReadFiles() {
    StringBuilder bomb = new StringBuilder("<!DOCTYPE X3D [<!ENTITY e0 'aaaaaaaaaa'>");
    for (int i = 1; i < 40; i++) {
      bomb.append("<!ENTITY e%d '&e%d;&e%d;&e%d;'>".formatted(i, i - 1, i - 1, i - 1));
    }
    bomb.append("<!ENTITY secret SYSTEM 'still.csv'>]>\n<X3D><Scene>\n").append(BOX);
    SimulateTestCase.Result result =
        folder
            .write("scene.x3d", bomb + "\n<WorldInfo title='&e39;'/></Scene></X3D>")
            .simulate("scene.x3d");
    assertThat(result.messages()).hasSize(1);
    assertThat(result.messages().get(0))
        .startsWith("scene.x3d:4:")
        .endsWith(
            "the entity &e39; cannot be expanded: the entity &e8; stands for more than 65536"
                + " characters; the part before it is kept");
    assertThat(result.polygons()).isEqualTo(12);
    assertThat(result.status()).isEqualTo(1);
    assertThat(
            folder
                .write("scene.x3d", bomb + "&secret;<Group/></Scene></X3D>")
                .simulate("scene.x3d")
                .messages())
        .containsExactly(
            "scene.x3d:3:22: the entity &secret; is external and is never fetched; it is left out");
  }

  @Test
  void aGzipBombIsLeftOutBeforeItFillsTheMemory() {
    assertNothingShown(
        bomb(),
        "scene.x3d: the compressed file grows more than 1000 times its size when "
            + "unpacked, which is not plausible for a scene; it is left out");
  }

  /** Ten gigabytes of blanks after the start of a scene, in ten megabytes. */
  private static byte[] bomb() {
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.writeBytes(new byte[] {0x1f, (byte) 0x8b, 8, 0, 0, 0, 0, 0, 0, 0});
    Deflater deflater = new Deflater(9, true);
    file.writeBytes(deflate(deflater, "<X3D><Scene><Shape><Box/></Shape>"));
    String blanks = " ".repeat(1 << 22);
    file.writeBytes(deflate(deflater, blanks));
    byte[] repeatable = deflate(deflater, blanks);
    deflater.end();
    for (long unpacked = 0; unpacked < 10_000_000_000L; unpacked += blanks.length()) {
      file.writeBytes(repeatable);
    }
    return file.toByteArray();
  }

  private static byte[] deflate(Deflater deflater, String text) {
    byte[] packed = new byte[1 << 16];
    deflater.setInput(text.getBytes(StandardCharsets.US_ASCII));
    return Arrays.copyOf(packed, deflater.deflate(packed, 0, packed.length, Deflater.SYNC_FLUSH));
  }

  @Test
  void damagedCompressionIsTold() throws IOException {
    assertNothingShown(
        new byte[] {0x1f, (byte) 0x8b, 8, 0, 97, 98, 99, 100, 101, 102, 10},
        "scene.x3d: the gzip compression is damaged or cut off here; nothing can be shown");
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream out = new GZIPOutputStream(bytes)) {
      String text = "<X3D><Scene>\n" + BOX + "<!-- " + new Random(1).ints(2000).boxed().toList();
      out.write((text + " --></Scene></X3D>").getBytes(StandardCharsets.UTF_8));
    }
    byte[] whole = bytes.toByteArray();
    SimulateTestCase.Result result =
        folder.write("scene.x3dz", Arrays.copyOf(whole, whole.length / 2)).simulate("scene.x3dz");
    assertThat(result.messages())
        .containsExactly(
            "scene.x3dz: the gzip compression is damaged or cut off here; the part "
                + "before it is kept");
    assertThat(result.polygons()).isEqualTo(12);
    assertThat(result.status()).isEqualTo(1);
  }

  @Test
  void problemsOfGeometryAreInDocumentOrderWhicheverThreadFindsThem() {
    StringBuilder nodes = new StringBuilder();
    String[] expected = new String[60];
    for (int i = 0; i < 60; i++) {
      nodes.append(
          "<Shape><IndexedFaceSet coordIndex='0 1 7'><Coordinate point='%s'/></IndexedFaceSet></Shape>\n"
              .formatted("0 0 0 1 0 0 ".repeat(1 + (i * 37 % 60) % 3)));
      expected[i] =
          ("scene.x3d:%d:8: IndexedFaceSet refers to point index 7, but the number of points is"
                  + " %d; 1 face is left out")
              .formatted(i + 2, 2 * (1 + (i * 37 % 60) % 3));
    }
    for (int run = 0; run < 5; run++) {
      assertTold(nodes.toString(), 12, expected);
    }
  }

  @Test
  void ofVeryManyProblemsTheFirstAreToldAndTheRestSummedUp() {
    StringBuilder nodes = new StringBuilder();
    for (int i = 0; i < 3000; i++) {
      nodes.append(
          "<Shape><IndexedFaceSet coordIndex='7'><Coordinate/></IndexedFaceSet></Shape>\n");
    }
    SimulateTestCase.Result result = folder.scene("scene.x3d", nodes + BOX).simulate("scene.x3d");
    assertThat(result.messages()).hasSize(101);
    assertThat(result.messages().get(99)).startsWith("scene.x3d:101:8: IndexedFaceSet has a face");
    assertThat(result.messages().get(100))
        .isEqualTo("scene.x3d: more than 100 problems; the rest are not listed");
    assertThat(result.polygons()).isEqualTo(12);
  }
}
