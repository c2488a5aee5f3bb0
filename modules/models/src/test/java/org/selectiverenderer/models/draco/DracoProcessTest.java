package org.selectiverenderer.models.draco;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.time.Duration;
import java.util.Arrays;
import java.util.Base64;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DracoProcessTest {
  private static final long PLENTY = 1_000_000;

  /**
   * A square of 2 by 2 with normals and red vertices, as Google's encoder (npm's draco3d 1.5.9)
   * writes it.
   */
  private static final String EDGEBREAKER =
      "RFJBQ08CAgEBAAAABAICAgAAAR//ARH/ARH/ARED/wAAAAAAAQAAAQAJAwAAAgEBCQMAAQMBAgIEAAIBAQEBAAMDATAB"
          + "EAMAJIJKBAAAAAD/PwAAAAAAAAAAAAAAAAAAAAAAQA4AAwEACgMBMBsBEAMAHIIA/gP/AwAA/wEAAAoBAQEAAgMB"
          + "QAEACQAAAAAA/wAAAA==";

  private static final String SEQUENTIAL =
      "RFJBQ08CAgEAAAACBAEAAQICAQMBAwAJAwAAAQkDAAECAgQAAgIDAQABAQADAwEwARADACiCiBEAAAAA/z8AAAADAQAK"
          + "AwEwGwEQAwAcggD+A/8DAAD/AQAAAAEBAAIDAUABAAkAAAAAAP8AAAAAAAAAAAAAAAAAAAAAAABADgo=";

  /** Damaged: the library looks for the highest bit of 0 without an end. */
  private static final String ENDLESS =
      "RFJBQ08CAgEAAAAMGssAAQIAAzoEBQYEBwUICQoICwkMDQ4MDw0QERIQExEUFRYUFxUBAgEJAwAAAAkDAAEDAgADAQAL"
          + "A60yG1UFAQgFlnWCG5YAAAAI/AcAAPgP/Acg4D8AAP8DAAD/AQAAAAEBAQED5SDlEDkOEG3sLqUUh0sPqWDddOFZ"
          + "5IEAAAAA/z8AAAo=";

  private static byte[] bytes(String base64) {
    return Base64.getDecoder().decode(base64);
  }

  @ParameterizedTest
  @ValueSource(strings = {EDGEBREAKER, SEQUENTIAL})
  void aMeshIsDecodedWithItsAttributes(String packed) throws IOException {
    DracoMesh mesh;
    try (DracoProcess process = new DracoProcess()) {
      mesh = process.decode(bytes(packed), PLENTY);
    }

    assertThat(mesh.points()).isEqualTo(4);
    assertThat(mesh.indices()).hasSize(6).contains(0, 1, 2, 3);
    float[] positions = mesh.attribute(0).orElseThrow().values();
    assertThat(positions).hasSize(12);
    double area = 0;
    for (int t = 0; t < 6; t += 3) {
      float[][] p = new float[3][];
      for (int k = 0; k < 3; k++) {
        int at = 3 * mesh.indices()[t + k];
        p[k] = Arrays.copyOfRange(positions, at, at + 3);
      }
      area +=
          ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]))
              / 2;
    }
    assertThat(area).isCloseTo(4, within(1e-3));
    assertThat(mesh.attribute(1).orElseThrow().values()).hasSize(12);
    assertThat(mesh.attribute(1).orElseThrow().values()[2]).isCloseTo(1, within(1e-2f));
    DracoMesh.Attribute colours = mesh.attribute(2).orElseThrow();
    assertThat(colours.integers()).isTrue();
    assertThat(colours.values()).startsWith(255, 0, 0, 255);
    assertThat(mesh.attribute(3)).isEmpty();
  }

  @Test
  void whatIsCutOffIsDamagedAndTheNextIsDecoded() throws IOException {
    byte[] whole = bytes(EDGEBREAKER);
    try (DracoProcess process = new DracoProcess()) {
      for (int length : new int[] {0, 4, 11, 40, 100}) {
        assertThatIOException()
            .isThrownBy(() -> process.decode(Arrays.copyOf(whole, length), PLENTY))
            .withMessage("its Draco data are damaged");
      }
      assertThat(process.decode(whole, PLENTY).points()).isEqualTo(4);
    }
  }

  @Test
  void moreNumbersThanAllowedAreRefused() {
    try (DracoProcess process = new DracoProcess()) {
      assertThatIOException()
          .isThrownBy(() -> process.decode(bytes(SEQUENTIAL), 30))
          .withMessageContaining("more numbers than fit");
    }
  }

  @Test
  void anAnnouncedNumberOfVerticesTakesNoMemoryOfThisProcess() {
    byte[] many = bytes(SEQUENTIAL);
    byte[] announced = new byte[many.length + 8];
    System.arraycopy(many, 0, announced, 0, 11);
    for (int i = 0; i < 2; i++) { // 2^31 - 1 faces and vertices, as varints
      Arrays.fill(announced, 11 + 5 * i, 15 + 5 * i, (byte) 0xff);
      announced[15 + 5 * i] = 7;
    }
    System.arraycopy(many, 13, announced, 21, many.length - 13);
    try (DracoProcess process = new DracoProcess()) {
      assertThatIOException()
          .isThrownBy(() -> process.decode(announced, PLENTY))
          .withMessageStartingWith("its Draco data ");
    }
  }

  @Test
  void whatTakesForEverIsEndedAndNothingElseOfTheModelIsDecoded() {
    try (DracoProcess process = new DracoProcess(Duration.ofSeconds(2))) {
      String message =
          "its Draco data are not read, since the decoder of Draco took more than 2 s at damaged data";
      assertThatIOException()
          .isThrownBy(() -> process.decode(bytes(ENDLESS), PLENTY))
          .withMessage(message);
      assertThatIOException()
          .isThrownBy(() -> process.decode(bytes(SEQUENTIAL), PLENTY))
          .withMessage(message);
    }
  }
}
