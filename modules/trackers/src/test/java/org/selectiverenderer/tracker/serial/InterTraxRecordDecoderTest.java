package org.selectiverenderer.tracker.serial;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.tracker.pipeline.RecordingPoseSink;

class InterTraxRecordDecoderTest {
  private static final String ZERO = "8000000000000080";

  /** Azimuth 16384, elevation -8192, twist 1. */
  private static final String TURNED = "80004000E001005F";

  private static final List<Double> TURNED_DEGREES = List.of(90.0, -45.0, 180.0 / 32768);

  private final InterTraxRecordDecoder records = new InterTraxRecordDecoder();
  private final RecordingPoseSink intake = new RecordingPoseSink();

  @Test
  void theProtocolsCheckValuesAreRead() {
    take(ZERO + TURNED);
    assertThat(intake.records).containsExactly(List.of(0.0, 0.0, 0.0), TURNED_DEGREES);
    assertThat(intake.bad).isZero();
  }

  @Test
  void oneRecordAloneIsNotYetTrusted() {
    take(TURNED);
    assertThat(records.locked()).isFalse();
    assertThat(intake.records).isEmpty();
  }

  @Test
  void recordsMayComeByteByByte() {
    byte[] bytes = HexFormat.of().parseHex(ZERO + TURNED + TURNED);
    for (byte b : bytes) {
      records.take(new byte[] {b}, 1, 0, intake);
    }
    assertThat(intake.records).hasSize(3).endsWith(TURNED_DEGREES);
  }

  @Test
  void theRestOfARecordAtTheBeginningIsNotCounted() {
    take("0001005F" + ZERO + TURNED);
    assertThat(intake.records).hasSize(2);
    assertThat(intake.bad).isZero();
  }

  @Test
  void aWrongChecksumCostsThatRecordOnly() {
    take(ZERO + TURNED + "8000400000000000" + TURNED + ZERO);
    assertThat(intake.records).hasSize(4);
    assertThat(intake.bad).isEqualTo(1);
  }

  @Test
  void aLostByteCostsThatRecordOnly() {
    take(ZERO + TURNED + TURNED.substring(2) + TURNED + ZERO);
    assertThat(intake.records).hasSize(4);
    assertThat(intake.bad).isEqualTo(1);
  }

  @Test
  void theHeadersByteMayOccurInside() {
    // Azimuth 0x8080, elevation 0x8080, twist 0x0080.
    String inside = "8080808080800000";
    take(ZERO + ZERO + inside + inside + TURNED + TURNED);
    assertThat(intake.records).hasSize(6).endsWith(TURNED_DEGREES, TURNED_DEGREES);
    assertThat(intake.bad).isZero();
  }

  @Test
  void garbageGivesNoRecordsAndIsCounted() {
    byte[] garbage = new byte[80_000];
    new Random(5).nextBytes(garbage);
    records.take(garbage, garbage.length, 0, intake);
    assertThat(intake.records).isEmpty();
    assertThat(intake.bad).isBetween(9_900, 10_000);
  }

  @Test
  void recordsAreFoundAgainAfterAnyGarbage() {
    Random random = new Random(6);
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    for (int i = 0; i < 1_000; i++) {
      byte[] garbage = new byte[random.nextInt(40)];
      random.nextBytes(garbage);
      stream.writeBytes(garbage);
      stream.writeBytes(HexFormat.of().parseHex(TURNED + TURNED + TURNED));
    }
    byte[] bytes = stream.toByteArray();
    records.take(bytes, bytes.length, 0, intake);
    // A chance of 1 in 65,536 per garbage byte that it is taken for a record: this seed has none.
    assertThat(intake.records).hasSize(3_000).containsOnly(TURNED_DEGREES);
  }

  private void take(String hex) {
    byte[] bytes = HexFormat.of().parseHex(hex);
    records.take(bytes, bytes.length, 0, intake);
  }
}
