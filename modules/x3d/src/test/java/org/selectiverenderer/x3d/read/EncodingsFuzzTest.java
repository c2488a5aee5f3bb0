package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneFormat;

/** Damaged scenes of all encodings end with problems that can be read, and can be converted. */
class EncodingsFuzzTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();
  private static final X3dReader READER = new X3dReader(CATALOGUE);

  private final ReaderFixture fixture = new ReaderFixture();

  private static byte[] scene(SceneFormat format) throws IOException {
    byte[] xml = SceneConversionTest.ALL.getBytes(StandardCharsets.UTF_8);
    XmlDocument document = READER.document("scene", new ByteArrayInputStream(xml), xml.length);
    return format
        .text(document, CATALOGUE, new ProblemCollector())
        .getBytes(StandardCharsets.UTF_8);
  }

  @ParameterizedTest
  @EnumSource
  void aSceneCutAtAnyByteIsReadAsFarAsItGoes(SceneFormat format) throws IOException {
    byte[] good = scene(format);
    for (int length = 0; length < good.length; length += 13) {
      fixture.read(Arrays.copyOf(good, length));
      assertReadable();
    }
  }

  @ParameterizedTest
  @EnumSource
  void noMutationOfASceneThrows(SceneFormat format) throws IOException {
    Random random = new Random(11);
    byte[] good = scene(format);
    for (int round = 0; round < 300; round++) {
      byte[] bytes = good.clone();
      for (int i = random.nextInt(4); i >= 0; i--) {
        int at = 16 + random.nextInt(bytes.length - 16); // what it is stays to be seen
        switch (random.nextInt(3)) {
          case 0 -> bytes[at] = (byte) random.nextInt();
          case 1 -> bytes[at] = (byte) "{}[]#\"\\., :-@".charAt(random.nextInt(13));
          default -> {
            int length = Math.min(random.nextInt(20), bytes.length - at);
            System.arraycopy(good, random.nextInt(good.length - length), bytes, at, length);
          }
        }
      }
      fixture.read(bytes);
      assertReadable();
      XmlDocument document =
          READER.document("test.x3d", new ByteArrayInputStream(bytes), bytes.length);
      for (SceneFormat other : SceneFormat.values()) {
        assertThat(other.text(document, CATALOGUE, new ProblemCollector())).isNotEmpty();
      }
    }
  }

  /** Every problem is a sentence with a place that an editor could jump to. */
  private void assertReadable() {
    assertThat(fixture.problems.list()).hasSizeLessThanOrEqualTo(ProblemCollector.LIMIT + 1);
    for (Problem problem : fixture.problems.list()) {
      assertThat(problem.toString())
          .startsWith("test.x3d")
          .doesNotContain("Exception", "\n", "null");
    }
  }
}
